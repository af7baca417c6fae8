:- module(repair, [smallest_repair/3]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(availability)).

/** <module> The least that would have to be added to a robot

Every requirement has alternatives, each a set of components and bare capabilities; requirements are
joined by taking one alternative of each. A thing covers what is above it: who adds a ColorCamera
has added a Camera. Sets that contain another alternative are dropped at once.
*/

% Beyond this many alternatives the larger ones are dropped.
max_alternatives(256).

%!  smallest_repair(+Context, +Wanted:list, -Repair:ordset) is det.
%
%   A smallest set that makes all of Wanted available; of equally small ones the first.

smallest_repair(Context, Wanted, Repair) :-
    join(Context, [], Wanted, [Repair|_]).

join(_, _, [], [[]]).
join(Context, Stack, [Requirement|Rest], Sets) :-
    alternatives(Context, Stack, Requirement, Some),
    join(Context, Stack, Rest, Others),
    findall(Set,
            ( member(A, Some),
              member(B, Others),
              append(A, B, Both),
              most_specific(Both, Set) ),
            Found),
    smallest_first(Found, Sets).

alternatives(Context, Stack, any(Members), Sets) :-
    !,
    findall(Set,
            ( member(Member, Members),
              alternatives(Context, Stack, Member, Inner),
              member(Set, Inner) ),
            Found),
    smallest_first(Found, Sets).
alternatives(_, Stack, What, [[]]) :-
    memberchk(What, Stack),
    !.
alternatives(Context, _, What, [[]]) :-
    evaluate(Context, What, Finding),
    get_dict(availability, Finding, Availability),
    memberchk(Availability, [available, on_makers_word]),
    !.
alternatives(Context, Stack, What, Sets) :-
    subclass(What, 'https://w3id.org/lares#Capability'),
    !,
    dependencies(What, Requirements),
    capability_alternatives(Requirements, Context, Stack, What, Found),
    smallest_first(Found, Sets).
alternatives(Context, Stack, What, Sets) :-
    dependencies(What, Requirements),
    join(Context, [What|Stack], Requirements, Inner),
    findall(Set, (member(Rest, Inner), most_specific([What|Rest], Set)), Found),
    smallest_first(Found, Sets).

% A bare capability is added itself, or by what a special case of it rests on.
capability_alternatives([], Context, Stack, What, [[What]|Through]) :-
    !,
    findall(Sub,
            ( rdf(Sub, rdfs:subClassOf, What), Sub \== What, named(Sub),
              \+ subclass(What, Sub), \+ memberchk(Sub, Stack), dependencies(Sub, [_|_]) ),
            Found),
    sort(Found, Below),
    findall(Set,
            ( member(Sub, Below),
              alternatives(Context, [What|Stack], Sub, Sets),
              member(Set, Sets) ),
            Through).
capability_alternatives(Requirements, Context, Stack, What, Sets) :-
    join(Context, [What|Stack], Requirements, Joined),
    (   Joined = [[]|_]
    ->  Sets = [[What]]
    ;   Sets = Joined
    ).

smallest_first(Sets, Kept) :-
    findall(Size-Set, (member(Set, Sets), length(Set, Size)), Sized),
    keysort(Sized, Sorted),
    findall(Set, member(_-Set, Sorted), InOrder),
    minimal(InOrder, [], Minimal),
    max_alternatives(Max),
    shortened(Minimal, Max, Kept).

minimal([], Kept, InOrder) :-
    reverse(Kept, InOrder).
minimal([Set|Sets], Kept, InOrder) :-
    (   member(Smaller, Kept), subset(Smaller, Set)
    ->  minimal(Sets, Kept, InOrder)
    ;   minimal(Sets, [Set|Kept], InOrder)
    ).

shortened(Sets, Max, Kept) :-
    length(Sets, Length),
    (   Length =< Max
    ->  Kept = Sets
    ;   length(Kept, Max),
        append(Kept, _, Sets)
    ).
