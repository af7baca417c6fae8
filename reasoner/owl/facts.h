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
  // Room for about that many triples, so that what is known to come is not copied as it grows.
  void Reserve(std::size_t triples);
  // False when it was known. `origin` is remembered.
  bool Add(const rdf::Triple& triple, std::uint32_t origin);
  bool Has(const rdf::Triple& triple) const;

  std::size_t size() const { return triples_.size(); }
  std::size_t published() const { return published_; }
  const rdf::Triple& At(std::size_t index) const { return triples_[index]; }
  std::uint32_t OriginOf(std::size_t index) const { return origins_[index]; }

  // Publishes the next triple and returns its index.
  std::size_t Publish();

  // How many published matches there are, or more: by predicate and one end.
  std::size_t Count(const rdf::Pattern& pattern) const {
    const auto [s, p, o] = pattern;
    if (p == rdf::kAnyTerm) return published_;
    if (s != rdf::kAnyTerm) return by_predicate_subject_.Count(Key(p, s), s);
    if (o != rdf::kAnyTerm) return by_predicate_object_.Count(Key(p, o), o);
    return by_predicate_.Count(Key(p), p);
  }

  // Calls visit(triple) for the published matches. `visit` may add triples but not publish.
  template <typename Visit>
  void ForEach(const rdf::Pattern& pattern, Visit&& visit) {
    const auto [s, p, o] = pattern;
    const bool has_s = s != rdf::kAnyTerm, has_p = p != rdf::kAnyTerm, has_o = o != rdf::kAnyTerm;
    if (has_s && has_p && has_o) {
      const rdf::Triple triple{s, p, o};
      if (IndexOf(triple) < published_) visit(triple);
    } else if (has_p && has_s) {
      Follow(by_predicate_subject_, Key(p, s), s, pattern, visit);
    } else if (has_p && has_o) {
      Follow(by_predicate_object_, Key(p, o), o, pattern, visit);
    } else if (has_p) {
      Follow(by_predicate_, Key(p), p, pattern, visit);
    } else if (has_s) {
      Complete(by_subject_, &rdf::Triple::subject);
      Follow(by_subject_, Key(s), s, pattern, visit);
    } else if (has_o) {
      Complete(by_object_, &rdf::Triple::object);
      Follow(by_object_, Key(o), o, pattern, visit);
    } else {
      for (std::size_t i = 0; i < published_; ++i) visit(rdf::Triple(triples_[i]));
    }
  }

 private:
  // Tables by neighbourhood: terms get their ids in the order in which they are first met, so what
  // is joined is mostly near, and the tables of one neighbourhood fit into the processor's cache
  // however large the whole grows.
  template <typename Table>
  class Parts {
   public:
    explicit Parts(TableMemory* memory) : memory_(memory) {}
    Table& Make(rdf::TermId term) {
      const std::size_t part = static_cast<std::uint32_t>(term) >> kPartBits;
      while (part >= tables_.size()) tables_.emplace_back(memory_);
      return tables_[part];
    }
    const Table* Find(rdf::TermId term) const {
      const std::size_t part = static_cast<std::uint32_t>(term) >> kPartBits;
      return part < tables_.size() ? &tables_[part] : nullptr;
    }

   private:
    static constexpr int kPartBits = 12;
    TableMemory* memory_;
    std::vector<Table> tables_;
  };

  // Which triples are known: open addressing; upper half of the hash, index + 1.
  struct TripleTable {
    explicit TripleTable(TableMemory* memory) : cells(memory) {}

    std::vector<std::uint64_t, TableAllocator<std::uint64_t>> cells;
    std::size_t count = 0;
  };

  // Triples of equal key as linked lists, newest first. Indices are counted from 1.
  struct Chains {
    explicit Chains(TableMemory* memory) : newest(memory) {}

    Parts<FlatMap> newest;  // by the term that tells keys apart most
    std::vector<std::uint32_t> older;

    void Append(std::uint64_t key, rdf::TermId term) {
      FlatMap::Entry& head = newest.Make(term).EntryOf(key);
      older.push_back(head.value);
      head.value = static_cast<std::uint32_t>(older.size());
      ++head.count;
    }
    std::size_t Count(std::uint64_t key, rdf::TermId term) const {
      const FlatMap* part = newest.Find(term);
      return part == nullptr ? 0 : part->CountOf(key);
    }
    // The number of the newest, counted from 1; 0 for none.
    std::uint32_t Newest(std::uint64_t key, rdf::TermId term) const {
      const FlatMap* part = newest.Find(term);
      return part == nullptr ? 0 : part->Find(key);
    }
  };

  static std::uint64_t Key(rdf::TermId a) { return static_cast<std::uint32_t>(a); }
  static std::uint64_t Key(rdf::TermId a, rdf::TermId b) {
    return PairKey(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  }

  template <typename Visit>
  void Follow(const Chains& chains, std::uint64_t key, rdf::TermId term,
              const rdf::Pattern& pattern, Visit&& visit) const {
    for (std::uint32_t i = chains.Newest(key, term); i != 0; i = chains.older[i - 1]) {
      const rdf::Triple triple = triples_[i - 1];
      if (pattern.object == rdf::kAnyTerm || pattern.object == triple.object) visit(triple);
    }
  }

  // Indexes that few rule sets need are made when first asked for.
  void Complete(Chains& chains, rdf::TermId rdf::Triple::*component) const {
    while (chains.older.size() < published_) {
      const rdf::TermId term = triples_[chains.older.size()].*component;
      chains.Append(Key(term), term);
    }
  }

  std::size_t IndexOf(const rdf::Triple& triple) const;  // size() when it is not known
  void Grow(TripleTable& known) const;

  std::vector<rdf::Triple> triples_;
  std::vector<std::uint32_t> origins_;
  TableMemory memory_;
  Parts<TripleTable> known_{&memory_};  // by subject
  std::size_t published_ = 0;
  Chains by_predicate_{&memory_}, by_predicate_subject_{&memory_}, by_predicate_object_{&memory_};
  Chains by_subject_{&memory_}, by_object_{&memory_};
};

}  // namespace lares::owl
