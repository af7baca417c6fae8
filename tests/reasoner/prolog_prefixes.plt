:- module(test_prefixes, []).
:- use_module(library(plunit)).
:- use_module(rules(prefixes)).

% declared before use, in heads, bodies and facts
:- rdf_meta
    parent(r, r),
    value(r, o),
    anywhere(t),
    untouched(-, ?).

parent(lares:'Cup', lares:'PhysicalObject').
parent(Class, lares:'Thing') :- Class == 'https://w3id.org/lares#Odd'.

value(lares:width, literal('5', xsd:integer, '')).
value(lares:kind, lares:'Cup').

anywhere([f(rdf:type, _), g(X, X:y)]) :- X = rdf.
untouched(rdf:type, rdf:type).

:- begin_tests(prefixes).

test(table, Iri == 'https://w3id.org/lares#') :-
    iri_prefix(lares, Iri).
test(table_holds_five, Prefixes == [lares, owl, rdf, rdfs, xsd]) :-
    findall(Prefix, iri_prefix(Prefix, _), Found),
    msort(Found, Prefixes).
test(unknown_prefix_is_not_in_the_table, fail) :-
    iri_prefix(foaf, _).

test(heads_are_expanded, all(Parent == ['https://w3id.org/lares#PhysicalObject'])) :-
    parent('https://w3id.org/lares#Cup', Parent).
test(bodies_are_expanded, nondet) :-
    parent(lares:'Cup', lares:'PhysicalObject').
test(clauses_with_bodies_are_expanded, Super == 'https://w3id.org/lares#Thing') :-
    parent(lares:'Odd', Super).
test(nested_goals_are_expanded, [true(Found == ['https://w3id.org/lares#PhysicalObject'])]) :-
    findall(Super, ( parent(lares:'Cup', Super), \+ parent(lares:'Cup', owl:'Thing') ), Found).
test(no_other_class, fail) :-
    parent(lares:'Saucer', _).

test(datatypes_are_expanded, Datatype == 'http://www.w3.org/2001/XMLSchema#integer') :-
    value('https://w3id.org/lares#width', literal(_, Datatype, _)).
test(objects_are_expanded, Kind == 'https://w3id.org/lares#Cup') :-
    value(lares:kind, Kind).

test(whole_terms_are_expanded) :-
    clause(anywhere([f(Iri, _), g(X, Y)]), _),
    Iri == 'http://www.w3.org/1999/02/22-rdf-syntax-ns#type',
    Y = Module:y, Module == X.
test(undeclared_arguments_are_left_alone, A == rdf:type) :-
    untouched(A, _).

test(at_run_time, Iri == 'http://www.w3.org/2002/07/owl#Thing') :-
    prefixed_iri(owl:'Thing', Iri).
test(an_iri_stays, Iri == 'http://x/y') :-
    prefixed_iri('http://x/y', Iri).
test(unbound, error(instantiation_error)) :-
    prefixed_iri(_, _).
test(unbound_local_name, error(instantiation_error)) :-
    prefixed_iri(owl:_, _).
test(no_iri, error(type_error(iri, 5))) :-
    prefixed_iri(5, _).
test(unknown_prefix, error(existence_error(iri_prefix, nope))) :-
    Unknown = nope,
    prefixed_iri(Unknown:x, _).
test(unknown_prefix_stops_the_compiler, error(existence_error(iri_prefix, nope))) :-
    expand_goal(test_prefixes:parent(nope:x, _), _),
    expand_goal(parent(nope:x, _), _).

:- end_tests(prefixes).
