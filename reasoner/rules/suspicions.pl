:- module(suspicions, [ suspicions/2 ]).
:- use_module(library(lists)).
:- use_module(library(solution_sequences)).
:- use_module(rules(prefixes)).
:- use_module(rules(rdf_view)).
:- use_module(rules(classes)).
:- use_module(rules(recipes)).

/** <module> What a recipe's author probably did not mean

Nothing here makes a recipe unusable; each is one sentence that names the things concerned.
*/

:- rdf_meta
    written_for(r, r, -),
    standard(r).

% More are as good as none: the first say what kind of mistake it is.
most_told(50).

%!  suspicions(+Graph, -Sentences:list) is det.
%
%   At most fifty.

suspicions(Graph, Sentences) :-
    most_told(Most),
    findall(Sentence, limit(Most, suspicion(Graph, Sentence)), Found),
    list_to_set(Found, Sentences).

suspicion(Graph, ["<", Term, "> is no term of ", Vocabulary, Meant]) :-
    findall(Used, vocabulary_term(Graph, Used), Found),
    sort(Found, Terms),
    member(Term, Terms),
    vocabulary(Term, Vocabulary, Local),
    \+ known_term(Term),
    meant(Local, Meant).
suspicion(Graph, [name(Subject), " says ", phrase(Property), " ", name(Object),
                  ": the other way round? ", phrase(Property), " is said by ", Kind]) :-
    written_for(Property, Listing, Kind),
    listed(Graph, Listing, Listed),
    rdf_in(Subject, Property, Object, Graph),
    atom(Object),
    memberchk(Object, Listed),
    \+ memberchk(Subject, Listed).
suspicion(Graph, ["the transition ", name(Id), " is caused by the step ", name(Step), " and comes from the result ",
                  name(Result), ": causedBy and fromState are swapped?"]) :-
    rdf_in(Id, lares:causedBy, Step, Graph),
    rdf_in(Id, lares:fromState, Result, Graph),
    rdf(Result, rdf:type, lares:'ActionResult'),
    \+ rdf(Step, rdf:type, lares:'ActionResult').
suspicion(Graph, [name(Class), " acts on ", label(Acted), " with ", label(Device),
                  ": objectActedOn and deviceUsed are swapped?"]) :-
    class_in(Graph, Class),
    own_restriction(Class, lares:objectActedOn, _, Acted),
    atom(Acted),
    own_restriction(Class, lares:deviceUsed, _, Device),
    atom(Device),
    of_kind(Acted, 'https://w3id.org/lares#HardwareComponent'),
    \+ of_kind(Device, 'https://w3id.org/lares#HardwareComponent').
suspicion(Graph, [name(Step), " is an individual where a class belongs: the step of ", name(Task),
                  " is described as 'a ", label(Kind), "', and should be a subclass of it"]) :-
    class_in(Graph, Task),
    own_restriction(Task, lares:subAction, _, Step),
    individual_in(Graph, Step, Kind).
suspicion(Graph, [name(Value), " is an individual where a class belongs: someValuesFrom of ",
                  phrase(Property), " names it; hasValue is for individuals"]) :-
    rdf_in(Node, owl:someValuesFrom, Value, Graph),
    rdf_in(Node, owl:onProperty, Property, Graph),
    \+ rdf_equal(Property, lares:subAction),
    individual_in(Graph, Value, _).
suspicion(Graph, [name(Thing), " is an individual, and is put below the class ", name(Above),
                  " like a class"]) :-
    rdf_in(Thing, rdfs:subClassOf, Above, Graph),
    named(Thing),
    named(Above),
    individual_in(Graph, Thing, _).

% -- misspelt vocabulary --

vocabulary_term(Graph, Predicate) :-
    rdf_in(_, Predicate, _, Graph).
vocabulary_term(Graph, Class) :-
    rdf_in(_, rdf:type, Class, Graph),
    atom(Class).

vocabulary(Term, Vocabulary, Local) :-
    member(Prefix-Vocabulary, [owl-"OWL", rdfs-"RDFS", rdf-"RDF"]),
    iri_prefix(Prefix, Namespace),
    atom_concat(Namespace, Local, Term),
    !.

