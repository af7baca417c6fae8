#include "ontology/rdf/three_way_merge.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "base/hash.h"

namespace lares::rdf {
namespace {

constexpr std::size_t kMaxDepth = 200;
constexpr std::size_t kLongKey = 2000;

// A value of a predicate by its key, with the statements that say it: its own, then those of the
// blank nodes below it.
using Values = std::map<std::string, std::vector<Statement>>;
using Subject = std::map<std::string, Values>;  // by predicate

// A document taken apart into subjects that stand for themselves: IRIs, and blank nodes that
// nothing else speaks of.
class Parts {
 public:
  explicit Parts(const Document& document) : document_(document) {
    for (const Statement& statement : document.statements) {
      by_subject_[statement.subject].push_back(statement);
      if (IsBlank(statement.object)) ++uses_[statement.object];
    }
    for (const auto& [subject, statements] : by_subject_) {
      if (!IsBlank(subject) || uses_.count(subject) == 0) Add(subject, statements);
    }
    // What only circles of blank nodes lead to.
    for (const auto& [subject, statements] : by_subject_) {
      if (taken_.count(subject) == 0) Add(subject, statements);
    }
  }

  const Subject* Find(const std::string& key) const {
    const auto found = subjects_.find(key);
    return found == subjects_.end() ? nullptr : &found->second;
  }
  const std::map<std::string, Subject>& subjects() const { return subjects_; }
  const Document& document() const { return document_; }

 private:
  bool IsBlank(std::uint32_t term) const { return document_.terms[term].kind == TermKind::kBlank; }

  // A circle, or what is nested deeper than anybody writes, is told apart by labels only.
  std::string KeyOf(std::uint32_t term) {
    if (!IsBlank(term)) return ToNTriples(document_.terms[term].view());
    if (const auto known = keys_.find(term); known != keys_.end()) return known->second;
    if (open_.size() >= kMaxDepth || !open_.insert(term).second) {
      ++labelled_;
      return ToNTriples(document_.terms[term].view());
    }
    const std::size_t labelled_before = labelled_;
    std::vector<std::string> said;
    if (const auto found = by_subject_.find(term); found != by_subject_.end()) {
      for (const Statement& statement : found->second) {
        said.push_back(KeyOf(statement.predicate) + " " + KeyOf(statement.object));
      }
    }
    std::sort(said.begin(), said.end());
    std::string key = "[";
    for (const std::string& each : said) key += " " + each + " ;";
    key += " ]";
    if (key.size() > kLongKey) key = "[ … " + Sha256Hex(key).substr(0, 32) + " ]";
    open_.erase(term);
    if (open_.empty() || labelled_ == labelled_before) keys_[term] = key;
    return key;
  }

  // The statements of the blank nodes from `term` on, each node once.
  void Collect(std::uint32_t term, std::set<std::uint32_t> seen, std::vector<Statement>& into) {
    std::vector<std::uint32_t> open{term};
    while (!open.empty()) {
      const std::uint32_t next = open.back();
      open.pop_back();
      if (!IsBlank(next) || !seen.insert(next).second) continue;
      taken_.insert(next);
      const auto found = by_subject_.find(next);
      if (found == by_subject_.end()) continue;
      for (const Statement& statement : found->second) {
        into.push_back(statement);
        open.push_back(statement.object);
      }
    }
  }

  void Add(std::uint32_t subject, const std::vector<Statement>& statements) {
    taken_.insert(subject);
    Subject& to = subjects_[KeyOf(subject)];
    for (const Statement& statement : statements) {
      std::vector<Statement> all{statement};
      Collect(statement.object, {subject}, all);
      to[KeyOf(statement.predicate)].emplace(KeyOf(statement.object), std::move(all));
    }
  }

