:- module(bodies,
          [ robots/2,
            robot_problems/2,
            base_link/2,
            robot_camera/2,
            has_matrix/1,
            placed_matrices/2
          ]).
:- use_module(library(lists)).
:- use_module(library(ugraphs)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(matching)).
:- use_module(rules(frames)).
:- use_module(rules(recipe_checks)).

/** <module> A robot's body: its links, its joints and where its camera sits

Only what the description asserts counts here. What follows from the axioms about parts makes every
link of a chain a successor of every other, and in some descriptions the robot a part of itself.
Matrices are handed out as `matrix(Individual, Entries)`, the 16 entries row by row as written; the
arithmetic is done elsewhere.
*/

:- rdf_meta
    entry(r, r, -).

%!  robots(+Graph, -Robots:ordset) is det.
%
%   The robots that a document describes.

robots(Graph, Robots) :-
    findall(Subject, described_individual(Graph, Subject), Found),
    sort(Found, Candidates),
    findall(Robot, (member(Robot, Candidates), robot(Robot)), Robots).

described_individual(Graph, Subject) :-
    rdf_in(Subject, rdf:type, Class, Graph),
    named(Subject),
    named(Class),
    \+ rdf_equal(Class, owl:'Class'),
    \+ rdf_equal(Class, lares:'UrdfLink'),
    \+ rdf_equal(Class, lares:'RotationMatrix3D').

%!  robot_problems(+Graph, -Problems:list) is det.
%
%   Joints in a circle, matrix entries that are no finite numbers, and matrices that are no poses.

robot_problems(Graph, Problems) :-
    findall(Problem, robot_problem(Graph, Problem), Found),
    list_to_set(Found, Problems).

robot_problem(Graph, Problem) :-
    findall(Parent-Child, joined_in(Graph, Parent, Child), Edges),
    vertices_edges_to_ugraph([], Edges, Chains),
    \+ top_sort(Chains, _),
    cycle_in(Chains, Cycle),
    chain_of(Cycle, Chain),
    append(["links and joints go in a circle: "|Chain], [], Problem).
robot_problem(Graph, ["entry ", phrase(Property), " of the matrix ", name(Matrix),
                      " is no finite number: '", Text, "'"]) :-
    matrix_property(Property),
    rdf_in(Matrix, Property, Literal, Graph),
    \+ rdf_number(Literal, _),
    ( Literal = literal(Text, _, _) -> true ; Text = Literal ).

robot_problem(Graph, Problem) :-
    findall(Matrix,
            ( rdf_in(Matrix, rdf:type, lares:'RotationMatrix3D', Graph),
              once(( matrix_property(Property), rdf_in(Matrix, Property, _, Graph) )) ),
            Found),
    sort(Found, Matrices),
    member(Matrix, Matrices),
    upper_entries(Matrix, Graph, Entries),
    \+ memberchk(_-unreadable, Entries),
    pose_problem(Matrix, Entries, Problem).

% Property-Values of the first three rows, row by row; the last row need not be written.
upper_entries(Matrix, Graph, Entries) :-
    findall(Property-Values,
            ( matrix_property(Property),
              \+ last_row(Property, _),
              entry_values(Matrix, Property, Graph, Values) ),
            Entries).

entry_values(Matrix, Property, Graph, Values) :-
    findall(Literal, rdf_in(Matrix, Property, Literal, Graph), Literals),
    (   member(Literal, Literals), \+ rdf_number(Literal, _)
    ->  Values = unreadable
    ;   findall(Value, (member(Literal, Literals), rdf_number(Literal, Value)), Values)
    ).

pose_problem(Matrix, Entries, ["entry ", phrase(Property), " of the matrix ", name(Matrix),
                               " is missing"]) :-
    member(Property-[], Entries).
pose_problem(Matrix, Entries, ["entry ", phrase(Property), " of the matrix ", name(Matrix),
                               " is given twice: ", A, " and ", B]) :-
    member(Property-[First|Others], Entries),
    once(( member(Other, Others), Other =\= First )),
    number_text(First, A),
    number_text(Other, B).
