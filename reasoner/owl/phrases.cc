#include "reasoner/owl/phrases.h"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {
namespace {

constexpr int kMaxDepth = 3;
constexpr std::size_t kMaxMembers = 8;

class Speaker {
 public:
  explicit Speaker(const rdf::View& view) : view_(view), words_(view.dictionary()) {}

  std::string Say(rdf::TermId term, int depth) const {
    const rdf::TermView is = view_.dictionary().Get(term);
    if (is.kind == rdf::TermKind::kLiteral) return "\"" + std::string(is.value) + "\"";
    if (is.kind != rdf::TermKind::kBlank) return Name(term, is.value);
    if (depth < kMaxDepth) {
      std::string expression = Restriction(term, depth);
      if (expression.empty()) expression = Combination(term, depth);
      if (!expression.empty()) return "(" + expression + ")";
      if (!One(term, words_.first).empty()) return "(" + List(term, " ", depth) + ")";
    }
    return "_:" + std::string(is.value);
  }

 private:
  std::string Name(rdf::TermId term, std::string_view iri) const {
    std::string label = view_.Label(term);
    return label.empty() ? "<" + std::string(iri) + ">" : label;
  }

  rdf::TermId Word(const std::string& name) const {
    return view_.dictionary().FindIri(Expand(name)).value_or(rdf::kAnyTerm);
  }

  std::vector<rdf::TermId> One(rdf::TermId subject, rdf::TermId predicate) const {
    if (predicate == rdf::kAnyTerm) return {};
    std::vector<rdf::TermId> objects = view_.Objects(subject, predicate);
    if (objects.size() > 1) objects.resize(1);
    return objects;
  }

  std::string Restriction(rdf::TermId term, int depth) const {
    constexpr std::array<std::pair<const char*, const char*>, 7> kKinds = {
        {{"owl:someValuesFrom", " some "},
         {"owl:allValuesFrom", " only "},
         {"owl:hasValue", " value "},
         {"owl:maxCardinality", " max "},
         {"owl:maxQualifiedCardinality", " max "},
         {"owl:minCardinality", " min "},
         {"owl:cardinality", " exactly "}}};
    for (const rdf::TermId property : One(term, Word("owl:onProperty"))) {
      for (const auto& [kind, joined] : kKinds) {
        for (const rdf::TermId filler : One(term, Word(kind))) {
          return Say(property, depth + 1) + joined + Say(filler, depth + 1);
        }
      }
    }
    return "";
  }

  std::string Combination(rdf::TermId term, int depth) const {
    constexpr std::array<std::pair<const char*, const char*>, 3> kKinds = {
        {{"owl:intersectionOf", " and "}, {"owl:unionOf", " or "}, {"owl:oneOf", ", "}}};
    for (const auto& [kind, between] : kKinds) {
      for (const rdf::TermId list : One(term, Word(kind))) return List(list, between, depth);
    }
    for (const rdf::TermId other : One(term, Word("owl:complementOf"))) {
      return "not " + Say(other, depth + 1);
    }
    return "";
  }

  std::string List(rdf::TermId list, std::string_view between, int depth) const {
    std::string text;
    for (std::size_t i = 0; list != words_.nil; ++i) {
      if (i == kMaxMembers) return text + std::string(between) + "…";
      const auto member = One(list, words_.first), rest = One(list, words_.rest);
      if (member.empty() || rest.empty()) break;
      if (i > 0) text += between;
      text += Say(member.front(), depth + 1);
      list = rest.front();
    }
    return text;
  }

  const rdf::View& view_;
  Vocabulary words_;
};

}  // namespace

std::string PhraseOf(rdf::TermId term, const rdf::View& view) { return Speaker(view).Say(term, 0); }

std::string PhraseOf(const rdf::Triple& triple, const rdf::View& view) {
  if (triple == rdf::Triple{}) return "contradiction";
  const Speaker speaker(view);
  const Vocabulary words(view.dictionary());
  const std::string_view predicate = view.dictionary().Get(triple.predicate).value;
  const bool is_standard = predicate.starts_with(rdf::kRdf) || predicate.starts_with(rdf::kRdfs) ||
                           predicate.starts_with(rdf::kOwl);
  std::string verb = triple.predicate == words.type ? "a"
                     : is_standard                  ? std::string(LocalName(predicate))
                                                    : speaker.Say(triple.predicate, 0);
  return speaker.Say(triple.subject, 0) + " " + verb + " " + speaker.Say(triple.object, 0);
}

std::string ToNTriples(rdf::TermId term, const rdf::View& view) {
  return rdf::ToNTriples(view.dictionary().Get(term));
}

bool IsListCell(const rdf::Triple& triple, const rdf::View& view) {
  const Vocabulary words(view.dictionary());
  return triple.predicate == words.first || triple.predicate == words.rest;
}

}  // namespace lares::owl
