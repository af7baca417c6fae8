#include "ontology/triples/dictionary.h"

#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/error.h"
#include "ontology/rdf/literal_value.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

// The datatype or language that many literals share.
struct Suffix {
  std::string datatype;
  std::string language;
};

struct Entry {
  const char* text = nullptr;
  const Suffix* suffix = nullptr;  // of literals that have one
  std::uint32_t size = 0;
  TermKind kind = TermKind::kIri;
  std::atomic<bool> has_twins{false};  // other literals denote its value
};

// Chunk k holds 2^(k + 8) entries, so that entries never move and small dictionaries stay small.
constexpr int kFirstChunkBits = 8;
constexpr int kChunks = 33 - kFirstChunkBits;

struct Slot {
  int chunk;
  std::size_t offset;
};

Slot SlotOf(std::uint32_t index) {
  const std::uint64_t shifted = std::uint64_t{index} + (1U << kFirstChunkBits);
  const int bits = std::bit_width(shifted) - 1;
  return {bits - kFirstChunkBits, static_cast<std::size_t>(shifted - (std::uint64_t{1} << bits))};
}

TermView Normal(const TermView& term) {
  if (term.kind != TermKind::kLiteral) return {term.kind, term.value, {}, {}};
  TermView normal = term;
  const bool is_string = normal.datatype.starts_with(kXsd) &&
                         normal.datatype.substr(kXsd.size()) == std::string_view("string");
  if (!normal.language.empty() || is_string) normal.datatype = {};
  return normal;
}

std::uint32_t HashOf(const TermView& term) {
  const std::hash<std::string_view> hash;
  std::uint64_t h = hash(term.value) + static_cast<std::uint64_t>(term.kind);
  if (!term.datatype.empty()) h = h * 31 + hash(term.datatype);
  if (!term.language.empty()) h = h * 37 + hash(term.language);
  return static_cast<std::uint32_t>((h * 0x9E3779B97F4A7C15ULL) >> 32);
}

TermView ViewOf(const Entry& entry) {
  TermView view{entry.kind, {entry.text, entry.size}, {}, {}};
  if (entry.suffix != nullptr) {
    view.datatype = entry.suffix->datatype;
    view.language = entry.suffix->language;
  }
  return view;
}

// Open addressing over hash << 32 | id; 0 is empty. Readers probe while one writer inserts.
struct Table {
  explicit Table(std::size_t size) : mask(size - 1), slots(size) {}
  std::size_t mask;
  std::vector<std::atomic<std::uint64_t>> slots;

  void Insert(std::uint64_t slot) {
    std::size_t i = (slot >> 32) & mask;
    while (slots[i].load(std::memory_order_relaxed) != 0) i = (i + 1) & mask;
    slots[i].store(slot, std::memory_order_release);
  }
};

// Text that never moves.
class Arena {
 public:
  const char* Copy(std::string_view text) {
    if (text.empty()) return "";
    if (text.size() > left_) NewBlock(text.size());
    char* copy = end_;
    std::memcpy(copy, text.data(), text.size());
    end_ += text.size();
    left_ -= text.size();
    return copy;
  }
  std::size_t bytes() const { return bytes_; }

 private:
  void NewBlock(std::size_t at_least) {
    const std::size_t size = std::max(at_least, next_block_);
    next_block_ = std::min<std::size_t>(2 * next_block_, 1U << 20);
    blocks_.push_back(std::make_unique_for_overwrite<char[]>(size));
    end_ = blocks_.back().get();
    left_ = size;
    bytes_ += size;
  }

  std::vector<std::unique_ptr<char[]>> blocks_;
  char* end_ = nullptr;
  std::size_t left_ = 0;
  std::size_t next_block_ = 4096;
  std::size_t bytes_ = 0;
};

// Which literals denote one value. Not thread-safe.
class ValueIndex {
 public:
  // The literal that first denoted `value`; `id` when it is the first.
  template <typename ValueOfId>
  TermId Insert(const DataValue& value, TermId id, ValueOfId&& value_of) {
    if (2 * (count_ + 1) > slots_.size()) Grow();
    const std::uint64_t hash = HashOf(value);
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = (hash >> 32) & mask;
    for (; slots_[i] != 0; i = (i + 1) & mask) {
      if (slots_[i] >> 32 != hash >> 32) continue;
      const TermId first{static_cast<std::uint32_t>(slots_[i])};
      if (value_of(first) == value) return first;
    }
    slots_[i] = (hash >> 32) << 32 | static_cast<std::uint32_t>(id);
    ++count_;
    return id;
  }
  std::size_t bytes() const { return slots_.capacity() * sizeof(std::uint64_t); }

