:- module(planning, [ plan/5 ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(recipes)).
:- use_module(rules(parameters)).
:- use_module(rules(templates)).
:- use_module(rules(matching)).
:- use_module(rules(bindings)).
:- use_module(rules(bodies)).

/** <module> From what a recipe says and a robot to a plan

    plan(Reading, Robot, Options, Place, Result)

Result is plan{start, states, ends, transitions, unordered, notes, settings, overridden} or
failed{choices, problems}. The recipe was made flat and its steps got the skill templates that could do
them (readings.pl); of these each step gets the one that fits robot and place (templates.pl), its
arguments (bindings.pl), and from all that the graph is put together (here).
*/

%!  plan(+Reading:dict, +Robot, +Options:dict, +Place, -Result:dict) is det.
%
%   Reading as reading/2 has it. Options is _{strict, answers, offers, environment, layers, given}:
%   `answers` lists Step-Template, `given` what was asked for (parameters.pl); Place is the environment's
%   individual or class, or ''.

plan(Reading, _, _, _, failed{choices:[], problems:Problems}) :-
    get_dict(problems, Reading, Problems),
    !.
plan(Reading, Robot, Options, Place, Result) :-
    get_dict(tasks, Reading, Tasks),
    recall_tasks(Tasks),
    get_dict(answers, Options, Answers),
    get_dict(given, Options, Given),
    get_dict(nodes, Reading, Nodes),
    context(Robot, Options, Context),
    fitting_templates(Reading, Context, Options, Place, Fitting),
    chosen_templates(Nodes, Fitting, Answers, Chosen, Choices, Unserved),
    get_dict(task, Reading, Task),
    settle(Task, Given, Settled, Unsettled),
    findall(Step, member(node([Step|_], _, _, _, _), Nodes), Steps),
    unknown_answers(Answers, Steps, Unknown),
    append([Unserved, Unsettled, Unknown], Problems),
    (   Choices == [], Problems == []
    ->  keys(Chosen, Keys),
        get_dict(environment, Options, Environment),
        get_dict(templates, Reading, Templates),
        camera(Robot, Chosen, Templates, Camera),
        Setting = setting{keys:Keys, robot:Context, camera:Camera, environment:Environment,
                          place:Place, settled:Settled, given:Given},
        states(Chosen, Templates, Setting, States, Remarks0),
        unused(Given, Settled, States, Remarks0, Unused),
        append(Unused, Remarks0, Remarks),
        finish(Reading, Chosen, States, Remarks, Settled, Result)
    ;   Result = failed{choices:Choices, problems:Problems}
    ).

context(Robot, Options, context(Robot, Claims, Strict)) :-
    get_dict(strict, Options, Strict),
    get_dict(offers, Options, Offers),
    findall(Claim, ( claims(Robot, Claim) ; member(Claim, Offers) ), Found),
    sort(Found, Claims).

% Finding it takes a while; not every skill asks for it.
camera(Robot, Chosen, Templates, Camera) :-
    (   asks_for_camera(Chosen, Templates),
        robot_camera(Robot, Found)
    ->  Camera = Found
    ;   Camera = none
    ).

asks_for_camera(Chosen, Templates) :-
    member(chosen(_, candidate(Template, _, _, _), _), Chosen),
    memberchk(template(Template, _, _, Inputs, _, _), Templates),
    member(Input, Inputs),
    get_dict(sources, Input, Sources),
    member(robot(Fact), Sources),
    memberchk(Fact, [camera, camera_pose]),
    !.

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

fitting_templates(Reading, Context, Options, Place, Fitting) :-
    get_dict(templates, Reading, Templates),
    get_dict(layers, Options, Layers),
    findall(Template-Conditions, member(template(Template, _, _, _, _, Conditions), Templates), Asking),
    fitting(Asking, Context, Place, Layers, Fitting).

% chosen(Node, Candidate, Distance) for each node with one template to choose.
chosen_templates(Nodes, Fitting, Answers, Chosen, Choices, Problems) :-
    findall(Node-Choice,
            ( member(Node, Nodes),
              Node = node([Step|_], _, _, Candidates, None),
              findall(Distance-Candidate,
                      ( member(Distance-Candidate, Candidates),
                        arg(1, Candidate, Template),
                        memberchk(Template, Fitting) ),
                      Applicable),
              choose_template(Step, Applicable, None, Answers, Choice) ),
            All),
    findall(chosen(Node, Candidate, Distance), member(Node-chosen(Candidate, Distance), All), Chosen),
    findall(choice(Step, Templates),
            member(node([Step|_], _, _, _, _)-tie(Templates), All),
            Choices0),
    sort(Choices0, Choices),
    findall(Problem, member(_-none(Problem), All), Problems0),
    list_to_set(Problems0, Problems).

% -- keys: what steps create and others use --

keys(Chosen, Keys) :-
    findall(Value-made(Type, Step),
            ( member(chosen(node([Step|_], _, _, _, _), candidate(_, _, Outputs, _), _), Chosen),
              member(made(_, Type, Value), Outputs) ),
            Found),
    findall(Value, member(Value-_, Found), Values0),
    sort(Values0, Values),
    name_keys(Values, [], Named),
    findall(key(Value, Name, Type, Step),
            ( member(Value-made(Type, Step), Found), memberchk(Value-Name, Named) ),
            Keys).

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

states([], _, _, [], []).
states([chosen(Node, Candidate, Distance)|More], Templates, Setting, [State|States], Remarks) :-
    Node = node([Step|Above], Id, Said, _, _),
    Candidate = candidate(Template, Action, Made, _),
    memberchk(template(Template, Skill, Outcomes, Inputs, Manner, _), Templates),
    findall(Name, member(outcome(Name, _), Outcomes), Names),
    get_dict(keys, Setting, Keys),
    findall(Output-Key,
            ( member(made(Output, _, Value), Made), memberchk(key(Value, Key, _, _), Keys) ),
            Outputs),
    put_dict(_{path:[Step|Above], id:Id, skill:Skill, said:Said}, Setting, Here),
    bind_inputs(Here, Step, Inputs, Bound, Some),
    State = state{id:Id, step:Step, action:Action, skill:Skill, template:Template,
                  distance:Distance, inputs:Bound, outputs:Outputs, outcomes:Names, manner:Manner},
    states(More, Templates, Setting, States, Others),
    append(Some, Others, Remarks).

finish(_, _, _, Remarks, _, failed{choices:[], problems:Problems}) :-
    findall(Problem, member(problem(Problem), Remarks), Found),
    Found \== [],
    !,
    list_to_set(Found, Problems).
finish(Reading, Chosen, States, Remarks, Settled,
       plan{start:Start, states:Ordered, ends:Ends, transitions:Transitions, unordered:Unordered,
            notes:Notes, settings:Settings, overridden:Overridden}) :-
    get_dict(start, Reading, Start),
    get_dict(unordered, Reading, Unordered),
    findall(Id-Ways, member(chosen(node(_, Id, _, _, _), candidate(_, _, _, Ways), _), Chosen), All),
    reached([Start], All, [], Reached),
    findall(State, (member(Id, Reached), member(State, States), get_dict(id, State, Id)), Ordered),
    findall(Way, (member(Id, Reached), memberchk(Id-Ways, All), member(Way, Ways)), Transitions),
    findall(end(End, Success),
            ( member(end(End, Success), [end(succeeded, true), end(exhausted, false),
                                         end(failed, false)]),
              memberchk(End, Reached) ),
            Ends),
    get_dict(notes, Reading, StructureNotes),
    findall(Note, ( member(note(Note), Remarks) ; member(Note, StructureNotes)
                  ; added_note(Transitions, Note) ; nothing_found_note(Transitions, Note) ), Notes0),
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

% Breadth first along the ways of each state, ends included.
reached([], _, Seen, Reached) :-
    reverse(Seen, Reached).
reached([Id|Queue], All, Seen, Reached) :-
    memberchk(Id, Seen),
    !,
    reached(Queue, All, Seen, Reached).
reached([Id|Queue], All, Seen, Reached) :-
    findall(To, (memberchk(Id-Ways, All), member(Way, Ways), get_dict(to, Way, To)), Next),
    append(Queue, Next, Longer),
    reached(Longer, All, [Id|Seen], Reached).

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
