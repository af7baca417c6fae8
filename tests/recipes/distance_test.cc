// The distance by which rules choose skill templates is that of the taxonomy.
#include <gtest/gtest.h>

#include <random>

#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/taxonomy.h"
#include "tests/recipes/world.h"

namespace lares::testing {
namespace {

using prolog::Atom;
using prolog::Value;

// Classes with redundant edges, equivalents, anonymous classes between them, and circles.
std::string RandomClasses(std::mt19937& random, int count) {
  std::string text = Turtle("");
  const auto any = [&](int limit) {
    return ":C" + std::to_string(std::uniform_int_distribution<int>(0, limit - 1)(random));
  };
  for (int i = 0; i < count; ++i) {
    text += ":C" + std::to_string(i) + " a owl:Class .\n";
    for (int edge = 0; edge < 2 && i > 0; ++edge) {
      text += ":C" + std::to_string(i) + " rdfs:subClassOf " + any(i) + " .\n";
    }
    if (random() % 6 == 0)
      text += ":C" + std::to_string(i) + " owl:equivalentClass " + any(count) + " .\n";
    if (random() % 5 == 0) {
      text += ":C" + std::to_string(i) +
              " rdfs:subClassOf [ a owl:Restriction ; owl:onProperty "
              "lares:subAction ; owl:someValuesFrom " +
              any(count) + " ] .\n";
    }
  }
  return text;
}

// None where the second is not above the first.
std::optional<int> ByRules(const rdf::View& view, const std::string& from, const std::string& to) {
  const auto answer =
      Engines().Once(view, "classes", "rada_distance", {Value{Atom{from}}, Value{Atom{to}}});
  if (!answer) return std::nullopt;
  return static_cast<int>(answer->integer());
}

TEST(Distance, RulesAndTaxonomyAgreeOnRandomHierarchies) {
  int compared = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    constexpr int kClasses = 14;
    World world = Catalogue();
    world.Put("classes", RandomClasses(random, kClasses));
    const rdf::View& view = world.view();
    const owl::Taxonomy taxonomy(view);
    const auto sub_class = view.dictionary().FindIri(std::string(rdf::kRdfs) + "subClassOf");
    for (int i = 0; i < kClasses; ++i) {
      for (int j = 0; j < kClasses; ++j) {
        const std::string from = Example("C" + std::to_string(i));
        const std::string to = Example("C" + std::to_string(j));
        const auto below = view.dictionary().FindIri(from);
        const auto above = view.dictionary().FindIri(to);
        const auto found = ByRules(view, from, to);
        if (i != j && !view.Contains({*below, *sub_class, *above})) {
          EXPECT_FALSE(found) << seed << " " << from << " " << to;
          continue;
        }
        const auto way = taxonomy.Rada(*below, *above);
        ASSERT_TRUE(way && found) << seed << " " << from << " " << to;
        EXPECT_EQ(*found, way->edges) << seed << " " << from << " " << to;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace lares::testing
