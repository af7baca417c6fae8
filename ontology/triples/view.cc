#include "ontology/triples/view.h"

#include <algorithm>
#include <ranges>
#include <tuple>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

// How well a label of this language serves; less is better.
int LabelRank(std::string_view language) {
  if (language.empty()) return 0;
  if (language == "en") return 1;
  return language.starts_with("en-") ? 2 : 3;
}

bool Asserts(const Graph& graph, const Triple& triple) {
  return std::binary_search(graph.triples.begin(), graph.triples.end(), triple);
}

// Whether a stored, asserted triple of `layer` has `term` in any place.
bool Mentions(const Layer& layer, TermId term) {
  for (const Pattern& pattern :
       {Pattern{term, {}, {}}, Pattern{{}, term, {}}, Pattern{{}, {}, term}}) {
    const auto run = layer.Range(pattern);
    if (std::any_of(run.begin(), run.end(),
                    [&](const Triple& triple) { return layer.IsAsserted(triple); })) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool View::Contains(const Triple& triple) const {
  return std::any_of(layers_.begin(), layers_.end(),
                     [&](const auto& layer) { return layer->Contains(triple); });
}

bool View::IsAsserted(const Triple& triple) const {
  return std::any_of(layers_.begin(), layers_.end(),
                     [&](const auto& layer) { return layer->IsAsserted(triple); });
}

std::vector<std::string> View::GraphsOf(const Triple& triple) const {
  std::vector<std::string> names;
  for (const auto& layer : layers_) {
    if (!layer->IsAsserted(triple)) continue;
    for (const Graph& graph : layer->graphs()) {
      if (Asserts(graph, triple)) names.push_back(graph.name);
    }
  }
  return names;
}

std::size_t View::size() const {
  std::size_t size = 0;
  for (const auto& layer : layers_) size += layer->size();
  return size;
}

std::size_t View::Estimate(const Pattern& pattern) const {
  std::size_t count = 0;
  for (const auto& layer : layers_) count += layer->Range(pattern).size();
  return count;
}

std::vector<Triple> View::Match(const Pattern& pattern, Origin origin) const {
  std::vector<Triple> triples;
  ForEach(
      pattern,
      [&](const Triple& triple) {
        triples.push_back(triple);
        return true;
      },
      origin);
  return triples;
}

std::vector<TermId> View::Objects(TermId subject, TermId predicate) const {
  std::vector<TermId> objects;
  ForEach({subject, predicate, {}}, [&](const Triple& triple) {
    objects.push_back(triple.object);
    return true;
  });
  return objects;
}

std::vector<TermId> View::Subjects(TermId predicate, TermId object) const {
  std::vector<TermId> subjects;
  ForEach({{}, predicate, object}, [&](const Triple& triple) {
    subjects.push_back(triple.subject);
    return true;
  });
  return subjects;
}

std::string View::AsWritten(TermId iri) const {
  for (const auto& layer : std::views::reverse(layers_)) {
    for (const Graph& graph : std::views::reverse(layer->graphs())) {
      const auto written = graph.as_written.find(iri);
      if (written != graph.as_written.end()) {
        return std::string(dictionary_->Get(written->second).value);
      }
    }
    if (Mentions(*layer, iri)) break;
  }
  return std::string(dictionary_->Get(iri).value);
}

std::string View::Label(TermId term) const {
  const TermView view = dictionary_->Get(term);
  if (view.kind == TermKind::kLiteral) return std::string(view.value);
  std::vector<std::tuple<int, std::string_view, std::string_view>> labels;
  const auto label = dictionary_->FindIri(std::string(kRdfs) + "label");
  if (label) {
    for (const TermId object : Objects(term, *label)) {
      const TermView text = dictionary_->Get(object);
      if (text.kind != TermKind::kLiteral) continue;
      labels.emplace_back(LabelRank(text.language), text.language, text.value);
    }
  }
  if (!labels.empty()) {
    return std::string(std::get<2>(*std::min_element(labels.begin(), labels.end())));
  }
  if (view.kind == TermKind::kBlank) return "_:" + std::string(view.value);
  return std::string(LocalName(view.value));
}

}  // namespace lares::rdf
