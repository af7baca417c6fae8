// The hierarchy of named classes as people draw it, and how far apart two of them are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ontology/triples/view.h"

namespace lares::owl {

// The transitive reduction of rdfs:subClassOf among named classes: equivalent ones are one node,
// anonymous ones, owl:Thing and owl:Nothing are left out, and no edge repeats what a longer way
// says. So a grandparent is at distance 2, whatever else the documents state. Immutable;
// thread-safe.
class Taxonomy {
 public:
  // `view` must be closed and is not kept. O(classes × ancestors).
  explicit Taxonomy(const rdf::View& view);

  struct Way {
    int edges = 0;                  // up from one and down to the other
    std::vector<rdf::TermId> path;  // both ends included, as they were asked for
    rdf::TermId common{};           // the class at which the way turns
    double similarity = 0;          // Wu & Palmer (1994); 1 for equivalent classes
  };
  // Rada et al. (1989): the fewest edges between two classes, through a class that is above or
  // equal to both. None when no named class is above both, or one of them is no class.
  std::optional<Way> Rada(rdf::TermId from, rdf::TermId to) const;
  // Wu & Palmer (1994): 2 n / (n₁ + n₂ + 2 n), n₁ and n₂ the edges up to a common class and n the
  // classes on the shortest way from it to a top class, both counted; through the common class that
  // makes it greatest. A distance is 1 less this.
  std::optional<Way> WuPalmer(rdf::TermId from, rdf::TermId to) const;

  bool Contains(rdf::TermId name) const { return node_of_.contains(name); }
  std::size_t size() const { return nodes_.size(); }
  // The classes right above one; of equivalents the one with the first IRI.
  std::vector<rdf::TermId> Parents(rdf::TermId name) const;

 private:
  using Node = std::uint32_t;
  struct NodeData {
    rdf::TermId name{};
    std::vector<Node> parents;
    int depth = 1;  // classes on the shortest way to a top class
  };
  struct Step {
    int edges = 0;
    Node from = 0;
  };
  using Climb = std::unordered_map<Node, Step>;

  Climb Up(Node start) const;
  Way MakeWay(rdf::TermId from, rdf::TermId to, Node common, const Climb& up_from,
              const Climb& up_to) const;
  template <typename Better>
  std::optional<Way> Best(rdf::TermId from, rdf::TermId to, Better better) const;
  void FindDepths();

  std::unordered_map<rdf::TermId, Node> node_of_;
  std::vector<NodeData> nodes_;
};

}  // namespace lares::owl
