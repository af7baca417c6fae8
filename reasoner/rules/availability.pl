:- module(availability,
          [ evaluate/3,
            dependency_restriction/2,
            dependencies/2,
            has_component/2,
            component/2,
            present/2,
            findings_warnings/2
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).

/** <module> Whether a robot has a capability or a component, and why

A finding is

    finding{kind, what, availability, asserted, provided_by, dependencies, missing, grounded,
            explanation, warnings}

`missing` are the leaves that would have to be added; `grounded` tells whether anything that the
robot really has, or claims, was met on the way, so that capabilities which only rest on each other
are not available for nothing. A context is `context(Robot, Claims, Strict)`.
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

%!  present(+Robot, +Class) is semidet.

present(Robot, Class) :- has_component(Robot, Class).

%!  evaluate(+Context, +Requirement, -Finding:dict) is det.

evaluate(Context, Requirement, Finding) :-
    evaluate(Context, [], Requirement, Finding).

evaluate(Context, Stack, any(Members), Finding) :-
    !,
    evaluate_each(Context, Stack, Members, Findings),
    choose_member(Findings, Finding).
evaluate(Context, Stack, What, Finding) :-
    is_capability(What),
    !,
    capability(Context, Stack, What, Finding).
evaluate(Context, Stack, What, Finding) :-
    component(Context, Stack, What, Finding).

is_capability(What) :- subclass(What, 'https://w3id.org/lares#Capability').

evaluate_each(_, _, [], []).
evaluate_each(Context, Stack, [Requirement|Rest], [Finding|Findings]) :-
    evaluate(Context, Stack, Requirement, Finding),
    evaluate_each(Context, Stack, Rest, Findings).

% Of a union any member will do: the first that is there, else the one with least missing.
choose_member(Findings, Finding) :-
    member(Finding, Findings),
    good(Finding),
    !.
choose_member(Findings, Finding) :-
    findall(Size-Index,
            ( nth0(Index, Findings, One),
              get_dict(missing, One, Missing),
              length(Missing, Size) ),
            Sizes),
    keysort(Sizes, [_-Best|_]),
    nth0(Best, Findings, Finding).

good(Finding) :-
    get_dict(availability, Finding, Availability),
    memberchk(Availability, [available, on_makers_word]).

% -- components --

component(context(Robot, _, _), _, What, Finding) :-
    findall(Part, component(Robot-What, Part), Found),
    Found \== [],
    !,
    sort(Found, Parts),
    dependencies(What, Requirements),
    findall(Absent, (member(Absent, Requirements), absent(Robot, Absent)), AbsentOnes),
    present_warnings(What, AbsentOnes, Warnings),
    Finding = finding{kind:component, what:What, availability:available, asserted:false,
                      provided_by:Parts, dependencies:[], missing:[], grounded:true,
                      explanation:["the robot has ", label(What)], warnings:Warnings}.
component(_, Stack, What, Finding) :-
    memberchk(What, Stack),
    !,
    circular(component, What, Finding).
component(Context, Stack, What, Finding) :-
    dependencies(What, Requirements),
    evaluate_each(Context, [What|Stack], Requirements, Findings),
    missing_leaves(Findings, Leaves0),
    most_specific([What|Leaves0], Leaves),
    Finding = finding{kind:component, what:What, availability:missing, asserted:false,
                      provided_by:[], dependencies:Findings, missing:Leaves, grounded:false,
                      explanation:["the robot's description lists no ", label(What)],
                      warnings:[]}.

absent(Robot, any(Members)) :-
    !,
    \+ ( member(Member, Members), \+ absent(Robot, Member) ).
absent(Robot, Class) :-
    \+ is_capability(Class),
    \+ present(Robot, Class).

present_warnings(_, [], []) :- !.
present_warnings(What, Absent, [Warning]) :-
    naming(Absent, Names),
    append(["the robot has ", label(What), ", which works with "|Names],
           [" that its description does not list"], Warning).

% -- capabilities --

capability(_, Stack, What, Finding) :-
    memberchk(What, Stack),
    !,
    circular(capability, What, Finding).
capability(Context, Stack, What, Finding) :-
    Context = context(_, Claims, Strict),
    claimed(Claims, What, By),
    dependencies(What, Requirements),
    evaluate_each(Context, [What|Stack], Requirements, Findings),
    findings_leaves(What, Stack, Requirements, Findings, Missing, Grounded),
    decide(Requirements, Missing, By, Strict, Context, [What|Stack], What, Decision),
    decision_finding(Decision, What, By, Findings, Grounded, Finding).

% A circle asks for nothing more than what is already being asked.
circular(Kind, What,
         finding{kind:Kind, what:What, availability:available, asserted:false, provided_by:[],
                 dependencies:[], missing:[], grounded:false,
                 explanation:[label(What), " is explained further up"], warnings:[]}).

claimed(Claims, What, By) :-
    findall(Claim, (member(Claim, Claims), subclass(Claim, What)), Found),
    most_specific(Found, By).

findings_leaves(What, Stack, Requirements, Findings, Missing, Grounded) :-
    missing_leaves(Findings, Leaves),
    (   member(Finding, Findings), get_dict(grounded, Finding, true)
    ->  Grounded = true
    ;   Grounded = false
    ),
    (   Leaves == [], Requirements \== [], Grounded == false, Stack == []
    ->  Missing = [What]
    ;   Missing = Leaves
    ).

missing_leaves(Findings, Leaves) :-
    findall(Leaf, (member(Finding, Findings), get_dict(missing, Finding, Missing),
                   member(Leaf, Missing)), Found),
    most_specific(Found, Leaves).

decide([_|_], [], _, _, _, _, _, derived) :- !.
decide([], _, [_|_], _, _, _, _, claimed) :- !.
decide([_|_], Missing, [_|_], false, _, _, _, on_word(Missing)) :- !.
decide([], _, _, _, Context, Stack, What, through(Sub, Finding)) :-
    provided_below(Context, Stack, What, Sub, Finding),
    !.
decide([], _, _, _, _, _, What, missing([What])) :- !.
decide(_, Missing, _, _, _, _, _, missing(Missing)).

% A capability without known dependencies is there when a special case of it is.
provided_below(Context, Stack, What, Sub, Finding) :-
    findall(Class, (rdf(Class, rdfs:subClassOf, What), Class \== What, named(Class)), Found),
    sort(Found, Below),
    member(Sub, Below),
    \+ subclass(What, Sub),
    \+ memberchk(Sub, Stack),
    dependencies(Sub, [_|_]),
    capability(Context, Stack, Sub, Finding),
    good(Finding),
    get_dict(grounded, Finding, true).

decision_finding(derived, What, By, Findings, Grounded, Finding) :-
    asserted(By, Asserted),
    ground_claim(By, Grounded, Ground),
    make(What, available, Asserted, By, Findings, [], Ground,
         ["everything that ", label(What), " depends on is there"], [], Finding).
decision_finding(claimed, What, By, _, _, Finding) :-
    make(What, available, true, By, [], [], true,
         ["the robot's description claims ", label(What), ", and nothing is known that it \c
depends on"], [], Finding).
decision_finding(on_word(Missing), What, By, Findings, _, Finding) :-
    naming(Missing, Names),
    append([label(What), " is there on the maker's word only: the robot's description claims it, \c
but lists no "|Names], [], Sentence),
    make(What, on_makers_word, true, By, Findings, Missing, true, Sentence, [Sentence], Finding0),
    put_dict(missing, Finding0, [], Finding).
decision_finding(through(Sub, Inner), What, By, _, _, Finding) :-
    make(What, available, false, By, [Inner], [], true,
         [label(Sub), ", a special case of ", label(What), ", is there"], [], Finding).
decision_finding(missing(Missing), What, By, Findings, Grounded, Finding) :-
    asserted(By, Asserted),
    (   Missing == [What]
    ->  Sentence = ["the robot's description does not claim ", label(What),
                    ", and nothing is known from which it would follow"]
    ;   naming(Missing, Names),
        Sentence = [label(What), " lacks "|Names]
    ),
    make(What, missing, Asserted, By, Findings, Missing, Grounded, Sentence, [], Finding).

make(What, Availability, Asserted, By, Findings, Missing, Grounded, Explanation, Warnings,
     finding{kind:capability, what:What, availability:Availability, asserted:Asserted,
             provided_by:By, dependencies:Findings, missing:Missing, grounded:Grounded,
             explanation:Explanation, warnings:Warnings}).

asserted([], false) :- !.
asserted(_, true).

ground_claim([_|_], _, true) :- !.
ground_claim(_, Grounded, Grounded).

%!  naming(+Resources, -Sentence:list) is det.
%
%   "A, B and C".

naming([any(Members)|Rest], Names) :-
    !,
    append(Members, Rest, All),
    naming(All, Names).
naming([Last], [label(Last)]) :- !.
naming([One, Two], [label(One), " and "|Rest]) :-
    !,
    naming([Two], Rest).
naming([One|More], [label(One), ", "|Rest]) :-
    naming(More, Rest).

%!  findings_warnings(+Findings, -Warnings:list) is det.
%
%   All warnings of the findings and of what they rest on, each once.

findings_warnings(Findings, Warnings) :-
    findall(Warning, (member(Finding, Findings), warning_of(Finding, Warning)), Found),
    list_to_set(Found, Warnings).

warning_of(Finding, Warning) :-
    get_dict(warnings, Finding, Warnings),
    member(Warning, Warnings).
warning_of(Finding, Warning) :-
    get_dict(dependencies, Finding, Findings),
    member(Inner, Findings),
    warning_of(Inner, Warning).