meant(Local, Meant) :-
    downcase_atom(Local, Lower),
    findall(Prefix:Name,
            ( term_of(Prefix, Names), member(Name, Names), downcase_atom(Name, Lower) ),
            [Prefix:Name|_]),
    !,
    atomic_list_concat([', and says nothing; ', Prefix, ':', Name, ' is meant?'], Atom),
    atom_string(Atom, Meant).
meant(_, ", and says nothing").

known_term(Term) :-
    term_of(Prefix, Names),
    iri_prefix(Prefix, Namespace),
    atom_concat(Namespace, Local, Term),
    memberchk(Local, Names),
    !.
known_term(Term) :-
    iri_prefix(rdf, Namespace),
    atom_concat(Namespace, Local, Term),
    atom_concat('_', Digits, Local),
    atom_number(Digits, Number),
    integer(Number).

term_of(rdf, [type, first, rest, nil, value, subject, predicate, object, 'Property', 'List', 'Statement',
              'Bag', 'Seq', 'Alt', langString, 'XMLLiteral', 'PlainLiteral', 'HTML']).
term_of(rdfs, [subClassOf, subPropertyOf, domain, range, label, comment, seeAlso, isDefinedBy, member,
               'Resource', 'Class', 'Literal', 'Datatype', 'Container',
               'ContainerMembershipProperty']).
term_of(owl, ['AllDifferent', 'AllDisjointClasses', 'AllDisjointProperties', 'Annotation',
              'AnnotationProperty', 'AsymmetricProperty', 'Axiom', 'Class', 'DataRange',
              'DatatypeProperty', 'DeprecatedClass', 'DeprecatedProperty', 'FunctionalProperty',
              'InverseFunctionalProperty', 'IrreflexiveProperty', 'NamedIndividual',
              'NegativePropertyAssertion', 'Nothing', 'ObjectProperty', 'Ontology',
              'OntologyProperty', 'ReflexiveProperty', 'Restriction', 'SymmetricProperty', 'Thing',
              'TransitiveProperty', allValuesFrom, annotatedProperty, annotatedSource,
              annotatedTarget, assertionProperty, backwardCompatibleWith, bottomDataProperty,
              bottomObjectProperty, cardinality, complementOf, datatypeComplementOf, deprecated,
              differentFrom, disjointUnionOf, disjointWith, distinctMembers, equivalentClass,
              equivalentProperty, hasKey, hasSelf, hasValue, imports, incompatibleWith,
              intersectionOf, inverseOf, maxCardinality, maxQualifiedCardinality, members,
              minCardinality, minQualifiedCardinality, onClass, onDataRange, onDatatype, oneOf,
              onProperties, onProperty, priorVersion, propertyChainAxiom, propertyDisjointWith,
              qualifiedCardinality, sameAs, someValuesFrom, sourceIndividual, targetIndividual,
              targetValue, topDataProperty, topObjectProperty, unionOf, versionInfo, versionIRI,
              withRestrictions]).

% -- roles --

written_for(lares:fromState, lares:stateTransition, "the transition").
written_for(lares:toState, lares:stateTransition, "the transition").
written_for(lares:causedBy, lares:stateTransition, "the transition").
written_for(lares:occursBeforeInOrdering, lares:orderingConstraints, "the ordering").
written_for(lares:occursAfterInOrdering, lares:orderingConstraints, "the ordering").

listed(Graph, Property, Listed) :-
    findall(Id, (class_in(Graph, Task), own_restriction(Task, Property, _, Id), atom(Id)), Found),
    sort(Found, Listed).

class_in(Graph, Class) :-
    findall(One,
            ( ( rdf_in(One, rdfs:subClassOf, _, Graph) ; rdf_in(One, owl:equivalentClass, _, Graph) ),
              named(One) ),
            Found),
    sort(Found, Classes),
    member(Class, Classes).

of_kind(Value, Class) :- subclass(Value, Class), !.
of_kind(Value, Class) :- rdf(Value, rdf:type, Class), !.

% Of a class that people would use for things, and itself no class or property.
individual_in(Graph, Thing, Kind) :-
    atom(Thing),
    named(Thing),
    rdf_in(Thing, rdf:type, Kind, Graph),
    named(Kind),
    \+ standard(Kind),
    \+ rdf_in(Thing, rdf:type, owl:'Class', Graph),
    !.

standard(Kind) :- vocabulary(Kind, _, _).
standard(lares:'RecipeParameter').
