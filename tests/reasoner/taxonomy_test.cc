// Distances between classes against breadth-first search on a naive reduction.
#include "reasoner/owl/taxonomy.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "reasoner/owl/materialise.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

using lares::testing::GraphOf;
using lares::testing::TermOf;

rdf::View Closed(const std::string& text) {
  const auto dictionary = std::make_shared<rdf::Dictionary>();
  return rdf::View(dictionary)
      .With(Materialise(rdf::View(dictionary), {GraphOf(text, *dictionary)}));
}

std::optional<Taxonomy::Way> Rada(const rdf::View& view, const char* from, const char* to) {
  return Taxonomy(view).Rada(TermOf(from, view.dictionary()), TermOf(to, view.dictionary()));
}

TEST(TaxonomyTest, AGrandparentIsAtDistanceTwoWhateverElseIsStated) {
  const rdf::View view = Closed(
      ":A rdfs:subClassOf :B . :B rdfs:subClassOf :C . :A rdfs:subClassOf :C . "
      ":A rdfs:subClassOf _:r . _:r rdfs:subClassOf :C . :C rdfs:subClassOf owl:Thing . "
      ":A rdfs:subClassOf owl:Thing .");
  const auto way = Rada(view, ":A", ":C");
  ASSERT_TRUE(way);
  EXPECT_EQ(way->edges, 2);
  EXPECT_EQ(way->path, (std::vector<rdf::TermId>{TermOf(":A", view.dictionary()),
                                                 TermOf(":B", view.dictionary()),
                                                 TermOf(":C", view.dictionary())}));
}

TEST(TaxonomyTest, EquivalentClassesAreOne) {
  const rdf::View view =
      Closed(":A rdfs:subClassOf :B . :B owl:equivalentClass :B2 . :B2 rdfs:subClassOf :C .");
  EXPECT_EQ(Rada(view, ":A", ":C")->edges, 2);
  EXPECT_EQ(Rada(view, ":B", ":B2")->edges, 0);
  EXPECT_EQ(Rada(view, ":B", ":B2")->similarity, 1);
  EXPECT_EQ(Rada(view, ":A", ":B2")->edges, 1);
  EXPECT_EQ(Rada(view, ":A", ":B2")->path.back(), TermOf(":B2", view.dictionary()));
}

TEST(TaxonomyTest, OwlThingJoinsNothing) {
  const rdf::View view =
      Closed(":A rdfs:subClassOf owl:Thing . :B rdfs:subClassOf owl:Thing . :C a owl:Class .");
  EXPECT_FALSE(Rada(view, ":A", ":B"));
  EXPECT_FALSE(Rada(view, ":A", ":C"));
  EXPECT_FALSE(Rada(view, ":A", ":unheard"));
  EXPECT_EQ(Rada(view, ":A", ":A")->edges, 0);
}

TEST(TaxonomyTest, SiblingsMeetAtTheirParent) {
  const rdf::View view =
      Closed(":A rdfs:subClassOf :P . :B rdfs:subClassOf :P . :P rdfs:subClassOf :Top .");
  const auto way = Rada(view, ":A", ":B");
  ASSERT_TRUE(way);
  EXPECT_EQ(way->edges, 2);
  EXPECT_EQ(way->common, TermOf(":P", view.dictionary()));
  // 2·2 / (1 + 1 + 2·2)
  EXPECT_DOUBLE_EQ(way->similarity, 2.0 / 3.0);
}

// Class names by node of a naive reduction: equivalents merged by mutual reachability.
struct Naive {
  std::map<int, std::set<int>> above;  // strictly, by representative
  std::map<int, int> representative;

  Naive(int count, const std::vector<std::pair<int, int>>& edges) {
    std::map<int, std::set<int>> reach;
    for (int i = 0; i < count; ++i) reach[i] = {i};
    for (bool again = true; again;) {
      again = false;
      for (const auto& [low, high] : edges) {
        for (int i = 0; i < count; ++i) {
          if (reach[i].contains(low) && reach[i].insert(high).second) again = true;
        }
      }
    }
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j <= i; ++j) {
        if (reach[i].contains(j) && reach[j].contains(i)) {
          representative[i] = j;
          break;
        }
      }
    }
    for (int i = 0; i < count; ++i) {
      for (const int j : reach[i]) {
        if (representative[i] != representative[j]) {
          above[representative[i]].insert(representative[j]);
        }
      }
    }
  }

  std::set<int> Parents(int node) {
    std::set<int> parents = above[node];
    for (const int middle : above[node]) {
      for (const int far : above[middle]) parents.erase(far);
    }
    return parents;
  }

  std::map<int, int> Up(int start) {
    std::map<int, int> edges{{start, 0}};
    std::vector<int> queue{start};
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const int parent : Parents(queue[i])) {
        if (edges.emplace(parent, edges[queue[i]] + 1).second) queue.push_back(parent);
      }
    }
    return edges;
  }

  int Distance(int a, int b) {  // -1: none
    const auto from = Up(representative[a]), to = Up(representative[b]);
    int best = -1;
    for (const auto& [node, edges] : from) {
      const auto other = to.find(node);
      if (other == to.end()) continue;
      if (best < 0 || edges + other->second < best) best = edges + other->second;
    }
    return best;
  }
};

TEST(TaxonomyTest, AgreesWithBreadthFirstSearchOnANaiveReduction) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const int count = 3 + static_cast<int>(random() % 10);
    const auto pick = [&] { return static_cast<int>(random() % static_cast<unsigned>(count)); };
    std::string text;
    std::vector<std::pair<int, int>> edges;
    const auto name = [](int i) { return ":C" + std::to_string(i); };
    for (int i = 0; i < count; ++i) text += name(i) + " a owl:Class .\n";
    for (int i = 0; i < count + 4; ++i) {
      int low = pick(), high = pick();
      if (random() % 8 != 0 && low > high) std::swap(low, high);  // circles are rare
      edges.emplace_back(low, high);
      text += name(low) + " rdfs:subClassOf " + name(high) + " .\n";
      if (random() % 10 != 0) continue;
      edges.emplace_back(high, low);
      text += name(low) + " owl:equivalentClass " + name(high) + " .\n";
    }
    text += ":C0 rdfs:subClassOf owl:Thing . :C1 rdfs:subClassOf _:x . _:x rdfs:subClassOf :C2 .\n";
    edges.emplace_back(1, 2);
    Naive naive(count, edges);
    const rdf::View view = Closed(text);
    const Taxonomy taxonomy(view);
    for (int a = 0; a < count; ++a) {
      for (int b = 0; b < count; ++b) {
        const auto way =
            taxonomy.Rada(TermOf(name(a), view.dictionary()), TermOf(name(b), view.dictionary()));
        ASSERT_EQ(way ? way->edges : -1, naive.Distance(a, b))
            << "seed " << seed << " " << a << " " << b << "\n"
            << text;
        if (!way) continue;
        const auto back =
            taxonomy.Rada(TermOf(name(b), view.dictionary()), TermOf(name(a), view.dictionary()));
        ASSERT_EQ(back->edges, way->edges);
        const std::size_t names = static_cast<std::size_t>(way->edges) + 1;
        ASSERT_EQ(way->path.size(), way->edges == 0 && a != b ? 2 : names);
        ASSERT_GT(way->similarity, 0);
        ASSERT_LE(way->similarity, 1);
        const auto similar = taxonomy.WuPalmer(TermOf(name(a), view.dictionary()),
                                               TermOf(name(b), view.dictionary()));
        ASSERT_GE(similar->similarity, way->similarity);
      }
    }
  }
}

}  // namespace
}  // namespace lares::owl
