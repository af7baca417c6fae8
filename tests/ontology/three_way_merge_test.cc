#include "ontology/rdf/three_way_merge.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

#include "base/error.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"

namespace lares::rdf {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Document Read(const std::string& body) {
  return ReadRdf("@prefix x: <http://x/> .\n" + body, Format::kTurtle, {});
}

std::set<std::string> Triples(const Document& document) {
  std::set<std::string> triples;
  for (const Statement& s : document.statements) {
    triples.insert(ToNTriples(document.terms[s.subject].view()) + " " +
                   ToNTriples(document.terms[s.predicate].view()) + " " +
                   ToNTriples(document.terms[s.object].view()));
  }
  return triples;
}

std::set<std::string> Triples(const std::string& body) { return Triples(Read(body)); }

TEST(ThreeWayMergeTest, ChangesOfEitherSideAddUp) {
  const MergeResult merged = MergeThreeWays(Read("x:a x:p 1 . x:b x:p 1 . x:c x:p 1 ."),
                                            Read("x:a x:p 2 . x:b x:p 1 . x:c x:p 1 . x:d x:p 1 ."),
                                            Read("x:a x:p 1 . x:b x:p 3 . x:e x:p 1 ."));
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(Triples(merged.document), Triples("x:a x:p 2 . x:b x:p 3 . x:d x:p 1 . x:e x:p 1 ."));
}

TEST(ThreeWayMergeTest, OneValueChangedTwiceIsAConflictWithAllThreeValues) {
  const MergeResult merged =
      MergeThreeWays(Read("x:a x:p 1 ."), Read("x:a x:p 2 ."), Read("x:a x:p 3 ."));
  ASSERT_EQ(merged.conflicts.size(), 1u);
  const MergeConflict& conflict = merged.conflicts[0];
  EXPECT_EQ(conflict.subject, "http://x/a");
  EXPECT_EQ(conflict.predicate, "http://x/p");
  EXPECT_THAT(conflict.base, ElementsAre(::testing::HasSubstr("\"1\"")));
  EXPECT_THAT(conflict.ours, ElementsAre(::testing::HasSubstr("\"2\"")));
  EXPECT_THAT(conflict.theirs, ElementsAre(::testing::HasSubstr("\"3\"")));
}

TEST(ThreeWayMergeTest, ChosenSideDecides) {
  const auto theirs = [](const MergeConflict&) { return std::optional(Side::kTheirs); };
  const MergeResult merged =
      MergeThreeWays(Read("x:a x:p 1 ."), Read("x:a x:p 2 ."), Read("x:a x:p 3 ."), theirs);
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(Triples(merged.document), Triples("x:a x:p 3 ."));
}

TEST(ThreeWayMergeTest, SameChangeOnBothSidesIsNone) {
  const MergeResult merged =
      MergeThreeWays(Read("x:a x:p 1 ."), Read("x:a x:p 2 ."), Read("x:a x:p 2 ."));
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(Triples(merged.document), Triples("x:a x:p 2 ."));
}

TEST(ThreeWayMergeTest, SeveralValuesOfAPredicateAddUp) {
  const MergeResult merged =
      MergeThreeWays(Read("x:map x:has x:a, x:b ."), Read("x:map x:has x:a, x:b, x:c ."),
                     Read("x:map x:has x:b, x:d ."));
  EXPECT_THAT(merged.conflicts, IsEmpty());
  EXPECT_EQ(Triples(merged.document), Triples("x:map x:has x:b, x:c, x:d ."));
}

TEST(ThreeWayMergeTest, TakenOutAndChangedIsAConflictTakenOutAloneIsNot) {
  EXPECT_EQ(MergeThreeWays(Read("x:a x:p 1 ."), Read("x:z x:p 1 ."), Read("x:a x:p 2 ."))
                .conflicts.size(),
            1u);
  const MergeResult gone =
      MergeThreeWays(Read("x:a x:p 1 ."), Read("x:z x:p 1 ."), Read("x:a x:p 1 ."));
  EXPECT_THAT(gone.conflicts, IsEmpty());
  EXPECT_EQ(Triples(gone.document), Triples("x:z x:p 1 ."));
}

TEST(ThreeWayMergeTest, BlankNodesAreOneValueWithWhatIsSaidOfThem) {
  const MergeResult moved =
      MergeThreeWays(Read("x:a x:at [ x:x 1 ; x:y 1 ] . x:b x:at [ x:x 1 ] ."),
                     Read("x:b x:at [ x:x 1 ] . x:a x:at [ x:y 1 ; x:x 1 ] ."),
                     Read("x:a x:at [ x:x 2 ; x:y 1 ] . x:b x:at [ x:x 1 ] ."));
  EXPECT_THAT(moved.conflicts, IsEmpty());
  EXPECT_EQ(moved.document.statements.size(), 5u);
  EXPECT_EQ(MergeThreeWays(Read("x:a x:at [ x:x 1 ] ."), Read("x:a x:at [ x:x 2 ] ."),
                           Read("x:a x:at [ x:x 3 ] ."))
                .conflicts.size(),
            1u);
}

TEST(ThreeWayMergeTest, WithoutACommonPastWhatBothSayDifferentlyConflicts) {
  const MergeResult merged =
      MergeThreeWays(Document(), Read("x:a x:p 1 ; x:q 1 ."), Read("x:a x:p 2 ; x:r 1 ."));
  EXPECT_EQ(merged.conflicts.size(), 1u);
}

TEST(ThreeWayMergeTest, CirclesAndDoublingBlankNodesEnd) {
  std::string doubling = "x:a x:p _:b0 .\n";
  for (int i = 0; i < 40; ++i) {
    const std::string here = "_:b" + std::to_string(i);
    const std::string next = "_:b" + std::to_string(i + 1);
    doubling += here + " x:p " + next + " ; x:q " + next + " .\n";
  }
  EXPECT_EQ(MergeThreeWays(Read(doubling), Read(doubling), Read(doubling)).conflicts.size(), 0u);
  const std::string circle = "_:a x:p _:b . _:b x:p _:a .";
  EXPECT_EQ(MergeThreeWays(Read(circle), Read(circle), Read(circle)).conflicts.size(), 0u);
  std::string chain = "x:a x:p _:c0 .\n";
  for (int i = 0; i < 20000; ++i) {
    chain += "_:c" + std::to_string(i) + " x:p _:c" + std::to_string(i + 1) + " .\n";
  }
  EXPECT_EQ(MergeThreeWays(Read(chain), Read(chain), Read(chain)).conflicts.size(), 0u);
}

// What a merge has to do whatever the documents are: nothing changed, nothing lost.
TEST(ThreeWayMergeTest, RandomDocumentsMergeByTheRules) {
  std::mt19937 random(11);
  const auto make = [&] {
    std::string text;
    for (int s = 0; s < 4; ++s) {
      for (int p = 0; p < 3; ++p) {
        if (random() % 3 == 0) continue;
        text += "x:s" + std::to_string(s) + " x:p" + std::to_string(p) + " " +
                std::to_string(random() % 3) + " .\n";
      }
    }
    return text;
  };
  for (int round = 0; round < 300; ++round) {
    const std::string base = make();
    const std::string other = make();
    EXPECT_EQ(Triples(MergeThreeWays(Read(base), Read(base), Read(other)).document),
              Triples(other));
    EXPECT_EQ(Triples(MergeThreeWays(Read(base), Read(other), Read(base)).document),
              Triples(other));
    EXPECT_EQ(Triples(MergeThreeWays(Read(base), Read(other), Read(other)).document),
              Triples(other));
    const std::string third = make();
    const MergeResult one = MergeThreeWays(Read(base), Read(other), Read(third));
    const MergeResult two = MergeThreeWays(Read(base), Read(third), Read(other));
    EXPECT_EQ(one.conflicts.size(), two.conflicts.size());
    if (one.conflicts.empty()) {
      EXPECT_EQ(Triples(one.document), Triples(two.document));
    }
  }
}

}  // namespace
}  // namespace lares::rdf
