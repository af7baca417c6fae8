:- module(flattening,
          [ flatten_task/2,
            ends_in_failure/4,
            failure/3,
            failure_cause/3,
            exit_of_loop/4
          ]).
:- use_module(library(lists)).
:- use_module(library(ugraphs)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(recipes)).
:- use_module(rules(recipe_checks)).
:- use_module(rules(bindings)).

/** <module> A recipe and the recipes inside it as one state graph

    flat{nodes, edges, entry, exits, unordered, notes, levels}

A node is `node(Path, Id)`, Path the step with the steps that contain it, innermost first; an edge is
`edge(Path, Cause, Path)`, Cause an action result, or `any` where a whole inner recipe was completed.
`unordered` are unordered(Above, Steps): steps of one recipe that nothing puts in order.
A level is `level(Above, Moves, Ends, Inner)`: the recipe of one task, whose steps lead on by
`move(From, Cause, To)` and are entered and left by `inner(Step, Entry, Exits)`.
*/

:- rdf_meta
    edge_cause(r, -, -),
    preference(r, -).

%!  flatten_task(+Task, -Flat:dict) is det.
%
%   Task has no problems.

flatten_task(Task, flat{nodes:Nodes, edges:Edges, entry:Entry, exits:Exits, unordered:Unordered,
                        notes:[], levels:Levels}) :-
    expand(Task, [], Entry, Exits, Paths, Edges, Unordered, Levels),
    identify(Paths, Nodes).

expand(Step, Above, Entry, Exits, Paths, Edges, Unordered, [level(Above, Moves, Ends, Inner)|Levels]) :-
    task_of(Step, Task),
    structure(Task, Structure),
    moves(Structure, Start, Ends, Moves, Unordered0),
    get_dict(steps, Structure, Steps),
    expand_steps(Steps, Above, Inner, Paths, InnerEdges, InnerUnordered, Levels),
    memberchk(inner(Start, Entry, _), Inner),
    findall(Exit, (member(End, Ends), memberchk(inner(End, _, Outs), Inner), member(Exit, Outs)),
            Exits0),
    sort(Exits0, Exits),
    findall(edge(From, EdgeCause, To),
            ( member(move(A, Cause, B), Moves),
              memberchk(inner(A, _, Outs), Inner),
              memberchk(inner(B, To, _), Inner),
              member(From, Outs),
              edge_cause(Cause, A-Outs, EdgeCause) ),
            OwnEdges),
    append(OwnEdges, InnerEdges, Edges),
    findall(unordered(Above, Group), member(Group, Unordered0), Own),
    append(Own, InnerUnordered, Unordered).

% An inner recipe that is completed has ended in whatever its last step found.
edge_cause(Cause, Step-[[Step|_]], Cause) :- !.
edge_cause(lares:'COMPLETED_OK', _, any) :- !.
edge_cause(Cause, _, Cause).

expand_steps([], _, [], [], [], [], []).
expand_steps([Step|Steps], Above, [inner(Step, Entry, Exits)|Inner], Paths, Edges, Unordered,
             Levels) :-
    (   task_of(Step, _)
    ->  expand(Step, [Step|Above], Entry, Exits, Some, SomeEdges, SomeUnordered, SomeLevels)
    ;   Entry = [Step|Above],
        Exits = [Entry],
        Some = [Entry],
        SomeEdges = [],
        SomeUnordered = [],
        SomeLevels = []
    ),
    expand_steps(Steps, Above, Inner, More, MoreEdges, MoreUnordered, MoreLevels),
    append(Some, More, Paths),
    append(SomeEdges, MoreEdges, Edges),
    append(SomeUnordered, MoreUnordered, Unordered),
    append(SomeLevels, MoreLevels, Levels).

moves(Structure, Start, Ends, Moves, []) :-
    get_dict(kind, Structure, state_machine),
    !,
    get_dict(starts, Structure, [Start|_]),
    end_states(Structure, Ends),
    get_dict(transitions, Structure, Transitions),
    findall(move(From, Cause, To), member(move(From, Cause, To, _), Transitions), Found),
    sort(Found, Moves).
moves(Structure, Start, [End], Moves, Unordered) :-
    topological(Structure, Order, Unordered),
    Order = [Start|_],
    last(Order, End),
    rdf_equal(Completed, lares:'COMPLETED_OK'),
    findall(move(A, Completed, B), nextto(A, B, Order), Moves).

%!  identify(+Paths, -Nodes:list) is det.
%
%   Ids from the steps' names, with the containing steps' names in front where that is ambiguous.

identify(Paths, Nodes) :-
    findall(Path-Short, (member(Path, Paths), Path = [Step|_], id_name(Step, Short)), Named),
    identify(Named, Named, [succeeded, failed, exhausted], Nodes).

identify([], _, _, []).
identify([Path-Short|Rest], Named, Taken, [node(Path, Id)|Nodes]) :-
    (   \+ memberchk(Short, Taken),
        \+ ( member(Other-Short, Named), Other \== Path )
    ->  Id = Short
    ;   reverse(Path, Outermost),
        findall(Name, (member(Part, Outermost), id_name(Part, Name)), Names),
        atomic_list_concat(Names, '--', Long),
        unique(Long, Taken, 1, Id)
    ),
    identify(Rest, Named, [Id|Taken], Nodes).

unique(Name, Taken, Count, Id) :-
    ( Count =:= 1 -> Candidate = Name ; atomic_list_concat([Name, '--', Count], Candidate) ),
    (   memberchk(Candidate, Taken)
    ->  Next is Count + 1,
        unique(Name, Taken, Next, Id)
    ;   Id = Candidate
    ).

