// Puts the constructs of a text together, as either syntax names them one after the other.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/owl_syntax/axioms_to_rdf.h"
#include "ontology/rdf/reader.h"

namespace lares::rdf {

// Checks that arguments fit, and says each axiom's triples as soon as it is whole. Every fault is
// an Error with the place that `place_of` gives for its point.
class AxiomAssembler {
 public:
  using PlaceOf = std::function<Place(const SourcePoint&)>;

  AxiomAssembler(DocumentBuilder& builder, const ReadOptions& options, PlaceOf place_of)
      : options_(options), place_of_(std::move(place_of)), rdf_(builder) {}

  AxiomsToRdf& rdf() { return rdf_; }
  std::size_t depth() const { return open_.size(); }
  // The innermost construct that is open. Only with depth() > 0.
  const OwlNode& top() const { return open_.back(); }

  void Open(std::string_view name, SourcePoint point);
  void Open(Construct construct, SourcePoint point);
  void Add(OwlNode leaf);
  void Close();

  [[noreturn]] void Refuse(const std::string& message, const SourcePoint& point) const;

 private:
  void Regroup(OwlNode& node) const;
  void CheckArguments(const OwlNode& node) const;
  void Attach(OwlNode node);
  void Say(const OwlNode& node);

  const ReadOptions& options_;
  PlaceOf place_of_;
  AxiomsToRdf rdf_;
  std::vector<OwlNode> open_;
};

}  // namespace lares::rdf
