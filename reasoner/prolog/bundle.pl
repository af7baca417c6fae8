/*  Makes the saved state that is embedded into the binary; run by CMake:

        swipl … -g main bundle.pl -- save  OUT.prc RULE_FILE…
        swipl … -g main bundle.pl -- check         RULE_FILE…

    Rules are loaded with autoloading off, so that a module which forgets to import something fails
    here and not in a robot's kitchen: every warning and every undefined predicate is an error.
*/

:- set_prolog_flag(autoload, false).

main :-
    current_prolog_flag(argv, Argv),
    run(Argv).

run([save, Out|Files]) :-
    load_rules(Files),
    % What follows is for saving only and must not drag half the library into the state: `explicit`
    % loads what a library declares when it is called, and nothing that a rule forgot to import.
    set_prolog_flag(autoload, explicit),
    use_module(library(qsave), [qsave_program/2]),
    % Flags are saved: the bundler's own `halt` would end the server at the first message.
    set_prolog_flag(on_error, print),
    set_prolog_flag(on_warning, print),
    % Class `development`, since a `runtime` state ignores the options that keep Prolog's hands off
    % signals.
    Options = [ class(development), stand_alone(false), autoload(false), foreign(no_save),
                goal(true), toplevel(halt), init_file(none)
              ],
    Save =.. [qsave_program, Out, Options],
    call(qsave:Save).
run([check|Files]) :-
    load_rules(Files),
    declare_foreign,
    use_module(library(check), []),
    call(check:list_undefined, [module_class([user])]).

load_rules(Files) :-
    Files = [First|_],
    file_directory_name(First, Folder),
    asserta(user:file_search_path(rules, Folder)),
    load_files(user:Files, [imports([])]).

% The predicates that the C++ side defines at run time.
declare_foreign :-
    forall('$member'(Name/Arity,
                     [ match/4, match_in/4, graphs/1, as_written/2, label/2, number/2 ]),
           ( functor(Head, Name, Arity),
             assertz((rdf_edge:Head :- fail))
           )).
