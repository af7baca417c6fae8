:- module(capabilities,
          [ robot_capabilities/3
          ]).
:- use_module(library(lists)).
:- use_module(library(apply)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(matching)).
:- use_module(rules(availability)).

/** <module> Everything that a robot can do, and what keeps it from the rest

The same evaluation as in matching, of every capability that is known instead of those that a task
needs.
*/

%!  robot_capabilities(+Robot, +Strict:oneof([true,false]), -Findings) is det.
%
%   One finding (see module availability) for each named capability, those that Robot claims
%   included; `not_found(Sentence)` when Robot is no robot.

robot_capabilities(Robot, _, not_found([name(Robot), " is no robot: it is of no kind of Robot and \c
claims no capability"])) :-
    \+ robot(Robot),
    !.
robot_capabilities(Robot, Strict, Findings) :-
    findall(Claim, claims(Robot, Claim), Claims0),
    sort(Claims0, Claims),
    findall(Capability,
            ( rdf(Capability, rdfs:subClassOf, lares:'Capability'),
              named(Capability),
              \+ rdf_equal(Capability, lares:'Capability'),
              \+ rdf_equal(Capability, owl:'Nothing') ),
            Found),
    sort(Found, Capabilities),
    maplist(evaluate(context(Robot, Claims, Strict)), Capabilities, Findings).
