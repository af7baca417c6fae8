:- module(templates,
          [ choose_template/3,
            template_serves/2,
            unknown_answers/3,
            can_exhaust/2,
            can_do/3,
            can_end/3,
            template_skill/2,
            template_outcomes/2,
            template_inputs/2,
            template_outputs/2,
            template_manner/2
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).
:- use_module(rules(availability)).
:- use_module(rules(requirements)).

/** <module> Skill templates: which of them does a step

Templates are documents (vocabulary in ontology/skills.ttl). A template serves the steps below its
action class when its conditions hold:

  - it has an outcome for every result that the recipe leads on from the step;
  - `appliesWithOutputOf C`: the step is given what a step below C creates; `notWithOutputOf C`: it
    is not;
  - `appliesWithProperty P`, `notWithProperty P`: the step says, or does not say, P;
  - `needsComponent C`, `needsCapability C`: the robot has it; `notWithComponent C`: it has not;
  - `appliesInPlace C`, `notInPlace C`, `needsLayer L`: of the environment.

Of those that apply, the one whose action is nearest to the step (Rada distance) is taken.
*/

:- rdf_meta
    text_of(r, r, -),
    first_text(r, r, -, -).

%!  choose_template(+Situation:dict, +Answers:list, -Choice) is det.
%
%   Situation is situation{step, causes, given, robot, place, layers} with the results that the recipe
%   leads on, the classes of the steps whose outputs the step is given, the robot's context or `none`
%   (with which the environment's place and layers are not looked at either). Choice is
%   chosen(Template, Action, Distance), tie(Templates), none(Sentence).

choose_template(Situation, Answers, Choice) :-
    get_dict(step, Situation, Step),
    findall(Template-Action, (template(Template, Action), subclass(Step, Action)), Serving),
    findall(Distance-(Template-Action),
            ( member(Template-Action, Serving),
              applies(Template, Situation),
              rada_distance(Step, Action, Distance) ),
            Applicable),
    keysort(Applicable, Sorted),
    pick(Sorted, Serving, Situation, Answers, Choice).

pick([], [], Situation, _, none([name(Step), " is an action for which no skill template is known"])) :-
    !,
    get_dict(step, Situation, Step).
pick([], Serving, Situation, _, none(["no skill template for ", name(Step), " has an outcome that \c
means ", name(Cause), ", by which the recipe leads on"])) :-
    get_dict(causes, Situation, Causes),
    member(Cause, Causes),
    \+ ( member(Template-_, Serving), outcome_for(Template, Cause) ),
    !,
    get_dict(step, Situation, Step).
pick([], Serving, Situation, _, none(Sentence)) :-
    !,
    get_dict(step, Situation, Step),
    findall(Part, (member(Template-_, Serving), template_name(Template, Part)), Names0),
    sort(Names0, Names),
    join_names(Names, Joined),
    append(["no skill template applies to ", name(Step), ": the conditions of "|Joined],
           [" do not hold here"], Sentence).
pick(Sorted, _, Situation, Answers, Choice) :-
    get_dict(step, Situation, Step),
    Sorted = [Least-_|_],
    findall(Template-Action, member(Least-(Template-Action), Sorted), Nearest0),
    sort(Nearest0, Nearest),
    (   member(Named-Wanted, Answers),
        goes_by(Step, Named)
    ->  (   member(Distance-(Template-Action), Sorted),
            template_goes_by(Template, Wanted)
        ->  Choice = chosen(Template, Action, Distance)
        ;   Choice = none(["the skill template ", name(Wanted), ", asked for, does not apply to ",
                           name(Step)])
        )
    ;   findall(Template, member(Template-_, Nearest), Templates0),
        sort(Templates0, Templates),
        (   Templates = [Template]
        ->  memberchk(Template-Action, Nearest),
            Choice = chosen(Template, Action, Least)
        ;   Choice = tie(Templates)
        )
    ).

%!  unknown_answers(+Answers:list, +Steps:list, -Problems:list) is det.
%
%   Answers (Step-Template) to what is no step.

unknown_answers(Answers, Steps, Problems) :-
    findall(["there is no step '", Named, "' for which a skill template was chosen"],
            ( member(Named-_, Answers), \+ ( member(Step, Steps), goes_by(Step, Named) ) ),
            Problems).

% By IRI, the last part of it, or label.
goes_by(Thing, Thing) :- !.
goes_by(Thing, Name) :- atom_concat(Before, Name, Thing), sub_atom(Before, _, 1, 0, '#'), !.
goes_by(Thing, Name) :- atom_concat(Before, Name, Thing), sub_atom(Before, _, 1, 0, '/'), !.
goes_by(Thing, Name) :- rdf_label(Thing, Name).

template_goes_by(Template, Name) :- goes_by(Template, Name), !.
template_goes_by(Template, Name) :- text_of(Template, lares:skillName, Name).

template_name(Template, label(Template)).

join_names([One], [One]) :- !.
join_names([One|More], [One, ", "|Rest]) :- join_names(More, Rest).

template(Template, Action) :-
    rdf(Template, rdf:type, lares:'SkillTemplate'),
    rdf_asserted(Template, lares:forAction, Action).

%!  template_serves(+Step, -Template) is nondet.
%
%   Template's action is above Step, conditions apart.

template_serves(Step, Template) :-
    template(Template, Action),
    subclass(Step, Action).

applies(Template, Situation) :-
    get_dict(causes, Situation, Causes),
    get_dict(given, Situation, Given),
    get_dict(robot, Situation, Robot),
    get_dict(step, Situation, Step),
    \+ ( member(Cause, Causes), \+ outcome_for(Template, Cause) ),
    \+ ( rdf_asserted(Template, lares:appliesWithOutputOf, Class), \+ given_by(Given, Class) ),
    \+ ( rdf_asserted(Template, lares:notWithOutputOf, Class), given_by(Given, Class) ),
    \+ ( rdf_asserted(Template, lares:appliesWithProperty, Property), \+ says(Step, Property) ),
    \+ ( rdf_asserted(Template, lares:notWithProperty, Property), says(Step, Property) ),
    \+ ( Robot \== none, rdf_asserted(Template, lares:needsComponent, Class),
         \+ robot_has(Robot, Class) ),
    \+ ( Robot \== none, rdf_asserted(Template, lares:notWithComponent, Class),
         robot_has(Robot, Class) ),
    ( Robot == none -> true ; fits_environment(Template, Situation) ),
    \+ ( Robot \== none, rdf_asserted(Template, lares:requires, _),
         \+ requirements_hold(Robot, Template) ),
    \+ ( Robot \== none, rdf_asserted(Template, lares:needsCapability, Class),
         \+ robot_can(Robot, Class) ).

fits_environment(Template, Situation) :-
    get_dict(place, Situation, Place),
    get_dict(layers, Situation, Layers),
    \+ ( rdf_asserted(Template, lares:appliesInPlace, Class), \+ in_place(Place, Class) ),
    \+ ( rdf_asserted(Template, lares:notInPlace, Class), in_place(Place, Class) ),
    \+ ( rdf_asserted(Template, lares:needsLayer, literal(Text, _, _)),
         to_atom(Text, Layer), \+ memberchk(Layer, Layers) ).

%   Place is an individual or a class, '' without one.
in_place(Place, Class) :-
    Place \== '',
    ( subclass(Place, Class) -> true ; rdf(Place, rdf:type, Class) ),
    !.

robot_has(context(Robot, _, _), Class) :-
    has_component(Robot, Class).

robot_can(Context, Class) :-
    available(Context, Class).

given_by(Given, Class) :-
    member(Producer, Given),
    subclass(Producer, Class),
    !.

says(Step, Property) :-
    restriction(Step, Property, _, _),
    !.

outcome_for(_, any) :- !.
outcome_for(Template, Cause) :-
    template_outcomes(Template, Outcomes),
    memberchk(outcome(_, Cause), Outcomes).

%!  can_exhaust(+Step, +Given) is semidet.
%
%   Some template for Step, given outputs of Given, may run out of things to do.

can_exhaust(Step, Given) :-
    applicable(Step, [], Given, Template),
    template_outcomes(Template, Outcomes),
    memberchk(outcome(exhausted, _), Outcomes),
    !.

%!  can_do(+Step, +Causes, +Given) is semidet.
%
%   Some template applies to Step, from which the recipe leads on by Causes.

can_do(Step, Causes, Given) :-
    applicable(Step, Causes, Given, _),
    !.

%!  can_end(+Step, +Causes, +Given) is semidet.
%
%   Some template for Step may come out well with something that is none of Causes.

can_end(Step, Causes, Given) :-
    applicable(Step, Causes, Given, Template),
    template_outcomes(Template, Outcomes),
    member(outcome(Name, Result), Outcomes),
    \+ memberchk(Name, [failed, exhausted]),
    \+ memberchk(Result, Causes),
    !.

applicable(Step, Causes, Given, Template) :-
    template_serves(Step, Template),
    applies(Template, situation{step:Step, causes:Causes, given:Given, robot:none}).

%!  template_skill(+Template, -Skill:atom) is det.

template_skill(Template, Skill) :-
    text_of(Template, lares:skillName, Skill),
    !.
template_skill(Template, Skill) :-
    rdf_label(Template, Skill).

%!  template_outcomes(+Template, -Outcomes:list) is det.
%
%   `outcome(Name, Result)` in the order succeeded, true, false, exhausted, others, failed; Result is
%   an IRI or `none`. Every skill can fail.

template_outcomes(Template, Outcomes) :-
    findall(Rank-outcome(Name, Result),
            ( rdf_asserted(Template, lares:skillOutcome, Node),
              text_of(Node, lares:outcomeName, Name),
              outcome_rank(Name, Rank),
              ( rdf_asserted(Node, lares:meansResult, Result) -> true ; Result = none ) ),
            Found),
    rdf_equal(Failure, lares:'COMPLETED_FAILED'),
    (   memberchk(_-outcome(failed, _), Found)
    ->  All = Found
    ;   All = [9-outcome(failed, Failure)|Found]
    ),
    sort(All, Sorted),
    findall(Outcome, member(_-Outcome, Sorted), Outcomes).

outcome_rank(succeeded, 0) :- !.
outcome_rank(true, 1) :- !.
outcome_rank(false, 2) :- !.
outcome_rank(exhausted, 3) :- !.
outcome_rank(failed, 9) :- !.
outcome_rank(_, 5).

%!  template_inputs(+Template, -Inputs:list) is det.
%
%   `input{name, type, unit, optional, sources}` by name; sources in the order to try.

template_inputs(Template, Inputs) :-
    findall(Name-input{name:Name, type:Type, unit:Unit, optional:Optional, sources:Sources},
            ( rdf_asserted(Template, lares:skillInput, Node),
              text_of(Node, lares:parameterName, Name),
              first_text(Node, lares:parameterType, string, Type),
              first_text(Node, lares:parameterUnit, '', Unit),
              first_text(Node, lares:optionalParameter, false, Optional),
              sources(Node, Sources) ),
            Found),
    keysort(Found, Sorted),
    findall(Input, member(_-Input, Sorted), Inputs).

sources(Node, Sources) :-
    findall(Order-Source,
            ( rdf_asserted(Node, lares:valueFrom, Value),
              first_text(Value, lares:tryOrder, '1', OrderText),
              ( atom_number(OrderText, Order) -> true ; Order = 1 ),
              source(Value, Source) ),
            Found),
    sort(Found, Sorted),
    findall(Source, member(_-Source, Sorted), Sources).

source(Node, recipe(Property, Filler)) :-
    rdf_asserted(Node, lares:recipeProperty, Property),
    ( rdf_asserted(Node, lares:fillerProperty, Filler) -> true ; Filler = none ).
source(Node, robot(Fact)) :- text_of(Node, lares:robotFact, Fact).
source(Node, part(Class)) :- rdf_asserted(Node, lares:robotPart, Class).
source(Node, environment(Fact)) :- text_of(Node, lares:environmentFact, Fact).
source(Node, default(Value)) :- text_of(Node, lares:defaultValue, Value).

%!  template_outputs(+Template, -Outputs:list) is det.
%
%   `output(Name, Type, KeyProperty)`: the step's value of KeyProperty names the key.

template_outputs(Template, Outputs) :-
    findall(output(Name, Type, Property),
            ( rdf_asserted(Template, lares:skillOutput, Node),
              text_of(Node, lares:parameterName, Name),
              first_text(Node, lares:parameterType, string, Type),
              rdf_asserted(Node, lares:keyProperty, Property) ),
            Found),
    sort(Found, Outputs).

%!  template_manner(+Template, -Manner:dict) is det.
%
%   `manner{retries, time_limit, fragment, claims, preconditions, effects}`: texts as written ('' for
%   none), classes of parts, texts, and `effect(Outcome, Text)`.

template_manner(Template, manner{retries:Retries, time_limit:Limit, fragment:Fragment,
                                 claims:Claims, preconditions:Preconditions, effects:Effects}) :-
    first_text(Template, lares:retryCount, '', Retries),
    first_text(Template, lares:timeLimit_s, '', Limit),
    first_text(Template, lares:treeFragment, '', Fragment),
    findall(Part, (rdf_asserted(Template, lares:claims, Part), atom(Part)), Parts),
    sort(Parts, Claims),
    findall(Text, text_of(Template, lares:precondition, Text), Texts),
    sort(Texts, Preconditions),
    findall(effect(Outcome, Text),
            ( rdf_asserted(Template, lares:skillOutcome, Node),
              text_of(Node, lares:outcomeName, Outcome),
              text_of(Node, lares:effect, Text) ),
            Found),
    sort(Found, Effects).

text_of(Node, Property, Text) :-
    rdf_asserted(Node, Property, literal(Text0, _, _)),
    to_atom(Text0, Text).

to_atom(Text, Atom) :- atom(Text), !, Atom = Text.
to_atom(Text, Atom) :- atom_string(Atom, Text).

first_text(Node, Property, _, Text) :-
    text_of(Node, Property, Text),
    !.
first_text(_, _, Default, Default).
