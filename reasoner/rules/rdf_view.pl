:- module(rdf_view,
          [ rdf/3,                      % ?Subject, ?Predicate, ?Object
            rdf_asserted/3,             % ?Subject, ?Predicate, ?Object
            rdf_in/4,                   % ?Subject, ?Predicate, ?Object, +Graph
            rdf_graph/1,                % ?Graph
            rdf_as_written/2,           % +Iri, -Original
            rdf_label/2,                % +Term, -Label
            rdf_number/2,               % +Literal, -Number
            rdf_equal/2                 % ?Iri, ?Iri
          ]).

:- use_module(library(lists), [member/2]).
:- use_module(rules(prefixes)).

/** <module> The triples of the view that the running goal was given

An IRI is an atom, written with a prefix (see prefixes.pl); a blank node is the atom `'_:label'`; a
literal is `literal(Lexical, Datatype, Language)` of atoms, Datatype '' for plain and
language-tagged text, Language '' for none. Arguments of a literal may be unbound in a pattern.

Unbound arguments match anything; a subject that is a literal matches nothing; what is no RDF term
(a number, a string, an unexpanded `lares:Cup`) raises `type_error(rdf_term, Culprit)`. Outside a
goal there is no view: `existence_error(rdf_view, current)`.

The predicates of module `rdf_edge` are C++ (reasoner/prolog/rdf_predicates.cc).
*/

:- rdf_meta
    rdf(r, r, o),
    rdf_asserted(r, r, o),
    rdf_in(r, r, o, -),
    rdf_as_written(r, -),
    rdf_label(o, -),
    rdf_number(o, -),
    rdf_equal(r, r).

%!  rdf(?Subject, ?Predicate, ?Object) is nondet.
%
%   True for each triple that is asserted or follows. Each answer comes once, in no order to rely
%   on.

rdf(Subject, Predicate, Object) :-
    rdf_edge:match(Subject, Predicate, Object, all).

%!  rdf_asserted(?Subject, ?Predicate, ?Object) is nondet.
%
%   True for each triple that a document states.

rdf_asserted(Subject, Predicate, Object) :-
    rdf_edge:match(Subject, Predicate, Object, asserted).

%!  rdf_in(?Subject, ?Predicate, ?Object, +Graph:atom) is nondet.
%
%   True for each triple that the document with this name states. Fails when the view has no such
%   graph.

rdf_in(Subject, Predicate, Object, Graph) :-
    rdf_edge:match_in(Subject, Predicate, Object, Graph).

%!  rdf_graph(?Graph:atom) is nondet.
%
%   The documents of the view, lowest layer first.

rdf_graph(Graph) :-
    rdf_edge:graphs(Graphs),
    member(Graph, Graphs).

%!  rdf_as_written(+Iri:atom, -Original:atom) is det.
%
%   Iri as the topmost document that mentions it wrote it; Iri itself when no alias changed it.

rdf_as_written(Iri, Original) :-
    rdf_edge:as_written(Iri, Original).

%!  rdf_label(+Term, -Label:atom) is det.
%
%   A name for people: rdfs:label in English or without a language, else the local name; the
%   lexical form of a literal.

rdf_label(Term, Label) :-
    rdf_edge:label(Term, Label).

%!  rdf_number(+Literal, -Number:number) is semidet.
%
%   Number that Literal's lexical form spells in the notation of XML Schema, whatever its datatype:
%   an integer when it is written as one and fits 64 bits, a float otherwise. Fails for anything
%   else, INF and NaN and IRIs included.

rdf_number(Literal, Number) :-
    rdf_edge:number(Literal, Number).

%!  rdf_equal(?A, ?B) is semidet.
%
%   A = B, with prefixes expanded in both: a way to write an IRI in a term that is not declared.

rdf_equal(Iri, Iri).
