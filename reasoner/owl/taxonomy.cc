#include "reasoner/owl/taxonomy.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <string_view>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/rule.h"

namespace lares::owl {
namespace {

std::string_view IriOf(rdf::TermId term, const rdf::View& view) {
  return view.dictionary().Get(term).value;
}

// Classes that people would call so, in the order of their IRIs.
std::vector<rdf::TermId> NamedClasses(const rdf::View& view, const Vocabulary& words) {
  std::set<rdf::TermId> found;
  view.ForEach({{}, words.sub_class_of, {}}, [&](const rdf::Triple& triple) {
    found.insert(triple.subject);
    found.insert(triple.object);
    return true;
  });
  for (const rdf::TermId term :
       view.Subjects(words.type, view.dictionary().InternIri(Expand("owl:Class")))) {
    found.insert(term);
  }
  for (const char* other : {"owl:Thing", "owl:Nothing", "rdfs:Resource", "owl:NamedIndividual"}) {
    found.erase(view.dictionary().InternIri(Expand(other)));
  }
  std::vector<rdf::TermId> named;
  for (const rdf::TermId term : found) {
    if (view.dictionary().Kind(term) == rdf::TermKind::kIri) named.push_back(term);
  }
  std::sort(named.begin(), named.end(),
            [&](rdf::TermId a, rdf::TermId b) { return IriOf(a, view) < IriOf(b, view); });
  return named;
}

}  // namespace

Taxonomy::Taxonomy(const rdf::View& view) {
  const Vocabulary words(view.dictionary());
  const std::vector<rdf::TermId> classes = NamedClasses(view, words);
  const std::set<rdf::TermId> is_named(classes.begin(), classes.end());
  std::vector<std::vector<Node>> above;
  for (const rdf::TermId name : classes) {
    if (node_of_.contains(name)) continue;  // equivalent to an earlier one
    const auto node = static_cast<Node>(nodes_.size());
    node_of_[name] = node;
    nodes_.push_back({name, {}, 1});
    for (const rdf::TermId other : view.Objects(name, words.sub_class_of)) {
      if (!is_named.contains(other) || !view.Contains({other, words.sub_class_of, name})) continue;
      node_of_.emplace(other, node);
    }
  }
  for (const NodeData& node : nodes_) {
    std::set<Node> supers;
    for (const rdf::TermId other : view.Objects(node.name, words.sub_class_of)) {
      const auto found = node_of_.find(other);
      if (found != node_of_.end()) supers.insert(found->second);
    }
    supers.erase(node_of_.at(node.name));
    above.emplace_back(supers.begin(), supers.end());
  }
  // Lowest first: what is above one of them is no parent.
  for (Node node = 0; node < nodes_.size(); ++node) {
    std::vector<Node> supers = above[node];
    std::stable_sort(supers.begin(), supers.end(),
                     [&](Node a, Node b) { return above[a].size() > above[b].size(); });
    std::set<Node> covered;
    for (const Node super : supers) {
      if (covered.contains(super)) continue;
      nodes_[node].parents.push_back(super);
      covered.insert(above[super].begin(), above[super].end());
    }
    std::sort(nodes_[node].parents.begin(), nodes_[node].parents.end());
  }
  FindDepths();
}

void Taxonomy::FindDepths() {
  std::vector<std::vector<Node>> children(nodes_.size());
  std::deque<Node> queue;
  std::vector<bool> seen(nodes_.size(), false);
  for (Node node = 0; node < nodes_.size(); ++node) {
    for (const Node parent : nodes_[node].parents) children[parent].push_back(node);
    if (!nodes_[node].parents.empty()) continue;
    queue.push_back(node);
    seen[node] = true;
  }
  for (; !queue.empty(); queue.pop_front()) {
    for (const Node child : children[queue.front()]) {
      if (seen[child]) continue;
      seen[child] = true;
      nodes_[child].depth = nodes_[queue.front()].depth + 1;
      queue.push_back(child);
    }
  }
}

std::vector<rdf::TermId> Taxonomy::Parents(rdf::TermId name) const {
  std::vector<rdf::TermId> parents;
  const auto node = node_of_.find(name);
  if (node == node_of_.end()) return parents;
  for (const Node parent : nodes_[node->second].parents) parents.push_back(nodes_[parent].name);
  return parents;
}

Taxonomy::Climb Taxonomy::Up(Node start) const {
  Climb climb;
  climb[start] = {0, start};
  std::deque<Node> queue{start};
  for (; !queue.empty(); queue.pop_front()) {
    const Node node = queue.front();
    const int edges = climb[node].edges + 1;
    for (const Node parent : nodes_[node].parents) {
      if (climb.try_emplace(parent, Step{edges, node}).second) queue.push_back(parent);
    }
  }
  return climb;
}

Taxonomy::Way Taxonomy::MakeWay(rdf::TermId from, rdf::TermId to, Node common, const Climb& up_from,
                                const Climb& up_to) const {
  const auto climb = [&](const Climb& up, std::vector<rdf::TermId>* path) {
    for (Node node = common; up.at(node).edges > 0;) {
      node = up.at(node).from;
      path->push_back(nodes_[node].name);
    }
  };
  Way way;
  const int n1 = up_from.at(common).edges, n2 = up_to.at(common).edges;
  way.edges = n1 + n2;
  way.common = nodes_[common].name;
  const double n = nodes_[common].depth;
  way.similarity = 2 * n / (n1 + n2 + 2 * n);
  climb(up_from, &way.path);
  std::reverse(way.path.begin(), way.path.end());
  way.path.push_back(way.common);
  climb(up_to, &way.path);
  way.path.front() = from;
  if (way.path.size() > 1) {
    way.path.back() = to;
  } else if (from != to) {
    way.path.push_back(to);  // equivalent: two names, no edge
  }
  return way;
}

template <typename Better>
std::optional<Taxonomy::Way> Taxonomy::Best(rdf::TermId from, rdf::TermId to, Better better) const {
  const auto a = node_of_.find(from), b = node_of_.find(to);
  if (a == node_of_.end() || b == node_of_.end()) return std::nullopt;
  const Climb up_from = Up(a->second), up_to = Up(b->second);
  std::optional<Way> best;
  for (Node node = 0; node < nodes_.size(); ++node) {  // so that ties go to the first IRI
    if (!up_from.contains(node) || !up_to.contains(node)) continue;
    Way way = MakeWay(from, to, node, up_from, up_to);
    if (!best || better(way, *best)) best = std::move(way);
  }
  return best;
}

std::optional<Taxonomy::Way> Taxonomy::Rada(rdf::TermId from, rdf::TermId to) const {
  return Best(from, to, [](const Way& a, const Way& b) { return a.edges < b.edges; });
}

std::optional<Taxonomy::Way> Taxonomy::WuPalmer(rdf::TermId from, rdf::TermId to) const {
  return Best(from, to, [](const Way& a, const Way& b) {
    return a.similarity > b.similarity || (a.similarity == b.similarity && a.edges < b.edges);
  });
}

}  // namespace lares::owl
