:- module(expert,
          [ expert_goal/3,              % +Text, -Goal, -Bindings
            expert_goal_unproved/3,     % +Text, -Goal, -Bindings
            expert_error/5              % +Exception, -Kind, -Text, -Line, -Column
          ]).
:- use_module(library(error)).
:- use_module(library(lists)).
:- use_module(library(sandbox)).
:- use_module(rules(edge)).
:- use_module(rules(rdf_view)).
:- use_module(rules(prefixes)).
:- use_module(rules(expert_words)).

/** <module> Goals that an expert writes

A goal is text; it is read, its prefixes are expanded, and it is proved to change and to reach
nothing before it is called. The proof is for good messages: what keeps others safe is the process
that the goal runs in.
*/

:- multifile sandbox:safe_primitive/1.

sandbox:safe_primitive(rdf_view:rdf(_, _, _)).
sandbox:safe_primitive(rdf_view:rdf_asserted(_, _, _)).
sandbox:safe_primitive(rdf_view:rdf_in(_, _, _, _)).
sandbox:safe_primitive(rdf_view:rdf_graph(_)).
sandbox:safe_primitive(rdf_view:rdf_as_written(_, _)).
sandbox:safe_primitive(rdf_view:rdf_label(_, _)).
sandbox:safe_primitive(rdf_view:rdf_number(_, _)).
sandbox:safe_primitive(rdf_view:rdf_equal(_, _)).
sandbox:safe_primitive(error:must_be(_, _)).
sandbox:safe_primitive(error:is_of_type(_, _)).
sandbox:safe_primitive(prefixes:iri_prefix(_, _)).
sandbox:safe_primitive(prefixes:prefixed_iri(_, _)).

%!  expert_goal(+Text:string, -Goal, -Bindings:list) is det.
%
%   Goal, qualified and ready to be called, and its named variables as Name=Variable; a variable
%   whose name begins with '_' is left out. Text is one goal, with or without `?-` and the full
%   stop.
%
%   @error syntax_error(_)
%   @error permission_error(call, read_only, Name/Arity) for what would change the knowledge base
%   @error permission_error(call, sandboxed, Goal) for what reaches out of Prolog

expert_goal(Text, Goal, Bindings) :-
    expert_goal_unproved(Text, Goal, Bindings),
    Goal = Module:Plain,
    refuse_changes(Plain, Module),
    safe_goal(Goal).

%!  expert_goal_unproved(+Text:string, -Goal, -Bindings:list) is det.
%
%   The same without the proof: for tests of what stands behind it.

expert_goal_unproved(Text, expert_words:Goal, Bindings) :-
    read_goal(Text, Read, Named),
    without_prompt(Read, Plain),
    include_named(Named, Bindings),
    must_be_callable(Plain),
    expand_in_words(Plain, Goal).

% A goal may do without the full stop.
read_goal(Text, Goal, Named) :-
    catch(read_text(Text, Goal, Named), Error, true),
    (   var(Error)
    ->  true
    ;   subsumes_term(error(syntax_error(end_of_file), _), Error)
    ->  string_concat(Text, "\n.", Stopped),
        read_text(Stopped, Goal, Named)
    ;   throw(Error)
    ).

read_text(Text, Goal, Named) :-
    setup_call_cleanup(
        open_string(Text, Stream),
        ( read_term(Stream, Goal, [variable_names(Named), module(expert_words)]),
          must_be_all(Goal, Stream)
        ),
        close(Stream)).

must_be_all(Goal, _) :-
    Goal == end_of_file,
    !,
    throw(error(syntax_error(no_goal), _)).
must_be_all(_, Stream) :-
    line_count(Stream, Line),
    line_position(Stream, Column),
    character_count(Stream, Characters),
    read_term(Stream, Next, [module(expert_words)]),
    (   Next == end_of_file
    ->  true
    ;   throw(error(syntax_error(one_goal_at_a_time), stream(Stream, Line, Column, Characters)))
    ).

without_prompt(Goal, Goal) :- var(Goal), !.
without_prompt((?- Goal), Goal) :- !.
without_prompt(Goal, Goal).

include_named([], []).
include_named([Name=_|Named], Bindings) :-
    sub_atom(Name, 0, 1, _, '_'),
    !,
    include_named(Named, Bindings).
include_named([Binding|Named], [Binding|Bindings]) :-
    include_named(Named, Bindings).

must_be_callable(Goal) :- callable(Goal), !.
must_be_callable(Goal) :- var(Goal), !, throw(error(instantiation_error, _)).
must_be_callable(Goal) :- throw(error(type_error(callable, Goal), _)).

% Prefixes are expanded as in a rule of the module whose words the goal may use.
expand_in_words(Goal, Expanded) :-
    setup_call_cleanup(
        '$set_source_module'(Old, expert_words),
        expand_goal(Goal, Expanded),
        '$set_source_module'(Old)).

% ---- Read-only ----------------------------------------------------------------------------------

% The sandbox would let a goal assert into its own module.
refuse_changes(Goal, _) :-
    var(Goal),
    !.
refuse_changes(Module:Goal, _) :-
    atom(Module),
    !,
    refuse_changes(Goal, Module),
    refuse_inner(Module, Goal).
refuse_changes(Goal, _) :-
    callable(Goal),
    functor(Goal, Name, Arity),
    changes(Name, Arity),
    !,
    throw(error(permission_error(call, read_only, Name/Arity), _)).
