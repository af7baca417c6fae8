:- module(test_rdf_view, []).
:- use_module(library(plunit)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).

:- begin_tests(rdf_view).

test(one_triple) :-
    rdf('http://x/cup', 'http://x/in', 'http://x/kitchen').
test(no_such_triple, fail) :-
    rdf('http://x/cup', 'http://x/in', 'http://x/bath').
test(all_answers, set(Place == ['http://x/house', 'http://x/kitchen'])) :-
    rdf('http://x/cup', 'http://x/in', Place).
test(a_full_match_is_deterministic, true) :-
    rdf('http://x/cup', 'http://x/in', 'http://x/kitchen').
test(a_single_answer_is_deterministic, S == 'http://x/cup') :-
    rdf(S, 'http://x/size', _).
test(prefixes, Class == 'https://w3id.org/lares#Cup') :-
    rdf('http://x/cup', rdf:type, Class).
test(prefixed_object, S == 'http://x/cup') :-
    rdf(S, rdf:type, lares:'Cup').
test(literal, Size == literal('5', 'http://www.w3.org/2001/XMLSchema#integer', '')) :-
    rdf('http://x/cup', 'http://x/size', Size).
test(literal_with_prefixed_datatype, S == 'http://x/cup') :-
    rdf(S, _, literal('5', xsd:integer, '')).
test(language, Name-Language == 'Tasse'-de) :-
    rdf('http://x/cup', 'http://x/name', literal(Name, _, Language)).
test(blank_node, all(P == ['http://x/in'])) :-
    rdf(Blank, _, 'http://x/kitchen'),
    sub_atom(Blank, 0, _, _, '_:'),
    rdf(Blank, P, 'http://x/kitchen').
test(join, all(Other == ['http://x/plate'])) :-
    rdf('http://x/cup', 'http://x/in', Place),
    rdf(Other, 'http://x/in', Place),
    Other \== 'http://x/cup',
    \+ sub_atom(Other, 0, _, _, '_:').
test(wrong_type, error(type_error(rdf_term, 123))) :-
    rdf(123, _, _).
test(wrong_predicate, error(type_error(rdf_term, "p"))) :-
    rdf(_, "p", _).

test(asserted, all(Place == ['http://x/kitchen'])) :-
    rdf_asserted('http://x/cup', 'http://x/in', Place).
test(not_asserted, fail) :-
    rdf_asserted('http://x/cup', 'http://x/in', 'http://x/house').

test(in_graph, all(S == ['http://x/plate'])) :-
    rdf_in(S, 'http://x/in', _, more),
    \+ sub_atom(S, 0, _, _, '_:').
test(in_graph_by_subject, all(P-O == ['http://x/in'-'http://x/kitchen'])) :-
    rdf_in('http://x/plate', P, O, more).
test(not_in_graph, fail) :-
    rdf_in('http://x/plate', _, _, room).
test(no_such_graph, fail) :-
    rdf_in(_, _, _, attic).
test(in_which_graph, error(instantiation_error)) :-
    rdf_in(_, _, _, _).
test(graphs, all(G == [room, more])) :-
    rdf_graph(G).
test(no_graph_of_that_name, fail) :-
    rdf_graph(attic).

test(number, N == 5) :-
    rdf('http://x/cup', 'http://x/size', Size),
    rdf_number(Size, N).
test(no_number, fail) :-
    rdf('http://x/cup', 'http://x/name', Name),
    rdf_number(Name, _).
test(number_of_nothing, error(instantiation_error)) :-
    rdf_number(_, _).
test(label, Label == 'Cup') :-
    rdf_label(lares:'Cup', Label).
test(label_of_nothing, error(instantiation_error)) :-
    rdf_label(_, _).
test(as_written, Iri == 'https://w3id.org/lares#Cup') :-
    rdf_as_written(lares:'Cup', Iri).
test(as_written_of_nothing, error(instantiation_error)) :-
    rdf_as_written(_, _).
test(equal, Iri == 'http://www.w3.org/2002/07/owl#Thing') :-
    rdf_equal(Iri, owl:'Thing').

:- end_tests(rdf_view).
