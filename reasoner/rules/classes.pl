:- module(classes,
          [ subclass/2,
            named/1,
            is_class/1,
            named_supers/2,
            restriction/4,
            most_specific/2,
            interval/3,
            rada_distance/3,
            class_chain/3,
            fillers/2,
            list_member/2
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).

/** <module> The class hierarchy as questions about the closure

All of these ask rdf/3 with at least one bound argument. Blank nodes, owl:Thing and the
like are classes for OWL but not for people: named_supers/2 and the distances leave them out.
*/

:- rdf_meta
    subclass(r, r),
    restriction(r, r, -, -),
    is_class(r),
    rada_distance(r, r, -),
    class_chain(r, r, -),
    interval(r, r, -).

%!  subclass(+Class, +Super) is semidet.
%
%   Class is Super or below it.

subclass(Class, Class) :- !.
subclass(Class, Super) :-
    rdf(Class, rdfs:subClassOf, Super),
    !.

%!  named(+Resource) is semidet.
%
%   True of an IRI that people would call a class: no blank node, no literal, not owl:Thing.

named(Resource) :-
    atom(Resource),
    \+ sub_atom(Resource, 0, _, _, '_:'),
    \+ rdf_equal(Resource, owl:'Thing'),
    \+ rdf_equal(Resource, rdfs:'Resource'),
    \+ rdf_equal(Resource, owl:'NamedIndividual').

%!  is_class(+Resource) is semidet.

is_class(Resource) :- rdf(Resource, rdf:type, owl:'Class'), !.
is_class(Resource) :- rdf(Resource, rdfs:subClassOf, _), !.
is_class(Resource) :- rdf(_, rdfs:subClassOf, Resource), !.

%!  named_supers(+Class, -Supers:ordset) is det.
%
%   The named classes strictly above Class; those equivalent to it are left out.

named_supers(Class, Supers) :-
    findall(Super,
            ( rdf(Class, rdfs:subClassOf, Super),
              Super \== Class,
              named(Super),
              \+ rdf(Super, rdfs:subClassOf, Class) ),
            Found),
    sort(Found, Supers).

%!  restriction(+Class, ?Property, -Quantifier, -Value) is nondet.
%
%   Class is below the restriction of Property to Value; Quantifier is `some` or `value`.

restriction(Class, Property, Quantifier, Value) :-
    rdf(Class, rdfs:subClassOf, Node),
    rdf(Node, owl:onProperty, Property),
    quantified(Node, Quantifier, Value).
restriction(Class, Property, Quantifier, Value) :-
    rdf(Class, owl:onProperty, Property),
    \+ rdf(Class, rdfs:subClassOf, Class),
    quantified(Class, Quantifier, Value).

quantified(Node, some, Value) :- rdf(Node, owl:someValuesFrom, Value).
quantified(Node, value, Value) :- rdf(Node, owl:hasValue, Value).

%!  most_specific(+Classes:list, -Kept:ordset) is det.
%
%   Classes without those that are above another one of them. Of equivalent ones the first in the
%   standard order stays.

most_specific(Classes, Kept) :-
    sort(Classes, Sorted),
    exclude(covered(Sorted), Sorted, Kept).

covered(Classes, Class) :-
    member(Other, Classes),
    Other \== Class,
    subclass(Other, Class),
    (   subclass(Class, Other)
    ->  Other @< Class
    ;   true
    ),
    !.

%!  interval(+Class, +Super, -Between:ordset) is det.
%
%   The named classes strictly above Class and at or below Super, one for each set of equivalent
%   ones.

interval(Class, Super, Between) :-
    named_supers(Class, Supers),
    findall(Middle, (member(Middle, Supers), subclass(Middle, Super)), Found),
    exclude(has_equivalent_before(Found, Super), Found, Between).

has_equivalent_before(Classes, Super, Class) :-
    Class \== Super,
    member(Other, Classes),
    Other \== Class,
    subclass(Other, Class),
    subclass(Class, Other),
    ( Other == Super -> true ; Other @< Class ),
    !.

%!  rada_distance(+Class, +Super, -Distance:integer) is semidet.
%
%   The number of edges between Class and Super in the transitive reduction of the hierarchy of
%   named classes (Rada et al. 1989), 0 when they are equivalent. Fails when Super is not above.

rada_distance(Class, Super, Distance) :-
    shortest_chain(Class, Super, Chain),
    length(Chain, Length),
    Distance is Length - 1.

%!  class_chain(+Class, +Super, -Chain:list) is semidet.
%
%   A shortest path upwards, both ends included.

class_chain(Class, Super, Chain) :-
    shortest_chain(Class, Super, Chain).

shortest_chain(Class, Super, [Class]) :-
    subclass(Class, Super),
    ( Class == Super -> true ; subclass(Super, Class) ),
    !.
shortest_chain(Class, Super, Chain) :-
    subclass(Class, Super),
    interval(Class, Super, Between),
    search([[Class]], [Class], Super, Between, Reversed),
    !,
    reverse(Reversed, Chain).

search([[Super|Path]|_], _, Super, _, [Super|Path]) :- !.
search([[Node|Path]|Queue], Seen, Super, Between, Found) :-
    include(below(Node), Between, Above),
    exclude(has_between(Above), Above, Parents),
    subtract(Parents, Seen, New),
    findall([Parent, Node|Path], member(Parent, New), Paths),
    append(Queue, Paths, Longer),
    append(New, Seen, Seen1),
    search(Longer, Seen1, Super, Between, Found).

below(Node, Class) :- Node \== Class, subclass(Node, Class).

has_between(Classes, Class) :-
    member(Other, Classes),
    Other \== Class,
    subclass(Other, Class),
    !.

%!  list_member(+List, -Item) is nondet.
%
%   The members of an RDF list; one that bites its own tail ends there.

list_member(List, Item) :- list_member(List, Item, []).

list_member(List, Item, Seen) :-
    \+ memberchk(List, Seen),
    rdf_asserted(List, rdf:first, First),
    !,
    (   Item = First
    ;   rdf_asserted(List, rdf:rest, Rest),
        list_member(Rest, Item, [List|Seen])
    ).

%!  fillers(+Value, -Required:list) is det.
%
%   What a restriction's value asks for: named classes as themselves, `any(Classes)` for a union,
%   the named members of an intersection, the most specific named types of an individual.

fillers(Value, [any(Members)]) :-
    \+ named(Value),
    rdf(Value, owl:unionOf, List),
    !,
    findall(Member, (list_member(List, Item), fillers(Item, Inner), member(Member, Inner),
                     atom(Member)), Found),
    sort(Found, Members).
fillers(Value, Members) :-
    \+ named(Value),
    rdf(Value, owl:intersectionOf, List),
    !,
    findall(Member, (list_member(List, Item), named(Item), Member = Item), Found),
    sort(Found, Members).
fillers(Value, [Value]) :-
    named(Value),
    is_class(Value),
    !.
fillers(Value, Types) :-
    named(Value),
    findall(Type, (rdf(Value, rdf:type, Type), named(Type)), Found),
    Found \== [],
    !,
    most_specific(Found, Types).
fillers(Value, [Value]) :-
    named(Value),
    !.
fillers(_, []).
