#include "reasoner/profile/consequences.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "ontology/rdf/vocabulary.h"
#include "ontology/triples/graph.h"
#include "reasoner/owl/materialise.h"

namespace lares::profile {
namespace {

constexpr std::string_view kGraph = "check:document";
constexpr std::string_view kMember = "urn:lares:check:member-of:";

// A class to be tried: its canonical id, and its term in the document.
struct Candidate {
  rdf::TermId id{};
  std::uint32_t term = 0;
};

class ConsequenceCheck {
 public:
  ConsequenceCheck(const DocumentIndex& index, const rdf::View& catalogue,
                   const rdf::AliasTable& aliases, Collector& found, std::stop_token stop)
      : index_(index), found_(found), stop_(std::move(stop)), view_(catalogue) {
    view_ = catalogue.With(Close(
        catalogue, rdf::MakeGraph(index.document(), kGraph, aliases, catalogue.dictionary())));
    const auto terms = static_cast<std::uint32_t>(index.document().terms.size());
    for (std::uint32_t term = 0; term < terms; ++term) {
      if (!index.IsIri(term)) continue;
      const auto id = catalogue.dictionary().FindIri(aliases.Canonical(index.Term(term).value));
      if (id) terms_.emplace(*id, term);
    }
  }

  void Run() {
    for (const rdf::Clash& clash : view_.layers().back()->clashes()) ReportClash(clash);
    std::vector<Candidate> candidates;
    const rdf::TermId nothing = Owl("Nothing");
    const rdf::TermId below = Iri(rdf::kRdfs, "subClassOf");
    for (const auto& [id, term] : terms_) {
      const bool is_class = index_.HasType(term, "owl:Class") || index_.HasType(term, "rdfs:Class");
      if (!is_class || id == nothing) continue;
      if (view_.Contains({id, below, nothing})) {
        found_.Add(Kind::kUnsatisfiable, "the class is below owl:Nothing and can have no member",
                   Collector::kNone, term);
      } else {
        candidates.push_back({id, term});
      }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.term < b.term; });
    Try(candidates);
  }

 private:
  std::shared_ptr<const rdf::Layer> Close(const rdf::View& below, rdf::Graph graph) {
    owl::Options options;
    options.max_inferred = 5'000'000;
    return owl::Materialise(below, {std::move(graph)}, options, stop_);
  }
  rdf::TermId Iri(std::string_view space, std::string_view local) {
    return view_.dictionary().InternIri(std::string(space) + std::string(local));
  }
  rdf::TermId Owl(std::string_view local) { return Iri(rdf::kOwl, local); }

  // Members of all classes at once may disturb each other (an inverse functional property makes
  // two of them one), so a contradiction is narrowed down until one class alone has it.
  void Try(std::span<const Candidate> candidates) {
    if (candidates.empty()) return;
    if (stop_.stop_requested()) throw Error(Code::kTimeout, "the check took too long");
    rdf::Graph graph;
    graph.name = "check:members";
    for (const Candidate& candidate : candidates) {
      graph.triples.push_back({MemberOf(candidate), Iri(rdf::kRdf, "type"), candidate.id});
    }
    std::sort(graph.triples.begin(), graph.triples.end());
    const auto layer = Close(view_, std::move(graph));
    if (layer->clash_count() == 0) return;
    if (candidates.size() == 1) return ReportUnsatisfiable(candidates.front(), *layer);
    Try(candidates.first(candidates.size() / 2));
    Try(candidates.subspan(candidates.size() / 2));
  }

  rdf::TermId MemberOf(const Candidate& candidate) {
    return view_.dictionary().InternIri(std::string(kMember) +
                                        std::to_string(static_cast<std::uint32_t>(candidate.id)));
  }

  void ReportUnsatisfiable(const Candidate& candidate, const rdf::Layer& layer) {
    std::vector<std::string> classes;
    std::string rule;
    if (!layer.clashes().empty()) {
      const rdf::Clash& clash = layer.clashes().front();
      rule = clash.rule;
      for (const rdf::Triple& premise : clash.premises) {
        if (premise.subject != MemberOf(candidate)) continue;
        if (premise.predicate != Iri(rdf::kRdf, "type")) continue;
        classes.push_back(view_.Label(premise.object));
      }
    }
    std::string message = "the class can have no member";
    if (classes.size() >= 2) {
      message +=
          ": it would be " + classes[0] + " and " + classes[1] + ", which exclude each other";
    } else if (!rule.empty()) {
      message += " (" + rule + ")";
    }
    found_.Add(Kind::kUnsatisfiable, message, Collector::kNone, candidate.term);
  }

  std::string Sentence(const rdf::Clash& clash) {
    const rdf::TermId type = Iri(rdf::kRdf, "type");
    std::vector<rdf::Triple> types;
    std::string premises;
    for (const rdf::Triple& premise : clash.premises) {
      const rdf::TermView object = view_.dictionary().Get(premise.object);
      if (premise.predicate == type && !object.value.starts_with(rdf::kOwl)) {
        types.push_back(premise);
      }
      premises += (premises.empty() ? "" : "; ") + view_.Label(premise.subject) + " " +
                  view_.Label(premise.predicate) + " " + view_.Label(premise.object);
    }
    if (types.size() == 2 && types[0].subject == types[1].subject) {
      return "is " + view_.Label(types[0].object) + " and " + view_.Label(types[1].object) +
             ", which exclude each other (" + clash.rule + ")";
    }
    return "these cannot all hold (" + clash.rule + "): " + premises;
  }

  void ReportClash(const rdf::Clash& clash) {
    // What is of two kinds is told by its own name.
    for (const rdf::Triple& premise : clash.premises) {
      const auto term = terms_.find(premise.subject);
      if (premise.predicate != Iri(rdf::kRdf, "type") || term == terms_.end()) continue;
      if (view_.dictionary().Get(premise.object).value.starts_with(rdf::kOwl)) continue;
      return found_.Add(Kind::kContradiction, Sentence(clash), Collector::kNone, term->second);
    }
    for (const rdf::Triple& premise : clash.premises) {
      for (const rdf::TermId id : {premise.subject, premise.object}) {
        const auto term = terms_.find(id);
        if (term == terms_.end() || !index_.Word(term->second).empty()) continue;
        return found_.Add(Kind::kContradiction, Sentence(clash), Collector::kNone, term->second);
      }
    }
    if (!index_.document().terms.empty()) {
      found_.Add(Kind::kContradiction, Sentence(clash), Collector::kNone, 0, "the document");
    }
  }

  const DocumentIndex& index_;
  Collector& found_;
  std::stop_token stop_;
  rdf::View view_;  // the catalogue with the document
  std::map<rdf::TermId, std::uint32_t> terms_;
};

}  // namespace

void CheckConsequences(const DocumentIndex& index, const rdf::View& catalogue,
                       const rdf::AliasTable& aliases, Collector& found, std::stop_token stop) {
  ConsequenceCheck(index, catalogue, aliases, found, std::move(stop)).Run();
}

}  // namespace lares::profile
