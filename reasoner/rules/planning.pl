:- module(planning, [ plan/5 ]).
:- use_module(library(lists)).
:- use_module(library(ugraphs)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(recipes)).
:- use_module(rules(recipe_checks)).
:- use_module(rules(parameters)).
:- use_module(rules(templates)).
:- use_module(rules(matching)).
:- use_module(rules(bindings)).
:- use_module(rules(bodies)).
:- use_module(rules(flattening)).

/** <module> From a recipe and a robot to a plan

    plan(Task, Robot, Options, Place, Result)

Result is plan{start, states, transitions, unordered, notes, settings} or failed{choices, problems}. The
recipe is made flat (flattening.pl), each step gets a skill template (templates.pl), its arguments
(bindings.pl) and a way on for every outcome (here).
*/

:- rdf_meta result_kind(r, -).

%!  plan(+Task, +Robot, +Options:dict, +Place, -Result:dict) is det.
%
%   Options is _{strict, answers, environment, layers, given}: `answers` lists Step-Template, `given`
%   what was asked for (parameters.pl); Place is the environment's individual or class, or ''.

plan(Task, Robot, Options, Place, Result) :-
    remember_tasks(Task),
    plan_remembered(Task, Robot, Options, Place, Result).

plan_remembered(Task, _, _, _, failed{choices:[], problems:Problems}) :-
    all_steps(Task, Steps),
    findall(Problem,
            ( member(Step, Steps), ( Step == Task -> Described = Step ; task_of(Step, Described) ),
              task_problems(none, Described, Some), member(Problem, Some) ),
            Found),
    Found \== [],
    !,
    list_to_set(Found, Problems).
plan_remembered(Task, Robot, Options, Place, Result) :-
    get_dict(strict, Options, Strict),
    get_dict(answers, Options, Answers),
    get_dict(layers, Options, Layers),
    get_dict(given, Options, Given),
    get_dict(offers, Options, Offers),
    findall(Claim, ( claims(Robot, Claim) ; member(Claim, Offers) ), Claims0),
    sort(Claims0, Claims),
    Context = context(Robot, Claims, Strict),
    flatten_task(Task, Flat),
    chosen_templates(Flat, here(Context, Place, Layers), Answers, Chosen, Choices, Unserved),
    settle(Task, Given, Settled, Unsettled),
    get_dict(nodes, Flat, Nodes),
    findall(Step, member(node([Step|_], _), Nodes), Steps),
    unknown_answers(Answers, Steps, Unknown),
    append([Unserved, Unsettled, Unknown], Problems),
    (   Choices == [], Problems == []
    ->  keys(Chosen, Keys),
        ( robot_camera(Robot, Camera) -> true ; Camera = none ),
        get_dict(environment, Options, Environment),
        Setting = setting{keys:Keys, robot:Context, camera:Camera, environment:Environment,
                          place:Place, settled:Settled, given:Given},
        states(Chosen, Setting, States, Remarks0),
        unused(Given, Settled, States, Remarks0, Unused),
        append(Unused, Remarks0, Remarks),
        finish(Flat, Chosen, States, Remarks, Settled, Result)
    ;   Result = failed{choices:Choices, problems:Problems}
    ).

unused(Given, Settled, States, Remarks, Unused) :-
    findall(Name, member(used(Name, _, _), Remarks), Used),
    unknown_settings(Given, Settled, Used, Names),
    findall(Name, ( member(settled(_, _, Setting), Settled), get_dict(name, Setting, Name)
                  ; member(State, States), get_dict(inputs, State, Inputs), member(Input, Inputs),
                    get_dict(name, Input, Name) ), Known0),
    sort(Known0, Known),
    comma_list(Known, List),
    findall(problem(["'", Name, "' is no parameter of this recipe and no input of its skills; there are "|
                     List]),
            member(Name, Names), Unused).

comma_list([], ["none"]) :- !.
comma_list([One], [One]) :- !.
comma_list([One|More], [One, ", "|Rest]) :- comma_list(More, Rest).

% -- templates --

