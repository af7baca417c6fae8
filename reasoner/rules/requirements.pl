:- module(requirements,
          [ stated_requirements/2,
            requirement_groups/3,
            requirements_met/3,
            requirements_hold/3,
            group_verdict/3,
            requirement_problems/2
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(library(pairs)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).

/** <module> Requirements in numbers

A `lares:NumericRequirement` (ontology/requirements.ttl) bounds one quantity of one class of parts. It
is stated of a subject: a class of actions, a capability, a component, or a skill template; what is
below the subject has it too. What a subject requires of one class of parts is a group,

    group{part, bounds:[bound{quantity, unit, least, most, stated_by}]}

with `none` for an open end, and must be met by one part. `lares:Robot` as the part means the robot
itself.
*/

:- rdf_meta
    one(r, r, -),
    bound(r, r, -),
    bound_problem(r, r, r, -, -).

%!  stated_requirements(+Robot, -Stated:list) is det.
%
%   All that is required in the view, as stated(Subject, Part, Bound), except by the documents that
%   describe Robot (`none` for no robot): a robot asks nothing of itself. What is malformed is left
%   out; requirement_problems/2 tells of it.

stated_requirements(Robot, Stated) :-
    describing(Robot, Graphs),
    findall(stated(Subject, Part, Bound),
            ( rdf_asserted(Subject, lares:requires, Node),
              said_outside(Graphs, Subject, Node),
              read(Subject, Node, Part, Bound) ),
            Found),
    sort(Found, Stated).

describing(none, []) :- !.
describing(Robot, Graphs) :-
    findall(Graph, (rdf_graph(Graph), once(rdf_in(Robot, rdf:type, _, Graph))), Graphs).

said_outside([], _, _) :- !.
said_outside(Graphs, Subject, Node) :-
    rdf_graph(Graph),
    \+ memberchk(Graph, Graphs),
    rdf_in(Subject, lares:requires, Node, Graph),
    !.

read(Subject, Node, Part, bound{quantity:Quantity, unit:Unit, least:Least, most:Most,
                                stated_by:Subject}) :-
    one(Node, lares:ofPart, Part),
    one(Node, lares:quantity, Quantity),
    unit_of(Quantity, Unit),
    bound(Node, lares:atLeast, Least),
    bound(Node, lares:atMost, Most),
    \+ ( Least == none, Most == none ).

one(Node, Property, Value) :-
    findall(Value, rdf_asserted(Node, Property, Value), [Value]),
    atom(Value).

bound(Node, Property, Bound) :-
    findall(Value, rdf_asserted(Node, Property, Value), Values),
    (   Values == []
    ->  Bound = none
    ;   Values = [Value],
        rdf_number(Value, Number),
        Number >= 0,
        Bound is float(Number)
    ).

%!  unit_of(+Quantity, -Unit:string) is semidet.
%
%   The unit that ends the name of a quantity. Fails when there is none.

unit_of(Quantity, Unit) :-
    unit(Suffix, Unit),
    atom_concat(Name, Suffix, Quantity),
    \+ sub_atom(Name, _, 1, 0, '#'),
    !.

unit('_m_s', "m/s").
unit('_rad_s', "rad/s").
unit('_m', "m").
unit('_rad', "rad").
unit('_px', "px").
unit('_kg', "kg").
unit('_hz', "Hz").
unit('_s', "s").

%!  requirement_groups(+Stated:list, +Subject, -Groups:list) is det.
%
%   What Subject requires, itself and by the classes above it, one group for each class of parts.

requirement_groups(Stated, Subject, Groups) :-
    findall(Part-Bound,
            ( member(stated(Holder, Part, Bound), Stated),
              subclass(Subject, Holder) ),
            Pairs0),
    sort(Pairs0, Pairs),
    group_pairs_by_key(Pairs, Grouped),
    findall(group{part:Part, bounds:Bounds}, member(Part-Bounds, Grouped), Groups).

%!  requirements_met(+Context, +Subject, -Verdicts:list) is det.
%
%   How the robot of `context(Robot, Claims, Strict)` meets what Subject requires: one
%   `verdict{part, verdict, by, sentence}` for each group. Verdict is `met`, `unknown` (some part
%   may meet it, but the description does not give the quantity), `insufficient` or `missing` (no
%   such part at all); By is the part that it was found of, or `none`.

requirements_met(context(Robot, _, _), Subject, Verdicts) :-
    stated_requirements(Robot, Stated),
    verdicts(Robot, Stated, Subject, Verdicts).

verdicts(Robot, Stated, Subject, Verdicts) :-
    requirement_groups(Stated, Subject, Groups),
    maplist(group_verdict(Robot), Groups, Verdicts).

%!  requirements_hold(+Context, +Stated:list, +Subject) is semidet.
%
%   Everything is met of what Stated (stated_requirements/2) says of Subject; in a context that is not
%   strict, or unknown.

requirements_hold(context(Robot, _, Strict), Stated, Subject) :-
    verdicts(Robot, Stated, Subject, Verdicts),
    \+ ( member(Verdict, Verdicts),
         get_dict(verdict, Verdict, How),
         \+ holds(How, Strict) ).

holds(met, _).
holds(unknown, false).

%!  group_verdict(+Robot, +Group:dict, -Verdict:dict) is det.

group_verdict(Robot, Group, verdict{part:Class, verdict:Verdict, by:By, sentence:Sentence}) :-
    get_dict(part, Group, Class),
    get_dict(bounds, Group, Bounds),
    findall(Part, part_of(Robot, Class, Part), Found),
    sort(Found, Parts),
    findall(Rank-found(Part, How, Short),
            ( member(Part, Parts),
              bounds_verdict(Bounds, Part, How, Short),
              rank(How, Rank) ),
            Ranked),
    keysort(Ranked, Sorted),
    (   Sorted = [_-found(By, Verdict, Unmet)|_]
    ->  true
    ;   By = none, Verdict = missing, Unmet = Bounds
    ),
    verdict_sentence(Verdict, Class, By, Unmet, Sentence).

rank(met, 0).
rank(unknown, 1).
rank(insufficient, 2).

part_of(Robot, Class, Robot) :-
    rdf_equal(Class, lares:'Robot').
part_of(Robot, Class, Part) :-
    rdf(Part, rdf:type, Class),
    rdf(Robot, lares:subComponent, Part).

% The bounds that decided come along.
bounds_verdict(Bounds, Part, Verdict, Unmet) :-
    findall(How-Bound, (member(Bound, Bounds), bound_verdict(Bound, Part, How)), All),
    (   findall(Bound, member(insufficient-Bound, All), Unmet), Unmet \== []
    ->  Verdict = insufficient
    ;   findall(Bound, member(unknown-Bound, All), Unmet), Unmet \== []
    ->  Verdict = unknown
    ;   Verdict = met
    ).

% Of several values that a part states the worst counts.
bound_verdict(Bound, Part, Verdict) :-
    get_dict(quantity, Bound, Quantity),
    findall(Number, (rdf(Part, Quantity, Literal), quantity_number(Literal, Number)), Numbers),
    (   Numbers == []
    ->  Verdict = unknown
    ;   member(Number, Numbers), outside(Bound, Number)
    ->  Verdict = insufficient
    ;   Verdict = met
    ).

quantity_number(Literal, Number) :-
    \+ atom(Literal),
    rdf_number(Literal, Number).

outside(Bound, Number) :-
    (   get_dict(least, Bound, Least), Least \== none, Number < Least
    ;   get_dict(most, Bound, Most), Most \== none, Number > Most
    ),
    !.

verdict_sentence(met, Class, By, _, [label(By), " is all that is required of ", label(Class)]).
verdict_sentence(unknown, Class, By, Unmet, Sentence) :-
    bound_words(Unmet, Words),
    append(["the robot's description does not say whether ", label(By), ", its ", label(Class),
            ", has "|Words], [], Sentence).
verdict_sentence(insufficient, Class, _, Unmet, Sentence) :-
    bound_words(Unmet, Words),
    append(["no ", label(Class), " of the robot has "|Words], [], Sentence).
verdict_sentence(missing, Class, _, Unmet, Sentence) :-
    bound_words(Unmet, Words),
    append(["the robot's description lists no ", label(Class), ", of which is required "|Words], [],
           Sentence).

bound_words(Bounds, Words) :-
    findall([label(Quantity), Text],
            ( member(Bound, Bounds),
              get_dict(quantity, Bound, Quantity),
              limits_text(Bound, Text) ),
            Pairs),
    joined(Pairs, Words).

joined([], []).
joined([Last], Last) :- !.
joined([One|More], Words) :-
    joined(More, Rest),
    append(One, [", "|Rest], Words).

limits_text(Bound, Text) :-
    get_dict(unit, Bound, Unit),
    get_dict(least, Bound, Least),
    get_dict(most, Bound, Most),
    (   Most == none
    ->  format(string(Text), " of at least ~g ~w", [Least, Unit])
    ;   Least == none
    ->  format(string(Text), " of at most ~g ~w", [Most, Unit])
    ;   format(string(Text), " between ~g and ~g ~w", [Least, Most, Unit])
    ).

%!  requirement_problems(+Graph, -Problems:list) is det.
%
%   What is wrong with the requirements that the document Graph states, one sentence for each.

requirement_problems(Graph, Problems) :-
    findall(Problem,
            ( rdf_in(Subject, lares:requires, Node, Graph),
              node_problem(Subject, Node, Problem) ),
            Found),
    list_to_set(Found, Problems).

node_problem(Subject, Node, [name(Subject), " requires something that is no requirement: it must be a \c
NumericRequirement with ofPart, quantity and atLeast or atMost"]) :-
    \+ atom(Node),
    !.
node_problem(Subject, Node, Problem) :-
    problem_with(Subject, Node, Problem).

problem_with(Subject, Node, ["a requirement of ", name(Subject), " names no part, or several (ofPart; \c
lares:Robot for the robot as a whole)"]) :-
    \+ one(Node, lares:ofPart, _).
problem_with(Subject, Node, ["a requirement of ", name(Subject), " is of ", name(Part),
                             ", which is no known class of components and not Robot"]) :-
    one(Node, lares:ofPart, Part),
    \+ subclass(Part, 'https://w3id.org/lares#Component'),
    \+ rdf_equal(Part, lares:'Robot').
problem_with(Subject, Node, ["a requirement of ", name(Subject), " names no quantity, or several \c
(quantity)"]) :-
    \+ one(Node, lares:quantity, _).
problem_with(Subject, Node, ["a requirement of ", name(Subject), " bounds ", name(Quantity),
                             ", whose name does not end in a unit (_m, _rad, _px, _kg, _s, _hz, _m_s, _rad_s)"]) :-
    one(Node, lares:quantity, Quantity),
    \+ unit_of(Quantity, _).
problem_with(Subject, Node, ["a requirement of ", name(Subject), " bounds ", name(Quantity),
                             ", which is no property that the catalogue knows"]) :-
    one(Node, lares:quantity, Quantity),
    unit_of(Quantity, _),
    \+ rdf(Quantity, rdf:type, owl:'DatatypeProperty').
problem_with(Subject, Node, ["a requirement of ", name(Subject), " says neither atLeast nor atMost"]) :-
    \+ rdf_asserted(Node, lares:atLeast, _),
    \+ rdf_asserted(Node, lares:atMost, _).
problem_with(Subject, Node, Problem) :-
    end(Property, Word),
    bound_problem(Subject, Node, Property, Word, Problem).
problem_with(Subject, Node, [Said, name(Subject), Text]) :-
    bound(Node, lares:atLeast, Least), Least \== none,
    bound(Node, lares:atMost, Most), Most \== none,
    Least > Most,
    Said = "a requirement of ",
    format(string(Text), " can never be met: at least ~g and at most ~g", [Least, Most]).

end(Property, "atLeast") :- rdf_equal(Property, lares:atLeast).
end(Property, "atMost") :- rdf_equal(Property, lares:atMost).

bound_problem(Subject, Node, Property, Word, ["a requirement of ", name(Subject), " says ", Word,
                                              " twice"]) :-
    findall(Value, rdf_asserted(Node, Property, Value), [_, _|_]).
bound_problem(Subject, Node, Property, Word, ["a requirement of ", name(Subject), Text]) :-
    rdf_asserted(Node, Property, Value),
    (   literal_text(Value, Lexical), \+ quantity_number(Value, _)
    ->  format(string(Text), " says ~w \"~w\", which is no finite number", [Word, Lexical])
    ;   quantity_number(Value, Number), Number < 0
    ->  format(string(Text), " says ~w ~w: a quantity is not negative", [Word, Number])
    ).

literal_text(literal(Lexical, _, _), Lexical) :- !.
literal_text(Iri, Iri).
