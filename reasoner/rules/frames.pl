:- module(frames,
          [ relative_matrices/3
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).

/** <module> Chains of matrices seen from another frame

Matrices are `matrix(Individual, Entries)`, the 16 entries row by row as written. What comes out is
such a list again, to be multiplied elsewhere; only the way back inwards needs arithmetic here.
*/

%!  relative_matrices(+ToBase:list, +ToNode:list, -Matrices:list) is semidet.
%
%   Both lists lead outwards from one link; Matrices lead from the end of ToBase to that of ToNode.
%   Fails when an entry of a matrix that is turned round is no number.

relative_matrices([Matrix|ToBase], [Matrix|ToNode], Matrices) :-
    !,
    relative_matrices(ToBase, ToNode, Matrices).
relative_matrices(ToBase, ToNode, Matrices) :-
    maplist(inverse, ToBase, Inverses),
    reverse(Inverses, Inwards),
    append(Inwards, ToNode, Matrices).

% Of a rigid motion: the rotation's transpose, and the translation turned back by it.
inverse(matrix(Individual, Entries), matrix(Individual, Inverse)) :-
    maplist(entry_number, Entries, [A, B, C, X, D, E, F, Y, G, H, I, Z|_]),
    catch(( X1 is -(A * X + D * Y + G * Z),
            Y1 is -(B * X + E * Y + H * Z),
            Z1 is -(C * X + F * Y + I * Z) ),
          error(evaluation_error(_), _), fail),
    maplist(entry_text, [A, D, G, X1, B, E, H, Y1, C, F, I, Z1, 0, 0, 0, 1], Inverse).

:- rdf_meta
    double(r).

double(xsd:double).

entry_number(Text, Number) :-
    double(Datatype),
    rdf_number(literal(Text, Datatype, ''), Number).

entry_text(Number, Text) :-
    atom_number(Text, Number).
