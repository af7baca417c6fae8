#include <nlohmann/json.hpp>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/phrases.h"
#include "reasoner/owl/why_not.h"

namespace lares::owl {
namespace {

std::string Variable(std::uint32_t number) { return "?" + std::to_string(number); }

// "something", and a number where there are several such things in one sentence.
std::string Part(const Slot& slot, const rdf::View& view) {
  if (!slot.is_variable) return PhraseOf(rdf::TermId{slot.value}, view);
  return "something (" + Variable(slot.value) + ")";
}

std::string Verb(const Slot& slot, const rdf::View& view) {
  if (slot.is_variable) return Part(slot, view);
  const bool is_type = view.dictionary().Get(rdf::TermId{slot.value}).value == Expand("a");
  return is_type ? "a" : Part(slot, view);
}

std::string Term(const Slot& slot, const rdf::View& view) {
  return slot.is_variable ? Variable(slot.value) : ToNTriples(rdf::TermId{slot.value}, view);
}

}  // namespace

std::string PhraseOf(const Atom& missing, const rdf::View& view) {
  return Part(missing.subject, view) + " " + Verb(missing.predicate, view) + " " +
         Part(missing.object, view);
}

std::string ToText(const rdf::Triple& goal, const std::vector<Lack>& lacks, const rdf::View& view) {
  const std::string what = "'" + PhraseOf(goal, view) + "'";
  if (lacks.empty()) {
    return what + " does not hold, and nothing is known from which it would follow\n";
  }
  std::string text = what + " does not hold; it would, if\n";
  for (std::size_t i = 0; i < lacks.size(); ++i) {
    const Lack& lack = lacks[i];
    text += (i == 0 ? "  " : "or\n  ");
    for (std::size_t j = 0; j < lack.missing.size(); ++j) {
      text += (j == 0 ? "" : "\n  and ") + PhraseOf(lack.missing[j], view);
    }
    text += lack.rules.empty() ? "\n    were said: no axiom leads there" : "\n    by";
    for (const std::string& rule : lack.rules) text += " " + rule;
    std::string given;
    for (const rdf::Triple& triple : lack.held) {
      if (IsListCell(triple, view)) continue;
      const char* first = lack.rules.empty() ? "; what does hold: " : ", given that ";
      given += (given.empty() ? first : ", ") + PhraseOf(triple, view);
    }
    text += given + "\n";
  }
  return text;
}

std::string ToJson(const rdf::Triple& goal, const std::vector<Lack>& lacks, const rdf::View& view) {
  using Json = nlohmann::ordered_json;
  const auto [s, p, o] = goal;
  Json json{{"goal", PhraseOf(goal, view)},
            {"triple", {ToNTriples(s, view), ToNTriples(p, view), ToNTriples(o, view)}},
            {"lacks", Json::array()}};
  for (const Lack& lack : lacks) {
    Json entry{{"missing", Json::array()}, {"held", Json::array()}, {"rules", lack.rules}};
    for (const Atom& atom : lack.missing) {
      entry["missing"].push_back(
          {{"text", PhraseOf(atom, view)},
           {"triple",
            {Term(atom.subject, view), Term(atom.predicate, view), Term(atom.object, view)}}});
    }
    for (const rdf::Triple& triple : lack.held) {
      if (!IsListCell(triple, view)) entry["held"].push_back(PhraseOf(triple, view));
    }
    json["lacks"].push_back(std::move(entry));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace lares::owl