  const Document& document_;
  std::map<std::uint32_t, std::vector<Statement>> by_subject_;
  std::unordered_map<std::uint32_t, int> uses_;  // of blank nodes, as objects
  std::unordered_map<std::uint32_t, std::string> keys_;
  std::set<std::uint32_t> open_;
  std::size_t labelled_ = 0;  // how often a label stood for what is said of its node
  std::set<std::uint32_t> taken_;
  std::map<std::string, Subject> subjects_;
};

// Puts statements of several documents into one; blank nodes of each value stay its own.
class Builder {
 public:
  Builder() { document_.format = Format::kTurtle; }

  void AddHead(const Document& from) {
    if (document_.base_iri.empty()) document_.base_iri = from.base_iri;
    for (const auto& [prefix, iri] : from.prefixes) document_.prefixes.emplace(prefix, iri);
    for (const std::string& import : from.imports) {
      if (std::find(document_.imports.begin(), document_.imports.end(), import) ==
          document_.imports.end()) {
        document_.imports.push_back(import);
      }
    }
  }

  // `subject_blank`: what a blank subject is called here, shared by all its values.
  void Add(const Document& from, const std::vector<Statement>& statements,
           std::map<std::uint32_t, std::uint32_t>& blanks) {
    for (const Statement& statement : statements) {
      const Statement added{Take(from, statement.subject, blanks),
                            Take(from, statement.predicate, blanks),
                            Take(from, statement.object, blanks), Statement::kDefaultGraph};
      const std::array<std::uint32_t, 3> key{added.subject, added.predicate, added.object};
      if (said_.insert(key).second) document_.statements.push_back(added);
    }
  }

  Document Take() { return std::move(document_); }

 private:
  std::uint32_t Take(const Document& from, std::uint32_t term,
                     std::map<std::uint32_t, std::uint32_t>& blanks) {
    const Term& original = from.terms[term];
    if (original.kind == TermKind::kBlank) {
      const auto [place, is_new] = blanks.emplace(term, 0);
      if (is_new) {
        place->second = static_cast<std::uint32_t>(document_.terms.size());
        document_.terms.push_back(Term::Blank("m" + std::to_string(++blank_count_)));
      }
      return place->second;
    }
    const auto [place, is_new] = terms_.emplace(ToNTriples(original.view()), 0);
    if (is_new) {
      place->second = static_cast<std::uint32_t>(document_.terms.size());
      document_.terms.push_back(original);
    }
    return place->second;
  }

  Document document_;
  std::map<std::string, std::uint32_t> terms_;
  std::set<std::array<std::uint32_t, 3>> said_;
  std::size_t blank_count_ = 0;
};

const Values kNoValues;

const Values& ValuesOf(const Subject* subject, const std::string& predicate) {
  if (subject == nullptr) return kNoValues;
  const auto found = subject->find(predicate);
  return found == subject->end() ? kNoValues : found->second;
}

bool SameKeys(const Values& a, const Values& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(),
                                            [](auto& x, auto& y) { return x.first == y.first; });
}

bool SameSubject(const Subject* a, const Subject* b) {
  if (a == nullptr || b == nullptr) return a == b;
  return a->size() == b->size() &&
         std::equal(a->begin(), a->end(), b->begin(), [](auto& x, auto& y) {
           return x.first == y.first && SameKeys(x.second, y.second);
         });
}

std::vector<std::string> KeysOf(const Values& values) {
  std::vector<std::string> keys;
  for (const auto& [key, statements] : values) keys.push_back(key);
  return keys;
}

std::string WithoutBrackets(const std::string& key) {
  return key.starts_with('<') ? key.substr(1, key.size() - 2) : key;
}

class ThreeWays {
 public:
  ThreeWays(const Document& base, const Document& ours, const Document& theirs,
            const std::function<std::optional<Side>(const MergeConflict&)>& choose)
      : base_(base), ours_(ours), theirs_(theirs), choose_(choose) {
    builder_.AddHead(ours);
    builder_.AddHead(theirs);
  }