chosen_templates(Flat, here(Context, Place, Layers), Answers, Chosen, Choices, Problems) :-
    get_dict(nodes, Flat, Nodes),
    findall(Step, member(node([Step|_], _), Nodes), Steps),
    findall(Node-Choice,
            ( member(Node, Nodes),
              Node = node([Step|Above], _),
              causes(Flat, [Step|Above], Causes),
              given_classes(Step, Steps, Given),
              choose_template(situation{step:Step, causes:Causes, given:Given, robot:Context,
                                        place:Place, layers:Layers},
                              Answers, Choice) ),
            All),
    findall(chosen(Path, Id, Template, Action, Distance),
            member(node(Path, Id)-chosen(Template, Action, Distance), All),
            Chosen),
    findall(choice(Step, Templates), member(node([Step|_], _)-tie(Templates), All), Choices0),
    sort(Choices0, Choices),
    findall(Problem, member(_-none(Problem), All), Problems0),
    list_to_set(Problems0, Problems).

causes(Flat, Path, Causes) :-
    get_dict(edges, Flat, Edges),
    findall(Cause, ( member(edge(Path, Cause, _), Edges) ; failure_cause(Flat, Path, Cause) ), Found),
    sort(Found, Causes).

% -- keys: what steps create and others use --

keys(Chosen, Keys) :-
    findall(Value-made(Type, Step),
            ( member(chosen([Step|_], _, Template, _, _), Chosen),
              output_value(Step, Template, _, Type, Value) ),
            Found),
    findall(Value, member(Value-_, Found), Values0),
    sort(Values0, Values),
    name_keys(Values, [], Named),
    findall(key(Value, Name, Type, Step),
            ( member(Value-made(Type, Step), Found), memberchk(Value-Name, Named) ),
            Keys).

output_value(Step, Template, Name, Type, Value) :-
    template_outputs(Template, Outputs),
    member(output(Name, Type, Property), Outputs),
    step_values(Step, Property, Values),
    findall(IriValue, (member(IriValue, Values), atom(IriValue)), [Value|_]).

name_keys([], _, []).
name_keys([Value|Values], Taken, [Value-Name|Rest]) :-
    key_name(Value, Wanted),
    free_name(Wanted, Taken, 1, Name),
    name_keys(Values, [Name|Taken], Rest).

free_name(Wanted, Taken, _, Wanted) :-
    \+ memberchk(Wanted, Taken),
    !.
free_name(Wanted, Taken, Count, Name) :-
    Next is Count + 1,
    atomic_list_concat([Wanted, '_', Next], Candidate),
    (   memberchk(Candidate, Taken)
    ->  free_name(Wanted, Taken, Next, Name)
    ;   Name = Candidate
    ).

% -- states --

states([], _, [], []).
states([chosen([Step|Above], Id, Template, Action, Distance)|More], Setting, [State|States],
       Remarks) :-
    template_skill(Template, Skill),
    template_outcomes(Template, Outcomes),
    findall(Name, member(outcome(Name, _), Outcomes), Names),
    get_dict(keys, Setting, Keys),
    findall(Output-Key,
            ( output_value(Step, Template, Output, _, Value),
              once(member(key(Value, Key, _, _), Keys)) ),
            Outputs),
    put_dict(_{path:[Step|Above], id:Id, skill:Skill}, Setting, Here),
    bind_inputs(Here, Step, Template, Inputs, Some),
    template_manner(Template, Manner),
    State = state{path:[Step|Above], id:Id, step:Step, action:Action, skill:Skill,
                  template:Template, distance:Distance, inputs:Inputs, outputs:Outputs,
                  outcomes:Names, manner:Manner},
    states(More, Setting, States, Others),
    append(Some, Others, Remarks).

finish(_, _, _, Remarks, _, failed{choices:[], problems:Problems}) :-
    findall(Problem, member(problem(Problem), Remarks), Found),
    Found \== [],
    !,
    list_to_set(Found, Problems).
finish(Flat, Chosen, States, Remarks, Settled,
       plan{start:Start, states:Ordered, ends:Ends, transitions:Transitions, unordered:Unordered,
            notes:Notes, settings:Settings, overridden:Overridden}) :-
    findall(Transition,
            ( member(chosen(Path, Id, Template, _, _), Chosen),
              template_outcomes(Template, Outcomes),
              member(outcome(Name, Result), Outcomes),
              way_on(Flat, Path, Name, Result, Target, Added, Reason),
              target_id(Flat, Target, To),
              Transition = transition{from:Id, outcome:Name, to:To, added:Added, reason:Reason} ),
            AllTransitions),
    get_dict(entry, Flat, Entry),
    node_id(Flat, Entry, Start),
    reached([Start], AllTransitions, [], Reached),
    findall(State, (member(Id, Reached), member(State, States), get_dict(id, State, Id)), Ordered),
    findall(Transition,
            ( member(Id, Reached), member(Transition, AllTransitions),
              get_dict(from, Transition, Id) ),
            Transitions),
    findall(end(Id, Success),
            ( member(end(Kind, Success), [end(succeeded, true), end(exhausted, false),
                                          end(failed, false)]),
              target_id(Flat, end(Kind), Id),
              memberchk(Id, Reached) ),
            Ends),
    get_dict(unordered, Flat, Groups),
    findall(group{steps:Steps, ids:Ids},
            ( member(unordered(Above, Steps), Groups),
              findall(Id, (member(Step, Steps), node_id(Flat, [Step|Above], Id)), Ids) ),
            Unordered),
    findall(Note, (member(note(Note), Remarks) ; structure_note(Flat, Note)
                  ; added_note(Transitions, Note) ; nothing_found_note(Transitions, Note)), Notes0),
    list_to_set(Notes0, Notes),
    findall(Set, (member(settled(_, Value, One), Settled), setting_text(Value, One, Set)), Settings),
    findall(overridden(Name, Parameter, Was), member(used(Name, Parameter, Was), Remarks),
            Overridden).

