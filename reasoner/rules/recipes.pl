:- module(recipes,
          [ task/1,
            task_in/2,
            task_of/2,
            remember_tasks/1,
            remembered_tasks/1,
            recall_tasks/1,
            created_by/2,
            own_restriction/4,
            own_step/2,
            structure/2,
            all_steps/2,
            step_values/3
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).

/** <module> What a recipe says, in both of its forms

A task is a class with restrictions of its own on sub-actions or state transitions. It is a state
machine (taskStartState, taskEndState, stateTransition with fromState, toState, causedBy) or a
partial order (orderingConstraints with occursBeforeInOrdering, occursAfterInOrdering). Restrictions
are read as asserted, beside each other or inside intersectionOf, typed as owl:Restriction or not.

    structure{kind, steps, starts, ends, transitions, orders}

with transitions `move(From, Cause, To, Id)`, of which a part that is not stated is `none`, and
orders `before(A, B, Id)`, likewise.
*/

:- rdf_meta
    own_restriction(r, r, -, -),
    part(r, r, -),
    stated(-, r, -),
    own_values(r, r, -).

%!  task(+Class) is semidet.
%
%   Class says itself how it is done.

task(Class) :-
    own_node(Class, Node),
    rdf_asserted(Node, owl:onProperty, Property),
    task_property(Property),
    !.

%!  task_of(+Step, -Task) is semidet.
%
%   Whose steps Step consists of: its own, or those of the most specific recipe above it, unless a
%   skill does it as a whole. Of several recipes the first by IRI.

task_of(Step, Task) :-
    nb_current(tasks_of_steps, Known),
    memberchk(Step-Found, Known),
    !,
    Found \== none,
    Task = Found.
task_of(Step, Task) :-
    find_task_of(Step, Task).

find_task_of(Step, Task) :-
    task(Step),
    !,
    Task = Step.
find_task_of(Step, Task) :-
    named_supers(Step, Supers),
    findall(Super, (member(Super, Supers), task(Super), \+ done_as_a_whole(Step, Super)), Found),
    most_specific(Found, [Task|_]).

done_as_a_whole(Step, Task) :-
    rdf_asserted(_, lares:forAction, Action),
    subclass(Action, Task),
    subclass(Step, Action),
    !.

task_property(Property) :- rdf_equal(Property, lares:subAction).
task_property(Property) :- rdf_equal(Property, lares:stateTransition).
task_property(Property) :- rdf_equal(Property, lares:taskStartState).
task_property(Property) :- rdf_equal(Property, lares:taskEndState).
task_property(Property) :- rdf_equal(Property, lares:orderingConstraints).

%!  task_in(+Graph, -Tasks:ordset) is det.
%
%   The tasks that a document describes.

task_in(Graph, Tasks) :-
    findall(Class,
            ( super_property(Super),
              rdf_in(Class, Super, _, Graph),
              named(Class) ),
            Found),
    sort(Found, Classes),
    findall(Class, (member(Class, Classes), task(Class)), Tasks).

super_property(Property) :- rdf_equal(Property, rdfs:subClassOf).
super_property(Property) :- rdf_equal(Property, owl:equivalentClass).

%!  own_restriction(+Class, ?Property, -Quantifier, -Value) is nondet.
%
%   As asserted of Class itself (or of an anonymous class); Quantifier is `some` or `value`.

own_restriction(Class, Property, Quantifier, Value) :-
    own_node(Class, Node),
    rdf_asserted(Node, owl:onProperty, Property),
    (   rdf_asserted(Node, owl:someValuesFrom, Value),
        Quantifier = some
    ;   rdf_asserted(Node, owl:hasValue, Value),
        Quantifier = value
    ).

own_node(Class, Node) :-
    named(Class),
    !,
    super_property(Super),
    rdf_asserted(Class, Super, Direct),
    \+ named(Direct),
    within(Direct, 0, Node).
own_node(Class, Node) :-
    within(Class, 0, Node).

% Anonymous classes nest; beyond any sane depth they are left alone.
within(Node, _, Node).
within(Node, Depth, Inner) :-
    Depth < 32,
    rdf_asserted(Node, owl:intersectionOf, List),
    list_member(List, Member),
    \+ named(Member),
    Deeper is Depth + 1,
    within(Member, Deeper, Inner).

%!  own_step(+Task, -Step) is nondet.

own_step(Task, Step) :-
    own_values(Task, lares:subAction, Steps),
    member(Step, Steps).

own_values(Task, Property, Values) :-
    findall(Value,
            ( own_restriction(Task, Property, _, Value), atom(Value) ),
            Found),
    sort(Found, Values).

%!  structure(+Task, -Structure:dict) is det.

structure(Task, structure{kind:Kind, steps:Steps, starts:Starts, ends:Ends,
                          transitions:Transitions, orders:Orders}) :-
    findall(Property-Value, (own_restriction(Task, Property, _, Value), atom(Value)), Stated),
    stated(Stated, lares:subAction, Steps),
    stated(Stated, lares:taskStartState, Starts),
    stated(Stated, lares:taskEndState, Ends),
    stated(Stated, lares:stateTransition, TransitionIds),
    stated(Stated, lares:orderingConstraints, OrderIds),
    findall(Move, (member(Id, TransitionIds), move(Id, Move)), Moves),
    sort(Moves, Transitions),
    findall(Order, (member(Id, OrderIds), order(Id, Order)), Found),
    sort(Found, Orders),
    (   Starts == [], Ends == [], TransitionIds == []
    ->  Kind = partial_order
    ;   Kind = state_machine
    ).

stated(Stated, Property, Values) :-
    findall(Value, member(Property-Value, Stated), Found),
    sort(Found, Values).

move(Id, move(From, Cause, To, Id)) :-
    part(Id, lares:fromState, From),
    part(Id, lares:causedBy, Cause),
    part(Id, lares:toState, To).

order(Id, before(Before, After, Id)) :-
    part(Id, lares:occursBeforeInOrdering, Before),
    part(Id, lares:occursAfterInOrdering, After).

part(Id, Property, Value) :-
    rdf_asserted(Id, Property, Value),
    atom(Value).
part(Id, Property, none) :-
    \+ rdf_asserted(Id, Property, _).

%!  remember_tasks(+Task) is det.
%
%   Until the running goal is undone, task_of/2 and created_by/2 of Task and of all its steps are looked
%   up.

remember_tasks(Task) :-
    all_steps(Task, Steps),
    findall(Step-Found,
            ( member(Step, Steps), ( find_task_of(Step, One) -> Found = One ; Found = none ) ),
            Known),
    b_setval(tasks_of_steps, Known),
    findall(Step-Values,
            ( member(Step, Steps),
              findall(Value, restriction(Step, 'https://w3id.org/lares#outputsCreated', _, Value),
                      Values) ),
            Created),
    b_setval(outputs_of_steps, Created).

%!  remembered_tasks(-Known:list) is det.
%
%   What recall_tasks/1 takes, after remember_tasks/1.

remembered_tasks(Known) :- b_getval(tasks_of_steps, Known).

%!  recall_tasks(+Known:list) is det.
%
%   Until the running goal is undone, task_of/2 is looked up in what was remembered by another goal.

recall_tasks(Known) :- b_setval(tasks_of_steps, Known).

%!  created_by(+Step, -Values:list) is semidet.
%
%   What Step creates (outputsCreated), where that was remembered.

created_by(Step, Values) :-
    nb_current(outputs_of_steps, Created),
    memberchk(Step-Values, Created).

%!  all_steps(+Task, -Steps:ordset) is det.
%
%   Task, its steps, their steps and so on.

all_steps(Task, Steps) :-
    closure([Task], [], Steps).

closure([], Seen, Steps) :-
    sort(Seen, Steps).
closure([Step|Rest], Seen, Steps) :-
    memberchk(Step, Seen),
    !,
    closure(Rest, Seen, Steps).
closure([Step|Rest], Seen, Steps) :-
    ( task_of(Step, Task) -> true ; Task = Step ),
    own_values(Task, lares:subAction, Inner),
    append(Inner, Rest, Open),
    closure(Open, [Step|Seen], Steps).

%!  step_values(+Step, +Property, -Values:list) is det.
%
%   The values that the recipe gives Property in Step: the step's own ones, else the most specific
%   inherited ones.

step_values(Step, Property, Values) :-
    findall(Value, own_restriction(Step, Property, _, Value), Own),
    Own \== [],
    !,
    sort(Own, Values).
step_values(Step, Property, Values) :-
    findall(Value, restriction(Step, Property, _, Value), Found),
    sort(Found, Sorted),
    findall(Named, (member(Named, Sorted), named(Named)), Names),
    most_specific(Names, Specific),
    findall(Other, (member(Other, Sorted), \+ named(Other)), Others),
    append(Specific, Others, Values).