  MergeResult Merge() {
    std::set<std::string> keys;
    for (const Parts* parts : {&ours_, &theirs_}) {
      for (const auto& [key, subject] : parts->subjects()) keys.insert(key);
    }
    for (const std::string& key : keys) MergeSubject(key);
    result_.document = builder_.Take();
    return std::move(result_);
  }

 private:
  void MergeSubject(const std::string& key) {
    const Subject* base = base_.Find(key);
    const Subject* ours = ours_.Find(key);
    const Subject* theirs = theirs_.Find(key);
    ours_blanks_.clear();
    theirs_blanks_.clear();
    if (ours == nullptr || theirs == nullptr) {
      if (base == nullptr) return AddWhole(ours, theirs);
      const Subject* left = ours != nullptr ? ours : theirs;
      if (SameSubject(left, base)) return;  // the other side took it out
      MergeConflict conflict{WithoutBrackets(key), "", {}, {}, {}};
      const Side side = Decide(std::move(conflict));
      return side == Side::kOurs ? AddWhole(ours, nullptr) : AddWhole(nullptr, theirs);
    }
    std::set<std::string> predicates;
    for (const Subject* subject : {ours, theirs}) {
      for (const auto& [predicate, values] : *subject) predicates.insert(predicate);
    }
    for (const std::string& predicate : predicates) {
      MergeValues(key, predicate, ValuesOf(base, predicate), ValuesOf(ours, predicate),
                  ValuesOf(theirs, predicate));
    }
  }

  void MergeValues(const std::string& subject, const std::string& predicate, const Values& base,
                   const Values& ours, const Values& theirs) {
    const bool both_changed = !SameKeys(base, ours) && !SameKeys(base, theirs);
    const bool single = base.size() <= 1 && ours.size() <= 1 && theirs.size() <= 1;
    if (both_changed && single && !SameKeys(ours, theirs)) {
      const Side side = Decide({WithoutBrackets(subject), WithoutBrackets(predicate), KeysOf(base),
                                KeysOf(ours), KeysOf(theirs)});
      return side == Side::kOurs ? AddAll(ours_, ours, ours_blanks_)
                                 : AddAll(theirs_, theirs, theirs_blanks_);
    }
    for (const auto& [key, statements] : ours) {
      // In all three, or new on our side.
      if (theirs.count(key) > 0 || base.count(key) == 0) {
        builder_.Add(ours_.document(), statements, ours_blanks_);
      }
    }
    for (const auto& [key, statements] : theirs) {
      if (ours.count(key) == 0 && base.count(key) == 0) {
        builder_.Add(theirs_.document(), statements, theirs_blanks_);
      }
    }
  }

  Side Decide(MergeConflict conflict) {
    if (choose_) {
      if (const std::optional<Side> side = choose_(conflict)) return *side;
    }
    result_.conflicts.push_back(std::move(conflict));
    return Side::kOurs;
  }

  void AddAll(const Parts& from, const Values& values,
              std::map<std::uint32_t, std::uint32_t>& blanks) {
    for (const auto& [key, statements] : values) builder_.Add(from.document(), statements, blanks);
  }
  void AddWhole(const Subject* ours, const Subject* theirs) {
    if (ours != nullptr) {
      for (const auto& [predicate, values] : *ours) AddAll(ours_, values, ours_blanks_);
    }
    if (theirs != nullptr) {
      for (const auto& [predicate, values] : *theirs) AddAll(theirs_, values, theirs_blanks_);
    }
  }

  Parts base_, ours_, theirs_;
  const std::function<std::optional<Side>(const MergeConflict&)>& choose_;
  Builder builder_;
  // Within one subject a blank node of a document is one node of the result.
  std::map<std::uint32_t, std::uint32_t> ours_blanks_, theirs_blanks_;
  MergeResult result_;
};

}  // namespace

MergeResult MergeThreeWays(const Document& base, const Document& ours, const Document& theirs,
                           const std::function<std::optional<Side>(const MergeConflict&)>& choose) {
  return ThreeWays(base, ours, theirs, choose).Merge();
}

}  // namespace lares::rdf