 private:
  static std::uint64_t HashOf(const DataValue& value) {
    const std::uint64_t text = std::hash<std::string_view>()(value.canonical);
    return (text + static_cast<std::uint64_t>(value.space)) * 0x9E3779B97F4A7C15ULL;
  }
  void Grow() {
    std::vector<std::uint64_t> old(slots_.empty() ? 64 : 2 * slots_.size());
    old.swap(slots_);
    const std::size_t mask = slots_.size() - 1;
    for (const std::uint64_t slot : old) {
      if (slot == 0) continue;
      std::size_t i = (slot >> 32) & mask;
      while (slots_[i] != 0) i = (i + 1) & mask;
      slots_[i] = slot;
    }
  }

  std::vector<std::uint64_t> slots_;  // open addressing over hash << 32 | id; 0 is empty
  std::size_t count_ = 0;
};

}  // namespace

struct Dictionary::State {
  State() { NewTable(1024); }
  ~State() {
    for (auto& chunk : chunks) delete[] chunk.load(std::memory_order_relaxed);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  std::array<std::atomic<Entry*>, kChunks> chunks{};
  std::atomic<std::uint32_t> size{0};  // entries below it are complete
  std::atomic<Table*> table{nullptr};

  mutable std::mutex mutex;                    // guards what follows, and all writing
  std::vector<std::unique_ptr<Table>> tables;  // outgrown ones stay for readers inside them
  Arena arena;
  std::deque<Suffix> suffixes;
  std::map<std::pair<std::string_view, std::string_view>, const Suffix*> suffix_of;
  ValueIndex values;
  bool has_derived_text = false;  // a literal of a datatype derived from xsd:string

  mutable std::shared_mutex twins_mutex;  // guards what follows
  std::unordered_map<TermId, TermId> first_of;
  std::unordered_map<TermId, std::vector<TermId>> twins_of;  // by the first

  Entry& At(std::uint32_t index) const {
    const Slot slot = SlotOf(index);
    return chunks[static_cast<std::size_t>(slot.chunk)].load(
        std::memory_order_acquire)[slot.offset];
  }

  const Entry& Known(TermId id) const {
    const auto number = static_cast<std::uint32_t>(id);
    if (number == 0 || number > size.load(std::memory_order_acquire)) {
      throw Error(Code::kInternal, "no term has id " + std::to_string(number));
    }
    return At(number - 1);
  }

  std::optional<TermId> Find(const TermView& term, std::uint32_t hash) const {
    const Table& now = *table.load(std::memory_order_acquire);
    for (std::size_t i = hash & now.mask;; i = (i + 1) & now.mask) {
      const std::uint64_t slot = now.slots[i].load(std::memory_order_acquire);
      if (slot == 0) return std::nullopt;
      if (slot >> 32 != hash) continue;
      const auto number = static_cast<std::uint32_t>(slot);
      if (ViewOf(At(number - 1)) == term) return TermId{number};
    }
  }

  void NewTable(std::size_t slots) {
    auto grown = std::make_unique<Table>(slots);
    if (!tables.empty()) {
      for (const auto& slot : tables.back()->slots) {
        const std::uint64_t value = slot.load(std::memory_order_relaxed);
        if (value != 0) grown->Insert(value);
      }
    }
    tables.push_back(std::move(grown));
    table.store(tables.back().get(), std::memory_order_release);
  }

  const Suffix* SuffixOf(const TermView& term) {
    if (term.datatype.empty() && term.language.empty()) return nullptr;
    if (const auto known = suffix_of.find({term.datatype, term.language});
        known != suffix_of.end()) {
      return known->second;
    }
    suffixes.push_back({std::string(term.datatype), std::string(term.language)});
    const Suffix& added = suffixes.back();
    suffix_of.emplace(std::pair<std::string_view, std::string_view>(added.datatype, added.language),
                      &added);
    return &added;
  }

  TermId Append(const TermView& term, std::uint32_t hash) {
    const std::uint32_t index = size.load(std::memory_order_relaxed);
    if (index == UINT32_MAX || term.value.size() > UINT32_MAX) {
      throw Error(Code::kTooLarge, "the dictionary of terms is full");
    }
    const Slot slot = SlotOf(index);
    auto& chunk = chunks[static_cast<std::size_t>(slot.chunk)];
    Entry* entries = chunk.load(std::memory_order_relaxed);
    if (entries == nullptr) {
      entries = new Entry[std::size_t{1} << (slot.chunk + kFirstChunkBits)];
      chunk.store(entries, std::memory_order_release);
    }
    Entry& entry = entries[slot.offset];
    entry.text = arena.Copy(term.value);
    entry.suffix = SuffixOf(term);
    entry.size = static_cast<std::uint32_t>(term.value.size());
    entry.kind = term.kind;
    if (2 * (std::size_t{index} + 1) > tables.back()->mask) {
      NewTable(2 * (tables.back()->mask + 1));
    }
    size.store(index + 1, std::memory_order_release);
    const TermId id{index + 1};
    if (term.kind == TermKind::kLiteral) NoteValue(term, id);
    tables.back()->Insert(std::uint64_t{hash} << 32 | (index + 1));
    return id;
  }

  auto value_of() const {
    return [this](TermId id) {
      return ValueOf(ViewOf(At(static_cast<std::uint32_t>(id) - 1))).value_or(DataValue{});
    };
  }

  // Plain text is its own value and far the most frequent: it is looked for only by, and beside,
  // text of derived datatypes.
  void NoteValue(const TermView& term, TermId id) {
    const bool is_plain = term.datatype.empty();
    if (is_plain && !has_derived_text) return;
    const auto value = ValueOf(term);
    if (!value) return;
    if (value->space == DataValue::Space::kText && !is_plain) {
      has_derived_text = true;
      const std::size_t split = value->canonical.find('\0');
      const std::string_view text = value->canonical;
      const TermView plain{TermKind::kLiteral, text.substr(split + 1), {}, text.substr(0, split)};
      if (const auto known = Find(plain, HashOf(plain))) values.Insert(*value, *known, value_of());
    }
    const TermId first = values.Insert(*value, id, value_of());
    if (first != id) NoteTwin(first, id);
  }
  void NoteTwin(TermId first, TermId id) {
    {
      const std::unique_lock lock(twins_mutex);
      std::vector<TermId>& twins = twins_of[first];
      if (twins.empty()) twins.push_back(first);
      twins.push_back(id);
      first_of[id] = first;
    }
    At(static_cast<std::uint32_t>(first) - 1).has_twins.store(true, std::memory_order_release);
    At(static_cast<std::uint32_t>(id) - 1).has_twins.store(true, std::memory_order_release);
  }
};

Dictionary::Dictionary() : state_(std::make_unique<State>()) {}
Dictionary::~Dictionary() = default;

TermId Dictionary::Intern(const TermView& term) {
  const TermView normal = Normal(term);
  const std::uint32_t hash = HashOf(normal);
  if (const auto known = state_->Find(normal, hash)) return *known;
  const std::lock_guard lock(state_->mutex);
  if (const auto known = state_->Find(normal, hash)) return *known;
  return state_->Append(normal, hash);
}

std::optional<TermId> Dictionary::Find(const TermView& term) const {
  const TermView normal = Normal(term);
  return state_->Find(normal, HashOf(normal));
}

TermView Dictionary::Get(TermId id) const { return ViewOf(state_->Known(id)); }

TermKind Dictionary::Kind(TermId id) const { return state_->Known(id).kind; }

TermId Dictionary::SameValue(TermId id) const {
  if (!state_->Known(id).has_twins.load(std::memory_order_acquire)) return id;
  const std::shared_lock lock(state_->twins_mutex);
  const auto first = state_->first_of.find(id);
  return first == state_->first_of.end() ? id : first->second;
}

bool Dictionary::has_twins() const {
  const std::shared_lock lock(state_->twins_mutex);
  return !state_->twins_of.empty();
}

std::vector<TermId> Dictionary::ValueTwins(TermId id) const {
  if (!state_->Known(id).has_twins.load(std::memory_order_acquire)) return {};
  const std::shared_lock lock(state_->twins_mutex);
  const auto first = state_->first_of.find(id);
  return state_->twins_of.at(first == state_->first_of.end() ? id : first->second);
}

std::size_t Dictionary::size() const { return state_->size.load(std::memory_order_acquire); }

std::size_t Dictionary::memory_bytes() const {
  const std::lock_guard lock(state_->mutex);
  std::size_t bytes = sizeof(State) + state_->arena.bytes();
  for (int k = 0; k < kChunks; ++k) {
    const auto& chunk = state_->chunks[static_cast<std::size_t>(k)];
    if (chunk.load(std::memory_order_relaxed) != nullptr) {
      bytes += sizeof(Entry) << (k + kFirstChunkBits);
    }
  }
  bytes += state_->values.bytes();
  for (const auto& table : state_->tables) bytes += table->slots.size() * sizeof(std::uint64_t);
  for (const Suffix& suffix : state_->suffixes) {
    bytes += sizeof(Suffix) + suffix.datatype.size() + suffix.language.size();
  }
  return bytes;
}

}  // namespace lares::rdf
