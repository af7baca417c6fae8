:- module(bindings,
          [ local_name/2,
            key_name/2,
            said_for/3,
            bind_inputs/5
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).
:- use_module(rules(parameters)).
:- use_module(rules(availability)).
:- use_module(rules(bodies)).

/** <module> Where the arguments of a skill come from

A setting is setting{keys, robot, camera, environment, place, settled, given, path, id, skill, said}:
`keys` a list of `key(Value, Name, Type, Producer)` for what the plan's steps create, the robot's context, its
camera (see robot_camera/2) or `none`, the environment's id ('' without one) and its individual or class
('' when unknown), the recipe's parameters and what was asked for (parameters.pl), and of the state that
the arguments are for the path, the id, the skill and what its step says (said_for/3).

A parameter is param{name, type, unit, source, origin, text, value} with value one of iri(Iri),
text(Text), key(Name), matrices(List, Frame), iris(List).
*/

:- rdf_meta
    point(r),
    no_relation(r).

%!  said_for(+Step, +Sources:list, -Said:list) is det.
%
%   `said(Property, Filler, Values)` for each source `recipe(Property, Filler)` of an input.

said_for(Step, Sources, Said) :-
    findall(said(Property, Filler, Values),
            ( member(recipe(Property, Filler), Sources),
              step_values(Step, Property, Values0),
              filled(Filler, Values0, Values) ),
            Said).

%!  bind_inputs(+Setting:dict, +Step, +Inputs:list, -Parameters:list, -Remarks:list) is det.
%
%   Inputs as template_inputs/2 has them. Remarks are `problem(Sentence)`, `note(Sentence)` and `used(Name, Parameter, Was)`: an input that
%   was asked for by Name, and the parameter that it would have been or `none`.

bind_inputs(Setting, Step, Inputs, Parameters, Remarks) :-
    bind_each(Inputs, Setting, Step, Found, Remarks),
    append(Found, Parameters).

bind_each([], _, _, [], []).
bind_each([Input|Inputs], Setting, Step, [Parameters|More], Remarks) :-
    bind(Input, Setting, Step, Parameters, Some),
    bind_each(Inputs, Setting, Step, More, Others),
    append(Some, Others, Remarks).

bind(Input, Setting, Step, Parameters, Remarks) :-
    asked_for(Input, Setting, Given),
    !,
    get_dict(name, Given, Asked),
    get_dict(type, Input, Type),
    get_dict(unit, Input, Unit),
    read_given(Given, Type, Unit, Value),
    (   Value = problem(Problem)
    ->  Parameters = [],
        Remarks = [used(Asked, none, none), problem(Problem)]
    ;   given_parameter(Value, '', Input, Setting, Step, Parameters, Remarks0),
        Parameters = [Parameter|_],
        ( bind_from_sources(Input, Setting, Step, [Was|_], _) -> true ; Was = none ),
        Remarks = [used(Asked, Parameter, Was)|Remarks0]
    ).
bind(Input, Setting, Step, Parameters, Remarks) :-
    bind_from_sources(Input, Setting, Step, Parameters, Remarks),
    !.
bind(Input, Setting, Step, [], Remarks) :-
    get_dict(optional, Input, true),
    !,
    unbound_notes(Input, Setting, Step, Remarks).
bind(Input, _, Step, [], [problem(Sentence)]) :-
    get_dict(name, Input, Name),
    get_dict(sources, Input, Sources),
    findall(Part, (member(Source, Sources), looked_at(Source, Part)), Parts),
    join(Parts, Joined),
    append(["nothing says what '", Name, "' of ", name(Step), " is; looked at "|Joined], [],
           Sentence).

bind_from_sources(Input, Setting, Step, Parameters, Remarks) :-
    get_dict(sources, Input, Sources),
    member(Source, Sources),
    from(Source, Input, Setting, Step, Parameters, Remarks),
    !.

% "state.input", "Skill.input" or "input", the most exact of them.
asked_for(Input, Setting, Given) :-
    get_dict(name, Input, Name),
    get_dict(given, Setting, All),
    get_dict(id, Setting, Id),
    get_dict(skill, Setting, Skill),
    atomic_list_concat([Id, '.', Name], OfState),
    atomic_list_concat([Skill, '.', Name], OfSkill),
    member(Wanted, [OfState, OfSkill, Name]),
    member(Given, All),
    get_dict(name, Given, Wanted),
    \+ declared(Setting, Wanted),
    !.

declared(Setting, Name) :-
    get_dict(settled, Setting, Settled),
    member(settled(_, _, One), Settled),
    get_dict(name, One, Name).

% Without an environment it is plain that nothing is said of it.
unbound_notes(Input, Setting, _, []) :-
    get_dict(environment, Setting, ''),
    get_dict(sources, Input, Sources),
    \+ ( member(Source, Sources), Source \= environment(_) ),
    !.
unbound_notes(Input, _, Step, [note(["'", Name, "' of ", name(Step), " is left open: nothing says \c
what it is, and the skill can do without"])]) :-
    get_dict(name, Input, Name).

looked_at(recipe(Property, none), [phrase(Property), " of the step"]).
looked_at(recipe(Property, Filler), [phrase(Filler), " inside ", phrase(Property), " of the step"]) :-
    Filler \== none.
looked_at(robot(Fact), ["the robot's ", Fact]).
looked_at(part(Class), ["the robot's parts of kind ", label(Class)]).
looked_at(environment(Fact), ["the environment's ", Fact]).

join([], ["nothing: its skill template names no source"]).
join([One], One) :- !.
join([One|More], Joined) :-
    join(More, Rest),
    append(One, [", "|Rest], Joined).

% -- from the recipe --

from(recipe(Property, Filler), Input, Setting, Step, Parameters, Remarks) :-
    get_dict(said, Setting, Said),
    memberchk(said(Property, Filler, [Value|Others]), Said),
    recipe_value(Value, Input, Setting, Step, Parameters, Remarks0),
    others_note(Others, Input, Step, Value, Notes),
    append(Remarks0, Notes, Remarks).
from(robot(Fact), Input, Setting, _, Parameters, Remarks) :-
    robot_fact(Fact, Setting, Input, Parameters, Remarks).
from(part(Class), Input, Setting, _, [Parameter], []) :-
    get_dict(robot, Setting, context(Robot, _, _)),
    findall(Part, component(Robot-Class, Part), Found),
    sort(Found, [Part]),
    parameter(Input, robot, Part, [label(Part)], iri(Part), Parameter).
from(environment(id), Input, Setting, _, [Parameter], []) :-
    get_dict(environment, Setting, Id),
    Id \== '',
    get_dict(place, Setting, Place),
    parameter(Input, environment, Place, [Id], text(Id), Parameter).
from(environment(place), Input, Setting, _, [Parameter], []) :-
    get_dict(place, Setting, Place),
    Place \== '',
    parameter(Input, environment, Place, [label(Place)], iri(Place), Parameter).
from(default(Text), Input, _, _, [Parameter], []) :-
    parameter(Input, template, '', [Text], text(Text), Parameter).

filled(none, Values, Named) :-
    !,
    findall(Value, (member(Value, Values), ( named(Value) -> true ; Value = literal(_, _, _) )),
            Named).
filled(Filler, Values, Inner) :-
    findall(Value,
            ( member(Outer, Values),
              atom(Outer),
              ( named(Outer) -> restriction(Outer, Filler, _, Value)
              ; own_restriction(Outer, Filler, _, Value) ) ),
            Found),
    sort(Found, Inner).

others_note([], _, _, _, []) :- !.
others_note(_, Input, Step, Value, [note([name(Step), " says several things for '", Name, "'; ",
                                          Shown, " is taken"])]) :-
    get_dict(name, Input, Name),
    ( Value = literal(Shown, _, _) -> true ; Shown = label(Value) ).

recipe_value(Value, Input, Setting, Step, Parameters, Remarks) :-
    placeholder(Value),
    !,
    get_dict(settled, Setting, Settled),
    get_dict(path, Setting, Path),
    placeholder_value(Settled, Path, Value, Settlement),
    given_parameter(Settlement, Value, Input, Setting, Step, Parameters, Remarks).
recipe_value(literal(Text, Datatype, _), Input, _, Step, Parameters, Remarks) :-
    !,
    (   get_dict(type, Input, number),
        \+ rdf_number(literal(Text, Datatype, ''), _)
    ->  get_dict(name, Input, Name),
        Parameters = [],
        Remarks = [problem(["'", Name, "' of ", name(Step), " is no finite number: '", Text, "'"])]
    ;   parameter(Input, recipe, Step, [Text], text(Text), Parameter),
        Parameters = [Parameter],
        Remarks = []
    ).
recipe_value(Value, Input, Setting, Step, [Parameter], Remarks) :-
    get_dict(keys, Setting, Keys),
    member(key(Value, Key, Type, Producer), Keys),
    Producer \== Step,
    !,
    parameter(Input, step, Value, ["what ", label(Producer), " found"], key(Key), Parameter),
    type_remarks(Input, Type, Step, Producer, Remarks).
recipe_value(Value, Input, _, _, [Parameter], []) :-
    has_matrix(Value),
    !,
    placed_matrices(Value, Matrices),
    parameter(Input, recipe, Value, [label(Value)], matrices(Matrices, map), Parameter).
recipe_value(Value, Input, Setting, _, Parameters, Remarks) :-
    \+ is_class(Value),
    get_dict(type, Input, Wanted),
    ( Wanted == pose ; Wanted == designator ),
    !,
    designator(Value, Input, Setting, Parameters, Remarks).
recipe_value(Value, Input, Setting, Step, [Parameter], Remarks) :-
    parameter(Input, recipe, Value, [label(Value)], iri(Value), Parameter),
    place_notes(Value, Setting, Step, Remarks).

% What was asked for, or what a nesting step or the recipe itself says in a parameter's place.
given_parameter(stated(Value), _, Input, Setting, Step, Parameters, Remarks) :-
    recipe_value(Value, Input, Setting, Step, Parameters, Remarks).
given_parameter(class(Class), _, Input, Setting, Step, [Parameter], Remarks) :-
    parameter(Input, request, Class, [label(Class)], iri(Class), Parameter),
    place_notes(Class, Setting, Step, Remarks).
given_parameter(text(Text), Origin, Input, _, _, [Parameter], []) :-
    parameter(Input, request, Origin, [Text], text(Text), Parameter).
given_parameter(pose(Pose), Origin, Input, _, _, [Parameter], []) :-
    parameter(Input, request, Origin, ["a pose that was asked for"], pose(Pose, map), Parameter0),
    put_dict(type, Parameter0, pose, Parameter).
given_parameter(thing(Thing), _, Input, Setting, _, [Parameter|Reference], []) :-
    parameter(Input, request, Thing, [label(Thing)], iri(Thing), Parameter0),
    put_dict(type, Parameter0, designator, Parameter),
    reference_pose(Thing, Input, Setting, Reference).
given_parameter(items(Texts, Iris), Origin, Input, _, _, [Parameter], []) :-
    named_items(Iris, Texts, Names),
    parameter(Input, request, Origin, Names, iris(Iris), Parameter).

named_items([], [], []).
named_items([Iri|Iris], [Text|Texts], Names) :-
    ( Iri == Text -> Name = Text ; Name = label(Iri) ),
    ( Iris == [] -> Names = [Name] ; Names = [Name, ", "|Rest], named_items(Iris, Texts, Rest) ).

type_remarks(Input, Type, _, _, []) :-
    get_dict(type, Input, Wanted),
    ( Wanted == Type ; Wanted == string ; Type == string ),
    !.
type_remarks(Input, Type, Step, Producer,
             [problem(["'", Name, "' of ", name(Step), " wants a ", Wanted, ", but ", name(Producer),
                       " creates a ", Type])]) :-
    get_dict(name, Input, Name),
    get_dict(type, Input, Wanted).

% -- designators: places and things described by how they stand to something --

designator(Value, Input, Setting, Parameters, Remarks) :-
    findall(Relation-Thing,
            ( rdf_asserted(Value, Relation, Thing),
              atom(Thing),
              \+ no_relation(Relation),
              \+ sub_atom(Thing, 0, _, _, '_:') ),
            Found),
    sort(Found, Relations),
    designated(Relations, Value, Input, Setting, Parameters, Remarks).

designated([], Value, Input, Setting, [Parameter], Remarks) :-
    ( point(Value) -> Text = ["the named place ", label(Value)] ; Text = [label(Value)] ),
    parameter(Input, recipe, Value, Text, iri(Value), Parameter0),
    put_dict(type, Parameter0, designator, Parameter),
    (   point(Value)
    ->  Remarks = [note(["the recipe names the place ", name(Value),
                         " without saying where it is: the robot must know it"])]
    ;   get_dict(robot, Setting, context(Robot, _, _)),
        rdf(Robot, lares:subComponent, Value)
    ->  Remarks = []
    ;   Remarks = [note(["the recipe names ", name(Value),
                         ", which is no part of this robot: the robot must know which is meant"])]
    ).
designated([Relation-Thing|More], Value, Input, Setting, [Parameter|Reference], []) :-
    relations_text([Relation-Thing|More], Text),
    parameter(Input, recipe, Value, Text, iri(Value), Parameter0),
    put_dict(type, Parameter0, designator, Parameter),
    reference_pose(Thing, Input, Setting, Reference).

relations_text([Relation-Thing], [phrase(Relation), " ", label(Thing)]) :- !.
relations_text([Relation-Thing|More], [phrase(Relation), " ", label(Thing), " and "|Rest]) :-
    relations_text(More, Rest).

no_relation(rdf:type).
no_relation(lares:relativeTo).
no_relation(owl:sameAs).
no_relation(rdfs:seeAlso).
no_relation(rdfs:isDefinedBy).

point(Value) :- rdf(Value, rdf:type, lares:'Point3D'), !.
point(Value) :- rdf(Value, rdf:type, lares:'Point2D'), !.
point(Value) :- rdf(Value, rdf:type, lares:'Place'), !.

% The newest pose at which the environment's map saw the thing.
reference_pose(Thing, Input, Setting, [Parameter]) :-
    get_dict(environment, Setting, Environment),
    Environment \== '',
    findall(When-Matrix, seen(Thing, When, Matrix), Found),
    keysort(Found, Sorted),
    last(Sorted, _-Matrix),
    placed_matrices(Matrix, Matrices),
    !,
    get_dict(name, Input, Name0),
    atom_concat(Name0, '_reference_pose', Name),
    Parameter = param{name:Name, type:pose, unit:m, source:environment, origin:Thing,
                      text:["where ", label(Thing), " was seen"], value:matrices(Matrices, map)}.
reference_pose(_, _, _, []).

seen(Thing, When, Matrix) :-
    rdf(Event, lares:objectActedOn, Thing),
    rdf(Event, lares:eventOccursAt, Matrix),
    has_matrix(Matrix),
    (   rdf(Event, lares:startTime, Time)
    ->  When = Time
    ;   When = ''
    ).
seen(Thing, '', Matrix) :-
    rdf(Thing, lares:orientation, Matrix),
    has_matrix(Matrix).

% -- the environment --

place_notes(Value, Setting, Step, [note([name(Step), " is written for ", label(Value),
                                         ", but this environment is a ", label(Kind)])]) :-
    get_dict(place, Setting, Place),
    Place \== '',
    subclass(Value, 'https://w3id.org/lares#Place'),
    \+ fits_place(Place, Value),
    place_kind(Place, Kind),
    !.
place_notes(_, _, _, []).

fits_place(Place, Class) :- subclass(Place, Class), !.
fits_place(Place, Class) :- subclass(Class, Place), !.
fits_place(Place, Class) :- rdf(Place, rdf:type, Class), !.
fits_place(Place, Class) :- Place == Class.

place_kind(Place, Place) :- is_class(Place), !.
place_kind(Place, Kind) :- fillers(Place, [Kind|_]), !.
place_kind(Place, Place).

% -- the robot --

robot_fact(base_frame, Setting, Input, [Parameter], []) :-
    get_dict(robot, Setting, context(Robot, _, _)),
    base_link(Robot, Link),
    link_name(Link, Name),
    parameter(Input, robot, Link, [Name], text(Name), Parameter).
robot_fact(camera, Setting, Input, [Parameter], Remarks) :-
    get_dict(camera, Setting, camera(Camera, _, _, Others)),
    link_name(Camera, Name),
    parameter(Input, robot, Camera, [Name], text(Name), Parameter),
    camera_notes(Others, Camera, Remarks).
robot_fact(camera_pose, Setting, Input, Parameters, Remarks) :-
    get_dict(camera, Setting, camera(Camera, Root, Matrices, _)),
    (   Root == none
    ->  get_dict(optional, Input, true),
        Parameters = [],
        Remarks = [note(["the pose of the camera ", name(Camera), " cannot be computed: no chain of \c
joints with known poses leads to it from the robot's base"])]
    ;   link_name(Root, Frame),
        parameter(Input, robot, Camera, [label(Camera), " on ", label(Root)],
                  matrices(Matrices, Frame), Parameter),
        Parameters = [Parameter],
        Remarks = []
    ).

camera_notes([], _, []) :- !.
camera_notes(Others, Camera, [note(["of the robot's cameras, ", name(Camera),
                                    " is taken and not "|Names])]) :-
    camera_names(Others, Names).

camera_names([One], [name(One)]) :- !.
camera_names([One|More], [name(One), ", "|Rest]) :- camera_names(More, Rest).

link_name(Link, Name) :-
    rdf_asserted(Link, lares:urdfName, literal(Name, _, _)),
    !.
link_name(Link, Name) :-
    local_name(Link, Name).

%!  key_name(+Value, -Name:atom) is det.
%
%   An identifier for the blackboard from an IRI's local name.

key_name(Value, Name) :-
    local_name(Value, Local),
    atom_codes(Local, Codes),
    identifier_codes(Codes, Identifier),
    (   Identifier = [First|_], code_type(First, alpha)
    ->  atom_codes(Name, Identifier)
    ;   atom_codes(Name, [0'k, 0'_|Identifier])
    ).

identifier_codes([], []).
identifier_codes([Code|Codes], [Code|Rest]) :-
    ( between(0'a, 0'z, Code) ; between(0'A, 0'Z, Code) ; between(0'0, 0'9, Code) ; Code == 0'_ ),
    !,
    identifier_codes(Codes, Rest).
identifier_codes([_|Codes], [0'_|Rest]) :-
    identifier_codes(Codes, Rest).

%!  local_name(+Iri, -Local:atom) is det.

local_name(Iri, Local) :-
    findall(Before, ( member(Separator, ['#', '/']), sub_atom(Iri, Before, 1, _, Separator) ), All),
    All \== [],
    max_list(All, Last),
    Start is Last + 1,
    sub_atom(Iri, Start, _, 0, Local),
    Local \== '',
    !.
local_name(Iri, Iri).

parameter(Input, Source, Origin, Text, Value,
          param{name:Name, type:Type, unit:Unit, source:Source, origin:Origin, text:Text,
                value:Value}) :-
    get_dict(name, Input, Name),
    get_dict(type, Input, Type),
    get_dict(unit, Input, Unit).