refuse_changes(Goal, Module) :-
    compound(Goal),
    predicate_property(Module:Goal, meta_predicate(Marks)),
    !,
    Goal =.. [_|Arguments],
    Marks =.. [_|MarkList],
    refuse_inside(MarkList, Arguments, Module).
refuse_changes(_, _).

% What a module keeps to itself is nobody's to call.
refuse_inner(Module, Goal) :-
    callable(Goal),
    Module \== expert_words,
    Module \== system,
    \+ predicate_property(expert_words:Goal, imported_from(Module)),
    !,
    throw(error(permission_error(call, sandboxed, Module:Goal), _)).
refuse_inner(_, _).

refuse_inside([], [], _).
refuse_inside([Mark|Marks], [Argument|Arguments], Module) :-
    refuse_argument(Mark, Argument, Module),
    refuse_inside(Marks, Arguments, Module).

refuse_argument(^, Argument, Module) :- !, strip_carets(Argument, Goal),
    refuse_changes(Goal, Module).
refuse_argument(Extra, Closure, Module) :-
    integer(Extra),
    callable(Closure),
    strip_module(Module:Closure, To, Plain),
    callable(Plain),
    !,
    length(More, Extra),
    Plain =.. Parts,
    append(Parts, More, All),
    Goal =.. All,
    refuse_changes(Goal, To).
refuse_argument(_, _, _).

strip_carets(Goal, Goal) :- var(Goal), !.
strip_carets(_^Goal, Stripped) :- !, strip_carets(Goal, Stripped).
strip_carets(Goal, Goal).

changes(Name, _) :-
    memberchk(Name, [ assert, asserta, assertz, retract, retractall, abolish, erase, dynamic,
                      recorda, recordz, recorded, set_prolog_flag, create_prolog_flag, op,
                      consult, load_files, use_module, ensure_loaded, make, tnot, table,
                      nb_setval, flag, halt, prolog, abort, break ]).

% ---- Errors -------------------------------------------------------------------------------------

%!  expert_error(+Exception, -Kind:atom, -Text:string, -Line:integer, -Column:integer) is det.
%
%   What went wrong, for programs and for people. Line and Column count from 1; 0 when not known.

expert_error(Exception, Kind, Text, Line, Column) :-
    error_kind(Exception, Kind),
    error_words(Exception, Text),
    (   error_position(Exception, Line, Column)
    ->  true
    ;   Line = 0, Column = 0
    ).

error_kind(Exception, thrown) :- var(Exception), !.
error_kind(error(Formal, Context), memory) :- without_memory(Formal, Context), !.
error_kind(error(Formal, _), Kind) :- nonvar(Formal), formal_kind(Formal, Kind), !.
error_kind(_, thrown).

% A text that outgrows the memory is told as a fault of the stream that it was written to.
without_memory(Formal, Context) :-
    nonvar(Formal),
    Formal = io_error(_, _),
    nonvar(Context),
    Context = context(_, Message),
    ( atom(Message) ; string(Message) ),
    !,
    sub_string(Message, _, _, _, "allocate memory").

formal_kind(syntax_error(_), syntax).
formal_kind(permission_error(call, sandboxed, _), refused).
formal_kind(permission_error(call, read_only, _), refused).
formal_kind(permission_error(_, _, _), refused).
formal_kind(instantiation_error, unbound).
formal_kind(type_error(_, _), type).
formal_kind(domain_error(_, _), domain).
formal_kind(existence_error(_, _), existence).
formal_kind(evaluation_error(_), evaluation).
formal_kind(representation_error(_), evaluation).
formal_kind(resource_error(_), memory).
formal_kind(system_error(_), refused).

error_words(Exception, Text) :-
    nonvar(Exception),
    Exception = error(Formal, Context),
    nonvar(Formal),
    own_words(Formal, Context, Text),
    !.
error_words(Exception, Text) :-
    catch(without_position(Exception, Plain), _, fail),
    edge:error_text(Plain, Text).

own_words(Formal, Context, "the goal needs more memory than it may have") :-
    without_memory(Formal, Context).
own_words(permission_error(call, read_only, Indicator), _, Text) :-
    format(string(Text), "~q would change something: goals only ask", [Indicator]).
own_words(permission_error(call, sandboxed, Goal), _, Text) :-
    strip_module(Goal, _, Plain),
    callable(Plain),
    functor(Plain, Name, Arity),
    format(string(Text), "~q reaches out of Prolog, which goals may not", [Name/Arity]).
own_words(instantiation_error, Context, Text) :-
    nonvar(Context),
    Context = sandbox(_, _),
    Text = "what is called must be known before the goal runs: here it is a variable".
own_words(existence_error(procedure, Procedure), _, Text) :-
    nonvar(Procedure),
    strip_module(Procedure, _, Plain),
    callable(Plain),
    (   Plain = Name/Arity
    ->  true
    ;   functor(Plain, Name, Arity)
    ),
    format(string(Text), "there is no predicate ~q", [Name/Arity]).
own_words(syntax_error(no_goal), _, "there is no goal in the text").
own_words(syntax_error(one_goal_at_a_time), _, "there is more text after the goal's full stop").

without_position(error(Formal, Context), error(Formal, _)) :-
    nonvar(Formal),
    Formal = syntax_error(_),
    nonvar(Context),
    !.
without_position(Exception, Exception).

error_position(error(syntax_error(_), Context), Line, Column) :-
    nonvar(Context),
    Context = stream(_, Line, Position, _),
    integer(Line),
    integer(Position),
    Column is Position + 1.
