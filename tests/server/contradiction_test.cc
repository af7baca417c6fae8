// Documents that contradict what is known: refused with their proof, or kept aside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "server/knowledge/refusal.h"
#include "tests/lares_data.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using server::Refusal;
using store::DocumentKind;
using ::testing::HasSubstr;

constexpr char kZoo[] = ":Cat a owl:Class ; owl:disjointWith :Dog . :Dog a owl:Class .\n";
constexpr char kBoth[] = ":tom a :Cat , :Dog .\n";

class ContradictionTest : public KnowledgeFixture {
 protected:
  server::PutAnswer PutAside(DocumentKind kind, const std::string& id, const std::string& bytes) {
    server::PutRequest request;
    request.kind = kind;
    request.id = id;
    request.file_name = id + ".ttl";
    request.bytes = bytes;
    request.quarantine = true;
    return knowledge_->Put(request);
  }
  bool Knows(const std::string& local) {
    const auto term =
        knowledge_->Catalogue().dictionary().FindIri("http://example.org/test#" + local);
    return term && !knowledge_->Catalogue().Match({*term, {}, {}}).empty();
  }
};

TEST_F(ContradictionTest, AnOntologyThatContradictsIsRefusedWithItsProofAndNothingChanges) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo);
  const auto before = knowledge_->counts().asserted;
  try {
    Put(DocumentKind::kOntology, "tom", std::string(kPrefixes) + kBoth);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.kind(), Refusal::Kind::kContradiction);
    EXPECT_THAT(refusal.what(), HasSubstr("tom is Cat and Dog, which exclude each other"));
    EXPECT_THAT(refusal.what(), HasSubstr("ontology:zoo"));
    EXPECT_THAT(refusal.hint(), HasSubstr("--quarantine"));
    const auto members = nlohmann::json::parse(refusal.members_json());
    EXPECT_FALSE(members.at("clashes").empty());
    EXPECT_FALSE(members.at("proof").at("nodes").empty());
    EXPECT_THAT(refusal.what(), HasSubstr("proof:"));
  }
  EXPECT_EQ(knowledge_->counts().asserted, before);
  EXPECT_EQ(knowledge_->counts().clashes, 0U);
  EXPECT_FALSE(store_->FindDocument(DocumentKind::kOntology, "tom"));
  Open();
  EXPECT_EQ(knowledge_->counts().clashes, 0U);
}

TEST_F(ContradictionTest, ALaterVersionThatContradictsLeavesTheOneBeforeInPlace) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo + ":tom a :Cat .\n");
  EXPECT_THROW(Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo + kBoth), Refusal);
  EXPECT_EQ(store_->FindDocument(DocumentKind::kOntology, "zoo")->version, 1);
  EXPECT_TRUE(Knows("tom"));
}

TEST_F(ContradictionTest, ARobotThatContradictsAStoredOntologysOwnTermsIsRefused) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo);
  EXPECT_THROW(Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover") + kBoth), Refusal);
  EXPECT_TRUE(store_->ListDocuments(DocumentKind::kRobot).empty());
}

TEST_F(ContradictionTest, AMapThatContradictsIsRefusedAndTheEnvironmentIsNotMade) {
  try {
    PutMap("flat", std::string(kPrefixes) + ":m a lares:SemanticEnvironmentMap .\n" + kZoo + kBoth);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.kind(), Refusal::Kind::kContradiction);
    EXPECT_THAT(refusal.what(), HasSubstr("proof:"));
    EXPECT_THAT(refusal.hint(), HasSubstr("--quarantine"));
  }
  EXPECT_FALSE(store_->FindEnvironment("flat"));
}

class VersionAsideTest : public ContradictionTest {
 protected:
  server::Knowledge::VersionAnswer PutMapAside(const std::string& bytes, bool with_trajectory) {
    store::NewVersion version;
    version.environment = "flat";
    version.note = "with Tom";
    version.layers.push_back({"semantic", "map.ttl", "", PutBlob(bytes), {}});
    if (with_trajectory) version.layers.push_back({"trajectory", "t.txt", "", PutBlob("1"), {}});
    return knowledge_->PutVersion(version, {false, true});
  }
  const std::string map_ = std::string(kPrefixes) + ":m a lares:SemanticEnvironmentMap .\n";
};

TEST_F(VersionAsideTest, ASemanticLayerKeptAsideLeavesTheEnvironmentAndIsReleasedOnceItMayBe) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo);
  PutMap("flat", map_);
  const auto aside = PutMapAside(map_ + kBoth, false);
  EXPECT_THAT(aside.quarantined, HasSubstr("which exclude each other"));
  EXPECT_EQ(aside.aside.id, "environment.flat");
  EXPECT_EQ(store_->GetVersion("flat", 0).number, 1);
  EXPECT_THROW(knowledge_->ReleaseVersion("environment.flat", false), Refusal);
  EXPECT_EQ(store_->ListDocuments(DocumentKind::kQuarantined).size(), 1U);
  knowledge_->Remove(DocumentKind::kOntology, "zoo");
  const auto taken = knowledge_->ReleaseVersion("environment.flat", false);
  EXPECT_EQ(taken.version.number, 2);
  EXPECT_EQ(taken.version.note, "with Tom");
  EXPECT_TRUE(store_->ListDocuments(DocumentKind::kQuarantined).empty());
  EXPECT_THROW(knowledge_->ReleaseVersion("environment.flat", false), Error);
}

