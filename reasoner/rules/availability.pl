:- module(availability,
          [ available/3,
            availability_of/3,
            dependency_restriction/2,
            dependencies/2,
            has_component/2,
            component/2,
            special_case/2,
            is_capability/1
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(requirements)).

/** <module> What classes depend on, and whether a robot has one thing

A context is `context(Robot, Claims, Strict)`: Claims are the capabilities that the description
claims, and the classes of components that are not the robot's but can be fetched for it.

Whole tasks are matched in C++ (recipes/match), over what needs/3 (matching.pl) says; available/3 is
for single conditions, as those of skill templates, and gives the same verdict
(tests/recipes/match_property_test.cc).
*/

:- rdf_meta dependency_property(r).

dependency_property(Property) :- rdf_equal(Property, lares:dependsOnCapability).
dependency_property(Property) :- rdf_equal(Property, lares:dependsOnComponent).
dependency_property(Property) :- rdf_equal(Property, lares:dependsOn).

%!  dependency_restriction(+Class, -Value) is nondet.

dependency_restriction(Class, Value) :-
    rdf(Class, rdfs:subClassOf, Node),
    \+ named(Node),
    rdf(Node, owl:onProperty, Property),
    dependency_property(Property),
    ( rdf(Node, owl:someValuesFrom, Value) ; rdf(Node, owl:hasValue, Value) ).

%!  dependencies(+Class, -Requirements:list) is det.
%
%   What Class needs, own and inherited, the most specific only: classes and any(Classes).

dependencies(Class, Requirements) :-
    findall(Filler,
            ( dependency_restriction(Class, Value),
              fillers(Value, Fillers),
              member(Filler, Fillers) ),
            Found),
    sort(Found, Distinct),
    findall(Named, (member(Named, Distinct), atom(Named), Named \== Class), Plain),
    most_specific(Plain, Specific),
    findall(any(Members),
            ( member(any(Members), Distinct),
              Members \== [],
              \+ ( member(Member, Members), member(One, Specific), subclass(One, Member) ) ),
            Unions),
    append(Specific, Unions, Requirements).

%!  has_component(+Robot, +Class) is semidet.

has_component(Robot, Class) :- component(Robot-Class, _), !.

%!  component(+RobotClass, -Part) is nondet.

component(Robot-Class, Part) :-
    rdf(Part, rdf:type, Class),
    rdf(Robot, lares:subComponent, Part).

%!  is_capability(+Class) is semidet.

is_capability(Class) :- subclass(Class, 'https://w3id.org/lares#Capability').

%!  available(+Context, +Stated:list, +Requirement) is semidet.
%
%   The robot has the capability or component Requirement, or one of any(Classes); Stated is what
%   stated_requirements/2 says of it.

available(Context, Stated, Requirement) :-
    proof(Requirement, Context, Stated, [], _, _),
    !.

%!  availability_of(+Context, +Requirement, -Answer:oneof([true,false])) is det.

availability_of(Context, Requirement, Answer) :-
    Context = context(Robot, _, _),
    stated_requirements(Robot, Stated),
    ( available(Context, Stated, Requirement) -> Answer = true ; Answer = false ).

% proof(+Requirement, +Context, +Stated, +Above, -Grounded, -Reach)
%
% Above are the things being asked for, the last first. A circle asks for nothing more than what is
% being asked already, and Reach is the least position in Above that the proof leads back to. What
% rests on nothing but its own circle is not there: Grounded tells whether anything that the robot
% really has, or claims, was met on the way.

proof(any(Members), Context, Stated, Above, Grounded, Reach) :-
    !,
    member(Member, Members),
    proof(Member, Context, Stated, Above, Grounded, Reach).
proof(What, _, _, Above, false, Reach) :-
    nth1(Back, Above, What),
    !,
    length(Above, Length),
    Reach is Length - Back + 1.
proof(What, Context, Stated, Above, Grounded, Reach) :-
    (   is_capability(What)
    ->  capability(What, Context, Stated, Above, Grounded, Reach)
    ;   part(What, Context, Stated, Above, Grounded, Reach)
    ).

part(What, Context, Stated, _, true, Nowhere) :-
    nowhere(Nowhere),
    Context = context(Robot, _, _),
    has_component(Robot, What),
    none_insufficient(Context, Stated, What).
part(What, Context, Stated, Above, true, Reach) :-
    Context = context(_, Claims, _),
    claimed(Claims, What),
    requirement_groups(Stated, What, Groups),
    \+ ( member(Group, Groups), \+ group_holds(Context, Group) ),
    dependencies(What, Requirements),
    proofs(Requirements, Context, Stated, [What|Above], _, Reach).

capability(What, Context, Stated, _, true, Nowhere) :-
    nowhere(Nowhere),
    Context = context(_, Claims, Strict),
    claimed(Claims, What),
    ( Strict == false -> true ; dependencies(What, []) ),
    (   Strict == false
    ->  none_insufficient(Context, Stated, What)
    ;   requirement_groups(Stated, What, Groups),
        \+ ( member(Group, Groups), \+ group_holds(Context, Group) )
    ),
    !.
capability(What, Context, Stated, Above, Grounded, Reach) :-
    Context = context(_, Claims, _),
    requirement_groups(Stated, What, Groups),
    \+ ( member(Group, Groups), \+ group_holds(Context, Group) ),
    dependencies(What, Requirements),
    (   Requirements == []
    ->  special_case(What, Sub),
        Needed = [Sub]
    ;   Needed = Requirements
    ),
    proofs(Needed, Context, Stated, [What|Above], Inner, Reach),
    (   ( claimed(Claims, What) ; Groups \== [] )
    ->  Grounded = true
    ;   Grounded = Inner
    ),
    length(Above, Depth),
    \+ ( Grounded == false, Reach > Depth ).

proofs([], _, _, _, false, Nowhere) :-
    nowhere(Nowhere).
proofs([Requirement|Rest], Context, Stated, Above, Grounded, Reach) :-
    proof(Requirement, Context, Stated, Above, First, FirstReach),
    proofs(Rest, Context, Stated, Above, Others, OthersReach),
    ( First == true -> Grounded = true ; Grounded = Others ),
    Reach is min(FirstReach, OthersReach).

%!  special_case(+Capability, -Special) is nondet.
%
%   A capability without known dependencies is there when one below it, whose are known, is.

special_case(What, Sub) :-
    rdf(Sub, rdfs:subClassOf, What),
    Sub \== What,
    named(Sub),
    \+ subclass(What, Sub),
    dependencies(Sub, [_|_]).

claimed(Claims, What) :-
    member(Claim, Claims),
    subclass(Claim, What),
    !.

% A proof that leads back to nothing above it.
nowhere(1_000_000).

% -- numbers --

% Where the robot's own numbers speak against it, no claim helps; what they leave open is no fault
% of a part that is there.
none_insufficient(Context, Stated, What) :-
    requirement_groups(Stated, What, Groups),
    \+ ( member(Group, Groups), verdict_of(Context, Group, insufficient) ).

group_holds(Context, Group) :-
    Context = context(_, _, Strict),
    verdict_of(Context, Group, Verdict),
    ( Verdict == met ; Verdict == unknown, Strict == false ),
    !.

verdict_of(context(Robot, _, _), Group, Verdict) :-
    group_verdict(Robot, Group, Found),
    get_dict(verdict, Found, Verdict).
