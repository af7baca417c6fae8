:- module(test_frames, []).
:- use_module(library(plunit)).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(rules(frames)).

:- begin_tests(frames).

% A quarter turn to the left, then 1, 2, 3 onwards; and its way back.
turned(matrix(a, ['0', '-1', '0', '1', '1', '0', '0', '2', '0', '0', '1', '3', '0', '0', '0', '1'])).
moved(matrix(b, ['1', '0', '0', '0.5', '0', '1', '0', '0', '0', '0', '1', '0', '0', '0', '0', '1'])).
unreadable(matrix(c, [x, '0', '0', '0', '0', '1', '0', '0', '0', '0', '1', '0', '0', '0', '0', '1'])).

test(what_both_ways_share_is_left_out, Matrices == [B]) :-
    turned(A), moved(B),
    relative_matrices([A], [A, B], Matrices).
test(the_way_in_is_turned_round, Numbers == [0, 1, 0, -2, -1, 0, 0, 1, 0, 0, 1, -3, 0, 0, 0, 1]) :-
    turned(A), moved(B),
    relative_matrices([A], [B], [matrix(a, Entries), B]),
    maplist(atom_number, Entries, Numbers).
test(the_last_joint_comes_first, Names == [b, a]) :-
    turned(A), moved(B),
    relative_matrices([A, B], [], Matrices),
    findall(Name, member(matrix(Name, _), Matrices), Names).
test(one_answer, all(Matrices == [[]])) :-
    turned(A),
    relative_matrices([A], [A], Matrices).
test(no_numbers, fail) :-
    unreadable(C),
    relative_matrices([C], [], _).

:- end_tests(frames).
