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

// Calls visit(term) for each term that `wanted` asks for where `stored` was found.
template <typename Visit>
bool ForEachMember(const Equality& equality, TermId wanted, TermId stored, Visit&& visit) {
  if (wanted != kAnyTerm) return visit(wanted);
  const std::span<const TermId> members = equality.Members(stored);
  if (members.empty()) return visit(stored);
  return std::all_of(members.begin(), members.end(), visit);
}

}  // namespace

bool View::ContainsStored(const Triple& triple) const {
  return std::any_of(layers_.begin(), layers_.end(),
                     [&](const auto& layer) { return layer->Contains(triple); });
}

bool View::Contains(const Triple& triple) const {
  if (has_literal_subjects_ && dictionary_->Kind(triple.subject) == TermKind::kLiteral) {
    return false;
  }
  if (equality_ == nullptr) return ContainsStored(triple);
  const Triple normal = equality_->Normal(triple);
  if (normal.predicate == equality_->same_as() && normal.subject == normal.object &&
      !equality_->Members(normal.subject).empty()) {
    return triple.subject != triple.object || IsAsserted(triple);
  }
  return ContainsStored(normal);
}

// The pairs of equal terms themselves: no layer stores them.
bool View::ForEachSame(const Pattern& pattern, const Visitor& visit) const {
  const Equality& equality = *equality_;
  const TermId same = equality.same_as();
  if (pattern.predicate != kAnyTerm && equality.Representative(pattern.predicate) != same) {
    return true;
  }
  const auto pairs_of = [&](std::span<const TermId> members) {
    return ForEachMember(equality, pattern.predicate, same, [&](TermId p) {
      for (const TermId s : members) {
        if (pattern.subject != kAnyTerm && pattern.subject != s) continue;
        for (const TermId o : members) {
          if (pattern.object != kAnyTerm && pattern.object != o) continue;
          if ((s != o || IsAsserted({s, p, o})) && !visit({s, p, o})) return false;
        }
      }
      return true;
    });
  };
  const TermId known = pattern.subject != kAnyTerm ? pattern.subject : pattern.object;
  if (known == kAnyTerm) return equality.ForEachClass(pairs_of);
  return pairs_of(equality.Members(equality.Representative(known)));
}

bool View::ForEachExpanded(const Pattern& pattern, const Visitor& visit, Origin origin) const {
  const Equality& equality = *equality_;
  const auto accept = [&](const Triple& triple) {
    const bool is_answer = dictionary_->Kind(triple.subject) != TermKind::kLiteral &&
                           dictionary_->Kind(triple.predicate) != TermKind::kLiteral &&
                           (origin == Origin::kAll || IsAsserted(triple));
    return !is_answer || visit(triple);
  };
  if (!ForEachSame(pattern, accept)) return false;
  const auto normal = [&](TermId term) {
    return term == kAnyTerm ? kAnyTerm : equality.Representative(term);
  };
  const Pattern stored{normal(pattern.subject), normal(pattern.predicate), normal(pattern.object)};
  return ForEachStored(stored, [&](const Triple& triple) {
    const bool is_of_class = triple.predicate == equality.same_as() &&
                             triple.subject == triple.object &&
                             !equality.Members(triple.subject).empty();
    if (is_of_class) return true;  // ForEachSame has it
    return ForEachMember(equality, pattern.subject, triple.subject, [&](TermId s) {
      return ForEachMember(equality, pattern.predicate, triple.predicate, [&](TermId p) {
        return ForEachMember(equality, pattern.object, triple.object, [&](TermId o) {
          return accept({s, p, o});
        });
      });
    });
  });
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
  Pattern stored = pattern;
  std::size_t count = 0;
  if (equality_ != nullptr) {
    for (TermId* term : {&stored.subject, &stored.predicate, &stored.object}) {
      if (*term != kAnyTerm) *term = equality_->Representative(*term);
    }
    if (stored.predicate == equality_->same_as()) {
      const TermId known = stored.subject != kAnyTerm ? stored.subject : stored.object;
      count = equality_->Members(known).size();
    }
  }
  for (const auto& layer : layers_) count += layer->Range(stored).size();
  return count;
}

// Whether an asserted triple of `layer` has `term` in any place.
bool View::IsMentioned(const Layer& layer, TermId term) const {
  if (layer.equality() != nullptr) {
    return std::any_of(layer.graphs().begin(), layer.graphs().end(), [&](const Graph& graph) {
      return std::any_of(graph.triples.begin(), graph.triples.end(), [&](const Triple& triple) {
        return triple.subject == term || triple.predicate == term || triple.object == term;
      });
    });
  }
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
    if (IsMentioned(*layer, iri)) break;
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
