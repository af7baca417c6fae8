#include "reasoner/sparql/terms.h"

#include <functional>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::sparql {
namespace {

std::size_t BytesOf(const rdf::Term& term) {
  const auto heap = [](const std::string& text) { return text.size() > 15 ? text.size() + 1 : 0; };
  return sizeof(rdf::Term) + 48 + heap(term.value) + heap(term.datatype) + heap(term.language);
}

rdf::TermView Normal(rdf::TermView term) {
  if (term.kind != rdf::TermKind::kLiteral) return {term.kind, term.value, {}, {}};
  const bool is_string =
      term.datatype.starts_with(rdf::kXsd) && term.datatype.substr(rdf::kXsd.size()) == "string";
  if (!term.language.empty() || is_string) term.datatype = {};
  return term;
}

}  // namespace

std::size_t Terms::Hash::operator()(const rdf::TermView& term) const {
  const std::hash<std::string_view> hash;
  return hash(term.value) * 31 + hash(term.datatype) * 17 + hash(term.language) +
         static_cast<std::size_t>(term.kind);
}

std::size_t Terms::Hash::operator()(std::uint32_t index) const {
  return (*this)(terms->local_[index].view());
}

bool Terms::Equal::operator()(const rdf::TermView& a, std::uint32_t b) const {
  return a == terms->local_[b].view();
}

Terms::Terms(const rdf::Dictionary& dictionary, Account& account)
    : dictionary_(dictionary), account_(account), index_(16, Hash{this}, Equal{this}) {}

rdf::TermView Terms::Get(TermId id) const {
  if (!IsLocal(id)) return dictionary_.Get(id);
  return local_[static_cast<std::uint32_t>(id) - kLocalTerms].view();
}

TermId Terms::Intern(const rdf::TermView& given) {
  rdf::TermView term = Normal(given);
  std::string lower;
  if (!term.language.empty()) {
    lower = ToLower(term.language);
    term.language = lower;
  }
  if (const auto known = dictionary_.Find(term)) return *known;
  if (const auto known = index_.find(term); known != index_.end()) {
    return TermId{kLocalTerms + *known};
  }
  rdf::Term made{term.kind, std::string(term.value), std::string(term.datatype),
                 std::string(term.language)};
  account_.Charge(BytesOf(made));
  local_.push_back(std::move(made));
  const auto number = static_cast<std::uint32_t>(local_.size() - 1);
  index_.insert(number);
  return TermId{kLocalTerms + number};
}

void Terms::Forget(std::size_t mark) {
  while (local_.size() > mark && local_.size() > kept_) {
    index_.erase(index_.find(static_cast<std::uint32_t>(local_.size() - 1)));
    account_.Release(BytesOf(local_.back()));
    local_.pop_back();
  }
}

}  // namespace lares::sparql
