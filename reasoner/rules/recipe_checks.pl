:- module(recipe_checks,
          [ tasks/2,
            task_problems/3,
            topological/3,
            unordered_pairs/2,
            given_classes/3,
            cycle_in/2,
            chain_of/2,
            end_states/2
          ]).
:- use_module(library(lists)).
:- use_module(library(ugraphs)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).
:- use_module(rules(parameters)).
:- use_module(rules(templates)).
:- use_module(rules(requirements)).

/** <module> What is wrong with a recipe

Each problem makes a recipe unusable and is one sentence that names the things concerned.
*/

:- rdf_meta input_property(r).

%!  tasks(+Graph, -Tasks:list) is det.
%
%   `task{task, top_level, state_machine, steps, parameters, problems, warnings}` for each task of the document.

tasks(Graph, Tasks) :-
    task_in(Graph, Classes),
    findall(Task, (member(Class, Classes), described(Graph, Classes, Class, Task)), Tasks).

described(Graph, Classes, Class,
          task{task:Class, top_level:Top, state_machine:Machine, steps:Steps,
               parameters:Parameters, problems:Problems, warnings:Warnings}) :-
    structure(Class, Structure),
    get_dict(steps, Structure, Steps),
    (   member(Other, Classes), Other \== Class, all_steps(Other, Inner), memberchk(Class, Inner)
    ->  Top = false
    ;   Top = true
    ),
    ( get_dict(kind, Structure, state_machine) -> Machine = true ; Machine = false ),
    declared_parameters(Class, Parameters),
    task_problems(Graph, Class, Problems),
    task_warnings(Structure, Warnings).

declared_parameters(Class, Parameters) :-
    task_parameters(Class, Found),
    findall(Parameter,
            ( member(One, Found),
              get_dict(default, One, Default),
              default_text(Default, Text),
              put_dict(default_text, One, Text, Parameter) ),
            Parameters).

default_text(none, "") :- !.
default_text(literal(Text, _, _), [Text]) :- !.
default_text(Iri, [label(Iri)]).

%!  task_problems(+Graph, +Task, -Problems:list) is det.
%
%   Graph is the recipe's document or `none`, when only known actions can be told from unknown.

task_problems(Graph, Task, Problems) :-
    structure(Task, Structure),
    findall(Problem, problem(Graph, Task, Structure, Problem), Found),
    list_to_set(Found, Problems).

problem(Graph, _, _, Problem) :-
    Graph \== none,
    requirement_problems(Graph, Problems),
    member(Problem, Problems).
problem(_, Task, Structure, [name(Task), " has no steps"]) :-
    get_dict(steps, Structure, []).
problem(_, Task, _, [name(Task), " is among its own sub-actions: it would never end"]) :-
    own_step(Task, Direct),
    all_steps(Direct, Steps),
    member(Step, Steps),
    ( Step == Task ; task_of(Step, Task) ),
    !.
