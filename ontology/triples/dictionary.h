// Terms as 32-bit ids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ontology/rdf/term.h"

namespace lares::rdf {

// Id of a term in one Dictionary; 0 is no term and stands for "any" in patterns.
enum class TermId : std::uint32_t {};
inline constexpr TermId kAnyTerm{0};

// Append-only: an id, once given, and the TermView behind it stay valid for the dictionary's life.
// All members are thread-safe; only an Intern of a term not seen before takes a lock.
// "a"^^xsd:string is "a", and a literal with a language has no datatype beside it.
class Dictionary {
 public:
  Dictionary();
  ~Dictionary();
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  TermId Intern(const TermView& term);
  TermId InternIri(std::string_view iri) { return Intern({TermKind::kIri, iri, {}, {}}); }
  std::optional<TermId> Find(const TermView& term) const;
  std::optional<TermId> FindIri(std::string_view iri) const {
    return Find({TermKind::kIri, iri, {}, {}});
  }
  // Throws kInternal for an id that this dictionary never gave.
  TermView Get(TermId id) const;
  // Get(id).kind, cheaper.
  TermKind Kind(TermId id) const;
  // The first literal given an id that denotes the same data value (ontology/rdf/literal_value.h);
  // `id` itself when it is no literal, has no known value, or is the first.
  TermId SameValue(TermId id) const;
  // Whether any two literals denote one value.
  bool has_twins() const;
  // All literals of one value, `id` among them, oldest first; empty when it is alone in its value.
  std::vector<TermId> ValueTwins(TermId id) const;
  // How many terms there are: ids run from 1 to size().
  std::size_t size() const;
  std::size_t memory_bytes() const;  // about, without malloc's own overhead

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::rdf
