// The terms of one evaluation: those of the dictionary, and those that the query makes.
#pragma once

#include <cstddef>
#include <deque>
#include <unordered_set>

#include "ontology/triples/dictionary.h"
#include "reasoner/sparql/limits.h"

namespace lares::sparql {

using rdf::TermId;

// Local ids have the highest bit set. Equal terms have equal ids, so ids can be compared.
inline constexpr std::uint32_t kLocalTerms = 0x80000000U;
inline bool IsLocal(TermId id) { return static_cast<std::uint32_t>(id) >= kLocalTerms; }

// Adds nothing to the dictionary. Not thread-safe.
class Terms {
 public:
  Terms(const rdf::Dictionary& dictionary, Account& account);
  Terms(const Terms&) = delete;
  Terms& operator=(const Terms&) = delete;

  // Valid until the term is forgotten; those of the dictionary for its life.
  rdf::TermView Get(TermId id) const;
  TermId Intern(const rdf::TermView& term);

  // Terms made since a mark are forgotten again, unless a row was kept meanwhile: whoever keeps ids
  // beyond the call that gave them calls Keep first.
  std::size_t Mark() const { return local_.size(); }
  void Forget(std::size_t mark);
  void Keep() { kept_ = local_.size(); }

 private:
  struct Hash {
    using is_transparent = void;
    const Terms* terms;
    std::size_t operator()(std::uint32_t index) const;
    std::size_t operator()(const rdf::TermView& term) const;
  };
  struct Equal {
    using is_transparent = void;
    const Terms* terms;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return a == b; }
    bool operator()(const rdf::TermView& a, std::uint32_t b) const;
    bool operator()(std::uint32_t a, const rdf::TermView& b) const { return (*this)(b, a); }
  };

  const rdf::Dictionary& dictionary_;
  Account& account_;
  std::deque<rdf::Term> local_;
  std::unordered_set<std::uint32_t, Hash, Equal> index_;
  std::size_t kept_ = 0;
};

}  // namespace lares::sparql
