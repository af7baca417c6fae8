:- module(matching,
          [ needs/3,
            capability_needs/2,
            profile/2,
            robot/1,
            claims/2
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).
:- use_module(rules(availability)).
:- use_module(rules(requirements)).

/** <module> What a task needs, and what a robot claims

needs/3 says once for a recipe all that deciding about any robot takes: what the steps need, and of
all that this rests on, what each thing depends on, the numbers it requires and what adding it costs.
recipes/match decides, explains and finds the smallest repairs. A requirement is a class or
`any(Classes)`.
*/

:- rdf_meta robot_type(r).

%!  needs(+Task, +Robot, -Needs:dict) is det.
%
%   `needs{steps, wanted, nodes, groups, sought}`; `not_found(Sentence)` when Task is none. What the
%   documents that describe Robot (`none` for no robot) require is left out. `sought` are the classes
%   of the objects that the steps act on.

needs(Task, _, not_found([name(Task), " is no task: no document says how it is done"])) :-
    \+ task(Task),
    !.
needs(Task, Robot, needs{steps:Needs, wanted:Wanted, nodes:Nodes, groups:StepGroups,
                         sought:Sought}) :-
    all_steps(Task, Steps),
    findall(Need, (member(Step, Steps), step_need(Step, Need)), Needs),
    wanted(Needs, Wanted),
    stated_requirements(Robot, Stated),
    findall(step_group{step:Step, group:Group},
            ( member(Step, Steps),
              requirement_groups(Stated, Step, Groups),
              member(Group, Groups) ),
            StepGroups),
    findall(Part, (member(StepGroup, StepGroups), get_dict(group, StepGroup, Group),
                   get_dict(part, Group, Part)), Parts),
    append(Wanted, Parts, Open),
    stated_costs(Costs),
    nodes(Open, Stated, Costs, [], Nodes),
    sought(Steps, Sought).

%!  capability_needs(+Robot, -Needs:dict) is det.
%
%   As needs/3 for a task that would need every capability that is known.

capability_needs(Robot, needs{steps:[], wanted:Capabilities, nodes:Nodes, groups:[], sought:[]}) :-
    findall(Capability,
            ( rdf(Capability, rdfs:subClassOf, lares:'Capability'),
              named(Capability),
              \+ rdf_equal(Capability, lares:'Capability'),
              \+ rdf_equal(Capability, owl:'Nothing') ),
            Found),
    sort(Found, Capabilities),
    stated_requirements(Robot, Stated),
    stated_costs(Costs),
    nodes(Capabilities, Stated, Costs, [], Nodes).

% The classes that are asked for and all that these rest on.
nodes([], _, _, _, []).
nodes([any(Members)|Rest], Stated, Costs, Seen, Nodes) :-
    !,
    append(Members, Rest, Open),
    nodes(Open, Stated, Costs, Seen, Nodes).
nodes([Class|Rest], Stated, Costs, Seen, Nodes) :-
    memberchk(Class, Seen),
    !,
    nodes(Rest, Stated, Costs, Seen, Nodes).
nodes([Class|Rest], Stated, Costs, Seen, [Node|Nodes]) :-
    node(Class, Stated, Costs, Node),
    get_dict(requirements, Node, Requirements),
    get_dict(special_cases, Node, SpecialCases),
    get_dict(groups, Node, Groups),
    findall(Part, (member(Group, Groups), get_dict(part, Group, Part)), Parts),
    append([Requirements, SpecialCases, Parts, Rest], Open),
    nodes(Open, Stated, Costs, [Class|Seen], Nodes).

node(Class, Stated, Costs, node{class:Class, kind:Kind, requirements:Requirements,
                                special_cases:SpecialCases, groups:Groups, cost:Cost}) :-
    ( is_capability(Class) -> Kind = capability ; Kind = component ),
    dependencies(Class, Requirements),
    (   Kind == capability, Requirements == []
    ->  findall(Sub, special_case(Class, Sub), Found),
        sort(Found, SpecialCases)
    ;   SpecialCases = []
    ),
    requirement_groups(Stated, Class, Groups),
    cost(Costs, Class, Cost).

stated_costs(Costs) :-
    findall(Class-Cost,
            ( rdf_asserted(Class, lares:additionCost, Value),
              rdf_number(Value, Number),
              Number > 0,
              Cost is float(Number) ),
            Costs).

% Of the nearest class above; the largest where several are.
cost(Costs, Class, Cost) :-
    findall(Holder, (member(Holder-_, Costs), subclass(Class, Holder)), Holders),
    most_specific(Holders, Nearest),
    findall(One, (member(Holder, Nearest), member(Holder-One, Costs)), Found),
    (   max_list(Found, Cost)
    ->  true
    ;   Cost = 10.0
    ).

sought(Steps, Sought) :-
    findall(Class,
            ( member(Step, Steps),
              object_property(Property),
              restriction(Step, Property, _, Value),
              fillers(Value, Classes),
              member(Class, Classes),
              atom(Class),
              subclass(Class, 'https://w3id.org/lares#PhysicalObject'),
              \+ subclass(Class, 'https://w3id.org/lares#Component') ),
            Found),
    most_specific(Found, Sought).

object_property(Property) :- rdf_equal(Property, lares:objectActedOn).
object_property(Property) :- rdf_equal(Property, lares:detectedObject).

% The most specific of what is needed; a union only where none of its members is needed anyway.
wanted(Needs, Wanted) :-
    findall(What, (member(Need, Needs), get_dict(what, Need, What)), All),
    sort(All, Distinct),
    findall(Class, (member(Class, Distinct), atom(Class)), Classes),
    most_specific(Classes, Specific),
    findall(any(Members),
            ( member(any(Members), Distinct),
              \+ ( member(Member, Members), member(One, Specific), subclass(One, Member) ) ),
            Unions),
    append(Specific, Unions, Wanted).

%!  step_need(+Step, -Need:dict) is nondet.
%
%   One capability (or component) that the class Step needs, the most specific ones only, or a union
%   any(Classes), with the classes through which it is inherited.

step_need(Step, need{step:Step, what:What, chain:Chain}) :-
    findall(Needed, step_dependency(Step, Needed), Found),
    sort(Found, Distinct),
    findall(Class, (member(Class, Distinct), atom(Class)), Classes),
    most_specific(Classes, Kept),
    (   member(What, Kept)
    ;   member(any(Members), Distinct),
        What = any(Members)
    ),
    stating_chain(Step, What, Chain).

step_dependency(Step, Needed) :-
    dependency_restriction(Step, Value),
    fillers(Value, Fillers),
    member(Needed, Fillers).

% The most general classes that state the need; the nearest of them.
stating_chain(Step, What, Chain) :-
    named_supers(Step, Supers),
    findall(Class, (member(Class, Supers), once(step_dependency_is(Class, What))), Holders),
    findall(Length-Path,
            ( member(Class, Holders),
              \+ ( member(Other, Holders), Other \== Class, subclass(Class, Other),
                   \+ subclass(Other, Class) ),
              class_chain(Step, Class, Path),
              length(Path, Length) ),
            Paths),
    keysort(Paths, [_-Chain|_]),
    !.
stating_chain(Step, _, [Step]).

step_dependency_is(Class, What) :-
    dependency_restriction(Class, Value),
    fillers(Value, Fillers),
    memberchk(What, Fillers).

%!  robot(+Robot) is semidet.
%
%   Robot is an individual of some class of robots, or claims a capability.

robot(Robot) :- robot_type(Robot), !.
robot(Robot) :- claims(Robot, _), !.

robot_type(Robot) :- rdf(Robot, rdf:type, lares:'Robot'), !.

%!  claims(+Robot, -Capability) is nondet.
%
%   The description claims Capability, of the individual or of its class.

claims(Robot, Capability) :-
    rdf(Robot, rdf:type, Type),
    \+ named(Type),
    rdf(Type, owl:onProperty, lares:hasCapability),
    ( rdf(Type, owl:someValuesFrom, Value) ; rdf(Type, owl:hasValue, Value) ),
    fillers(Value, Fillers),
    member(Capability, Fillers),
    may_be_claimed(Capability).
claims(Robot, Capability) :-
    rdf(Robot, lares:hasCapability, Value),
    fillers(Value, Fillers),
    member(Capability, Fillers),
    may_be_claimed(Capability).

% Parts are listed, not claimed.
may_be_claimed(Capability) :-
    atom(Capability),
    \+ subclass(Capability, 'https://w3id.org/lares#Component').

%!  profile(+Robot, -Claims) is det.
%
%   The capabilities that the description claims; `not_found(Sentence)` when Robot is no robot.

profile(Robot, not_found([name(Robot), " is no robot: it is of no kind of Robot and claims no \c
capability"])) :-
    \+ robot(Robot),
    !.
profile(Robot, Claims) :-
    findall(Capability, claims(Robot, Capability), Found),
    sort(Found, Claims).
