% SWI-Prolog's rdf_db on an N-Triples file: seconds to load it, seconds to match each of its triples
% by subject and predicate and by subject and object, and the answers found. The medians of five.
:- use_module(library(semweb/rdf_db)).
:- use_module(library(semweb/rdf_ntriples)).

:- initialization(main, main).

main([File]) :-
    findall(Load-Match-Found, (between(1, 5, _), run(File, Load, Match, Found)), Runs),
    findall(Load, member(Load-_-_, Runs), Loads),
    findall(Match, member(_-Match-_, Runs), Matches),
    median(Loads, Load),
    median(Matches, Match),
    Runs = [_-_-Found|_],
    format("~6f ~6f ~d~n", [Load, Match, Found]).

run(File, Load, Match, Found) :-
    rdf_reset_db,
    seconds(rdf_load(File, [format(ntriples), silent(true), register_namespaces(false)]), Load),
    findall(rdf(S, P, O), rdf(S, P, O), Triples),
    seconds(count(Triples, Found), Match).

seconds(Goal, Seconds) :-
    get_time(Begin),
    call(Goal),
    get_time(End),
    Seconds is End - Begin.

count(Triples, Found) :-
    Counter = count(0),
    (   member(rdf(S, P, O), Triples),
        (   rdf(S, P, _) ; rdf(S, _, O) ),
        arg(1, Counter, Before),
        After is Before + 1,
        nb_setarg(1, Counter, After),
        fail
    ;   arg(1, Counter, Found)
    ).

median(List, Median) :-
    msort(List, Sorted),
    length(Sorted, Length),
    Middle is Length // 2,
    nth0(Middle, Sorted, Median).
