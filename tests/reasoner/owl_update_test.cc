// Closures that are kept up, against closures made anew and against the naive one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "reasoner/owl/update.h"
#include "tests/ontology/test_graph.h"
#include "tests/reasoner/owl_naive.h"
#include "tests/reasoner/random_ontology.h"

namespace lares::owl {
namespace {

using lares::testing::Author;
using lares::testing::CloseNaively;
using lares::testing::ComparableTriples;
using lares::testing::GraphOf;
using lares::testing::NaiveClosure;
using lares::testing::ToText;
using LayerPtr = std::shared_ptr<const rdf::Layer>;
using Statements = std::vector<std::string>;

Options KeepingAllClashes() {
  Options options;
  options.max_clashes = SIZE_MAX;
  return options;
}

// All that a layer says, as text, so that two can be compared and the difference read.
std::set<std::string> Contents(const rdf::View& below, const LayerPtr& layer) {
  const rdf::Dictionary& dictionary = below.dictionary();
  const rdf::View view = below.With(layer);
  std::set<std::string> lines;
  for (const rdf::Triple& triple : rdf::View(below.shared_dictionary()).With(layer).Match({})) {
    std::string line = ToText(triple, dictionary) + (layer->IsAsserted(triple) ? " asserted" : "");
    for (const std::string& graph : view.GraphsOf(triple)) line += " " + graph;
    EXPECT_TRUE(lines.insert(line).second) << "stored twice: " << line;
  }
  for (const rdf::Graph& graph : layer->graphs()) {
    for (const rdf::Triple& triple : graph.triples) {
      lines.insert(graph.name + " says " + ToText(triple, dictionary) +
                   (layer->Contains(triple) ? "" : ", held below"));
      EXPECT_TRUE(layer->IsAsserted(triple));
    }
  }
  for (const rdf::Clash& clash : layer->clashes()) {
    std::vector<rdf::Triple> premises = clash.premises;
    std::sort(premises.begin(), premises.end());
    std::string line = clash.rule;
    for (const rdf::Triple& premise : premises) line += " | " + ToText(premise, dictionary);
    EXPECT_TRUE(lines.insert(line).second) << "reported twice: " << line;
  }
  lines.insert(std::to_string(layer->clash_count()) + " contradictions");
  return lines;
}

std::string Difference(const std::set<std::string>& found, const std::set<std::string>& expected) {
  std::string text;
  for (const std::string& line : expected) {
    if (!found.contains(line)) text += "missing " + line + "\n";
  }
  for (const std::string& line : found) {
    if (!expected.contains(line)) text += "wrong " + line + "\n";
  }
  return text;
}

// Documents that come, change and go.
class Documents {
 public:
  explicit Documents(Author& author) : author_(author) {}

  void Edit() {
    const std::string name = "g" + std::to_string(author_.Below(4));
    const unsigned what = author_.Below(8);
    if (!texts_.contains(name) || what == 0) {
      texts_[name] = {};
      Write(name, 3 + author_.Below(8));
    } else if (what == 1) {
      texts_.erase(name);
    } else {
      Statements& statements = texts_[name];
      for (unsigned i = 1 + author_.Below(3); i > 0 && !statements.empty(); --i) {
        statements.erase(statements.begin() +
                         author_.Below(static_cast<unsigned>(statements.size())));
      }
      if (what < 6) Write(name, 1 + author_.Below(3));
      if (what == 6) Repeat(name);
    }
  }

  std::vector<rdf::Graph> Graphs(rdf::Dictionary& dictionary) const {
    std::vector<rdf::Graph> graphs;
    for (const auto& [name, statements] : texts_) {
      graphs.push_back(GraphOf(Join(statements), dictionary, name));
    }
    return graphs;
  }

  std::string Text() const {
    std::string text;
    for (const auto& [name, statements] : texts_) text += name + ":\n" + Join(statements);
    return text;
  }

 private:
  void Write(const std::string& name, unsigned count) {
    for (unsigned i = 0; i < count; ++i) texts_[name].push_back(author_.Statement());
  }
  // What another document says too.
  void Repeat(const std::string& name) {
    const Statements& other = texts_.begin()->second;
    if (!other.empty()) {
      const std::string statement = other[author_.Below(static_cast<unsigned>(other.size()))];
      texts_[name].push_back(statement);
    }
  }
  static std::string Join(const Statements& statements) {
    std::string text;
    for (const std::string& statement : statements) text += statement;
    return text;
  }

