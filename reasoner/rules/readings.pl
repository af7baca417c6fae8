:- module(readings, [ reading/2 ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(recipes)).
:- use_module(rules(recipe_checks)).
:- use_module(rules(templates)).
:- use_module(rules(bindings)).
:- use_module(rules(flattening)).

/** <module> What planning takes from a recipe, whatever the robot

A reading hangs on the recipe and the catalogue alone, so it may be kept as long as these stay:

    reading{task, tasks, start, nodes, templates, unordered, notes}

`tasks` is for recall_tasks/1. A node is node(Path, Id, Said, Candidates, None): Path the step with the
steps that contain it, innermost first, Said what it says for the inputs of its candidates (said_for/3),
None the sentence for when no candidate fits. Candidates are `Distance-candidate(Template, Action,
Outputs, Ways)`, the nearest first, with made(Name, Type, Value) for each output that the step names,
and a transition for each way that the skill may end. A template is
template(Template, Skill, Outcomes, Inputs, Manner, Conditions).
*/

%!  reading(+Task, -Reading:dict) is det.
%
%   `unreadable{problems}` when the recipe cannot be used.

reading(Task, Reading) :-
    remember_tasks(Task),
    all_steps(Task, Steps),
    findall(Problem,
            ( member(Step, Steps), ( Step == Task -> Described = Step ; task_of(Step, Described) ),
              task_problems(none, Described, Some), member(Problem, Some) ),
            Found),
    (   Found == []
    ->  readable(Task, Reading)
    ;   list_to_set(Found, Problems),
        Reading = unreadable{problems:Problems}
    ).

readable(Task, reading{task:Task, tasks:Known, start:Start, nodes:Nodes, templates:Templates,
                       unordered:Unordered, notes:Notes}) :-
    remembered_tasks(Known),
    flatten_task(Task, Flat),
    served(Flat, Served),
    read_templates(Served, Templates),
    findall(Node, (member(One, Served), node(One, Flat, Templates, Node)), Nodes),
    get_dict(entry, Flat, Entry),
    node_id(Flat, Entry, Start),
    get_dict(unordered, Flat, Groups),
    findall(group{steps:Steps, ids:Ids},
            ( member(unordered(Above, Steps), Groups),
              findall(Id, (member(Step, Steps), node_id(Flat, [Step|Above], Id)), Ids) ),
            Unordered),
    findall(Note, structure_note(Flat, Note), Notes).

% served(Path, Id, Candidates, None) for each node.
served(Flat, Served) :-
    get_dict(nodes, Flat, Nodes),
    findall(Step, member(node([Step|_], _), Nodes), Steps),
    findall(served([Step|Above], Id, Candidates, None),
            ( member(node([Step|Above], Id), Nodes),
              causes(Flat, [Step|Above], Causes),
              given_classes(Step, Steps, Given),
              candidates(Step, Causes, Given, Candidates, None) ),
            Served).

causes(Flat, Path, Causes) :-
    get_dict(edges, Flat, Edges),
    findall(Cause, ( member(edge(Path, Cause, _), Edges) ; failure_cause(Flat, Path, Cause) ), Found),
    sort(Found, Causes).

read_templates(Served, Templates) :-
    findall(Template,
            ( member(served(_, _, Candidates, _), Served), member(_-(Template-_), Candidates) ),
            Found),
    sort(Found, Distinct),
    findall(template(Template, Skill, Outcomes, Inputs, Manner, Conditions),
            ( member(Template, Distinct),
              template_skill(Template, Skill),
              template_outcomes(Template, Outcomes),
              template_inputs(Template, Inputs),
              template_manner(Template, Manner),
              template_conditions(Template, Conditions) ),
            Templates).

node(served([Step|Above], Id, Found, None), Flat, Templates,
     node([Step|Above], Id, Said, Candidates, None)) :-
    findall(Source,
            ( member(_-(Template-_), Found),
              memberchk(template(Template, _, _, Inputs, _, _), Templates),
              member(Input, Inputs),
              get_dict(sources, Input, Sources),
              member(Source, Sources) ),
            Sources0),
    sort(Sources0, Distinct),
    said_for(Step, Distinct, Said),
    findall(Distance-candidate(Template, Action, Outputs, Ways),
            ( member(Distance-(Template-Action), Found),
              memberchk(template(Template, _, Outcomes, _, _, _), Templates),
              findall(made(Name, Type, Value), output_value(Step, Template, Name, Type, Value),
                      Outputs),
              findall(Way, way(Flat, [Step|Above], Id, Outcomes, Way), Ways) ),
            Candidates).

output_value(Step, Template, Name, Type, Value) :-
    template_outputs(Template, Outputs),
    member(output(Name, Type, Property), Outputs),
    step_values(Step, Property, Values),
    findall(IriValue, (member(IriValue, Values), atom(IriValue)), [Value|_]).

structure_note(Flat, ["the recipe does not say in which order these are done: "|Names]) :-
    get_dict(unordered, Flat, Groups),
    member(unordered(_, Group), Groups),
    naming(Group, Names).
structure_note(Flat, Note) :-
    get_dict(notes, Flat, Notes),
    member(Note, Notes).

naming([One], [label(One)]) :- !.
naming([One|More], [label(One), ", "|Rest]) :- naming(More, Rest).

% -- the way on from an outcome --

way(Flat, Path, Id, Outcomes, transition{from:Id, outcome:Name, to:To, added:Added, reason:Reason}) :-
    member(outcome(Name, Result), Outcomes),
    way_on(Flat, Path, Name, Result, Target, Added, Reason),
    target_id(Flat, Target, To).

way_on(Flat, Path, _, Result, Target, false, "") :-
    Result \== none,
    ends_in_failure(Flat, Path, Result, Target),
    !.
way_on(Flat, Path, _, Result, Target, false, "") :-
    Result \== none,
    edge_to(Flat, Path, Result, Target),
    !.
way_on(Flat, Path, Name, _, Target, false, "") :-
    ordinary(Name),
    edge_to(Flat, Path, any, Target),
    !.
way_on(Flat, Path, Name, _, end(succeeded), false, "") :-
    ordinary(Name),
    get_dict(exits, Flat, Exits),
    memberchk(Path, Exits),
    !.
way_on(Flat, Path, exhausted, _, Target, true, Reason) :-
    !,
    exit_of_loop(Flat, Path, Target, Reason).
way_on(Flat, [_|Above], failed, _, node(To), false, "") :-
    failure(Flat, Above, node(To)),
    !.
way_on(_, _, failed, _, end(failed), true, "the recipe does not say what to do when this fails") :-
    !.
way_on(_, _, Name, _, end(failed), true, Reason) :-
    atomics_to_string(["the recipe does not say what to do on '", Name, "'"], Reason).

ordinary(Name) :- Name \== failed, Name \== exhausted.

edge_to(Flat, Path, Cause, node(To)) :-
    get_dict(edges, Flat, Edges),
    memberchk(edge(Path, Cause, To), Edges).

atomics_to_string(Parts, Text) :-
    atomic_list_concat(Parts, Atom),
    atom_string(Atom, Text).

target_id(Flat, node(Path), Id) :- node_id(Flat, Path, Id).
target_id(_, end(Kind), Kind).

node_id(Flat, Path, Id) :-
    get_dict(nodes, Flat, Nodes),
    memberchk(node(Path, Id), Nodes).