problem(Graph, _, Structure, [name(Step), " is of an unknown kind: no class above it is an action that \c
the catalogue knows (a recipe cannot use a task of another document as a step)"]) :-
    get_dict(steps, Structure, Steps),
    member(Step, Steps),
    \+ known_action(Graph, Step).
problem(Graph, _, Structure, Problem) :-
    get_dict(transitions, Structure, Moves),
    known_results(Graph, Results),
    member(move(_, Cause, _, Id), Moves),
    Cause \== none,
    \+ memberchk(Cause, Results),
    all_named(Results, Names),
    append(["transition ", name(Id), " is caused by ", name(Cause), ", which is no result that the \c
catalogue knows; it knows "|Names], [], Problem).
problem(_, Task, Structure, Problem) :-
    get_dict(kind, Structure, partial_order),
    !,
    order_problem(Task, Structure, Problem).
problem(_, Task, Structure, Problem) :-
    get_dict(steps, Structure, [_|_]),
    machine_problem(Task, Structure, Problem).

known_action(Graph, Step) :-
    named_supers(Step, Supers),
    member(Super, Supers),
    rdf(Super, rdfs:subClassOf, lares:'Action'),
    \+ rdf_equal(Super, lares:'Action'),
    (   Graph == none
    ->  true
    ;   known_outside(Graph, Super)
    ),
    !.

% A recipe cannot make up a result: no skill would ever have it.
known_results(Graph, Results) :-
    findall(Result,
            ( rdf_asserted(Result, rdf:type, lares:'ActionResult'),
              once(( rdf_graph(Other), Other \== Graph,
                     rdf_in(Result, rdf:type, lares:'ActionResult', Other) )) ),
            Found),
    sort(Found, Results).

known_outside(Graph, Class) :-
    rdf_graph(Other),
    Other \== Graph,
    rdf_in(Class, rdfs:subClassOf, _, Other),
    !.

% -- partial orders --

order_problem(Task, Structure, Problem) :-
    get_dict(steps, Structure, Steps),
    order_edges(Structure, Edges),
    vertices_edges_to_ugraph(Steps, Edges, Graph),
    cycle_in(Graph, Cycle),
    chain_of(Cycle, Chain),
    append(["the ordering constraints of ", name(Task), " go in a circle: "|Chain], [], Problem).

order_edges(Structure, Edges) :-
    get_dict(steps, Structure, Steps),
    get_dict(orders, Structure, Orders),
    findall(A-B,
            ( member(before(A, B, _), Orders), memberchk(A, Steps), memberchk(B, Steps) ),
            Found),
    sort(Found, Edges).

% Some shortest cycle.
cycle_in(Graph, Cycle) :-
    findall(Length-Path,
            ( member(Vertex-_, Graph), shortest_path(Graph, Vertex, Path),
              length(Path, Length) ),
            Paths),
    keysort(Paths, [_-Cycle|_]).

shortest_path(Graph, Vertex, Path) :-
    neighbours(Vertex, Graph, Next),
    findall([Node, Vertex], member(Node, Next), Queue),
    path_back(Queue, [], Vertex, Graph, Reversed),
    reverse(Reversed, Path).

path_back([[Vertex|Path]|_], _, Vertex, _, [Vertex|Path]) :- !.
path_back([[Node|Path]|Queue], Seen, Vertex, Graph, Found) :-
    (   memberchk(Node, Seen)
    ->  path_back(Queue, Seen, Vertex, Graph, Found)
    ;   neighbours(Node, Graph, Next),
        findall([Following, Node|Path], member(Following, Next), New),
        append(Queue, New, Longer),
        path_back(Longer, [Node|Seen], Vertex, Graph, Found)
    ).

chain_of([One], [name(One)]) :- !.
chain_of([One|More], [name(One), " → "|Rest]) :- chain_of(More, Rest).

%!  topological(+Structure:dict, -Order:list, -Unordered:list) is semidet.
%
%   The steps of a partial order in a row, of steps that are ready the first by IRI, and the groups
%   of steps that no constraint puts in order. Fails when the constraints go in a circle.

topological(Structure, Order, Unordered) :-
    get_dict(steps, Structure, Steps),
    order_edges(Structure, Edges),
    vertices_edges_to_ugraph(Steps, Edges, Graph),
    ready_first(Graph, Order),
    transitive_closure(Graph, Closure),
    findall([A, B],
            ( member(A, Steps), member(B, Steps), A @< B,
              \+ edge(A, B, Closure), \+ edge(B, A, Closure) ),
            Pairs),
    unordered_pairs(Pairs, Unordered).

edge(A, B, Graph) :- neighbours(A, Graph, Next), memberchk(B, Next).

ready_first([], []) :- !.
ready_first(Graph, [Step|Order]) :-
    findall(Target, (member(_-Targets, Graph), member(Target, Targets)), Blocked0),
    sort(Blocked0, Blocked),
    member(Step-_, Graph),
    \+ memberchk(Step, Blocked),
    !,
    del_vertices(Graph, [Step], Rest),
    ready_first(Rest, Order).

%!  unordered_pairs(+Pairs:list, -Groups:list) is det.
%
%   Pairs of a set in which everything is unordered become that one group.

unordered_pairs(Pairs, Groups) :-
    findall(A-B, (member([A, B], Pairs)), Edges0),
    findall(B-A, (member([A, B], Pairs)), Edges1),
    append(Edges0, Edges1, Edges),
    vertices_edges_to_ugraph([], Edges, Graph),
    transitive_closure(Graph, Closure),
    findall(Group, (member(_-Group0, Closure), sort(Group0, Group)), Components0),
    sort(Components0, Components),
    findall(Group, (member(Component, Components), grouped(Component, Graph, Pairs, Group)), Groups).

grouped(Component, Graph, _, Component) :-
    Component \== [],
    \+ ( member(A, Component), member(B, Component), A \== B, \+ edge(A, B, Graph) ),
    !.
grouped(Component, _, Pairs, [A, B]) :-
    member([A, B], Pairs),
    memberchk(A, Component).

% -- state machines --

machine_problem(Task, Structure, [name(Task), " has no start state"]) :-
    get_dict(starts, Structure, []).
machine_problem(Task, Structure, Problem) :-
    get_dict(starts, Structure, Starts),
    Starts = [_, _|_],
    all_named(Starts, Names),
    append([name(Task), " has more than one start state: "|Names], [], Problem).
machine_problem(Task, Structure, Problem) :-
    get_dict(steps, Structure, Steps),
    (   get_dict(starts, Structure, States), Role = "start"
    ;   get_dict(ends, Structure, States), Role = "end"
    ),
    member(State, States),
    \+ memberchk(State, Steps),
    Problem = ["the ", Role, " state ", name(State), " is no step of ", name(Task)].
machine_problem(_, Structure, ["transition ", name(Id), " does not say ", Part]) :-
    get_dict(transitions, Structure, Moves),
    member(move(From, Cause, To, Id), Moves),
    (   From == none, Part = "where it comes from (fromState)"
    ;   To == none, Part = "where it leads (toState)"
    ;   Cause == none, Part = "what causes it (causedBy)"
    ).
machine_problem(Task, Structure, ["transition ", name(Id), " ", Verb, " ", name(State),
                                  ", which is no step of ", name(Task)]) :-
    get_dict(transitions, Structure, Moves),
    get_dict(steps, Structure, Steps),
    member(move(From, _, To, Id), Moves),
    (   State = From, Verb = "comes from"
    ;   State = To, Verb = "leads to"
    ),
    State \== none,
    \+ memberchk(State, Steps),
    \+ ( State == To, rdf_equal(To, lares:'TaskFailed') ).
machine_problem(_, Structure, ["on ", name(Cause), ", ", name(From), " leads both to ", name(A),
                               " and to ", name(B)]) :-
    get_dict(transitions, Structure, Moves),
    member(move(From, Cause, A, _), Moves),
    Cause \== none, From \== none,
    member(move(From, Cause, B, _), Moves),
    A @< B.
machine_problem(Task, Structure, [name(Step), " cannot be reached from the start of ", name(Task)]) :-
    get_dict(starts, Structure, [Start]),
    get_dict(steps, Structure, Steps),
    memberchk(Start, Steps),
    move_graph(Structure, Graph),
    reachable(Start, Graph, Reached),
    member(Step, Steps),
    \+ memberchk(Step, Reached).
machine_problem(Task, Structure, Problem) :-
    move_graph(Structure, Graph),
    end_states(Structure, Stated),
    findall(End, (member(End, Stated), \+ always_leads_on(Structure, End)), Ends),
    get_dict(steps, Structure, Steps),
    findall(Step, (member(Step, Steps), stuck(Step, Graph, Ends, Steps)), Stuck),
    Stuck = [_|_],
    stuck_sentence(Stuck, Graph, Task, Problem).

stuck(Step, Graph, Ends, Steps) :-
    reachable(Step, Graph, Reached),
    \+ ( member(End, Ends), memberchk(End, Reached) ),
    \+ ( member(Way, Reached), given_classes(Way, Steps, Given), can_exhaust(Way, Given) ).

stuck_sentence(Stuck, Graph, Task, ["no end of ", name(Task), " can be reached from ", name(Step),
                                    ", and no transition leaves it"]) :-
    member(Step, Stuck),
    neighbours(Step, Graph, []),
    !.
stuck_sentence(Stuck, Graph, Task, Problem) :-
    findall(Vertex, (member(Vertex-_, Graph), \+ memberchk(Vertex, Stuck)), Others),
    del_vertices(Graph, Others, Inner),
    cycle_in(Inner, Cycle),
    !,
    chain_of(Cycle, Chain),
    append(["no end of ", name(Task), " can be reached from the cycle "|Chain], [], Problem).

move_graph(Structure, Graph) :-
    get_dict(steps, Structure, Steps),
    get_dict(transitions, Structure, Moves),
    findall(From-To,
            ( member(move(From, _, To, _), Moves), memberchk(From, Steps), memberchk(To, Steps) ),
            Edges),
    vertices_edges_to_ugraph(Steps, Edges, Graph).

% Without a stated end, the states that nothing leaves.
end_states(Structure, Ends) :-
    get_dict(ends, Structure, Stated),
    Stated = [_|_],
    !,
    Ends = Stated.
end_states(Structure, Ends) :-
    move_graph(Structure, Graph),
    findall(Step, member(Step-[], Graph), Ends).

%!  always_leads_on(+Structure:dict, +State) is semidet.
%
%   However State comes out, unless it fails or has nothing left to do, a transition leaves it: the
%   recipe cannot end there.

always_leads_on(Structure, State) :-
    get_dict(transitions, Structure, Moves),
    findall(Cause, (member(move(State, Cause, _, _), Moves), Cause \== none), Causes),
    Causes \== [],
    (   task_of(State, _)
    ->  ends_with_every([completed], Causes)
    ;   get_dict(steps, Structure, Steps),
        given_classes(State, Steps, Given),
        (   can_do(State, Causes, Given)
        ->  \+ can_end(State, Causes, Given)
        ;   ends_with_every([completed, checked], Causes)
        )
    ).

ends_with_every(Ways, Causes) :-
    member(Way, Ways),
    every_result(Way, Results),
    \+ ( member(Result, Results), \+ memberchk(Result, Causes) ),
    !.

every_result(completed, [Completed]) :- rdf_equal(Completed, lares:'COMPLETED_OK').
every_result(checked, [True, False]) :-
    rdf_equal(True, lares:'CONDITION_TRUE'),
    rdf_equal(False, lares:'CONDITION_FALSE').

%!  given_classes(+Step, +Steps, -Producers:list) is det.
%
%   Those of Steps whose outputs (outputsCreated) Step is given.

given_classes(Step, Steps, Producers) :-
    findall(Producer,
            ( input_property(Property),
              restriction(Step, Property, _, Value),
              atom(Value),
              member(Producer, Steps),
              Producer \== Step,
              creates(Producer, Value) ),
            Found),
    sort(Found, Producers).

creates(Producer, Value) :-
    created_by(Producer, Known),
    !,
    memberchk(Value, Known).
creates(Producer, Value) :-
    restriction(Producer, 'https://w3id.org/lares#outputsCreated', _, Value).

input_property(Property) :- rdf_equal(Property, lares:toLocation).
input_property(Property) :- rdf_equal(Property, lares:objectActedOn).
input_property(Property) :- rdf_equal(Property, lares:deviceUsed).

all_named([One], [name(One)]) :- !.
all_named([One|More], [name(One), ", "|Rest]) :- all_named(More, Rest).

%!  task_warnings(+Structure:dict, -Warnings:list) is det.

task_warnings(Structure, Warnings) :-
    findall(Warning, task_warning(Structure, Warning), Warnings).

task_warning(Structure, ["the ordering constraint ", name(Id),
                         " is left out: the recipe is a state machine"]) :-
    get_dict(kind, Structure, state_machine),
    get_dict(orders, Structure, Orders),
    member(before(_, _, Id), Orders).
task_warning(Structure, ["the ordering constraint ", name(Id), " is left out: it does not order two \c
steps of the recipe"]) :-
    get_dict(kind, Structure, partial_order),
    get_dict(orders, Structure, Orders),
    get_dict(steps, Structure, Steps),
    member(before(A, B, Id), Orders),
    \+ ( memberchk(A, Steps), memberchk(B, Steps) ).
task_warning(Structure, ["the end state ", name(End),
                         " is no end: however it comes out, a transition leaves it"]) :-
    get_dict(kind, Structure, state_machine),
    get_dict(ends, Structure, Ends),
    member(End, Ends),
    always_leads_on(Structure, End).
task_warning(Structure, ["no end state is stated; the states that nothing leaves are taken: "|Names]) :-
    get_dict(kind, Structure, state_machine),
    get_dict(ends, Structure, []),
    end_states(Structure, Ends),
    Ends = [_|_],
    all_named(Ends, Names).