id_name(Step, Name) :-
    local_name(Step, Local),
    atom_codes(Local, Codes),
    findall(Safe, (member(Code, Codes), id_code(Code, Safe)), SafeCodes),
    atom_codes(Name, SafeCodes).

id_code(Code, Code) :-
    ( between(0'a, 0'z, Code) ; between(0'A, 0'Z, Code) ; between(0'0, 0'9, Code)
    ; memberchk(Code, [0'_, 0'-]) ),
    !.
id_code(_, 0'-).

%!  ends_in_failure(+Flat:dict, +Path, +Cause, -Target) is semidet.
%
%   A recipe itself says that its task has failed when the step at Path ends with Cause: the recipe of
%   the step, or one that contains it of which the step is an exit. Target is where that leads.

ends_in_failure(Flat, [Step|Above], Cause, Target) :-
    level_of(Flat, Above, Moves, _),
    rdf_equal(Failed, lares:'TaskFailed'),
    memberchk(move(Step, Cause, Failed), Moves),
    !,
    failure(Flat, Above, Target).
ends_in_failure(Flat, Path, Cause, Target) :-
    Path = [_, Nesting|Outer],
    exit_of(Flat, Path, [Nesting|Outer]),
    ends_in_failure(Flat, [Nesting|Outer], Cause, Target).

%!  failure(+Flat:dict, +Above, -Target) is det.
%
%   Where it leads when the recipe of the steps below Above has failed: to where the recipes that
%   contain it say, else to the end.

failure(_, [], end(failed)).
failure(Flat, [Nesting|Outer], Target) :-
    level_of(Flat, Outer, Moves, Inner),
    rdf_equal(Failure, lares:'COMPLETED_FAILED'),
    rdf_equal(Failed, lares:'TaskFailed'),
    (   memberchk(move(Nesting, Failure, To), Moves),
        To \== Failed,
        memberchk(inner(To, Entry, _), Inner)
    ->  Target = node(Entry)
    ;   failure(Flat, Outer, Target)
    ).

%!  failure_cause(+Flat:dict, +Path, -Cause) is nondet.
%
%   By Cause the recipe leads on from the step at Path to its failure.

failure_cause(Flat, [Step|Above], Cause) :-
    level_of(Flat, Above, Moves, _),
    rdf_equal(Failed, lares:'TaskFailed'),
    member(move(Step, Cause, Failed), Moves).

level_of(Flat, Above, Moves, Inner) :-
    get_dict(levels, Flat, Levels),
    memberchk(level(Above, Moves, _, Inner), Levels).

exit_of(Flat, Path, [Nesting|Outer]) :-
    level_of(Flat, Outer, _, Inner),
    memberchk(inner(Nesting, _, Exits), Inner),
    memberchk(Path, Exits).

%!  exit_of_loop(+Flat:dict, +Path, -Target, -Reason:string) is det.
%
%   Where to go when the skill at Path has run out of things to do: out of the innermost loop it
%   stands in. Target is node(Path) or end(Kind).

exit_of_loop(Flat, [Step|Above], Target, Reason) :-
    get_dict(levels, Flat, Levels),
    memberchk(level(Above, Moves, Ends, Inner), Levels),
    (   loop_of(Step, Moves, Loop)
    ->  leave(Loop, Moves, Ends, Inner, Above, Levels, Target, Reason)
    ;   Above == []
    ->  Target = end(failed),
        Reason = "nothing is left to try, and the recipe does not say what to do then"
    ;   exit_of_loop(Flat, Above, Target, Reason)
    ).

loop_of(Step, Moves, Loop) :-
    findall(A-B, member(move(A, _, B), Moves), Edges),
    vertices_edges_to_ugraph([Step], Edges, Graph),
    reachable(Step, Graph, After),
    findall(Member, (member(Member, After), reachable(Member, Graph, Back), memberchk(Step, Back),
                     member(Member-Targets, Graph), member(Target, Targets),
                     reachable(Target, Graph, Round), memberchk(Member, Round)),
            Found),
    sort(Found, Loop),
    memberchk(Step, Loop).

leave(Loop, Moves, _, Inner, _, _, node(Entry),
      "nothing is left to try; this is where the loop's own exit leads") :-
    findall(Rank-To,
            ( member(move(From, Cause, To), Moves),
              memberchk(From, Loop),
              \+ memberchk(To, Loop),
              memberchk(inner(To, _, _), Inner),
              preference(Cause, Rank) ),
            Exits),
    sort(Exits, [_-To|_]),
    !,
    memberchk(inner(To, Entry, _), Inner).
leave(Loop, _, Ends, _, Above, Levels, Target, "the recipe ends in this loop") :-
    member(End, Ends),
    memberchk(End, Loop),
    !,
    after_end(Above, Levels, Target).
leave(_, _, _, _, _, _, end(exhausted), "nothing is left to try, and the loop has no exit").

preference(lares:'CONDITION_TRUE', 1) :- !.
preference(lares:'COMPLETED_OK', 2) :- !.
preference(lares:'COMPLETED_FAILED', 9) :- !.
preference(_, 3).

% What follows when the recipe of the step on top of Above has ended.
after_end([], _, end(succeeded)).
after_end([Step|Above], Levels, Target) :-
    memberchk(level(Above, Moves, Ends, Inner), Levels),
    rdf_equal(Completed, lares:'COMPLETED_OK'),
    (   memberchk(move(Step, Completed, To), Moves)
    ->  memberchk(inner(To, Entry, _), Inner),
        Target = node(Entry)
    ;   memberchk(Step, Ends)
    ->  after_end(Above, Levels, Target)
    ;   Target = end(failed)
    ).
