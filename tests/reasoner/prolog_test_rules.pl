:- module(prolog_test_rules,
          [ echo/2, yes/2, no/2, none/1, count/2, loop/1, loop_stubbornly/1, loop_over_triples/1, loop_over_lookups/1,
            loop_over_builtin/1, long_list/1, deep/2, throw_term/2, throw_text/3, odd/2, triple/2,
            subjects/3, asserted/2, in_graph/3, graphs/1, number_of/2, label_of/2, written_of/2,
            first_triple/1, throw_after_triple/1, partial/2, sum_of_triples/1, same_term/1,
            raw/2, wait_then_count/2, same_both_ends/1, literal_with/4, unknown_predicate/1,
            print_and_throw/1, complain/1
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).

% Rules for the tests of the edge only.

echo(Value, Value).
yes(_, yes).
no(_, _) :- fail.
none(_) :- fail.
count(To, N) :- between(1, To, N).

loop(X) :- loop(X).

loop_stubbornly(X) :- catch(loop(X), _, true), loop_stubbornly(X).

loop_over_triples(_) :- repeat, rdf(_, _, _), fail.

loop_over_lookups(_) :- repeat, rdf(S, _, _), rdf(_, _, S), fail.

loop_over_builtin(_) :- between(1, inf, X), X < 0.

long_list(List) :- long_list_(0, List).

long_list_(N, [N|Rest]) :- succ(N, Next), long_list_(Next, Rest).

deep(0, end) :- !.
deep(N, f(Rest)) :- M is N - 1, deep(M, Rest).

throw_term(Term, _) :- throw(Term).
throw_text(Code, Message, _) :- throw(lares_error(Code, Message)).
unknown_predicate(_) :- call(never_written).

print_and_throw(_) :- atom_length(_, _).

complain(survived) :- print_message(error, format("an error that a rule prints", [])).

odd(variable, _).
odd(nested_variable, [_]).
odd(big, X) :- X is 2 ** 70.
odd(edge, X) :- X is 2 ** 63 - 1.
odd(rational, X) :- X = 1r3.
odd(cyclic, X) :- X = f(X).
odd(cyclic_list, X) :- X = [1|X].
odd(partial_list, [1|_]).
odd(improper_list, [1|2]).
odd(stream, X) :- current_output(X).
odd(numbered_dict, _{1: a}).
odd(wide, X) :- wide(40, X).
odd(zero_arity, X) :- compound_name_arguments(X, f, []).
odd(empty_atom, '').
odd(not_quite_empty_list, '[]').
odd(nul, X) :- atom_codes(X, [0'a, 0, 0'b]).

wide(0, x) :- !.
wide(N, f(X, X)) :- M is N - 1, wide(M, X).

triple(t(S, P, O), t(S, P, O)) :- rdf(S, P, O).

subjects(Predicate, Object, Subject) :- rdf(Subject, Predicate, Object).
asserted(S, t(P, O)) :- rdf_asserted(S, P, O).
in_graph(Graph, Subject, t(P, O)) :-
    ( Subject == any -> true ; S = Subject ),
    rdf_in(S, P, O, Graph).
graphs(Graphs) :- findall(Graph, rdf_graph(Graph), Graphs).
number_of(Literal, Number) :- rdf_number(Literal, Number).
label_of(Term, Label) :- rdf_label(Term, Label).
written_of(Iri, Written) :- rdf_as_written(Iri, Written).

first_triple(S) :- rdf(S, _, _), !.
throw_after_triple(_) :- rdf(_, _, _), throw(stop).
partial(N, Found) :- findnsols(N, S, rdf(S, _, _), Found), !.
sum_of_triples(N) :- findall(x, rdf(_, _, _), Xs), length(Xs, N).
same_both_ends(S) :- rdf(S, _, S).
literal_with(Lexical, Datatype, Language, t(L, D, Tag)) :-
    unless_any(Lexical, L), unless_any(Datatype, D), unless_any(Language, Tag),
    rdf(_, _, literal(L, D, Tag)).

unless_any(any, _) :- !.
unless_any(Value, Value).

% The prefix is expanded here and in the test compared with the full IRI.
same_term(Iri) :- rdf_equal(Iri, rdfs:subClassOf).

raw(Term, found) :- rdf(Term, _, _).

wait_then_count(Rounds, Counts) :-
    findall(N, (between(1, Rounds, _), sum_of_triples(N)), All),
    sort(All, Counts).
