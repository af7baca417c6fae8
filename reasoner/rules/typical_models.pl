:- module(typical_models,
          [ choose/6,
            places_for/3,
            evidence/3,
            use/3
          ]).
:- use_module(library(lists)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(availability)).

/** <module> Which stored object models are worth loading for a kind of room

Logic only: which rows of a table of likely places speak for a model, and whether a robot can use
it. What the rows amount to, the order and the budget are C++ (reasoner/models).

A row is `row(Object, Place)`: the table counts things of the class Object in places of the class
Place. A kind is `kind(Class, Above)`, what a model is a model of; Above are the classes that the
model's own description puts it under, which the view need not know. An algorithm is
`algorithm(Iri, Classes)`; one without classes is unstated.
*/

%!  choose(+Room, +Rows:list, +Kinds:list, +Algorithms:list, +Robot, -Choice) is det.
%
%   Choice is choice(Places, Evidence, Uses): see places_for/3; one of evidence/3 for each of Kinds;
%   one of use/3 for each of Algorithms. Robot is an IRI, or '' for none.

choose(Room, Rows, Kinds, Algorithms, Robot, choice(Places, Evidence, Uses)) :-
    places_for(Room, Rows, Places),
    counted_in(Places, Rows, Objects),
    findall(Found, (member(Kind, Kinds), evidence(Kind, Objects, Found)), Evidence),
    findall(Use, (member(Algorithm, Algorithms), use(Algorithm, Robot, Use)), Uses).

%!  places_for(+Room, +Rows:list, -Places) is det.
%
%   here(Classes): the places of Rows that are rooms of the kind Room. Where there are none,
%   as(Super): the nearest kind of place above Room that has rows, or else `unknown`.

places_for(Room, Rows, Places) :-
    must_be_bound(Room),
    findall(Place, member(row(_, Place), Rows), All),
    sort(All, Distinct),
    findall(Place, (member(Place, Distinct), subclass(Place, Room)), Here),
    (   Here \== []
    ->  Places = here(Here)
    ;   nearest([Room], Distinct, Super)
    ->  Places = as(Super)
    ;   Places = unknown
    ).

counted_in(here(Places), Rows, Objects) :-
    !,
    findall(Object, (member(row(Object, Place), Rows), memberchk(Place, Places)), All),
    sort(All, Objects).
counted_in(as(Place), Rows, Objects) :-
    !,
    counted_in(here([Place]), Rows, Objects).
counted_in(unknown, _, []).

%!  evidence(+Kind, +Objects:list, -Evidence) is det.
%
%   rows(Counted): those of Objects that are things of the kind. Where there are none, as(Super): a
%   thing of the kind is one of the class Super, the nearest that is counted; or else `none`.

evidence(kind(Class, Above), Objects, Evidence) :-
    must_be_bound(Class),
    findall(Object, (member(Object, Objects), subclass(Object, Class)), Counted),
    (   Counted \== []
    ->  Evidence = rows(Counted)
    ;   nearest([Class|Above], Objects, Super)
    ->  Evidence = as(Super)
    ;   Evidence = none
    ).

% The one of Candidates that is above one of Classes by the fewest steps; of several the first.
nearest(Classes, Candidates, Super) :-
    findall(Distance-Candidate,
            ( member(Candidate, Candidates),
              member(Class, Classes),
              subclass(Class, Candidate),
              rada_distance(Class, Candidate, Distance) ),
            Found),
    sort(Found, [_-Super|_]).

%!  use(+Algorithm, +Robot, -Use) is det.
%
%   `any` without a robot; has(Class) when Robot has a component of the class Class that the model
%   is for; perhaps(Class, General) when it has one that is described no further than as General,
%   which is above Class; lacks(Classes) otherwise. A model that states no algorithm wants some
%   program that recognises objects.

use(_, '', any) :- !.
use(algorithm(Iri, []), Robot, Use) :-
    Iri == '',
    !,
    rdf_equal(Recognition, lares:'ObjectRecognitionComponent'),
    use(algorithm(Recognition, [Recognition]), Robot, Use).
use(algorithm(Iri, Classes), Robot, Use) :-
    (   rdf(Robot, lares:subComponent, Iri)
    ->  Use = has(Iri)
    ;   member(Class, Classes),
        availability_of(context(Robot, [], false), Class, true)
    ->  Use = has(Class)
    ;   member(Class, Classes),
        described_as(Robot, Class, General)
    ->  Use = perhaps(Class, General)
    ;   Classes == []
    ->  Use = lacks([Iri])
    ;   Use = lacks(Classes)
    ).

% Robot has a program of perception that might be one of Class: General, above Class, is the most
% that is said of it.
described_as(Robot, Class, General) :-
    rdf(Robot, lares:subComponent, Part),
    findall(Type, (rdf(Part, rdf:type, Type), named(Type)), Types),
    most_specific(Types, Specific),
    member(General, Specific),
    General \== Class,
    subclass(Class, General),
    subclass(General, lares:'PerceptionComponent').

must_be_bound(Term) :-
    (   var(Term)
    ->  throw(error(instantiation_error, _))
    ;   true
    ).
