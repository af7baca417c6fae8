:- module(prolog_bench, [nothing/1, enumerate/1, lookups/1, objects/1]).
:- use_module(rules(rdf_view)).

% Goals of prolog_bench.cc.

nothing(done).

% All triples.
enumerate(done) :- ( rdf(_, _, _), fail ; true ).

% For each subject, one lookup of its only object.
lookups(done) :- ( rdf(S, P, _), rdf(S, P, _), fail ; true ).

% For each object, a check of the whole triple.
objects(done) :- ( rdf(S, P, O), rdf(S, P, O), fail ; true ).
