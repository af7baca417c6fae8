// Immutable triples in layers, shared by any number of readers.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ontology/triples/dictionary.h"
#include "ontology/triples/equality.h"
#include "ontology/triples/graph.h"

namespace lares::rdf {

// kAnyTerm matches everything.
struct Pattern {
  TermId subject{};
  TermId predicate{};
  TermId object{};
};

enum class Origin { kAll, kAsserted };

// A contradiction that the rules found: which rule, and the triples it rests on.
struct Clash {
  std::string rule;  // "cax-dw"
  std::vector<Triple> premises;
};

// What reasoning found out about a layer. Each member may be in any order.
struct Inference {
  // Duplicates are dropped, also of asserted triples. With `equality`: by representatives, and what
  // asserted triples become by them belongs here too. A literal may be a subject: such triples take
  // part in reasoning and are answers to nobody.
  std::vector<Triple> inferred;
  std::vector<Clash> clashes;
  std::size_t clash_count = 0;  // with those that were not kept; at least clashes.size()
  // Triples that the graphs assert but layers below hold already (asserted or inferred): they count
  // as asserted here, and are not stored again. Sorted.
  std::vector<Triple> held_below;
  // Which terms are the same here and in all layers below; null when none are.
  std::shared_ptr<const Equality> equality;
};

// One set of triples, sorted three ways, with who asserted which. Built once, never changed.
class Layer {
 public:
  Layer(std::vector<Graph> graphs, std::vector<Triple> inferred, std::vector<Clash> clashes);
  // A layer whose inferred triples have literals as subjects needs `dictionary` to tell.
  Layer(std::vector<Graph> graphs, Inference inference, const Dictionary* dictionary = nullptr);

  // Triples stored here: asserted or inferred, by representatives, and not held below.
  std::size_t size() const { return spo_.size(); }
  // Distinct triples that the graphs assert, held below or not.
  std::size_t asserted_size() const { return asserted().size(); }
  std::size_t memory_bytes() const;  // about
  const std::vector<Graph>& graphs() const { return graphs_; }
  const std::vector<Clash>& clashes() const { return clashes_; }
  std::size_t clash_count() const { return clash_count_; }
  const std::shared_ptr<const Equality>& equality() const { return equality_; }
  // Whether a literal is the subject of a stored triple.
  bool has_literal_subjects() const { return has_literal_subjects_; }

  // The contiguous run of stored triples that match, in one of the three orders. Pattern lookup is
  // two binary searches. Where layers have an equality, ask their View instead.
  std::span<const Triple> Range(const Pattern& pattern) const;
  bool Contains(const Triple& triple) const;
  bool IsAsserted(const Triple& triple) const;

 private:
  const std::vector<Triple>& asserted() const {
    return graphs_.size() == 1 ? graphs_.front().triples : asserted_;
  }

  std::vector<Graph> graphs_;
  std::vector<Triple> asserted_;  // sorted; empty for one graph, whose own triples serve
  std::vector<Clash> clashes_;
  std::size_t clash_count_ = 0;
  std::shared_ptr<const Equality> equality_;
  bool has_literal_subjects_ = false;
  TermId largest_{};  // no term of a stored triple has a larger id
  // Range() must return matching triples only: (S P O), (S P ?), (S ? ?) and (? ? ?) from spo_;
  // (? P O) and (? P ?) from pos_; (? ? O) and (S ? O) from osp_. Each holds full triples.
  std::vector<Triple> spo_, pos_, osp_;
};

// A stack of layers over one dictionary; no triple is in two of them. A View is a value: copying it
// pins its layers (a few shared_ptr), dropping it frees what nobody else holds. Where terms are the
// same, it answers for each of them, though layers store one.
class View {
 public:
  explicit View(std::shared_ptr<Dictionary> dictionary) : dictionary_(std::move(dictionary)) {}

  Dictionary& dictionary() const { return *dictionary_; }
  const std::shared_ptr<Dictionary>& shared_dictionary() const { return dictionary_; }
  const std::vector<std::shared_ptr<const Layer>>& layers() const { return layers_; }
  View With(std::shared_ptr<const Layer> top) const {
    View view = *this;
    if (top->equality() != nullptr) view.equality_ = top->equality();
    view.has_literal_subjects_ = view.has_literal_subjects_ || top->has_literal_subjects();
    view.layers_.push_back(std::move(top));
    return view;
  }
  // Which terms are the same; null when none are.
  const Equality* equality() const { return equality_.get(); }
  const std::shared_ptr<const Equality>& shared_equality() const { return equality_; }
  // Whether a literal is the subject of a stored triple.
  bool has_literal_subjects() const { return has_literal_subjects_; }

  bool Contains(const Triple& triple) const;
  // By a graph of any layer.
  bool IsAsserted(const Triple& triple) const;
  // Names of the graphs that assert it, lowest layer first; empty for inferred triples.
  std::vector<std::string> GraphsOf(const Triple& triple) const;
  std::size_t size() const;
  // About how many answers there are, in O(log n); not fewer where no terms are the same.
  std::size_t Estimate(const Pattern& pattern) const;

  // Calls `visit(triple)` for each answer until it returns false; true when all were visited.
  template <typename Visit>
  bool ForEach(const Pattern& pattern, Visit&& visit, Origin origin = Origin::kAll) const {
    if (equality_ != nullptr) return ForEachExpanded(pattern, visit, origin);
    return ForEachStored(pattern, [&](const Triple& triple) {
      if (has_literal_subjects_ && dictionary_->Kind(triple.subject) == TermKind::kLiteral) {
        return true;
      }
      return (origin == Origin::kAsserted && !IsAsserted(triple)) || visit(triple);
    });
  }
  // The same for the triples that are stored: by representatives, those with literals as subjects
  // included. For reasoning; `pattern` must name representatives.
  template <typename Visit>
  bool ForEachStored(const Pattern& pattern, Visit&& visit) const {
    for (const auto& layer : layers_) {
      const bool is_normal = layer->equality() == equality_;
      for (const Triple& triple : layer->Range(pattern)) {
        if (!is_normal && !equality_->IsNormal(triple)) continue;
        if (!visit(triple)) return false;
      }
    }
    return true;
  }
  bool ContainsStored(const Triple& triple) const;

  // Conveniences over ForEach, in no particular order.
  std::vector<Triple> Match(const Pattern& pattern, Origin origin = Origin::kAll) const;
  std::vector<TermId> Objects(TermId subject, TermId predicate) const;
  std::vector<TermId> Subjects(TermId predicate, TermId object) const;
  // The IRI as the topmost document that mentions it wrote it; the canonical one otherwise.
  std::string AsWritten(TermId iri) const;
  // rdfs:label, without a language tag, then "en", then any preferred; otherwise the local name.
  // A literal's text; a blank node's label with "_:".
  std::string Label(TermId term) const;

 private:
  using Visitor = std::function<bool(const Triple&)>;
  bool ForEachExpanded(const Pattern& pattern, const Visitor& visit, Origin origin) const;
  bool ForEachSame(const Pattern& pattern, const Visitor& visit) const;
  bool IsMentioned(const Layer& layer, TermId term) const;

  std::shared_ptr<Dictionary> dictionary_;
  std::vector<std::shared_ptr<const Layer>> layers_;
  std::shared_ptr<const Equality> equality_;  // of the topmost layer that has one
  bool has_literal_subjects_ = false;
};

}  // namespace lares::rdf
