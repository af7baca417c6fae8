:- module(matching,
          [ match/4,
            robot/1,
            claims/2
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).
:- use_module(rules(availability)).
:- use_module(rules(repair)).

/** <module> What a task needs against what a robot has

    match(Task, Robot, Options, Report)

is the whole of it. Sentences are lists of strings, `name(Iri)`, `label(Iri)` and `phrase(Iri)`,
so that only one place decides how things are named.
*/

:- rdf_meta robot_type(r).

%!  match(+Task, +Robot, +Strict:oneof([true,false]), -Report:dict) is det.
%
%   Report is `not_found(Sentence)` when Task or Robot are nothing of the kind.

match(Task, _, _, not_found([name(Task), " is no task: no document says how it is done"])) :-
    \+ task(Task),
    !.
match(_, Robot, _, not_found([name(Robot), " is no robot: it is of no kind of Robot and claims no \c
capability"])) :-
    \+ robot(Robot),
    !.
match(Task, Robot, Strict, Report) :-
    all_steps(Task, Steps),
    findall(Need, (member(Step, Steps), step_need(Step, Need)), Needs0),
    wanted(Needs0, Wanted),
    claimed_by_type(Robot, Claims),
    Context = context(Robot, Claims, Strict),
    maplist(evaluate(Context), Wanted, Findings0),
    mark_derivable(Findings0, Findings),
    settle_unions(Needs0, Wanted, Findings, Needs),
    (   forall(member(Finding, Findings), usable(Finding))
    ->  Feasible = true,
        Repair = []
    ;   Feasible = false,
        smallest_repair(Context, Wanted, Repair)
    ),
    findings_warnings(Findings, Warnings),
    Report = match{feasible:Feasible, needs:Needs, capabilities:Findings, repair:Repair,
                   warnings:Warnings}.

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

% In the report a union is the member that was taken.
settle_unions(Needs0, Wanted, Findings, Needs) :-
    findall(Need,
            ( member(Need0, Needs0),
              get_dict(what, Need0, What),
              (   atom(What)
              ->  Need = Need0
              ;   nth0(Index, Wanted, What)
              ->  nth0(Index, Findings, Finding),
                  get_dict(what, Finding, Taken),
                  put_dict(what, Need0, Taken, Need)
              ) ),
            Needs).

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
    atom(Capability).
claims(Robot, Capability) :-
    rdf(Robot, lares:hasCapability, Value),
    fillers(Value, Fillers),
    member(Capability, Fillers),
    atom(Capability).

claimed_by_type(Robot, Claims) :-
    findall(Capability, claims(Robot, Capability), Found),
    sort(Found, Claims).

usable(Finding) :-
    get_dict(availability, Finding, Availability),
    memberchk(Availability, [available, on_makers_word]).

%!  mark_derivable(+Findings, -Marked) is det.
%
%   A missing capability all of whose missing things are those of other missing capabilities that it
%   rests on comes with them.

mark_derivable(Findings, Marked) :-
    maplist(derivable(Findings), Findings, Marked).

derivable(Findings, Finding, Marked) :-
    get_dict(availability, Finding, missing),
    get_dict(missing, Finding, Leaves),
    Leaves \== [],
    get_dict(what, Finding, What),
    \+ memberchk(What, Leaves),
    findall(Leaf,
            ( member(Other, Findings),
              get_dict(availability, Other, missing),
              get_dict(what, Other, OtherWhat),
              OtherWhat \== What,
              rests_on(Finding, OtherWhat),
              \+ rests_on(Other, What),
              get_dict(missing, Other, OtherLeaves),
              member(Leaf, OtherLeaves) ),
            Covered),
    subtract(Leaves, Covered, []),
    !,
    put_dict(_{availability:derivable,
               explanation:[label(What), " is missing, and comes with the other missing things"]},
             Finding, Marked).
derivable(_, Finding, Finding).

rests_on(Finding, What) :-
    get_dict(dependencies, Finding, Dependencies),
    member(Dependency, Dependencies),
    (   get_dict(what, Dependency, What)
    ;   rests_on(Dependency, What)
    ),
    !.
