#include "tests/ontology/owl_mapping_table.h"

#include <map>

namespace lares::rdf::testing {
namespace {

constexpr std::string_view kData = ":d a owl:DatatypeProperty . :e a owl:DatatypeProperty .";
constexpr std::string_view kObject = ":p a owl:ObjectProperty .";
constexpr std::string_view kNotes = ":n a owl:AnnotationProperty . :m a owl:AnnotationProperty .";
constexpr std::string_view kRange = ":T a rdfs:Datatype .";

std::string Expanded(std::string_view xml) {
  static const std::map<char, std::string> kElements = {
      {'C', "Class"},        {'P', "ObjectProperty"},
      {'D', "DataProperty"}, {'A', "AnnotationProperty"},
      {'T', "Datatype"},     {'I', "NamedIndividual"},
  };
  std::string text;
  while (!xml.empty()) {
    const std::size_t open = xml.find('{');
    text += xml.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = xml.find('}', open);
    const char kind = xml[open + 1];
    const std::string name(xml.substr(open + 3, close - open - 3));
    const std::string qualified = name.find(':') == std::string::npos ? ":" + name : name;
    if (kind == 'L') {
      text += "<Literal>" + name + "</Literal>";
    } else if (kind == 'N') {
      text += "<AnonymousIndividual nodeID=\"_:" + name + "\"/>";
    } else if (kind == 'U') {
      text += "<AbbreviatedIRI>" + qualified + "</AbbreviatedIRI>";
    } else {
      text += "<" + kElements.at(kind) + " abbreviatedIRI=\"" + qualified + "\"/>";
    }
    xml.remove_prefix(close + 1);
  }
  return text;
}

std::vector<MappingRow> Rows() {
  return {
      // Declarations.
      {"DeclareClass", "Declaration(Class(:A))", "<Declaration>{C A}</Declaration>",
       ":A a owl:Class ."},
      {"DeclareDatatype", "Declaration(Datatype(:T))", "<Declaration>{T T}</Declaration>",
       ":T a rdfs:Datatype ."},
      {"DeclareObjectProperty", "Declaration(ObjectProperty(:p))",
       "<Declaration>{P p}</Declaration>", ":p a owl:ObjectProperty ."},
      {"DeclareDataProperty", "Declaration(DataProperty(:d))", "<Declaration>{D d}</Declaration>",
       ":d a owl:DatatypeProperty ."},
      {"DeclareAnnotationProperty", "Declaration(AnnotationProperty(:n))",
       "<Declaration>{A n}</Declaration>", ":n a owl:AnnotationProperty ."},
      {"DeclareNamedIndividual", "Declaration(NamedIndividual(:i))",
       "<Declaration>{I i}</Declaration>", ":i a owl:NamedIndividual ."},
      // Classes.
      {"SubClassOf", "SubClassOf(:A :B)", "<SubClassOf>{C A}{C B}</SubClassOf>",
       ":A rdfs:subClassOf :B ."},
      {"EquivalentClassesOfThree", "EquivalentClasses(:A :B :C)",
       "<EquivalentClasses>{C A}{C B}{C C}</EquivalentClasses>",
       ":A owl:equivalentClass :B . :B owl:equivalentClass :C ."},
      {"EquivalentClassesThroughAnExpression", "EquivalentClasses(:A ObjectComplementOf(:B) :C)",
       "<EquivalentClasses>{C A}<ObjectComplementOf>{C B}</ObjectComplementOf>{C C}"
       "</EquivalentClasses>",
       ":A owl:equivalentClass _:x . _:x a owl:Class ; owl:complementOf :B ; "
       "owl:equivalentClass :C ."},
      {"DisjointClassesOfTwo", "DisjointClasses(:A :B)",
       "<DisjointClasses>{C A}{C B}</DisjointClasses>", ":A owl:disjointWith :B ."},
      {"DisjointClassesOfThree", "DisjointClasses(:A :B :C)",
       "<DisjointClasses>{C A}{C B}{C C}</DisjointClasses>",
       "[] a owl:AllDisjointClasses ; owl:members ( :A :B :C ) ."},
      {"DisjointUnion", "DisjointUnion(:A :B :C)", "<DisjointUnion>{C A}{C B}{C C}</DisjointUnion>",
       ":A owl:disjointUnionOf ( :B :C ) ."},
      // Class expressions.
      {"ObjectIntersectionOf", "SubClassOf(:A ObjectIntersectionOf(:B :C))",
       "<SubClassOf>{C A}<ObjectIntersectionOf>{C B}{C C}</ObjectIntersectionOf></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Class ; owl:intersectionOf ( :B :C ) ] ."},
      {"ObjectUnionOf", "SubClassOf(ObjectUnionOf(:B :C :D) :A)",
       "<SubClassOf><ObjectUnionOf>{C B}{C C}{C D}</ObjectUnionOf>{C A}</SubClassOf>",
       "[ a owl:Class ; owl:unionOf ( :B :C :D ) ] rdfs:subClassOf :A ."},
      {"ObjectComplementOf", "SubClassOf(:A ObjectComplementOf(:B))",
       "<SubClassOf>{C A}<ObjectComplementOf>{C B}</ObjectComplementOf></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Class ; owl:complementOf :B ] ."},
      {"ObjectOneOf", "SubClassOf(:A ObjectOneOf(:i _:j))",
       "<SubClassOf>{C A}<ObjectOneOf>{I i}{N j}</ObjectOneOf></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Class ; owl:oneOf ( :i _:j ) ] ."},
      {"ObjectSomeValuesFrom", "SubClassOf(:A ObjectSomeValuesFrom(:p :B))",
       "<SubClassOf>{C A}<ObjectSomeValuesFrom>{P p}{C B}</ObjectSomeValuesFrom></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :B ] ."},
      {"ObjectAllValuesFromOfAnInverse",
       "SubClassOf(:A ObjectAllValuesFrom(ObjectInverseOf(:p) owl:Thing))",
       "<SubClassOf>{C A}<ObjectAllValuesFrom><ObjectInverseOf>{P p}</ObjectInverseOf>"
       "{C owl:Thing}</ObjectAllValuesFrom></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty [ owl:inverseOf :p ] ; "
       "owl:allValuesFrom owl:Thing ] ."},
      {"ObjectHasValue", "SubClassOf(:A ObjectHasValue(:p :i))",
       "<SubClassOf>{C A}<ObjectHasValue>{P p}{I i}</ObjectHasValue></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:hasValue :i ] ."},
      {"ObjectHasSelf", "SubClassOf(:A ObjectHasSelf(:p))",
       "<SubClassOf>{C A}<ObjectHasSelf>{P p}</ObjectHasSelf></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:hasSelf true ] ."},
      {"ObjectMinCardinality", "SubClassOf(:A ObjectMinCardinality(2 :p))",
       "<SubClassOf>{C A}<ObjectMinCardinality cardinality=\"2\">{P p}</ObjectMinCardinality>"
       "</SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; "
       "owl:minCardinality \"2\"^^xsd:nonNegativeInteger ] ."},
      {"ObjectMaxCardinality", "SubClassOf(:A ObjectMaxCardinality(0 :p :B))",
       "<SubClassOf>{C A}<ObjectMaxCardinality cardinality=\"0\">{P p}{C B}"
       "</ObjectMaxCardinality></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; "
       "owl:maxQualifiedCardinality \"0\"^^xsd:nonNegativeInteger ; owl:onClass :B ] ."},
      {"ObjectExactCardinality", "SubClassOf(:A ObjectExactCardinality(1 :p :B))",
       "<SubClassOf>{C A}<ObjectExactCardinality cardinality=\"1\">{P p}{C B}"
       "</ObjectExactCardinality></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; "
       "owl:qualifiedCardinality \"1\"^^xsd:nonNegativeInteger ; owl:onClass :B ] ."},
      {"DataSomeValuesFrom", "SubClassOf(:A DataSomeValuesFrom(:d xsd:integer))",
       "<SubClassOf>{C A}<DataSomeValuesFrom>{D d}{T xsd:integer}</DataSomeValuesFrom>"
       "</SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; "
       "owl:someValuesFrom xsd:integer ] ."},
      {"DataSomeValuesFromOfTwo", "SubClassOf(:A DataSomeValuesFrom(:d :e :T))",
       "<SubClassOf>{C A}<DataSomeValuesFrom>{D d}{D e}{T T}</DataSomeValuesFrom></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperties ( :d :e ) ; "
       "owl:someValuesFrom :T ] ."},
      {"DataAllValuesFrom", "SubClassOf(:A DataAllValuesFrom(:d DataOneOf(\"x\" \"y\"@en)))",
       "<SubClassOf>{C A}<DataAllValuesFrom>{D d}<DataOneOf>{L x}"
       "<Literal xml:lang=\"en\">y</Literal></DataOneOf></DataAllValuesFrom></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:allValuesFrom "
       "[ a rdfs:Datatype ; owl:oneOf ( \"x\" \"y\"@en ) ] ] ."},
      {"DataHasValue", "SubClassOf(:A DataHasValue(:d \"5\"^^xsd:integer))",
       "<SubClassOf>{C A}<DataHasValue>{D d}<Literal "
       "datatypeIRI=\"http://www.w3.org/2001/XMLSchema#integer\">5</Literal></DataHasValue>"
       "</SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:hasValue 5 ] ."},
      {"DataMinCardinality", "SubClassOf(:A DataMinCardinality(1 :d))",
       "<SubClassOf>{C A}<DataMinCardinality cardinality=\"1\">{D d}</DataMinCardinality>"
       "</SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; "
       "owl:minCardinality \"1\"^^xsd:nonNegativeInteger ] .",
       kData},
      {"DataMaxCardinality", "SubClassOf(:A DataMaxCardinality(1 :d xsd:string))",
       "<SubClassOf>{C A}<DataMaxCardinality cardinality=\"1\">{D d}{T xsd:string}"
       "</DataMaxCardinality></SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; "
       "owl:maxQualifiedCardinality \"1\"^^xsd:nonNegativeInteger ; "
       "owl:onDataRange xsd:string ] ."},
      {"DataExactCardinality", "SubClassOf(:A DataExactCardinality(3 :d))",
       "<SubClassOf>{C A}<DataExactCardinality cardinality=\"3\">{D d}</DataExactCardinality>"
       "</SubClassOf>",
       ":A rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; "
       "owl:cardinality \"3\"^^xsd:nonNegativeInteger ] .",
       kData},
      // Data ranges.
      {"DataIntersectionOf", "DataPropertyRange(:d DataIntersectionOf(xsd:integer :T))",
       "<DataPropertyRange>{D d}<DataIntersectionOf>{T xsd:integer}{T T}</DataIntersectionOf>"
       "</DataPropertyRange>",
       ":d rdfs:range [ a rdfs:Datatype ; owl:intersectionOf ( xsd:integer :T ) ] ."},
      {"DataUnionOf", "DataPropertyRange(:d DataUnionOf(xsd:string :T))",
       "<DataPropertyRange>{D d}<DataUnionOf>{T xsd:string}{T T}</DataUnionOf>"
       "</DataPropertyRange>",
       ":d rdfs:range [ a rdfs:Datatype ; owl:unionOf ( xsd:string :T ) ] ."},
      {"DataComplementOf", "DataPropertyRange(:d DataComplementOf(xsd:string))",
       "<DataPropertyRange>{D d}<DataComplementOf>{T xsd:string}</DataComplementOf>"
       "</DataPropertyRange>",
       ":d rdfs:range [ a rdfs:Datatype ; owl:datatypeComplementOf xsd:string ] ."},
      {"DatatypeRestriction",
       "DatatypeDefinition(:T DatatypeRestriction(xsd:integer xsd:minInclusive "
       "\"5\"^^xsd:integer xsd:maxExclusive \"10\"^^xsd:integer))",
       "<DatatypeDefinition>{T T}<DatatypeRestriction>{T xsd:integer}"
       "<FacetRestriction facet=\"http://www.w3.org/2001/XMLSchema#minInclusive\"><Literal "
       "datatypeIRI=\"http://www.w3.org/2001/XMLSchema#integer\">5</Literal></FacetRestriction>"
       "<FacetRestriction facet=\"http://www.w3.org/2001/XMLSchema#maxExclusive\"><Literal "
       "datatypeIRI=\"http://www.w3.org/2001/XMLSchema#integer\">10</Literal></FacetRestriction>"
       "</DatatypeRestriction></DatatypeDefinition>",
       ":T owl:equivalentClass [ a rdfs:Datatype ; owl:onDatatype xsd:integer ; "
       "owl:withRestrictions ( [ xsd:minInclusive 5 ] [ xsd:maxExclusive 10 ] ) ] ."},
      {"DatatypeDefinitionByAName", "DatatypeDefinition(:T xsd:string)",
       "<DatatypeDefinition>{T T}{T xsd:string}</DatatypeDefinition>",
       ":T owl:equivalentClass xsd:string .", kRange},
      // Object properties.
      {"SubObjectPropertyOf", "SubObjectPropertyOf(:p :q)",
       "<SubObjectPropertyOf>{P p}{P q}</SubObjectPropertyOf>", ":p rdfs:subPropertyOf :q ."},
      {"SubObjectPropertyOfAnInverse", "SubObjectPropertyOf(ObjectInverseOf(:p) :q)",
       "<SubObjectPropertyOf><ObjectInverseOf>{P p}</ObjectInverseOf>{P q}"
       "</SubObjectPropertyOf>",
       "[ owl:inverseOf :p ] rdfs:subPropertyOf :q ."},
      {"ObjectPropertyChain", "SubObjectPropertyOf(ObjectPropertyChain(:p ObjectInverseOf(:q)) :r)",
       "<SubObjectPropertyOf><ObjectPropertyChain>{P p}<ObjectInverseOf>{P q}</ObjectInverseOf>"
       "</ObjectPropertyChain>{P r}</SubObjectPropertyOf>",
       ":r owl:propertyChainAxiom ( :p [ owl:inverseOf :q ] ) ."},
      {"EquivalentObjectProperties", "EquivalentObjectProperties(:p :q :r)",
       "<EquivalentObjectProperties>{P p}{P q}{P r}</EquivalentObjectProperties>",
       ":p owl:equivalentProperty :q . :q owl:equivalentProperty :r ."},
      {"DisjointObjectPropertiesOfTwo", "DisjointObjectProperties(:p :q)",
       "<DisjointObjectProperties>{P p}{P q}</DisjointObjectProperties>",
       ":p owl:propertyDisjointWith :q ."},
      {"DisjointObjectPropertiesOfThree", "DisjointObjectProperties(:p :q :r)",
       "<DisjointObjectProperties>{P p}{P q}{P r}</DisjointObjectProperties>",
       "[] a owl:AllDisjointProperties ; owl:members ( :p :q :r ) ."},
      {"ObjectPropertyDomain", "ObjectPropertyDomain(:p :A)",
       "<ObjectPropertyDomain>{P p}{C A}</ObjectPropertyDomain>", ":p rdfs:domain :A ."},
      {"ObjectPropertyRange", "ObjectPropertyRange(:p :A)",
       "<ObjectPropertyRange>{P p}{C A}</ObjectPropertyRange>", ":p rdfs:range :A ."},
      {"InverseObjectProperties", "InverseObjectProperties(:p :q)",
       "<InverseObjectProperties>{P p}{P q}</InverseObjectProperties>", ":p owl:inverseOf :q ."},
      {"FunctionalObjectProperty", "FunctionalObjectProperty(:p)",
       "<FunctionalObjectProperty>{P p}</FunctionalObjectProperty>",
       ":p a owl:FunctionalProperty ."},
      {"InverseFunctionalObjectProperty", "InverseFunctionalObjectProperty(:p)",
       "<InverseFunctionalObjectProperty>{P p}</InverseFunctionalObjectProperty>",
       ":p a owl:InverseFunctionalProperty ."},
      {"ReflexiveObjectProperty", "ReflexiveObjectProperty(:p)",
       "<ReflexiveObjectProperty>{P p}</ReflexiveObjectProperty>", ":p a owl:ReflexiveProperty ."},
      {"IrreflexiveObjectProperty", "IrreflexiveObjectProperty(:p)",
       "<IrreflexiveObjectProperty>{P p}</IrreflexiveObjectProperty>",
       ":p a owl:IrreflexiveProperty ."},
      {"SymmetricObjectProperty", "SymmetricObjectProperty(:p)",
       "<SymmetricObjectProperty>{P p}</SymmetricObjectProperty>", ":p a owl:SymmetricProperty ."},
      {"AsymmetricObjectProperty", "AsymmetricObjectProperty(:p)",
       "<AsymmetricObjectProperty>{P p}</AsymmetricObjectProperty>",
       ":p a owl:AsymmetricProperty ."},
      {"TransitiveObjectProperty", "TransitiveObjectProperty(:p)",
       "<TransitiveObjectProperty>{P p}</TransitiveObjectProperty>",
       ":p a owl:TransitiveProperty ."},
      // Data properties.
      {"SubDataPropertyOf", "SubDataPropertyOf(:d :e)",
       "<SubDataPropertyOf>{D d}{D e}</SubDataPropertyOf>", ":d rdfs:subPropertyOf :e .", kData},
      {"EquivalentDataProperties", "EquivalentDataProperties(:d :e)",
       "<EquivalentDataProperties>{D d}{D e}</EquivalentDataProperties>",
       ":d owl:equivalentProperty :e .", kData},
      {"DisjointDataProperties", "DisjointDataProperties(:d :e)",
       "<DisjointDataProperties>{D d}{D e}</DisjointDataProperties>",
       ":d owl:propertyDisjointWith :e .", kData},
      {"DataPropertyDomain", "DataPropertyDomain(:d :A)",
       "<DataPropertyDomain>{D d}{C A}</DataPropertyDomain>", ":d rdfs:domain :A .", kData},
      {"DataPropertyRange", "DataPropertyRange(:d xsd:string)",
       "<DataPropertyRange>{D d}{T xsd:string}</DataPropertyRange>", ":d rdfs:range xsd:string ."},
      {"FunctionalDataProperty", "FunctionalDataProperty(:d)",
       "<FunctionalDataProperty>{D d}</FunctionalDataProperty>", ":d a owl:FunctionalProperty .",
       kData},
      {"HasKey", "HasKey(:A (:p ObjectInverseOf(:q)) (:d))",
       "<HasKey>{C A}{P p}<ObjectInverseOf>{P q}</ObjectInverseOf>{D d}</HasKey>",
       ":A owl:hasKey ( :p [ owl:inverseOf :q ] :d ) .", kData},
      {"HasKeyOfDataOnly", "HasKey(:A () (:d))", "<HasKey>{C A}{D d}</HasKey>",
       ":A owl:hasKey ( :d ) .", kData},
      // Individuals.
      {"SameIndividual", "SameIndividual(:i _:j :k)",
       "<SameIndividual>{I i}{N j}{I k}</SameIndividual>",
       ":i owl:sameAs _:j . _:j owl:sameAs :k ."},
      {"DifferentIndividualsOfTwo", "DifferentIndividuals(:i :j)",
       "<DifferentIndividuals>{I i}{I j}</DifferentIndividuals>", ":i owl:differentFrom :j ."},
      {"DifferentIndividualsOfThree", "DifferentIndividuals(:i :j :k)",
       "<DifferentIndividuals>{I i}{I j}{I k}</DifferentIndividuals>",
       "[] a owl:AllDifferent ; owl:members ( :i :j :k ) ."},
      {"ClassAssertion", "ClassAssertion(:A :i)", "<ClassAssertion>{C A}{I i}</ClassAssertion>",
       ":i a :A ."},
      {"ClassAssertionOfAnExpression", "ClassAssertion(ObjectHasSelf(:p) _:i)",
       "<ClassAssertion><ObjectHasSelf>{P p}</ObjectHasSelf>{N i}</ClassAssertion>",
       "_:i a [ a owl:Restriction ; owl:onProperty :p ; owl:hasSelf true ] ."},
      {"ObjectPropertyAssertion", "ObjectPropertyAssertion(:p :i _:j)",
       "<ObjectPropertyAssertion>{P p}{I i}{N j}</ObjectPropertyAssertion>", ":i :p _:j .",
       kObject},
      {"ObjectPropertyAssertionOfAnInverse", "ObjectPropertyAssertion(ObjectInverseOf(:p) :i :j)",
       "<ObjectPropertyAssertion><ObjectInverseOf>{P p}</ObjectInverseOf>{I i}{I j}"
       "</ObjectPropertyAssertion>",
       ":j :p :i ."},
      {"DataPropertyAssertion", "DataPropertyAssertion(:d :i \"a \\\"b\\\" \\\\ c\")",
       "<DataPropertyAssertion>{D d}{I i}{L a \"b\" \\ c}</DataPropertyAssertion>",
       ":i :d \"a \\\"b\\\" \\\\ c\" .", kData},
      {"NegativeObjectPropertyAssertion", "NegativeObjectPropertyAssertion(:p :i :j)",
       "<NegativeObjectPropertyAssertion>{P p}{I i}{I j}</NegativeObjectPropertyAssertion>",
       "[] a owl:NegativePropertyAssertion ; owl:sourceIndividual :i ; owl:assertionProperty :p ; "
       "owl:targetIndividual :j ."},
      {"NegativeDataPropertyAssertion", "NegativeDataPropertyAssertion(:d :i \"x\")",
       "<NegativeDataPropertyAssertion>{D d}{I i}{L x}</NegativeDataPropertyAssertion>",
       "[] a owl:NegativePropertyAssertion ; owl:sourceIndividual :i ; owl:assertionProperty :d ; "
       "owl:targetValue \"x\" ."},
      // Annotations.
      {"AnnotationAssertionOfAnIri", "AnnotationAssertion(:n :A :B)",
       "<AnnotationAssertion>{A n}{U A}{U B}</AnnotationAssertion>", ":A :n :B .", kNotes},
      {"AnnotationAssertionOfANode", "AnnotationAssertion(rdfs:label _:i _:j)",
       "<AnnotationAssertion>{A rdfs:label}{N i}{N j}</AnnotationAssertion>",
       "_:i rdfs:label _:j ."},
      {"AnnotationAssertionOfALiteral", "AnnotationAssertion(rdfs:label :A \"a\"@de-at)",
       "<AnnotationAssertion>{A rdfs:label}{U A}<Literal xml:lang=\"de-AT\">a</Literal>"
       "</AnnotationAssertion>",
       ":A rdfs:label \"a\"@de-at ."},
      {"SubAnnotationPropertyOf", "SubAnnotationPropertyOf(:n :m)",
       "<SubAnnotationPropertyOf>{A n}{A m}</SubAnnotationPropertyOf>",
       ":n rdfs:subPropertyOf :m .", kNotes},
      {"AnnotationPropertyDomain", "AnnotationPropertyDomain(:n :A)",
       "<AnnotationPropertyDomain>{A n}{U A}</AnnotationPropertyDomain>", ":n rdfs:domain :A .",
       kNotes},
      {"AnnotationPropertyRange", "AnnotationPropertyRange(:n xsd:string)",
       "<AnnotationPropertyRange>{A n}{U xsd:string}</AnnotationPropertyRange>",
       ":n rdfs:range xsd:string .", kNotes},
      {"AnnotatedAxiom", "SubClassOf(Annotation(:n \"x\") Annotation(:m :i) :A :B)",
       "<SubClassOf><Annotation>{A n}{L x}</Annotation><Annotation>{A m}{U i}</Annotation>"
       "{C A}{C B}</SubClassOf>",
       ":A rdfs:subClassOf :B . [] a owl:Axiom ; owl:annotatedSource :A ; "
       "owl:annotatedProperty rdfs:subClassOf ; owl:annotatedTarget :B ; :n \"x\" ; :m :i ."},
      {"AnnotatedAnnotation", "SubClassOf(Annotation(Annotation(:m \"y\") :n \"x\") :A :B)",
       "<SubClassOf><Annotation><Annotation>{A m}{L y}</Annotation>{A n}{L x}</Annotation>"
       "{C A}{C B}</SubClassOf>",
       ":A rdfs:subClassOf :B . _:x a owl:Axiom ; owl:annotatedSource :A ; "
       "owl:annotatedProperty rdfs:subClassOf ; owl:annotatedTarget :B ; :n \"x\" . "
       "[] a owl:Annotation ; owl:annotatedSource _:x ; owl:annotatedProperty :n ; "
       "owl:annotatedTarget \"x\" ; :m \"y\" ."},
      {"AnnotatedDeclaration", "Declaration(Annotation(:n \"x\") Class(:A))",
       "<Declaration><Annotation>{A n}{L x}</Annotation>{C A}</Declaration>",
       ":A a owl:Class . [] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty rdf:type "
       "; "
       "owl:annotatedTarget owl:Class ; :n \"x\" ."},
      {"AnnotatedChain", "SubObjectPropertyOf(Annotation(:n \"x\") ObjectPropertyChain(:p :q) :r)",
       "<SubObjectPropertyOf><Annotation>{A n}{L x}</Annotation><ObjectPropertyChain>{P p}{P q}"
       "</ObjectPropertyChain>{P r}</SubObjectPropertyOf>",
       ":r owl:propertyChainAxiom _:l . _:l rdf:first :p ; rdf:rest ( :q ) . [] a owl:Axiom ; "
       "owl:annotatedSource :r ; owl:annotatedProperty owl:propertyChainAxiom ; "
       "owl:annotatedTarget _:l ; :n \"x\" ."},
      {"AnnotatedAxiomOfSeveralTriples", "SameIndividual(Annotation(:n \"x\") :i :j :k)",
       "<SameIndividual><Annotation>{A n}{L x}</Annotation>{I i}{I j}{I k}</SameIndividual>",
       ":i owl:sameAs :j . :j owl:sameAs :k . "
       "[] a owl:Axiom ; owl:annotatedSource :i ; owl:annotatedProperty owl:sameAs ; "
       "owl:annotatedTarget :j ; :n \"x\" . "
       "[] a owl:Axiom ; owl:annotatedSource :j ; owl:annotatedProperty owl:sameAs ; "
       "owl:annotatedTarget :k ; :n \"x\" ."},
      {"AnnotatedAxiomWithANode",
       "DisjointClasses(Annotation(Annotation(:m \"y\") :n \"x\") :A :B :C)",
       "<DisjointClasses><Annotation><Annotation>{A m}{L y}</Annotation>{A n}{L x}</Annotation>"
       "{C A}{C B}{C C}</DisjointClasses>",
       "_:x a owl:AllDisjointClasses ; owl:members ( :A :B :C ) ; :n \"x\" . "
       "[] a owl:Annotation ; owl:annotatedSource _:x ; owl:annotatedProperty :n ; "
       "owl:annotatedTarget \"x\" ; :m \"y\" ."},
      {"AnnotatedNegativeAssertion",
       "NegativeDataPropertyAssertion(Annotation(:n \"y\") :d :i \"x\")",
       "<NegativeDataPropertyAssertion><Annotation>{A n}{L y}</Annotation>{D d}{I i}{L x}"
       "</NegativeDataPropertyAssertion>",
       "[] a owl:NegativePropertyAssertion ; owl:sourceIndividual :i ; owl:assertionProperty :d ; "
       "owl:targetValue \"x\" ; :n \"y\" ."},
      {"AnnotatedAnnotationAssertion", "AnnotationAssertion(Annotation(:m \"y\") :n :A \"x\")",
       "<AnnotationAssertion><Annotation>{A m}{L y}</Annotation>{A n}{U A}{L x}"
       "</AnnotationAssertion>",
       ":A :n \"x\" . [] a owl:Axiom ; owl:annotatedSource :A ; owl:annotatedProperty :n ; "
       "owl:annotatedTarget \"x\" ; :m \"y\" .",
       kNotes},
      {"OntologyAnnotation", "Annotation(Annotation(:m \"y\") :n \"x\")",
       "<Annotation><Annotation>{A m}{L y}</Annotation>{A n}{L x}</Annotation>",
       "<http://e/o> :n \"x\" . [] a owl:Annotation ; owl:annotatedSource <http://e/o> ; "
       "owl:annotatedProperty :n ; owl:annotatedTarget \"x\" ; :m \"y\" ."},
      {"Import", "Import(<http://e/other>)", "<Import>http://e/other</Import>",
       "<http://e/o> owl:imports <http://e/other> ."},
      {"PlainLiteral", "DataPropertyAssertion(:d :i \"a@b@en\"^^rdf:PlainLiteral)",
       "<DataPropertyAssertion>{D d}{I i}<Literal "
       "datatypeIRI=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral\">a@b@en</Literal>"
       "</DataPropertyAssertion>",
       ":i :d \"a@b\"@en ."},
  };
}

}  // namespace

const std::vector<MappingRow>& MappingTable() {
  static const std::vector<MappingRow> rows = Rows();
  return rows;
}

std::string FunctionalText(std::string_view axioms) {
  return "Prefix(:=<http://e/>)\nOntology(<http://e/o>\n" + std::string(axioms) + "\n)";
}

std::string OwlXmlText(std::string_view axioms) {
  return "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"http://e/o\" "
         "ontologyIRI=\"http://e/o\"><Prefix name=\"\" IRI=\"http://e/\"/>\n" +
         Expanded(axioms) + "\n</Ontology>";
}

std::string TurtleText(std::string_view statements) {
  return "@prefix : <http://e/> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
         "@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n"
         "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
         "@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n"
         "<http://e/o> a owl:Ontology .\n" +
         std::string(statements);
}

}  // namespace lares::rdf::testing
