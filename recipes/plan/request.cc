#include "recipes/plan/request.h"

#include <algorithm>
#include <set>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::recipes {
namespace {

using prolog::Atom;
using prolog::Value;

// How well a name fits, best first.
enum Fit { kIri, kLocalName, kLocalNameIgnoringCase, kLabel, kFits };

struct Candidates {
  std::vector<std::string> by_fit[kFits];

  void Add(Fit fit, std::string_view iri) {
    std::vector<std::string>& those = by_fit[fit];
    if (std::find(those.begin(), those.end(), iri) == those.end()) those.emplace_back(iri);
  }
  // Those that fit best; several when they fit equally well.
  std::vector<std::string> Best() const {
    for (const std::vector<std::string>& those : by_fit) {
      if (!those.empty()) return those;
    }
    return {};
  }
};

struct Meaning {
  Candidates classes;
  Candidates things;
};

Value Atoms(const std::vector<std::string>& texts) {
  prolog::List atoms;
  for (const std::string& text : texts) atoms.push_back(Value{Atom{text}});
  return Value{std::move(atoms)};
}

// Everything that `names` (as written) may mean, found in one pass over the view.
class Meanings {
 public:
  Meanings(const rdf::View& view, const std::set<std::string>& names) : view_(view) {
    for (const std::string& name : names) {
      meanings_[name];
      by_lower_[ToLower(name)].push_back(name);
      lengths_.insert(name.size());
    }
    const rdf::Dictionary& dictionary = view.dictionary();
    const auto type = dictionary.FindIri(std::string(rdf::kRdf) + "type");
    if (!type) return;
    type_ = *type;
    FindClassesAndThings();
    FindLabelled();
  }

  Value Classes(const std::string& name) const { return Atoms(meanings_.at(name).classes.Best()); }
  Value Things(const std::string& name) const { return Atoms(meanings_.at(name).things.Best()); }

 private:
  void FindClassesAndThings() {
    const rdf::Dictionary& dictionary = view_.dictionary();
    ForEachStated(type_, [&](const rdf::Triple& triple) {
      const rdf::TermView subject = dictionary.Get(triple.subject);
      if (subject.kind == rdf::TermKind::kIri) AddByName(triple, subject.value);
    });
  }
  // Straight through the documents: what follows from them names nothing new.
  template <typename Visit>
  void ForEachStated(rdf::TermId predicate, Visit visit) const {
    for (const auto& layer : view_.layers()) {
      for (const rdf::Graph& graph : layer->graphs()) {
        for (const rdf::Triple& triple : graph.triples) {
          if (triple.predicate == predicate) visit(triple);
        }
      }
    }
  }
  // Whether it, or its last part, is as long as some name: most are told apart by that.
  bool MayBeNamed(std::string_view iri) const {
    return std::any_of(lengths_.begin(), lengths_.end(), [&](std::size_t length) {
      if (iri.size() <= length) return iri.size() == length;
      const char before = iri[iri.size() - length - 1];
      return before == '#' || before == '/';
    });
  }
  void AddByName(const rdf::Triple& triple, std::string_view iri) {
    if (!MayBeNamed(iri)) return;
    const std::string_view local = LocalName(iri);
    const auto named = by_lower_.find(ToLower(local));
    if (named != by_lower_.end()) {
      for (const std::string& name : named->second) {
        Side(name, triple.object).Add(name == local ? kLocalName : kLocalNameIgnoringCase, iri);
      }
    }
    const auto whole = meanings_.find(std::string(iri));
    if (whole != meanings_.end()) Side(whole->first, triple.object).Add(kIri, iri);
  }
  void FindLabelled() {
    const rdf::Dictionary& dictionary = view_.dictionary();
    const auto label = dictionary.FindIri(std::string(rdf::kRdfs) + "label");
    if (!label) return;
    ForEachStated(*label, [&](const rdf::Triple& triple) {
      const std::string_view text = dictionary.Get(triple.object).value;
      if (lengths_.count(text.size()) == 0) return;
      const auto named = by_lower_.find(ToLower(text));
      const rdf::TermView subject = dictionary.Get(triple.subject);
      if (named == by_lower_.end() || subject.kind != rdf::TermKind::kIri) return;
      for (const rdf::TermId kind : view_.Objects(triple.subject, type_)) {
        for (const std::string& name : named->second) Side(name, kind).Add(kLabel, subject.value);
      }
    });
  }
  // owl:Class and what is no thing of the world go to the classes' side or nowhere.
  Candidates& Side(const std::string& name, rdf::TermId kind) {
    const std::string_view iri = view_.dictionary().Get(kind).value;
    if (iri == std::string(rdf::kOwl) + "Class") return meanings_.at(name).classes;
    const bool is_vocabulary = iri.starts_with(rdf::kOwl) && LocalName(iri) != "NamedIndividual";
    if (is_vocabulary || iri.starts_with(rdf::kRdf) || iri.starts_with(rdf::kRdfs)) return nowhere_;
    return meanings_.at(name).things;
  }

  const rdf::View& view_;
  rdf::TermId type_{};
  std::map<std::string, Meaning> meanings_;
  std::map<std::string, std::vector<std::string>> by_lower_;
  std::set<std::size_t> lengths_;
  Candidates nowhere_;
};

std::vector<std::string> Parts(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part(Trim(std::string_view(text).substr(begin, end - begin)));
    if (!part.empty()) parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

Value Item(const Meanings& meanings, const std::string& text) {
  return Value{prolog::Dict{{"text", Value{Atom{text}}},
                            {"classes", meanings.Classes(text)},
                            {"things", meanings.Things(text)}}};
}

}  // namespace

Value ToGiven(const rdf::View& view, const std::map<std::string, std::string>& set) {
  prolog::List given;
  if (set.empty()) return Value{std::move(given)};
  std::set<std::string> names;
  for (const auto& [name, text] : set) {
    names.insert(text);
    for (const std::string& part : Parts(text)) names.insert(part);
  }
  const Meanings meanings(view, names);
  for (const auto& [name, text] : set) {
    prolog::List items;
    for (const std::string& part : Parts(text)) items.push_back(Item(meanings, part));
    given.push_back(Value{prolog::Dict{{"name", Value{Atom{name}}},
                                       {"text", Value{Atom{text}}},
                                       {"classes", meanings.Classes(text)},
                                       {"things", meanings.Things(text)},
                                       {"items", Value{std::move(items)}}}});
  }
  return Value{std::move(given)};
}

}  // namespace lares::recipes
