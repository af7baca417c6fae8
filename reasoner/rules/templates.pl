:- module(templates,
          [ candidates/5,
            template_conditions/2,
            fitting/5,
            choose_template/5,
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
    all_of(r, r, -),
    text_of(r, r, -),
    first_text(r, r, -, -).

%!  candidates(+Step, +Causes:list, +Given:list, -Candidates:list, -None) is det.
%
%   The templates that do Step for some robot in some place: `Distance-(Template-Action)`, the nearest
%   first. Causes are the results that the recipe leads on from it, Given the classes of the steps whose
%   outputs it is given. None is the sentence for a robot of which no candidate fits.

candidates(Step, Causes, Given, Candidates, None) :-
    findall(Template-Action, (template(Template, Action), subclass(Step, Action)), Serving),
    findall(Distance-(Template-Action),
            ( member(Template-Action, Serving),
              applies(Template, Step, Causes, Given),
              rada_distance(Step, Action, Distance) ),
            Found),
    keysort(Found, Candidates),
    no_template(Serving, Step, Causes, None).

no_template([], Step, _, [name(Step), " is an action for which no skill template is known"]) :-
    !.
no_template(Serving, Step, Causes, ["no skill template for ", name(Step), " has an outcome that \c
means ", name(Cause), ", by which the recipe leads on"]) :-
    member(Cause, Causes),
    \+ ( member(Template-_, Serving), outcome_for(Template, Cause) ),
    !.
no_template(Serving, Step, _, Sentence) :-
    findall(label(Template), member(Template-_, Serving), Names0),
    sort(Names0, Names),
    join_names(Names, Joined),
    append(["no skill template applies to ", name(Step), ": the conditions of "|Joined],
           [" do not hold here"], Sentence).

%!  choose_template(+Step, +Candidates:list, +None, +Answers:list, -Choice) is det.
%
%   Of Candidates (`Distance-Candidate`, the nearest first, of which arguments 1 and 2 are template and
%   action) that fit. Answers lists Step-Template as people name them. Choice is
%   chosen(Candidate, Distance), tie(Templates) or none(Sentence).

choose_template(_, [], None, _, none(None)) :-
    !.
choose_template(Step, Candidates, _, Answers, Choice) :-
    member(Named-Wanted, Answers),
    goes_by(Step, Named),
    !,
    (   member(Distance-Candidate, Candidates),
        arg(1, Candidate, Template),
        template_goes_by(Template, Wanted)
    ->  Choice = chosen(Candidate, Distance)
    ;   Choice = none(["the skill template ", name(Wanted), ", asked for, does not apply to ",
                       name(Step)])
    ).
choose_template(_, Candidates, _, _, Choice) :-
    Candidates = [Least-_|_],
    findall(Template, (member(Least-Candidate, Candidates), arg(1, Candidate, Template)), Nearest),
    sort(Nearest, Templates),
    (   Templates = [_]
    ->  findall(Action-Candidate, (member(Least-Candidate, Candidates), arg(2, Candidate, Action)),
                Ways),
        keysort(Ways, [_-First|_]),
        Choice = chosen(First, Least)
    ;   Choice = tie(Templates)
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

% What does not hang on robot and place.
applies(Template, Step, Causes, Given) :-
    \+ ( member(Cause, Causes), \+ outcome_for(Template, Cause) ),
    \+ ( rdf_asserted(Template, lares:appliesWithOutputOf, Class), \+ given_by(Given, Class) ),
    \+ ( rdf_asserted(Template, lares:notWithOutputOf, Class), given_by(Given, Class) ),
    \+ ( rdf_asserted(Template, lares:appliesWithProperty, Property), \+ says(Step, Property) ),
    \+ ( rdf_asserted(Template, lares:notWithProperty, Property), says(Step, Property) ).

%!  template_conditions(+Template, -Conditions:dict) is det.
%
%   What it asks of robot and place: conditions{components, no_components, places, no_places, layers,
%   capabilities, numbers}, `numbers` telling whether it states requirements.

template_conditions(Template, conditions{components:Components, no_components:NoComponents,
                                         places:Places, no_places:NoPlaces, layers:Layers,
                                         capabilities:Capabilities, numbers:Numbers}) :-
    all_of(Template, lares:needsComponent, Components),
    all_of(Template, lares:notWithComponent, NoComponents),
    all_of(Template, lares:appliesInPlace, Places),
    all_of(Template, lares:notInPlace, NoPlaces),
    all_of(Template, lares:needsCapability, Capabilities),
    findall(Layer, text_of(Template, lares:needsLayer, Layer), Layers),
    ( rdf_asserted(Template, lares:requires, _) -> Numbers = true ; Numbers = false ).

all_of(Template, Property, Values) :-
    findall(Value, rdf_asserted(Template, Property, Value), Values).

%!  fitting(+Templates:list, +Robot, +Place, +Layers:list, -Fitting:list) is det.
%
%   Those of Templates (`Template-Conditions`) whose conditions hold for the robot of context Robot, in
%   Place ('' for none) of which the environment has Layers.

fitting(Templates, Robot, Place, Layers, Fitting) :-
    (   member(_-Conditions, Templates), asks_more(Conditions)
    ->  Robot = context(Individual, _, _),
        stated_requirements(Individual, Stated)
    ;   Stated = []
    ),
    findall(Template,
            ( member(Template-Conditions, Templates),
              fits(Conditions, Template, Robot, Stated, Place, Layers) ),
            Fitting).

asks_more(Conditions) :- get_dict(numbers, Conditions, true), !.
asks_more(Conditions) :- \+ get_dict(capabilities, Conditions, []).

fits(Conditions, Template, Robot, Stated, Place, Layers) :-
    \+ lacks(Conditions, Template, Robot, Stated, Place, Layers).

lacks(Conditions, _, Robot, _, _, _) :-
    one_of(components, Conditions, Class),
    \+ robot_has(Robot, Class).
lacks(Conditions, _, Robot, _, _, _) :-
    one_of(no_components, Conditions, Class),
    robot_has(Robot, Class).
lacks(Conditions, _, _, _, Place, _) :-
    one_of(places, Conditions, Class),
    \+ in_place(Place, Class).
lacks(Conditions, _, _, _, Place, _) :-
    one_of(no_places, Conditions, Class),
    in_place(Place, Class).
lacks(Conditions, _, _, _, _, Layers) :-
    one_of(layers, Conditions, Layer),
    \+ memberchk(Layer, Layers).
lacks(Conditions, Template, Robot, Stated, _, _) :-
    get_dict(numbers, Conditions, true),
    \+ requirements_hold(Robot, Stated, Template).
lacks(Conditions, _, Robot, Stated, _, _) :-
    one_of(capabilities, Conditions, Class),
    \+ available(Robot, Stated, Class).

one_of(Kind, Conditions, One) :-
    get_dict(Kind, Conditions, All),
    member(One, All).

%   Place is an individual or a class, '' without one.
in_place(Place, Class) :-
    Place \== '',
    ( subclass(Place, Class) -> true ; rdf(Place, rdf:type, Class) ),
    !.

robot_has(context(Robot, _, _), Class) :-
    has_component(Robot, Class).

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
    applies(Template, Step, Causes, Given).

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