pose_problem(Matrix, Entries, ["the matrix ", name(Matrix), " is no pose: entries m00 to m22 are no \c
rotation"]) :-
    findall(Value, member(_-[Value|_], Entries), Values),
    Values = [A, B, C, _, D, E, F, _, G, H, I, _],
    \+ rotation([A, B, C], [D, E, F], [G, H, I]).

number_text(Number, Text) :-
    atom_number(Atom, Number),
    atom_string(Atom, Text).

% Rows of length 1 at right angles, right-handed, as far as rounded figures go.
rotation(X, Y, Z) :-
    near(X, X, 1), near(Y, Y, 1), near(Z, Z, 1),
    near(X, Y, 0), near(X, Z, 0), near(Y, Z, 0),
    X = [X0, X1, X2],
    Y = [Y0, Y1, Y2],
    C0 is X1 * Y2 - X2 * Y1,
    C1 is X2 * Y0 - X0 * Y2,
    C2 is X0 * Y1 - X1 * Y0,
    near([C0, C1, C2], Z, 1).

% Huge figures overflow: no rotation either.
near([A0, A1, A2], [B0, B1, B2], Wanted) :-
    catch(abs(A0 * B0 + A1 * B1 + A2 * B2 - Wanted) < 0.02, error(evaluation_error(_), _), fail).

joined_in(Graph, Parent, Child) :-
    joint_property(Property, Direction),
    rdf_in(Subject, Property, Object, Graph),
    (   Direction = down
    ->  Parent = Subject, Child = Object
    ;   Parent = Object, Child = Subject
    ).

joint_property(Property, down) :- rdf_equal(Property, lares:succeedingJoint).
joint_property(Property, down) :- rdf_equal(Property, lares:succeedingLink).
joint_property(Property, up) :- rdf_equal(Property, lares:precedingLink).
joint_property(Property, up) :- rdf_equal(Property, lares:precedingJoint).

%!  base_link(+Robot, -Link) is semidet.
%
%   The link that poses on Robot are seen from: the one that is stated as such, else its first.

base_link(Robot, Link) :- stated_base_link(Robot, Link), !.
base_link(Robot, Link) :-
    findall(Found,
            (   rdf_asserted(Robot, lares:baseLinkOfComposition, Found)
            ;   rdf_asserted(Robot, lares:succeedingLink, Found)
            ),
            Links0),
    sort(Links0, [Link|_]).

stated_base_link(Robot, Link) :-
    findall(Found, rdf_asserted(Robot, lares:baseFrameLink, Found), Links0),
    sort(Links0, [Link|_]).

%!  robot_camera(+Robot, -Camera:compound) is semidet.
%
%   `camera(Part, Root, Matrices, Others)`: the camera to recognise things with and the others that
%   the robot has. Colour cameras come first, then those that are links of the kinematic chain.
%   Root is the link at the chain's beginning, or the robot's base link where one is stated that hangs
%   on the same chain, and Matrices lead from it to the camera, all joints at zero. Root is `none`
%   when the chain cannot be followed.

robot_camera(Robot, camera(Camera, Root, Matrices, Others)) :-
    findall(Part, (rdf(Part, rdf:type, lares:'Camera'), rdf(Robot, lares:subComponent, Part)),
            Found),
    preferred_first(Found, Ranked),
    Ranked = [Rank-Best|_],
    findall(Good, member(Rank-Good, Ranked), Goods),
    (   member(Camera, Goods),
        jointed(Camera),
        chain(Robot, Camera, Root, Matrices)
    ->  true
    ;   member(Camera, Goods), chain(Robot, Camera, Root, Matrices)
    ->  true
    ;   Camera = Best, Root = none, Matrices = []
    ),
    findall(Other, (member(_-Other, Ranked), Other \== Camera), Others).

% Things are recognised by their colours: colour cameras, then those not named for something else.
preferred_first(Found, Ranked) :-
    sort(Found, Sorted),
    findall(Rank-Camera, (member(Camera, Sorted), camera_rank(Camera, Rank)), Unordered),
    keysort(Unordered, Ranked).

camera_rank(Camera, 0) :- rdf(Camera, rdf:type, lares:'ColorCamera'), !.
camera_rank(Camera, 2) :- sees_no_colour(Camera), !.
camera_rank(_, 1).

sees_no_colour(Camera) :-
    rdf_label(Camera, Label),
    downcase_atom(Label, Name),
    (   member(Word, [infrared, depth]), sub_atom(Name, _, _, _, Word)
    ;   atomic_list_concat(Words, '_', Name), memberchk(ir, Words)
    ;   atomic_list_concat(Words, ' ', Name), memberchk(ir, Words)
    ).

% A link of the chain itself, not a device that hangs on one.
jointed(Camera) :- rdf_asserted(_, lares:succeedingLink, Camera), !.

chain(Robot, Node, Base, Matrices) :-
    climb(Robot, Node, [Node], Root, [], FromRoot),
    (   stated_base_link(Robot, Base),
        climb(Robot, Base, [Base], Root, [], BaseFromRoot),
        relative_matrices(BaseFromRoot, FromRoot, Matrices)
    ->  true
    ;   Base = Root,
        FromRoot = [_|_],
        Matrices = FromRoot
    ).

% From a link to the link before its joint, whose pose must be known; from a device to what it hangs
% on.
climb(Robot, Node, Seen, Root, Below, Matrices) :-
    (   joint_before(Robot, Node, Joint, Link)
    ->  \+ memberchk(Link, Seen),
        joint_matrix(Joint, Matrix),
        climb(Robot, Link, [Link|Seen], Root, [Matrix|Below], Matrices)
    ;   rdf_asserted(Carrier, lares:subComponent, Node),
        Carrier \== Robot
    ->  \+ memberchk(Carrier, Seen),
        climb(Robot, Carrier, [Carrier|Seen], Root, Below, Matrices)
    ;   Root = Node,
        Matrices = Below
    ).

joint_before(Robot, Node, Joint, Link) :-
    rdf_asserted(Joint, lares:succeedingLink, Node),
    Joint \== Robot,
    (   rdf_asserted(Link, lares:succeedingJoint, Joint)
    ;   rdf_asserted(Joint, lares:precedingLink, Link)
    ),
    !.

% Stated as the joint's orientation, or by the newest event in which the robot felt it.
joint_matrix(Joint, Matrix) :-
    rdf_asserted(Joint, lares:orientation, Individual),
    !,
    matrix(Individual, Matrix).
joint_matrix(Joint, Matrix) :-
    findall(When-Individual,
            ( rdf_asserted(Event, lares:objectActedOn, Joint),
              rdf_asserted(Event, lares:eventOccursAt, Individual),
              ( rdf_asserted(Event, lares:startTime, Time) -> When = Time ; When = '' ) ),
            Found),
    keysort(Found, Sorted),
    last(Sorted, _-Individual),
    matrix(Individual, Matrix).

%!  has_matrix(+Individual) is semidet.

has_matrix(Individual) :-
    rdf_asserted(Individual, lares:m00, _),
    !.

%!  placed_matrices(+Individual, -Matrices:list) is semidet.
%
%   The matrix of Individual after those that it is relative to, outermost first.

placed_matrices(Individual, Matrices) :-
    placed(Individual, [Individual], [], Matrices).

placed(Individual, Seen, Below, Matrices) :-
    matrix(Individual, Matrix),
    (   rdf_asserted(Individual, lares:relativeTo, Outer),
        has_matrix(Outer),
        \+ memberchk(Outer, Seen)
    ->  placed(Outer, [Outer|Seen], [Matrix|Below], Matrices)
    ;   Matrices = [Matrix|Below]
    ).

matrix(Individual, matrix(Individual, Entries)) :-
    findall(Text, (matrix_property(Property), entry(Individual, Property, Text)), Entries),
    length(Entries, 16).

matrix_property(Property) :- rdf_equal(Property, lares:m00).
matrix_property(Property) :- rdf_equal(Property, lares:m01).
matrix_property(Property) :- rdf_equal(Property, lares:m02).
matrix_property(Property) :- rdf_equal(Property, lares:m03).
matrix_property(Property) :- rdf_equal(Property, lares:m10).
matrix_property(Property) :- rdf_equal(Property, lares:m11).
matrix_property(Property) :- rdf_equal(Property, lares:m12).
matrix_property(Property) :- rdf_equal(Property, lares:m13).
matrix_property(Property) :- rdf_equal(Property, lares:m20).
matrix_property(Property) :- rdf_equal(Property, lares:m21).
matrix_property(Property) :- rdf_equal(Property, lares:m22).
matrix_property(Property) :- rdf_equal(Property, lares:m23).
matrix_property(Property) :- rdf_equal(Property, lares:m30).
matrix_property(Property) :- rdf_equal(Property, lares:m31).
matrix_property(Property) :- rdf_equal(Property, lares:m32).
matrix_property(Property) :- rdf_equal(Property, lares:m33).

entry(Individual, Property, Text) :-
    rdf_asserted(Individual, Property, literal(Text, _, _)),
    !.
entry(_, Property, Text) :-
    last_row(Property, Text).

:- rdf_meta last_row(r, -).

last_row(lares:m30, '0').
last_row(lares:m31, '0').
last_row(lares:m32, '0').
last_row(lares:m33, '1').
