// The triples of the layer that is being made, in order of arrival, with indexes for joins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/owl/flat_map.h"

namespace lares::owl {

// A triple is *known* once added and takes part in joins once *published*. Triples are published in
// the order in which they were added; so a rule sees each combination of premises when the last of
// them is published, and not before.
class Facts {
 public:
  // False when it was known. `origin` is remembered.
  bool Add(const rdf::Triple& triple, std::uint32_t origin);
  bool Has(const rdf::Triple& triple) const;

  std::size_t size() const { return triples_.size(); }
  std::size_t published() const { return published_; }
  const rdf::Triple& At(std::size_t index) const { return triples_[index]; }
  std::uint32_t OriginOf(std::size_t index) const { return origins_[index]; }
  const std::vector<rdf::Triple>& triples() const { return triples_; }
  const std::vector<std::uint32_t>& origins() const { return origins_; }

  // Publishes the next triple and returns its index.
  std::size_t Publish();

  // Calls visit(triple) for the published matches. `visit` may add triples but not publish.
  template <typename Visit>
  void ForEach(const rdf::Pattern& pattern, Visit&& visit) {
    const auto [s, p, o] = pattern;
    const bool has_s = s != rdf::kAnyTerm, has_p = p != rdf::kAnyTerm, has_o = o != rdf::kAnyTerm;
    if (has_s && has_p && has_o) {
      const rdf::Triple triple{s, p, o};
      if (IndexOf(triple) < published_) visit(triple);
    } else if (has_p && has_s) {
      Follow(by_predicate_subject_, Key(p, s), pattern, visit);
    } else if (has_p && has_o) {
      Follow(by_predicate_object_, Key(p, o), pattern, visit);
    } else if (has_p) {
      Follow(by_predicate_, Key(p), pattern, visit);
    } else if (has_s) {
      Complete(by_subject_, &rdf::Triple::subject);
      Follow(by_subject_, Key(s), pattern, visit);
    } else if (has_o) {
      Complete(by_object_, &rdf::Triple::object);
      Follow(by_object_, Key(o), pattern, visit);
    } else {
      for (std::size_t i = 0; i < published_; ++i) visit(rdf::Triple(triples_[i]));
    }
  }

 private:
  // Triples of equal key as linked lists, newest first. Indices are counted from 1.
  struct Chains {
    FlatMap newest;
    std::vector<std::uint32_t> older;

    void Append(std::uint64_t key) {
      std::uint32_t& head = newest[key];
      older.push_back(head);
      head = static_cast<std::uint32_t>(older.size());
    }
  };

  static std::uint64_t Key(rdf::TermId a) { return static_cast<std::uint32_t>(a); }
  static std::uint64_t Key(rdf::TermId a, rdf::TermId b) {
    return PairKey(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  }

  template <typename Visit>
  void Follow(const Chains& chains, std::uint64_t key, const rdf::Pattern& pattern,
              Visit&& visit) const {
    for (std::uint32_t i = chains.newest.Find(key); i != 0; i = chains.older[i - 1]) {
      const rdf::Triple triple = triples_[i - 1];
      if (pattern.object == rdf::kAnyTerm || pattern.object == triple.object) visit(triple);
    }
  }

  // Indexes that few rule sets need are made when first asked for.
  void Complete(Chains& chains, rdf::TermId rdf::Triple::*component) const {
    while (chains.older.size() < published_) {
      chains.Append(Key(triples_[chains.older.size()].*component));
    }
  }

  std::size_t IndexOf(const rdf::Triple& triple) const;  // size() when it is not known
  void Grow();

  std::vector<rdf::Triple> triples_;
  std::vector<std::uint32_t> origins_;
  std::vector<std::uint64_t> cells_;  // open addressing: upper half of the hash, index + 1
  std::size_t published_ = 0;
  Chains by_predicate_, by_predicate_subject_, by_predicate_object_, by_subject_, by_object_;
};

}  // namespace lares::owl
