:- module(parameters,
          [ task_parameters/2,
            placeholder/1,
            settle/4,
            unknown_settings/4,
            placeholder_value/4,
            read_given/4
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).

/** <module> What a recipe leaves to whoever asks for a plan

A recipe declares a parameter as an individual of lares:RecipeParameter that stands in its steps
where the value will be (a placeholder), and says of it `parameterOf` (the task), `parameterName`,
`parameterType`, and, where it likes, `parameterUnit`, `valuesBelow` (a class above the value),
`parameterDefault`, `optionalParameter`, and `parameterProperty`: with which property a step that
nests the recipe gives the value.

What was asked for comes as `given{name, text, classes, things, items}`: the text, the classes and the
individuals that go equally well by it, and the same of each part of a list. A value that was read is
one of class(Iri), thing(Iri), text(Text), pose(Text), items(Texts, Iris) or stated(Value), which is what
the recipe itself says.
*/

%!  task_parameters(+Task, -Parameters:list) is det.
%
%   `parameter{placeholder, name, type, unit, below, default, optional, property}` by name; `none` for
%   what is not stated.

task_parameters(Task, Parameters) :-
    findall(Name-parameter{placeholder:Node, name:Name, type:Type, unit:Unit, below:Below,
                           default:Default, optional:Optional, property:Property},
            ( rdf_asserted(Node, lares:parameterOf, Task),
              text(Node, lares:parameterName, '', Name),
              text(Node, lares:parameterType, string, Type),
              text(Node, lares:parameterUnit, '', Unit),
              text(Node, lares:optionalParameter, false, Optional),
              stated(Node, lares:valuesBelow, Below),
              stated(Node, lares:parameterDefault, Default),
              stated(Node, lares:parameterProperty, Property) ),
            Found),
    keysort(Found, Sorted),
    findall(Parameter, member(_-Parameter, Sorted), Parameters).

:- rdf_meta
    text(r, r, -, -),
    stated(r, r, -).

text(Node, Property, _, Text) :-
    rdf_asserted(Node, Property, literal(Found, _, _)),
    !,
    ( atom(Found) -> Text = Found ; atom_string(Text, Found) ).
text(_, _, Default, Default).

stated(Node, Property, Value) :-
    rdf_asserted(Node, Property, Value),
    !.
stated(_, _, none).

%!  placeholder(+Value) is semidet.

placeholder(Value) :-
    atom(Value),
    rdf_asserted(Value, lares:parameterOf, _),
    !.

%!  settle(+Task, +Given:list, -Settled:list, -Problems:list) is det.
%
%   `settled(Placeholder, Value, Setting)` for each declared parameter of Task that has a value; Setting
%   is setting{name, type, unit, value, default}.

settle(Task, Given, Settled, Problems) :-
    task_parameters(Task, Parameters),
    findall(Outcome, (member(Parameter, Parameters), settle_one(Task, Parameter, Given, Outcome)),
            Outcomes),
    findall(settled(Placeholder, Value, Setting),
            member(settled(Placeholder, Value, Setting), Outcomes), Settled),
    findall(Problem, member(problem(Problem), Outcomes), Problems).

settle_one(_, Parameter, Given, Outcome) :-
    get_dict(name, Parameter, Name),
    member(One, Given),
    get_dict(name, One, Name),
    !,
    get_dict(type, Parameter, Type),
    get_dict(unit, Parameter, Unit),
    (   read_given(One, Type, Unit, Value),
        Value = problem(Problem)
    ->  Outcome = problem(Problem)
    ;   read_given(One, Type, Unit, Value),
        below_problem(Parameter, Value, Problem)
    ->  Outcome = problem(Problem)
    ;   read_given(One, Type, Unit, Value),
        settled_as(Parameter, Value, false, Outcome)
    ).
settle_one(_, Parameter, _, Outcome) :-
    get_dict(default, Parameter, Default),
    Default \== none,
    !,
    settled_as(Parameter, stated(Default), true, Outcome).
settle_one(Task, Parameter, _, problem([label(Task), " needs a value for '", Name, "' (", Type|Rest])) :-
    get_dict(optional, Parameter, Optional),
    Optional \== true,
    get_dict(name, Parameter, Name),
    get_dict(type, Parameter, Type),
    (   get_dict(below, Parameter, Below), Below \== none
    ->  Rest = [", a kind of ", label(Below), "); give it as ", Name, "=…"]
    ;   Rest = ["); give it as ", Name, "=…"]
    ).

settled_as(Parameter, Value, IsDefault,
           settled(Placeholder, Value, setting{name:Name, type:Type, unit:Unit, value:Value,
                                               default:IsDefault})) :-
    get_dict(placeholder, Parameter, Placeholder),
    get_dict(name, Parameter, Name),
    get_dict(type, Parameter, Type),
    get_dict(unit, Parameter, Unit).

below_problem(Parameter, Value, ["'", Name, "' must be a kind of ", label(Below), ", and ",
                                 label(One), " is none"]) :-
    get_dict(below, Parameter, Below),
    Below \== none,
    ( Value = class(One) ; Value = thing(One) ; Value = items(_, Items), member(One, Items) ),
    \+ subclass(One, Below),
    \+ rdf(One, rdf:type, Below),
    !,
    get_dict(name, Parameter, Name).

%!  unknown_settings(+Given:list, +Settled:list, +Used:list, -Names:list) is det.
%
%   Names that were given but neither declared nor, as Used tells, inputs of any step.

unknown_settings(Given, Settled, Used, Names) :-
    findall(Name,
            ( member(One, Given),
              get_dict(name, One, Name),
              \+ memberchk(Name, Used),
              \+ ( member(settled(_, _, Setting), Settled), get_dict(name, Setting, Name) ) ),
            Names).

%!  placeholder_value(+Settled:list, +Path:list, +Placeholder, -Value) is semidet.
%
%   Path is a step with the steps that contain it, innermost first. The value that the step which
%   nests the placeholder's recipe states, else what was settled.

placeholder_value(Settled, [_|Above], Placeholder, Value) :-
    rdf_asserted(Placeholder, lares:parameterOf, Task),
    append(_, [Nesting|Outer], Above),
    task_of(Nesting, Task),
    !,
    nested_value(Settled, [Nesting|Outer], Placeholder, Value).
placeholder_value(Settled, _, Placeholder, Value) :-
    memberchk(settled(Placeholder, Value, _), Settled).

nested_value(Settled, [Nesting|Outer], Placeholder, Value) :-
    rdf_asserted(Placeholder, lares:parameterProperty, Property),
    step_values(Nesting, Property, Values0),
    findall(One, (member(One, Values0), One \== Placeholder), [Stated|_]),
    !,
    (   placeholder(Stated)
    ->  placeholder_value(Settled, [Nesting|Outer], Stated, Value)
    ;   Value = stated(Stated)
    ).
nested_value(_, _, Placeholder, stated(Default)) :-
    rdf_asserted(Placeholder, lares:parameterDefault, Default),
    !.

%!  read_given(+Given:dict, +Type:atom, +Unit:atom, -Value) is det.
%
%   Value may be problem(Sentence).

read_given(Given, Type, Unit, Value) :-
    get_dict(text, Given, Text),
    get_dict(name, Given, Name),
    (   many_meant(Type, Given, Text0, Many)
    ->  names_of(Many, Names),
        append(["'", Name, "' may be, for '", Text0, "', "|Names], [": write the IRI"], Sentence),
        Value = problem(Sentence)
    ;   read_value(Type, Unit, Given, Value0)
    ->  Value = Value0
    ;   wanted(Type, Unit, Wanted),
        Value = problem(["'", Name, "' must be ", Wanted, ", not '", Text, "'"])
    ).

% Only what the type asks for can be ambiguous.
many_meant(Type, Given, Text, Many) :-
    meaning_of(Type, Key, Whole),
    (   Whole == true
    ->  One = Given
    ;   get_dict(items, Given, Items),
        member(One, Items)
    ),
    get_dict(Key, One, Many),
    Many = [_, _|_],
    get_dict(text, One, Text),
    \+ ( Key == things, pose_text(Text, _) ),
    !.

meaning_of(class, classes, true).
meaning_of(class_list, classes, false).
meaning_of(designator, things, true).
meaning_of(pose, things, true).
meaning_of(designator_list, things, false).

names_of([One], [name(One)]) :- !.
names_of([One|More], [name(One), " or "|Rest]) :- names_of(More, Rest).

read_value(class, _, Given, class(Class)) :-
    get_dict(classes, Given, [Class]).
read_value(class_list, _, Given, items(Texts, Classes)) :-
    list_of(classes, Given, Texts, Classes).
read_value(designator_list, _, Given, items(Texts, Things)) :-
    list_of(things, Given, Texts, Things).
read_value(pose_list, _, Given, items(Texts, Poses)) :-
    get_dict(items, Given, Items),
    Items = [_|_],
    findall(Pose, (member(Item, Items), get_dict(text, Item, Text), pose_text(Text, Pose)), Poses),
    length(Items, Count),
    length(Poses, Count),
    Texts = Poses.
read_value(designator, _, Given, Value) :- thing_or_pose(Given, Value).
read_value(pose, _, Given, Value) :- thing_or_pose(Given, Value).
read_value(number, Unit, Given, text(Number)) :-
    get_dict(text, Given, Text),
    number_with_unit(Text, Unit, Number).
read_value(boolean, _, Given, text(Text)) :-
    get_dict(text, Given, Text),
    memberchk(Text, [true, false]).
read_value(string, _, Given, text(Text)) :-
    get_dict(text, Given, Text),
    Text \== ''.

thing_or_pose(Given, pose(Pose)) :-
    get_dict(text, Given, Text),
    pose_text(Text, Pose),
    !.
thing_or_pose(Given, thing(Thing)) :-
    get_dict(things, Given, [Thing]).

list_of(Key, Given, Texts, Iris) :-
    get_dict(items, Given, Items),
    Items = [_|_],
    findall(Text-Iri, (member(Item, Items), get_dict(text, Item, Text), get_dict(Key, Item, [Iri])),
            Found),
    length(Items, Count),
    length(Found, Count),
    findall(Text, member(Text-_, Found), Texts),
    findall(Iri, member(_-Iri, Found), Iris).

% "x y yaw" or "x y z qx qy qz qw", in the map frame.
pose_text(Text, Pose) :-
    split_string(Text, " ", " ", Parts0),
    exclude_empty(Parts0, Parts),
    length(Parts, Length),
    memberchk(Length, [3, 7]),
    findall(Number, (member(Part, Parts), finite(Part, Number)), Numbers),
    length(Numbers, Length),
    full_pose(Numbers, Full),
    atomic_list_concat(Full, ' ', Pose).

exclude_empty(Parts, Kept) :-
    findall(Part, (member(Part, Parts), Part \== ""), Kept).

% In the notation of XML Schema, as everywhere else, not in Prolog's.
finite(Text, Number) :-
    atom_string(Atom, Text),
    rdf_number(literal(Atom, '', ''), Number),
    abs(Number) < 1.0e9.

full_pose([X, Y, Yaw], [X, Y, 0, 0, 0, Sine, Cosine]) :-
    !,
    Sine0 is sin(Yaw / 2.0),
    Cosine0 is cos(Yaw / 2.0),
    rounded(Sine0, Sine),
    rounded(Cosine0, Cosine).
full_pose([X, Y, Z, A, B, C, D], [X, Y, Z, A, B, C, D]) :-
    Norm is A * A + B * B + C * C + D * D,
    abs(Norm - 1.0) < 0.01.

rounded(Value, Rounded) :- Rounded is round(Value * 1.0e6) / 1.0e6.

number_with_unit(Text, Unit, Number) :-
    split_string(Text, " ", " ", Parts0),
    exclude_empty(Parts0, Parts),
    (   Parts = [Plain]
    ->  true
    ;   Parts = [Plain, Named], atom_string(Unit, Named)
    ),
    finite(Plain, _),
    atom_string(Number, Plain).

wanted(class, _, "a class that is known here").
wanted(class_list, _, "classes that are known here, separated by commas").
wanted(designator, _, "a thing of the environment or a pose ('x y yaw')").
wanted(pose, _, "a thing of the environment or a pose ('x y yaw')").
wanted(designator_list, _, "things of the environment, separated by commas").
wanted(pose_list, _, "poses ('x y yaw'), separated by commas").
wanted(number, '', "a finite number") :- !.
wanted(number, Unit, Wanted) :-
    atomic_list_concat(['a finite number in ', Unit], Atom),
    atom_string(Atom, Wanted).
wanted(boolean, _, "true or false").
wanted(string, _, "a text").
wanted(Type, _, Wanted) :-
    \+ memberchk(Type, [class, class_list, designator, pose, designator_list, pose_list, number,
                        boolean, string]),
    atomic_list_concat(['of the type ', Type, ', which is not known'], Atom),
    atom_string(Atom, Wanted).
