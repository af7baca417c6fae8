#include "tests/ontology/isomorphism.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <vector>

namespace lares::rdf::testing {
namespace {

// A statement's four terms as text; blank nodes as "_:label".
using Quad = std::array<std::string, 4>;
using Colours = std::map<std::string, std::size_t>;

std::set<Quad> QuadsOf(const Document& document) {
  const auto text = [&](std::uint32_t index) { return ToNTriples(document.terms[index].view()); };
  std::set<Quad> quads;
  for (const Statement& s : document.statements) {
    quads.insert({text(s.subject), text(s.predicate), text(s.object),
                  s.graph == Statement::kDefaultGraph ? "" : text(s.graph)});
  }
  return quads;
}

bool IsBlank(const std::string& term) { return term.starts_with("_:"); }

std::size_t Mix(std::size_t a, std::size_t b) {
  return (a ^ (b + 0x9E3779B97F4A7C15ull + (a << 6) + (a >> 2))) * 0xBF58476D1CE4E5B9ull;
}

std::size_t ColourOf(const std::string& term, const Colours& colours) {
  if (!IsBlank(term)) return std::hash<std::string>()(term);
  return colours.at(term);
}

// Each blank node's colour becomes a function of the statements it is in, until the number of
// colours grows no more.
void Refine(const std::set<Quad>& quads, Colours& colours) {
  std::size_t count = 0;
  for (;;) {
    Colours next = colours;
    for (const Quad& quad : quads) {
      std::size_t sum = 0;
      for (const std::string& term : quad) sum = Mix(sum, ColourOf(term, colours));
      for (std::size_t i = 0; i < quad.size(); ++i) {
        if (IsBlank(quad[i])) next[quad[i]] += Mix(sum, i + 1);  // order does not matter
      }
    }
    colours = std::move(next);
    std::set<std::size_t> distinct;
    for (const auto& [label, colour] : colours) distinct.insert(colour);
    if (distinct.size() <= count) return;
    count = distinct.size();
  }
}

Colours FirstColours(const std::set<Quad>& quads) {
  Colours colours;
  for (const Quad& quad : quads) {
    for (const std::string& term : quad) {
      if (IsBlank(term)) colours[term] = 1;
    }
  }
  return colours;
}

std::map<std::size_t, std::vector<std::string>> Classes(const Colours& colours) {
  std::map<std::size_t, std::vector<std::string>> classes;
  for (const auto& [label, colour] : colours) classes[colour].push_back(label);
  return classes;
}

bool Match(const std::set<Quad>& a, Colours colours_a, const std::set<Quad>& b, Colours colours_b,
           std::size_t fresh) {
  Refine(a, colours_a);
  Refine(b, colours_b);
  const auto classes_a = Classes(colours_a);
  const auto classes_b = Classes(colours_b);
  if (classes_a.size() != classes_b.size()) return false;
  const std::vector<std::string>* ambiguous = nullptr;
  std::size_t colour = 0;
  std::map<std::string, std::string> renamed;
  for (const auto& [key, labels] : classes_a) {
    const auto other = classes_b.find(key);
    if (other == classes_b.end() || other->second.size() != labels.size()) return false;
    if (labels.size() > 1 && (ambiguous == nullptr || labels.size() < ambiguous->size())) {
      ambiguous = &labels;
      colour = key;
    }
    renamed[labels[0]] = other->second[0];
  }
  if (ambiguous == nullptr) {
    return std::all_of(a.begin(), a.end(), [&](Quad quad) {
      for (std::string& term : quad) {
        if (IsBlank(term)) term = renamed[term];
      }
      return b.count(quad) != 0;
    });
  }
  colours_a[ambiguous->front()] = fresh;
  for (const std::string& candidate : classes_b.at(colour)) {
    Colours tried = colours_b;
    tried[candidate] = fresh;
    if (Match(a, colours_a, b, tried, fresh + 1)) return true;
  }
  return false;
}

}  // namespace

bool AreIsomorphic(const Document& a, const Document& b) {
  const std::set<Quad> quads_a = QuadsOf(a);
  const std::set<Quad> quads_b = QuadsOf(b);
  if (quads_a.size() != quads_b.size()) return false;
  return Match(quads_a, FirstColours(quads_a), quads_b, FirstColours(quads_b), 1000);
}

std::string Lines(const Document& document) {
  std::string lines;
  for (const Quad& quad : QuadsOf(document)) {
    for (const std::string& term : quad) lines += term + " ";
    lines += ".\n";
  }
  return lines;
}

}  // namespace lares::rdf::testing
