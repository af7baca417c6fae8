// Dictionary ids as Prolog atoms and back, converted once. Inside this folder only.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <shared_mutex>
#include <string_view>
#include <unordered_map>

#include "ontology/triples/dictionary.h"
#include "reasoner/prolog/terms.h"

namespace lares::prolog {

// One per dictionary. Its atoms are registered, so Prolog's garbage collector keeps them, and given
// back when it goes. Thread-safe; every member needs an attached engine.
class TermCache {
 public:
  // The cache of this dictionary, made when there is none; caches of dictionaries that are gone are
  // dropped.
  static std::shared_ptr<TermCache> For(const std::shared_ptr<rdf::Dictionary>& dictionary);

  explicit TermCache(const std::shared_ptr<rdf::Dictionary>& dictionary);
  ~TermCache();
  TermCache(const TermCache&) = delete;
  TermCache& operator=(const TermCache&) = delete;

  struct Atoms {
    AtomRef value = 0;     // the IRI, "_:label" or the lexical form
    AtomRef datatype = 0;  // 0 when the term is no literal
    AtomRef language = 0;
  };
  // `id` must be one that the dictionary gave.
  Atoms AtomsOf(rdf::TermId id);

  // The IRI or blank node that an atom spells; nothing when the dictionary has none.
  std::optional<rdf::TermId> IdOf(AtomRef atom);

 private:
  struct Entry {
    std::atomic<AtomRef> value{0}, datatype{0}, language{0};
  };
  // Segment k holds 2^k times as many entries as the first, so that small dictionaries have small
  // caches and entries never move.
  static constexpr std::uint32_t kFirstSegment = 1u << 8;
  static constexpr std::size_t kSegments = 25;

  struct Shard {
    std::shared_mutex mutex;
    std::unordered_map<AtomRef, rdf::TermId> ids;
  };
  static constexpr std::size_t kShards = 16;

  Entry& EntryOf(rdf::TermId id);
  Atoms Fill(rdf::TermId id, Entry& entry);
  Shard& ShardOf(AtomRef atom) { return shards_[(atom >> 7) % kShards]; }
  void Remember(AtomRef atom, rdf::TermId id);

  std::weak_ptr<rdf::Dictionary> owner_;
  const rdf::Dictionary& dictionary_;  // alive while any goal uses this cache
  std::array<std::atomic<Entry*>, kSegments> segments_{};
  std::array<Shard, kShards> shards_;
};

}  // namespace lares::prolog
