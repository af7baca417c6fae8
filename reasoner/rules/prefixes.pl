:- module(prefixes,
          [ iri_prefix/2,               % ?Prefix, ?Iri
            prefixed_iri/2,             % +Prefixed, -Iri
            (rdf_meta)/1,               % +Heads
            op(1150, fx, rdf_meta)
          ]).

/** <module> IRIs are written with prefixes

This table is the only place where rules spell out a namespace. Elsewhere an IRI is written
`lares:Cup`, and becomes the atom when the file is compiled, in the arguments that a predicate
declares so:

    :- rdf_meta
        subclass_of(r, r),
        value(r, r, o).

`r` marks an IRI, `o` an IRI or literal (of which the datatype may have a prefix), `t` any term, all
of which is expanded; every other mark leaves its argument alone. The declaration stands before the
first use, and works for the module itself (heads and bodies) and for all that import the predicate.
An unknown prefix is an error at compile time. A local name that is no Prolog atom is quoted:
`lares:'PartialOrdering-Strict'`.
*/

%!  iri_prefix(?Prefix:atom, ?Iri:atom) is nondet.
%
%   The table.

iri_prefix(rdf,   'http://www.w3.org/1999/02/22-rdf-syntax-ns#').
iri_prefix(rdfs,  'http://www.w3.org/2000/01/rdf-schema#').
iri_prefix(owl,   'http://www.w3.org/2002/07/owl#').
iri_prefix(xsd,   'http://www.w3.org/2001/XMLSchema#').
iri_prefix(lares, 'https://w3id.org/lares#').

%!  prefixed_iri(+Prefixed, -Iri:atom) is det.
%
%   Iri of `Prefix:Local`; an atom is an IRI already.
%
%   @error instantiation_error
%   @error type_error(iri, Prefixed)
%   @error existence_error(iri_prefix, Prefix)

prefixed_iri(Prefixed, Iri) :-
    nonvar(Prefixed),
    Prefixed = Prefix:Local,
    !,
    must_be_atom(Prefix, Prefixed),
    must_be_atom(Local, Prefixed),
    (   iri_prefix(Prefix, Namespace)
    ->  atom_concat(Namespace, Local, Iri)
    ;   throw(error(existence_error(iri_prefix, Prefix), _))
    ).
prefixed_iri(Atom, Iri) :-
    must_be_atom(Atom, Atom),
    Iri = Atom.

must_be_atom(Part, _) :-
    atom(Part),
    !.
must_be_atom(Part, _) :-
    var(Part),
    !,
    throw(error(instantiation_error, _)).
must_be_atom(_, Culprit) :-
    throw(error(type_error(iri, Culprit), _)).

%!  rdf_meta(+Heads) is det.
%
%   Directive: which arguments of which predicates of this module are IRIs.

rdf_meta(Heads) :-
    throw(error(context_error(nodirective, rdf_meta(Heads)), _)).

:- multifile system:term_expansion/2, system:goal_expansion/2.
:- dynamic   system:term_expansion/2, system:goal_expansion/2.

% declared(Module, Head): the marks of a predicate, Head being their template.
:- dynamic declared/2.

declare((Heads, More), Module) :-
    !,
    declare(Heads, Module),
    declare(More, Module).
declare(Head, Module) :-
    must_be_declarable(Head),
    functor(Head, Name, Arity),
    functor(General, Name, Arity),
    retractall(declared(Module, General)),
    assertz(declared(Module, Head)).

must_be_declarable(Head) :-
    compound(Head),
    !.
must_be_declarable(Head) :-
    throw(error(type_error(rdf_meta_head, Head), _)).

% marks(+Module, +Goal, -Marks): also when Module has imported the predicate.
marks(Module, Goal, Marks) :-
    functor(Goal, Name, Arity),
    functor(Marks, Name, Arity),
    (   declared(Module, Marks)
    ->  true
    ;   declared(_, Marks),
        predicate_property(Module:Goal, imported_from(Definition)),
        declared(Definition, Marks)
    ->  true
    ).

expand_arguments(Goal, Marks, Expanded) :-
    Goal =.. [Name|Arguments],
    Marks =.. [_|MarkList],
    expand_each(MarkList, Arguments, ExpandedArguments),
    Expanded =.. [Name|ExpandedArguments].

expand_each([], [], []).
expand_each([Mark|Marks], [Argument|Arguments], [Expanded|Rest]) :-
    expand_argument(Mark, Argument, Expanded),
    expand_each(Marks, Arguments, Rest).

expand_argument(r, Argument, Iri) :-
    prefixed(Argument),
    !,
    prefixed_iri(Argument, Iri).
expand_argument(o, Argument, Object) :-
    !,
    expand_object(Argument, Object).
expand_argument(t, Argument, Term) :-
    !,
    expand_term_deep(Argument, Term).
expand_argument(_, Argument, Argument).

expand_object(Argument, Iri) :-
    prefixed(Argument),
    !,
    prefixed_iri(Argument, Iri).
expand_object(Argument, literal(Lexical, Iri, Language)) :-
    nonvar(Argument),
    Argument = literal(Lexical, Datatype, Language),
    prefixed(Datatype),
    !,
    prefixed_iri(Datatype, Iri).
expand_object(Argument, Argument).

expand_term_deep(Term, Term) :-
    \+ compound(Term),
    !.
expand_term_deep(Term, Iri) :-
    prefixed(Term),
    !,
    prefixed_iri(Term, Iri).
expand_term_deep(Term, Expanded) :-
    compound_name_arguments(Term, Name, Arguments),
    expand_all_deep(Arguments, ExpandedArguments),
    compound_name_arguments(Expanded, Name, ExpandedArguments).

expand_all_deep([], []).
expand_all_deep([Argument|Arguments], [Expanded|Rest]) :-
    expand_term_deep(Argument, Expanded),
    expand_all_deep(Arguments, Rest).

% Both sides known: a variable that is a module or a local name is none of ours.
prefixed(Term) :-
    nonvar(Term),
    Term = Prefix:Local,
    atom(Prefix),
    atom(Local).

expand_head(Module, Head, Expanded) :-
    callable(Head),
    marks(Module, Head, Marks),
    expand_arguments(Head, Marks, Expanded),
    Expanded \== Head.

expand_clause(Module, (Head :- Body), (Expanded :- Body)) :-
    !,
    expand_head(Module, Head, Expanded).
expand_clause(Module, Head, Expanded) :-
    expand_head(Module, Head, Expanded).

system:term_expansion((:- rdf_meta(Heads)), []) :-
    prolog_load_context(module, Module),
    prefixes:declare(Heads, Module).
system:term_expansion(Clause, Expanded) :-
    prolog_load_context(module, Module),
    prefixes:expand_clause(Module, Clause, Expanded).

system:goal_expansion(Goal, Expanded) :-
    compound(Goal),
    prolog_load_context(module, Module),
    prefixes:expand_head(Module, Goal, Expanded).
