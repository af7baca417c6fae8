#include "reasoner/prolog/term_cache.h"

#include <SWI-Prolog.h>

#include <bit>
#include <mutex>
#include <string>
#include <vector>

#include "base/error.h"

namespace lares::prolog {
namespace {

constexpr std::string_view kBlankPrefix = "_:";

// A registered atom.
AtomRef NewAtom(std::string_view text) {
  const atom_t atom = PL_new_atom_mbchars(REP_UTF8, text.size(), text.data());
  if (atom == 0) throw Error(Code::kTooLarge, "Prolog has no room for another atom");
  return atom;
}

std::string TextOfAtom(AtomRef atom) {
  const fid_t frame = PL_open_foreign_frame();
  const term_t term = PL_new_term_ref();
  std::string text;
  if (PL_put_atom(term, atom)) text = TextOf(term);
  PL_close_foreign_frame(frame);
  return text;
}

std::optional<rdf::TermId> FindTerm(const rdf::Dictionary& dictionary, std::string_view text) {
  if (!text.starts_with(kBlankPrefix)) return dictionary.FindIri(text);
  return dictionary.Find({rdf::TermKind::kBlank, text.substr(kBlankPrefix.size()), {}, {}});
}

struct Registry {
  std::mutex mutex;
  std::unordered_map<const rdf::Dictionary*, std::shared_ptr<TermCache>> caches;
};

Registry& GetRegistry() {
  static Registry* const registry = new Registry;  // outlives every thread
  return *registry;
}

}  // namespace

std::shared_ptr<TermCache> TermCache::For(const std::shared_ptr<rdf::Dictionary>& dictionary) {
  Registry& registry = GetRegistry();
  const std::lock_guard lock(registry.mutex);
  // An address may be used again by another dictionary once the first is gone.
  const auto found = registry.caches.find(dictionary.get());
  if (found != registry.caches.end() && !found->second->owner_.expired()) return found->second;
  std::erase_if(registry.caches, [](const auto& entry) { return entry.second->owner_.expired(); });
  auto cache = std::make_shared<TermCache>(dictionary);
  registry.caches.insert_or_assign(dictionary.get(), cache);
  return cache;
}

TermCache::TermCache(const std::shared_ptr<rdf::Dictionary>& dictionary)
    : owner_(dictionary), dictionary_(*dictionary) {}

TermCache::~TermCache() {
  for (std::size_t k = 0; k < kSegments; ++k) {
    const std::unique_ptr<Entry[]> segment(segments_[k].load());
    if (segment == nullptr) continue;
    for (std::size_t i = 0; i < std::size_t{kFirstSegment} << k; ++i) {
      const Entry& entry = segment[i];
      for (const AtomRef atom :
           {entry.value.load(), entry.datatype.load(), entry.language.load()}) {
        if (atom != 0) PL_unregister_atom(atom);
      }
    }
  }
}

TermCache::Entry& TermCache::EntryOf(rdf::TermId id) {
  const std::uint64_t place = std::uint64_t{static_cast<std::uint32_t>(id)} + kFirstSegment;
  const auto k = static_cast<std::size_t>(std::bit_width(place / kFirstSegment)) - 1;
  const std::uint64_t size = std::uint64_t{kFirstSegment} << k;
  Entry* segment = segments_[k].load(std::memory_order_acquire);
  if (segment == nullptr) {
    auto fresh = std::make_unique<Entry[]>(size);
    if (segments_[k].compare_exchange_strong(segment, fresh.get())) segment = fresh.release();
  }
  return segment[place - size];
}

TermCache::Atoms TermCache::AtomsOf(rdf::TermId id) {
  Entry& entry = EntryOf(id);
  const AtomRef value = entry.value.load(std::memory_order_acquire);
  if (value == 0) return Fill(id, entry);
  return {value, entry.datatype.load(std::memory_order_relaxed),
          entry.language.load(std::memory_order_relaxed)};
}

TermCache::Atoms TermCache::Fill(rdf::TermId id, Entry& entry) {
  const rdf::TermView term = dictionary_.Get(id);
  Atoms atoms;
  if (term.kind == rdf::TermKind::kLiteral) {
    atoms = {NewAtom(term.value), NewAtom(term.datatype), NewAtom(term.language)};
  } else if (term.kind == rdf::TermKind::kBlank) {
    atoms.value = NewAtom(std::string(kBlankPrefix) + std::string(term.value));
  } else {
    atoms.value = NewAtom(term.value);
  }
  // Whoever else fills this entry stores the same atoms; one of us keeps the registrations.
  entry.datatype.store(atoms.datatype, std::memory_order_relaxed);
  entry.language.store(atoms.language, std::memory_order_relaxed);
  AtomRef expected = 0;
  if (!entry.value.compare_exchange_strong(expected, atoms.value)) {
    for (const AtomRef atom : {atoms.value, atoms.datatype, atoms.language}) {
      if (atom != 0) PL_unregister_atom(atom);
    }
  } else if (atoms.datatype == 0) {
    Remember(atoms.value, id);
  }
  return atoms;
}

void TermCache::Remember(AtomRef atom, rdf::TermId id) {
  Shard& shard = ShardOf(atom);
  const std::unique_lock lock(shard.mutex);
  shard.ids.emplace(atom, id);
}

std::optional<rdf::TermId> TermCache::IdOf(AtomRef atom) {
  Shard& shard = ShardOf(atom);
  {
    const std::shared_lock lock(shard.mutex);
    const auto found = shard.ids.find(atom);
    if (found != shard.ids.end()) return found->second;
  }
  const std::optional<rdf::TermId> id = FindTerm(dictionary_, TextOfAtom(atom));
  if (id) AtomsOf(*id);  // registers the atom and remembers it
  return id;
}

}  // namespace lares::prolog
