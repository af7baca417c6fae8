:- module(prolog_test_runner, [run_plt/2]).
:- set_prolog_flag(autoload, explicit).   % what libraries declare; never what a rule forgot
:- set_prolog_flag(verbose, normal).
:- use_module(library(plunit)).
:- use_module(user:library(plunit)).
:- use_module(rules(prefixes), []).

/** <module> The Prolog half of prolog_test_runner.cc
*/

:- dynamic complaint/0.

:- multifile user:message_hook/3.
:- dynamic   user:message_hook/3.

% Any warning or error while loading or running makes the run fail; it is printed nevertheless.
user:message_hook(_, Kind, _) :-
    ( Kind == error ; Kind == warning ),
    \+ prolog_test_runner:complaint,
    assertz(prolog_test_runner:complaint),
    fail.

%!  run_plt(+File:atom, -Result) is semidet.
%
%   True when File loads cleanly and all its tests pass; there is at least one.

run_plt(File, passed) :-
    load_files(user:File, [imports([])]),
    run_tests,
    plunit:test_summary(_, Summary),
    get_dict(passed, Summary, Passed),
    Passed > 0,
    \+ complaint.