TEST_F(VersionAsideTest, OtherLayersAreNotLostOnTheWay) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo);
  try {
    PutMapAside(map_ + kBoth, true);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_THAT(refusal.hint(), HasSubstr("only a semantic layer"));
  }
  EXPECT_FALSE(store_->FindEnvironment("flat"));
  EXPECT_TRUE(store_->ListDocuments(DocumentKind::kQuarantined).empty());
}

TEST_F(VersionAsideTest, AnEditorsMapMaySayNewThingsOfOthersTerms) {
  store::NewVersion version;
  version.environment = "flat";
  version.layers.push_back(
      {"semantic", "map.ttl", "", PutBlob(map_ + "lares:Cup rdfs:subClassOf :Weapon .\n"), {}});
  EXPECT_THROW(knowledge_->PutVersion(version), Refusal);
  const auto answer = knowledge_->PutVersion(version, {true, false});
  EXPECT_EQ(answer.version.layers.at(0).facts.at("editor"), "true");
}

TEST_F(ContradictionTest, KeptAsideItIsListedWithTheReasonAndPartOfNoView) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo);
  const auto answer = PutAside(DocumentKind::kOntology, "tom", std::string(kPrefixes) + kBoth);
  EXPECT_THAT(answer.quarantined, HasSubstr("which exclude each other"));
  EXPECT_EQ(answer.document.kind, DocumentKind::kQuarantined);
  const auto aside = store_->ListDocuments(DocumentKind::kQuarantined);
  ASSERT_EQ(aside.size(), 1U);
  EXPECT_EQ(aside[0].id, "ontology.tom");
  EXPECT_THAT(aside[0].details_json, HasSubstr("which exclude each other"));
  EXPECT_FALSE(Knows("tom"));
  Open();
  EXPECT_FALSE(Knows("tom"));
  EXPECT_THROW(knowledge_->Release("ontology.tom", false), Refusal);
  EXPECT_EQ(store_->ListDocuments(DocumentKind::kQuarantined).size(), 1U);
}

TEST_F(ContradictionTest, ReleasedWhenTheGroundIsGoneItIsTaken) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo);
  PutAside(DocumentKind::kOntology, "tom", std::string(kPrefixes) + kBoth);
  knowledge_->Remove(DocumentKind::kOntology, "zoo");
  const auto answer = knowledge_->Release("ontology.tom", false);
  EXPECT_EQ(answer.document.id, "tom");
  EXPECT_TRUE(Knows("tom"));
  EXPECT_TRUE(store_->ListDocuments(DocumentKind::kQuarantined).empty());
  EXPECT_THROW(knowledge_->Release("ontology.tom", false), Error);
}

TEST_F(ContradictionTest, AVersionKeptAsideLeavesTheOneInUse) {
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover"));
  PutAside(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover") + kZoo + kBoth);
  EXPECT_EQ(store_->FindDocument(DocumentKind::kRobot, "rover")->version, 1);
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover") + kZoo);
  EXPECT_TRUE(store_->ListDocuments(DocumentKind::kQuarantined).empty()) << "mended and sent again";
}

TEST_F(ContradictionTest, WhatContradictsNothingIsTakenThoughItMightBeKeptAside) {
  EXPECT_EQ(PutAside(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + kZoo).quarantined,
            "");
}

// SRDL's axioms and RoboEarth's own robots exclude each other: the catalogue takes no side.
TEST_F(ContradictionTest, AContradictionOverASharedTermIsAWarningUnlessAnEditorDecidedIt) {
  const std::string shared =
      "<http://ias.cs.tum.edu/kb/srdl2-comp.owl> a owl:Ontology .\n"
      "@prefix srdl2-comp: <http://ias.cs.tum.edu/kb/srdl2-comp.owl#> .\n"
      "srdl2-comp:ArmComponent a owl:Class ; owl:disjointWith srdl2-comp:MobileBase .\n";
  const std::string robot = BaseOnlyRobot("rover") + ":rover_base a lares:ArmComponent .\n";
  Put(DocumentKind::kOntology, "srdl2-comp", std::string(kPrefixes) + shared);
  const auto answer = Put(DocumentKind::kRobot, "rover", robot);
  EXPECT_THAT(answer.warnings, ::testing::Contains(HasSubstr("which exclude each other")));
  PutAsEditor(DocumentKind::kOntology, "srdl2-comp", std::string(kPrefixes) + shared + "#\n");
  EXPECT_THROW(Put(DocumentKind::kRobot, "rover2", robot), Refusal);
}

}  // namespace
}  // namespace lares::testing
