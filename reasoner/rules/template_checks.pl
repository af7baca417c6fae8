:- module(template_checks, [ described_templates/2 ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(templates)).
:- use_module(rules(requirements)).

/** <module> What a skill template says, and what is wrong with it

Each problem makes a template unusable and is one sentence. The syntax of conditions and of tree
fragments is checked elsewhere.
*/

:- rdf_meta
    texts(r, r, -),
    values(r, r, -),
    condition_text(r, -),
    opposed(r, r).

%!  described_templates(+Graph, -Templates:list) is det.
%
%   `template{template, comment, actions, skill, conditions, inputs, outputs, outcomes, manner, problems,
%   warnings}` of each template of a document, or of all with Graph = all.

described_templates(Graph, Templates) :-
    findall(Template, template_in(Graph, Template), Found),
    sort(Found, Sorted),
    findall(Described, (member(Template, Sorted), describe(Template, Described)), Described0),
    with_requirement_problems(Graph, Described0, Templates).

% What is wrong with the numbers of a document is told once, with its first template.
with_requirement_problems(Graph, [First|Rest], [Told|Rest]) :-
    Graph \== all,
    requirement_problems(Graph, Found),
    Found \== [],
    !,
    get_dict(problems, First, Problems0),
    append(Problems0, Found, Problems),
    put_dict(problems, First, Problems, Told).
with_requirement_problems(_, Templates, Templates).

template_in(all, Template) :-
    !,
    rdf(Template, rdf:type, lares:'SkillTemplate'),
    named(Template).
template_in(Graph, Template) :-
    rdf_in(Template, rdf:type, lares:'SkillTemplate', Graph).

describe(Template, template{template:Template, comment:Comment, actions:Actions, skill:Skill,
                            conditions:Conditions, inputs:Inputs, outputs:Outputs,
                            outcomes:Outcomes, manner:Manner, problems:Problems,
                            warnings:Warnings}) :-
    ( texts(Template, rdfs:comment, [Comment|_]) -> true ; Comment = '' ),
    values(Template, lares:forAction, Actions),
    ( texts(Template, lares:skillName, [Skill|_]) -> true ; Skill = '' ),
    findall(Sentence, condition(Template, Sentence), Conditions),
    template_inputs(Template, Inputs0),
    findall(In, (member(Input, Inputs0), described_input(Input, In)), Inputs),
    template_outputs(Template, Outputs0),
    findall(output{name:Name, type:Type, property:Property},
            member(output(Name, Type, Property), Outputs0), Outputs),
    template_outcomes(Template, Outcomes0),
    findall(outcome{name:Name, means:Means}, member(outcome(Name, Means), Outcomes0), Outcomes),
    template_manner(Template, Manner),
    findall(Problem, problem(Template, Problem), Problems0),
    list_to_set(Problems0, Problems),
    findall(Warning, warning(Template, Warning), Warnings0),
    list_to_set(Warnings0, Warnings).

described_input(Input, in{name:Name, type:Type, unit:Unit, optional:Optional, sources:Texts}) :-
    get_dict(name, Input, Name),
    get_dict(type, Input, Type),
    get_dict(unit, Input, Unit),
    get_dict(optional, Input, Optional),
    get_dict(sources, Input, Sources),
    findall(Text, (member(Source, Sources), source_text(Source, Text)), Texts).

source_text(recipe(Property, none), ["recipe: ", phrase(Property)]) :- !.
source_text(recipe(Property, Filler), ["recipe: ", phrase(Filler), " inside ", phrase(Property)]).
source_text(robot(Fact), ["robot: ", Fact]).
source_text(part(Class), ["robot: its only ", label(Class)]).
source_text(environment(Fact), ["environment: ", Fact]).
source_text(default(Value), ["default: ", Value]).

% -- conditions --

condition_text(lares:appliesWithOutputOf, "with the output of ").
condition_text(lares:notWithOutputOf, "not with the output of ").
condition_text(lares:appliesWithProperty, "where the step says ").
condition_text(lares:notWithProperty, "where the step does not say ").
condition_text(lares:needsComponent, "for robots with ").
condition_text(lares:notWithComponent, "for robots without ").
condition_text(lares:needsCapability, "for robots that can ").
condition_text(lares:appliesInPlace, "in ").
condition_text(lares:notInPlace, "not in ").
condition_text(lares:needsLayer, "where the environment has the layer ").

condition(Template, [Text, Named]) :-
    condition_of(Template, Property, Value),
    condition_text(Property, Text),
    ( Value = literal(Layer, _, _) -> Named = Layer ; Named = label(Value) ).

condition_of(Template, Property, Value) :-
    condition_text(Property, _),
    rdf_asserted(Template, Property, Value).

% -- problems --

problem(Template, [name(Template), " serves no action (forAction)"]) :-
    values(Template, lares:forAction, []).
problem(Template, [name(Template), " serves ", name(Action), ", which is no action that is known here"]) :-
    values(Template, lares:forAction, Actions),
    member(Action, Actions),
    \+ subclass(Action, 'https://w3id.org/lares#Action').
problem(Template, [name(Template), " names no skill (skillName)"]) :-
    texts(Template, lares:skillName, []).
problem(Template, [name(Template), " names a skill that cannot be called: '", Name, "' is no identifier"]) :-
    texts(Template, lares:skillName, Names),
    member(Name, Names),
    \+ identifier(Name).
problem(Template, [name(Template), " names two skills: '", A, "' and '", B, "'"]) :-
    texts(Template, lares:skillName, [A, B|_]).
problem(Template, Problem) :-
    contradiction(Template, Problem).
problem(Template, [name(Template), " has a condition on ", name(Class), ", which is no class that is known here"]) :-
    condition_of(Template, Property, Class),
    \+ rdf_equal(Property, lares:appliesWithProperty),
    \+ rdf_equal(Property, lares:notWithProperty),
    atom(Class),
    \+ is_class(Class).
problem(Template, [name(Template), " needs the layer '", Layer, "', and there is none of that name"]) :-
    texts(Template, lares:needsLayer, Layers),
    member(Layer, Layers),
    \+ memberchk(Layer, [semantic, features, octomap, grid, cloud, trajectory]).
problem(Template, Problem) :-
    rdf_asserted(Template, lares:skillInput, Node),
    input_problem(Template, Node, Problem).
problem(Template, Problem) :-
    rdf_asserted(Template, lares:skillOutput, Node),
    output_problem(Template, Node, Problem).
problem(Template, [name(Template), " has two parameters '", Name, "'"]) :-
    findall(Name, parameter_name(Template, Name), Names),
    msort(Names, Sorted),
    nextto(Name, Name, Sorted).
problem(Template, Problem) :-
    outcome_problem(Template, Problem).
problem(Template, [name(Template), ": retryCount is a whole number from 0 to 100, not '", Text, "'"]) :-
    texts(Template, lares:retryCount, Texts),
    member(Text, Texts),
    \+ ( rdf_number(literal(Text, '', ''), Number), integer(Number), between(0, 100, Number) ).
problem(Template, [name(Template), ": timeLimit_s is a number of seconds above 0 and up to a week, not '",
                   Text, "'"]) :-
    texts(Template, lares:timeLimit_s, Texts),
    member(Text, Texts),
    \+ ( rdf_number(literal(Text, '', ''), Number), Number > 0, Number =< 604800 ).
problem(Template, [name(Template), " states ", phrase(Property), " more than once"]) :-
    ( rdf_equal(Property, lares:retryCount) ; rdf_equal(Property, lares:timeLimit_s)
    ; rdf_equal(Property, lares:treeFragment) ),
    texts(Template, Property, [_, _|_]).
problem(Template, [name(Template), " claims ", name(Class), ", which is no kind of component"]) :-
    values(Template, lares:claims, Classes),
    member(Class, Classes),
    \+ subclass(Class, 'https://w3id.org/lares#Component').

contradiction(Template, [name(Template), " can never apply: it applies ", WithText, Shown,
                         " and ", AgainstText, Other]) :-
    opposed(With, Against),
    rdf_asserted(Template, With, A),
    rdf_asserted(Template, Against, B),
    atom(A), atom(B),
    ( A == B -> true ; subclass(A, B) ),
    condition_text(With, WithText),
    condition_text(Against, AgainstText),
    Shown = label(A),
    Other = label(B).

opposed(lares:appliesWithOutputOf, lares:notWithOutputOf).
opposed(lares:appliesWithProperty, lares:notWithProperty).
opposed(lares:needsComponent, lares:notWithComponent).
opposed(lares:appliesInPlace, lares:notInPlace).

parameter_name(Template, Name) :-
    ( rdf_asserted(Template, lares:skillInput, Node)
    ; rdf_asserted(Template, lares:skillOutput, Node) ),
    texts(Node, lares:parameterName, Names),
    member(Name, Names).

input_problem(Template, Node, Problem) :-
    named_parameter_problem(Template, Node, "input", Problem).
input_problem(Template, Node, [name(Template), ": '", Name, "' is in '", Unit, "', but ", Rule]) :-
    parameter(Node, Name, Type),
    texts(Node, lares:parameterUnit, Units),
    member(Unit, Units),
    unit_rule(Type, Unit, Rule).
input_problem(Template, Node, [name(Template), ": nothing says where '", Name,
                               "' comes from (valueFrom)"]) :-
    parameter(Node, Name, _),
    \+ rdf_asserted(Node, lares:valueFrom, _),
    \+ optional(Node).
input_problem(Template, Node, [name(Template), ": a source of '", Name, "' names ", How,
                               "; it is one of recipeProperty, robotFact, robotPart, environmentFact, \c
defaultValue"]) :-
    parameter(Node, Name, _),
    rdf_asserted(Node, lares:valueFrom, Source),
    findall(Property, source_property(Source, Property), Properties),
    ( Properties == [] -> How = "nothing" ; Properties = [_, _|_], How = "several things" ).
input_problem(Template, Node, [name(Template), ": there is no ", Kind, " '", Fact, "' for '", Name, "'"]) :-
    parameter(Node, Name, _),
    rdf_asserted(Node, lares:valueFrom, Source),
    (   texts(Source, lares:robotFact, Facts), Kind = "robot fact",
        Known = [base_frame, camera, camera_pose]
    ;   texts(Source, lares:environmentFact, Facts), Kind = "environment fact", Known = [id, place]
    ),
    member(Fact, Facts),
    \+ memberchk(Fact, Known).
input_problem(Template, Node, [name(Template), ": the default of '", Name, "' is no finite number: '",
                               Text, "'"]) :-
    parameter(Node, Name, number),
    rdf_asserted(Node, lares:valueFrom, Source),
    texts(Source, lares:defaultValue, Texts),
    member(Text, Texts),
    \+ rdf_number(literal(Text, '', ''), _).

output_problem(Template, Node, Problem) :-
    named_parameter_problem(Template, Node, "output", Problem).
output_problem(Template, Node, [name(Template), ": the output '", Name,
                                "' does not say by which property steps name it (keyProperty)"]) :-
    parameter(Node, Name, _),
    \+ rdf_asserted(Node, lares:keyProperty, _).

named_parameter_problem(Template, Node, Kind, [name(Template), " has an ", Kind,
                                               " without a name (parameterName)"]) :-
    texts(Node, lares:parameterName, []).
named_parameter_problem(Template, Node, Kind, [name(Template), " has an ", Kind, " that is called '", Name,
                                               "': behaviour trees cannot use that name"]) :-
    texts(Node, lares:parameterName, Names),
    member(Name, Names),
    ( \+ identifier(Name) -> true ; memberchk(Name, [name, 'ID', outcome]) ).
named_parameter_problem(Template, Node, _, [name(Template), ": '", Name, "' is of the type '", Type,
                                            "', which is not known"]) :-
    parameter(Node, Name, Type),
    \+ memberchk(Type, [pose, pose_list, class, class_list, designator, designator_list, string,
                        number, boolean]).

parameter(Node, Name, Type) :-
    texts(Node, lares:parameterName, [Name|_]),
    ( texts(Node, lares:parameterType, [Type|_]) -> true ; Type = string ).

optional(Node) :- texts(Node, lares:optionalParameter, [true|_]).

source_property(Source, Property) :-
    member(Written, [recipeProperty, robotFact, robotPart, environmentFact, defaultValue]),
    atom_concat('https://w3id.org/lares#', Written, Property),
    rdf_asserted(Source, Property, _).

unit_rule(Type, Unit, "poses are in m") :-
    memberchk(Type, [pose, pose_list]),
    Unit \== m,
    !.
unit_rule(number, Unit, "units are those of SI: m, s, kg, rad, m/s, rad/s, Hz, N, W, V, A, K, px, …") :-
    \+ memberchk(Unit, [m, s, kg, rad, 'm/s', 'rad/s', 'm/s^2', 'm/s²', 'Hz', 'N', 'N m', 'J', 'W', 'V',
                        'A', 'K', 'Pa', px, 'm^2', 'm²', 'm^3', 'm³', 'lx', '1']),
    !.
unit_rule(Type, _, "only poses and numbers have units") :-
    \+ memberchk(Type, [pose, pose_list, number]).

outcome_problem(Template, [name(Template), " has no outcome but failing"]) :-
    findall(Name, (outcome(Template, _, Name), Name \== failed), []).
outcome_problem(Template, [name(Template), " has an outcome that is called '", Name,
                           "', which is no identifier"]) :-
    outcome(Template, _, Name),
    \+ identifier(Name).
outcome_problem(Template, [name(Template), " has two outcomes '", Name, "'"]) :-
    findall(Name, outcome(Template, _, Name), Names),
    msort(Names, Sorted),
    nextto(Name, Name, Sorted).
outcome_problem(Template, [name(Template), ": nobody can handle the outcome '", Name,
                           "': it means no result (meansResult) that a recipe could lead on by"]) :-
    outcome(Template, Node, Name),
    \+ memberchk(Name, [succeeded, failed, exhausted]),
    \+ rdf_asserted(Node, lares:meansResult, _).
outcome_problem(Template, [name(Template), ": the outcome '", Name, "' means ", name(Result),
                           ", which is no result that is known here"]) :-
    outcome(Template, Node, Name),
    rdf_asserted(Node, lares:meansResult, Result),
    \+ rdf(Result, rdf:type, lares:'ActionResult').
outcome_problem(Template, [name(Template), ": the outcomes '", A, "' and '", B, "' mean the same result"]) :-
    outcome(Template, NodeA, A),
    outcome(Template, NodeB, B),
    A @< B,
    rdf_asserted(NodeA, lares:meansResult, Result),
    rdf_asserted(NodeB, lares:meansResult, Result).

outcome(Template, Node, Name) :-
    rdf_asserted(Template, lares:skillOutcome, Node),
    texts(Node, lares:outcomeName, Names),
    ( Names == [] -> Name = '' ; member(Name, Names) ).

% -- warnings --

warning(Template, [name(Template), " serves ", label(Action), " under the same conditions as ",
                   name(Other), ": plans will ask which of them is meant"]) :-
    rdf_asserted(Template, lares:forAction, Action),
    rdf(Other, rdf:type, lares:'SkillTemplate'),
    Other \== Template,
    rdf_asserted(Other, lares:forAction, Action),
    conditions(Template, Conditions),
    conditions(Other, Conditions).

conditions(Template, Conditions) :-
    findall(Property-Value, condition_of(Template, Property, Value), Found),
    sort(Found, Conditions).

texts(Node, Property, Texts) :-
    findall(Text,
            ( rdf_asserted(Node, Property, literal(Found, _, _)),
              ( atom(Found) -> Text = Found ; atom_string(Text, Found) ) ),
            Texts).

values(Node, Property, Values) :-
    findall(Value, (rdf_asserted(Node, Property, Value), atom(Value)), Found),
    sort(Found, Values).

identifier(Name) :-
    atom_codes(Name, [First|Rest]),
    letter(First),
    \+ ( member(Code, Rest), \+ letter(Code), \+ between(0'0, 0'9, Code) ).

letter(Code) :- between(0'a, 0'z, Code), !.
letter(Code) :- between(0'A, 0'Z, Code), !.
letter(0'_).