  Author& author_;
  std::map<std::string, Statements> texts_;
};

void AddTo(std::set<rdf::Triple>& all, const std::vector<rdf::Graph>& graphs) {
  for (const rdf::Graph& graph : graphs) all.insert(graph.triples.begin(), graph.triples.end());
}

void ExpectNaive(const rdf::View& view, const std::set<rdf::Triple>& asserted,
                 const std::string& trace) {
  rdf::Dictionary& dictionary = view.dictionary();
  const NaiveClosure naive = CloseNaively(asserted, dictionary);
  std::set<std::string> found, expected;
  for (const rdf::Triple& triple : ComparableTriples(view)) {
    found.insert(ToText(triple, dictionary));
  }
  for (const rdf::Triple& triple : naive.triples) expected.insert(ToText(triple, dictionary));
  for (const auto& layer : view.layers()) {
    for (const rdf::Clash& clash : layer->clashes()) found.insert(clash.rule);
  }
  for (const std::string& rule : naive.clashes) expected.insert(rule);
  // Once two numbers are one, which further contradictions are found is of no interest.
  if (naive.clashes.contains("eq-diff1")) found.insert(naive.clashes.begin(), naive.clashes.end());
  ASSERT_EQ(Difference(found, expected), "") << trace;
}

// How often `seeds` scripts are tried: more of them where LARES_EDIT_SCRIPTS says so.
unsigned Scripts(unsigned usual) {
  const char* wanted = std::getenv("LARES_EDIT_SCRIPTS");
  return wanted == nullptr ? usual : static_cast<unsigned>(std::stoul(wanted));
}

void RunScript(unsigned seed, bool equality, bool has_layer_below, unsigned edits) {
  Author author(seed, equality);
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  rdf::View below(dictionary);
  std::set<rdf::Triple> asserted_below;
  std::string trace = "seed " + std::to_string(seed) + "\n";
  if (has_layer_below) {
    const std::string text = author.Text(4 + static_cast<int>(author.Below(10)));
    const std::vector<rdf::Graph> graphs = {GraphOf(text, *dictionary, "below")};
    trace += "below:\n" + text;
    AddTo(asserted_below, graphs);
    below = below.With(Materialise(below, graphs, KeepingAllClashes()));
  }
  Documents documents(author);
  documents.Edit();
  documents.Edit();
  documents.Edit();
  LayerPtr layer = Materialise(below, documents.Graphs(*dictionary), KeepingAllClashes());
  for (unsigned edit = 0; edit < edits; ++edit) {
    const std::string text_before = documents.Text();
    documents.Edit();
    const std::vector<rdf::Graph> graphs = documents.Graphs(*dictionary);
    layer = Update(below, *layer, graphs, KeepingAllClashes());
    const LayerPtr anew = Materialise(below, graphs, KeepingAllClashes());
    const std::string step = trace + "before\n" + text_before + "after\n" + documents.Text();
    ASSERT_EQ(Difference(Contents(below, layer), Contents(below, anew)), "") << step;
    if (edit + 1 < edits) continue;
    std::set<rdf::Triple> asserted = asserted_below;
    AddTo(asserted, graphs);
    ASSERT_NO_FATAL_FAILURE(ExpectNaive(below.With(layer), asserted, step));
  }
}

TEST(OwlUpdateTest, ALayerKeptUpIsTheLayerMadeAnew) {
  for (unsigned seed = 1; seed <= Scripts(400); ++seed) {
    ASSERT_NO_FATAL_FAILURE(RunScript(seed, false, false, 6));
  }
}

TEST(OwlUpdateTest, SoIsALayerOverAnother) {
  for (unsigned seed = 1; seed <= Scripts(400); ++seed) {
    ASSERT_NO_FATAL_FAILURE(RunScript(100'000 + seed, false, true, 6));
  }
}

TEST(OwlUpdateTest, SoIsALayerWhereThingsBecomeEqual) {
  for (unsigned seed = 1; seed <= Scripts(150); ++seed) {
    ASSERT_NO_FATAL_FAILURE(RunScript(200'000 + seed, true, seed % 2 == 0, 4));
  }
}

}  // namespace
}  // namespace lares::owl
