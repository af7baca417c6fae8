// Universities in the shape of the Lehigh University Benchmark, of any number: an ontology and data
// of our own, so that closures are measured at sizes for which no file is at hand.
#pragma once

#include <string>

namespace lares::bench {

// Classes by what their members do, a transitive property, inverses, subproperties, domains and
// ranges. Turtle.
std::string UniversityOntology();

// N-Triples of the university `number`: 15 to 25 departments, about 100 000 triples. Numbers of
// people, courses and papers are drawn within the bounds that Guo, Pan and Heflin give (LUBM: A
// benchmark for OWL knowledge base systems, 2005). The same for the same number.
std::string University(int number);

}  // namespace lares::bench