setting_text(Value, One, set{name:Name, type:Type, unit:Unit, default:Default, value:Text,
                             text:Sentence}) :-
    get_dict(name, One, Name),
    get_dict(type, One, Type),
    get_dict(unit, One, Unit),
    get_dict(default, One, Default),
    value_text(Value, Text, Sentence).

value_text(class(Iri), Iri, [label(Iri)]).
value_text(thing(Iri), Iri, [label(Iri)]).
value_text(text(Text), Text, [Text]).
value_text(pose(Pose), Pose, [Pose]).
value_text(items(_, Iris), Text, Sentence) :-
    atomic_list_concat(Iris, ' ', Text),
    findall(label(Iri), member(Iri, Iris), Labels),
    comma_list(Labels, Sentence).
value_text(stated(literal(Text, _, _)), Text, [Text]) :- !.
value_text(stated(Iri), Iri, [label(Iri)]).

% Breadth first along the transitions, ends included.
reached([], _, Seen, Reached) :-
    reverse(Seen, Reached).
reached([Id|Queue], Transitions, Seen, Reached) :-
    memberchk(Id, Seen),
    !,
    reached(Queue, Transitions, Seen, Reached).
reached([Id|Queue], Transitions, Seen, Reached) :-
    findall(To, (member(Transition, Transitions), get_dict(from, Transition, Id),
                 get_dict(to, Transition, To)), Next),
    append(Queue, Next, Longer),
    reached(Longer, Transitions, [Id|Seen], Reached).

structure_note(Flat, ["the recipe does not say in which order these are done: "|Names]) :-
    get_dict(unordered, Flat, Groups),
    member(unordered(_, Group), Groups),
    naming(Group, Names).
structure_note(Flat, Note) :-
    get_dict(notes, Flat, Notes),
    member(Note, Notes).

naming([One], [label(One)]) :- !.
naming([One|More], [label(One), ", "|Rest]) :- naming(More, Rest).

added_note(Transitions, ["added: ", From, " on '", Outcome, "' leads to ", To, " (", Reason, ")"]) :-
    member(Transition, Transitions),
    get_dict(added, Transition, true),
    get_dict(outcome, Transition, Outcome),
    Outcome \== failed,
    get_dict(from, Transition, From),
    get_dict(to, Transition, To),
    get_dict(reason, Transition, Reason).

nothing_found_note(Transitions, ["the plan also ends as succeeded when nothing was found: from ", From,
                                 " on 'exhausted' by way of "|Names]) :-
    member(Transition, Transitions),
    get_dict(added, Transition, true),
    get_dict(outcome, Transition, exhausted),
    get_dict(from, Transition, From),
    get_dict(to, Transition, To),
    straight_on([To], Transitions, Path),
    plain_names(Path, Names).

% Shortest path to the successful end that needs no further decision of the exhausted loop.
straight_on([succeeded|Path], _, Names) :-
    !,
    reverse([succeeded|Path], Names).
straight_on([Id|Path], Transitions, Names) :-
    member(Transition, Transitions),
    get_dict(from, Transition, Id),
    get_dict(outcome, Transition, Outcome),
    \+ memberchk(Outcome, [failed, exhausted]),
    get_dict(to, Transition, To),
    \+ memberchk(To, [Id|Path]),
    straight_on([To, Id|Path], Transitions, Names),
    !.

plain_names([One], [One]) :- !.
plain_names([One|More], [One, " → "|Rest]) :- plain_names(More, Rest).

% -- the way on from an outcome --

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
