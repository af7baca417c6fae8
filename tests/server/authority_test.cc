// Who may say what, from the side of the service.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>

#include "server/knowledge/refusal.h"
#include "tests/lares_data.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using server::Refusal;
using store::DocumentKind;
using ::testing::HasSubstr;

class AuthorityTest : public KnowledgeFixture {
 protected:
  // What is refused of a document; empty when it is taken.
  std::string Refused(DocumentKind kind, const std::string& id, const std::string& body) {
    try {
      Put(kind, id, kPrefixes + body);
      return "";
    } catch (const Refusal& refusal) {
      EXPECT_EQ(refusal.kind(), Refusal::Kind::kForeignTerm);
      return refusal.FullMessage();
    }
  }
  bool Holds(const rdf::View& view, const std::string& s, const std::string& p,
             const std::string& o) {
    rdf::Dictionary& terms = view.dictionary();
    return view.Contains({terms.InternIri(s), terms.InternIri(p), terms.InternIri(o)});
  }
};

constexpr char kTest[] = "http://example.org/test#";
constexpr char kSubClassOf[] = "http://www.w3.org/2000/01/rdf-schema#subClassOf";
constexpr char kType[] = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";
constexpr char kLaresNs[] = "https://w3id.org/lares#";

TEST_F(AuthorityTest, ANewSuperclassForOursIsRefusedWithPlaceOwnerAndHint) {
  try {
    Put(DocumentKind::kOntology, "weapons",
        std::string(kPrefixes) +
            ":Weapon a owl:Class .\nlares:Cup rdfs:label \"mug\"@en .\n"
            "lares:Cup\n  rdfs:subClassOf :Weapon .\n");
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("Cup subClassOf Weapon"));
    EXPECT_THAT(refusal.what(), HasSubstr("Cup belongs to module:objects"));
    ASSERT_TRUE(refusal.place());
    EXPECT_EQ(refusal.place()->line, 9);
    EXPECT_THAT(refusal.hint(), HasSubstr("--editor"));
    const auto members = nlohmann::json::parse(refusal.members_json());
    EXPECT_EQ(members.at("axioms").size(), 1U);
  }
  EXPECT_FALSE(store_->FindDocument(DocumentKind::kOntology, "weapons"));
  EXPECT_FALSE(Holds(knowledge_->Catalogue(), std::string(kLaresNs) + "Cup", kSubClassOf,
                     std::string(kTest) + "Weapon"));
}

TEST_F(AuthorityTest, AHistoricNameOfOursIsOurs) {
  EXPECT_THAT(Refused(DocumentKind::kOntology, "w",
                      "@prefix k: <http://ias.cs.tum.edu/kb/knowrob.owl#> . "
                      "k:Cup rdfs:subClassOf :Weapon ."),
              HasSubstr("Cup belongs to module:objects"));
}

TEST_F(AuthorityTest, AnEditorMayAndItIsKeptWithTheVersion) {
  const auto answer = PutAsEditor(DocumentKind::kOntology, "weapons",
                                  std::string(kPrefixes) + "lares:Cup rdfs:subClassOf :Weapon .");
  EXPECT_TRUE(nlohmann::json::parse(answer.document.details_json).at("editor").get<bool>());
  EXPECT_TRUE(Holds(knowledge_->Catalogue(), std::string(kLaresNs) + "Cup", kSubClassOf,
                    std::string(kTest) + "Weapon"));
  Open();
  EXPECT_TRUE(Holds(knowledge_->Catalogue(), std::string(kLaresNs) + "Cup", kSubClassOf,
                    std::string(kTest) + "Weapon"));
}

TEST_F(AuthorityTest, WhatIsOfTheDocumentsOwnMayRestOnOurs) {
  for (const char* body : {
           ":Goblet a owl:Class ; rdfs:subClassOf lares:Cup .",
           ":Goblet owl:disjointWith lares:Bottle .",
           ":OurCup owl:equivalentClass [ owl:intersectionOf ( lares:Cup lares:Artifact ) ] ; "
           "rdfs:subClassOf lares:Cup , lares:PhysicalObject , :Thing .",
           ":holds a owl:ObjectProperty ; rdfs:subPropertyOf lares:in ; rdfs:domain lares:Cup .",
           ":RedCup owl:equivalentClass [ owl:intersectionOf ( lares:Cup :Red ) ] .",
           ":Red rdfs:subClassOf [ a owl:Restriction ; owl:onProperty lares:on ; "
           "owl:allValuesFrom lares:Table ] .",
           "lares:Cup a owl:Class ; rdfs:label \"tasse\"@fr .",
           ":cup1 a lares:Cup ; lares:on :table1 .",
       }) {
    EXPECT_EQ(Refused(DocumentKind::kOntology, "mine", body), "") << body;
  }
}

TEST_F(AuthorityTest, EveryKindOfAxiomAboutOursIsRefused) {
  for (const char* body : {
           "lares:Cup rdfs:subClassOf [ a owl:Restriction ; owl:onProperty lares:on ; "
           "owl:someValuesFrom :Shelf ] .",
           ":Goblet owl:equivalentClass lares:Cup .",
           "lares:Cup owl:equivalentClass :Goblet .",
           "lares:Cup owl:disjointWith lares:Bottle .",
           "[] a owl:AllDisjointClasses ; owl:members ( :Goblet lares:Cup lares:Bottle ) .",
           "lares:on rdfs:domain :Goblet .",
           "lares:on rdfs:range lares:Cup .",
           "lares:on rdfs:subPropertyOf :near .",
           "lares:on a owl:FunctionalProperty .",
           "lares:on owl:inverseOf :carries .",
           "lares:on owl:propertyChainAxiom ( lares:in lares:on ) .",
           "lares:Cup owl:hasKey ( lares:on ) .",
           "lares:Cup owl:unionOf ( :A :B ) .",
           ":Vessel owl:unionOf ( lares:Cup lares:Bottle ) .",
           "lares:Cup a owl:ObjectProperty .",
           "lares:Cup owl:sameAs :Goblet .",
           "[ owl:intersectionOf ( lares:Cup lares:Artifact ) ] rdfs:subClassOf lares:Bottle .",
           ":RedCup owl:equivalentClass [ owl:intersectionOf ( lares:Cup lares:Artifact ) ] ; "
           "rdfs:subClassOf lares:Bottle .",
       }) {
    EXPECT_NE(Refused(DocumentKind::kOntology, "mine", body), "") << body;
  }
}

TEST_F(AuthorityTest, ARepeatedRestrictionAndAListAreRecognisedWhateverTheirNodesAreCalled) {
  EXPECT_EQ(Refused(DocumentKind::kOntology, "echo",
                    "lares:IkeaExpedit2x4 rdfs:subClassOf lares:Cabinet , _:r . "
                    "_:r owl:hasValue lares:ContainObjects ; a owl:Restriction ; "
                    "owl:onProperty lares:affords ."),
            "");
  const std::string four =
      "[ a owl:Restriction ; owl:onProperty lares:hasCapability ; owl:someValuesFrom "
      "lares:GraspingCapability ] "
      "[ a owl:Restriction ; owl:onProperty lares:hasCapability ; owl:someValuesFrom "
      "lares:move_arm ] "
      "[ a owl:Restriction ; owl:onProperty lares:hasCapability ; owl:someValuesFrom "
      "lares:move_base ] ";
  const std::string last =
      "[ a owl:Restriction ; owl:onProperty lares:hasCapability ; owl:someValuesFrom "
      "lares:ObjectRecognitionCapability ] ";
  EXPECT_EQ(Refused(DocumentKind::kOntology, "echo",
                    "lares:PR2 rdfs:subClassOf [ a owl:Class ; owl:intersectionOf ( " + four +
                        last + ") ] ."),
            "");
  EXPECT_NE(Refused(DocumentKind::kOntology, "echo",
                    "lares:PR2 rdfs:subClassOf [ a owl:Class ; owl:intersectionOf ( " + four +
                        "[ a owl:Restriction ; owl:onProperty lares:hasCapability ; "
                        "owl:someValuesFrom lares:Flying ] ) ] ."),
            "");
}

TEST_F(AuthorityTest, AnInheritedSuperclassIsEntailed) {
  EXPECT_EQ(Refused(DocumentKind::kOntology, "echo",
                    "lares:Cup rdfs:subClassOf lares:PhysicalObject , owl:Thing ."),
            "");
}

TEST_F(AuthorityTest, NeitherRecipeNorRobotNorEnvironmentAddsToTermsOfOthers) {
  const std::string axiom = "lares:Cup rdfs:subClassOf :Weapon .\n";
  for (const DocumentKind kind : {DocumentKind::kRecipe, DocumentKind::kRobot}) {
    const std::string body =
        kind == DocumentKind::kRecipe ? WalkRecipe("Walk", 1) : BaseOnlyRobot("rover");
    EXPECT_THROW(Put(kind, "x", body + axiom), Refusal);
    EXPECT_NO_THROW(Put(kind, "x", body + ":Weapon rdfs:subClassOf lares:Artifact .\n"));
  }
  const std::string map = std::string(kPrefixes) + ":m a lares:SemanticEnvironmentMap .\n";
  EXPECT_THROW(PutMap("flat", map + axiom), Refusal);
  EXPECT_FALSE(store_->FindEnvironment("flat"));
  EXPECT_NO_THROW(PutMap("flat", map));
}

TEST_F(AuthorityTest, AStoredOntologyOwnsWhatItDeclaresFirst) {
  Put(DocumentKind::kOntology, "zoo", std::string(kPrefixes) + ":Cat a owl:Class .");
  const std::string claim = ":Cat rdfs:subClassOf :Fluid .";
  EXPECT_THAT(Refused(DocumentKind::kOntology, "art", claim), HasSubstr("ontology:zoo"));
  EXPECT_EQ(Refused(DocumentKind::kOntology, "zoo", claim), "");
  EXPECT_EQ(Refused(DocumentKind::kOntology, "art", claim), "") << "the owner states it now";
  Open();
  EXPECT_THAT(Refused(DocumentKind::kOntology, "art", ":Cat rdfs:subClassOf :Solid ."),
              HasSubstr("ontology:zoo"));
  knowledge_->Remove(DocumentKind::kOntology, "zoo");
  EXPECT_EQ(Refused(DocumentKind::kOntology, "art", ":Cat rdfs:subClassOf :Solid ."), "");
}

TEST_F(AuthorityTest, ADocumentOwnsTheNamesOfItsNamespaceWhoeverMentionsThemFirst) {
  Put(DocumentKind::kOntology, "early",
      std::string(kPrefixes) + "<http://example.org/other#Cat> a owl:Class .");
  EXPECT_EQ(Refused(DocumentKind::kOntology, "zoo",
                    "@prefix z: <http://example.org/zoo#> . <http://example.org/zoo> a "
                    "owl:Ontology . z:Cat a owl:Class ."),
            "");
  Put(DocumentKind::kOntology, "other",
      std::string(kPrefixes) +
          "<http://example.org/other> a owl:Ontology . <http://example.org/other#Cat> "
          "rdfs:subClassOf :Animal .");
  EXPECT_NE(Refused(DocumentKind::kOntology, "early",
                    "<http://example.org/other#Cat> rdfs:subClassOf :Fluid ."),
            "");
}

TEST_F(AuthorityTest, AnIndividualOfTwoDocumentsKeepsEachAssertionInItsGraph) {
  Put(DocumentKind::kOntology, "one", std::string(kPrefixes) + ":c a lares:Cup .");
  Put(DocumentKind::kOntology, "two", std::string(kPrefixes) + ":c lares:on :t ; a lares:Cup .");
  const rdf::View view = knowledge_->Catalogue();
  rdf::Dictionary& terms = view.dictionary();
  const rdf::TermId cup = terms.InternIri(std::string(kTest) + "c");
  EXPECT_THAT(
      view.GraphsOf({cup, terms.InternIri(kType), terms.InternIri(std::string(kLaresNs) + "Cup")}),
      ::testing::UnorderedElementsAre("ontology:one", "ontology:two"));
  EXPECT_THAT(view.GraphsOf({cup, terms.InternIri(std::string(kLaresNs) + "on"),
                             terms.InternIri(std::string(kTest) + "t")}),
              ::testing::ElementsAre("ontology:two"));
}

TEST_F(AuthorityTest, FactsOfOneOverlayNeverReachAnother) {
  const std::string map = std::string(kPrefixes) + ":m a lares:SemanticEnvironmentMap .\n";
  PutMap("one", map + ":Odd rdfs:subClassOf lares:Cup . :x a :Odd ; lares:on :t .\n");
  PutMap("two", map + ":x a lares:Bottle .\n");
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover") + ":x a lares:Camera .\n");
  const auto is_a = [&](const server::ViewRequest& request, const std::string& kind) {
    return Holds(knowledge_->ViewFor(request), std::string(kTest) + "x", kType, kLaresNs + kind);
  };
  EXPECT_TRUE(is_a({"", "", "one", 0}, "Cup"));
  EXPECT_FALSE(is_a({"", "", "two", 0}, "Cup"));
  EXPECT_FALSE(is_a({"", "", "one", 0}, "Bottle"));
  EXPECT_FALSE(is_a({"", "", "one", 0}, "Camera"));
  EXPECT_FALSE(is_a({"", "rover", "", 0}, "Cup"));
  EXPECT_TRUE(is_a({"", "rover", "two", 0}, "Camera")) << "named together, they are one question";
  EXPECT_FALSE(Holds(knowledge_->Catalogue(), std::string(kTest) + "Odd", kSubClassOf,
                     std::string(kLaresNs) + "Cup"));
}

TEST_F(AuthorityTest, AnObjectModelDescribesItsClassByRestrictionsAndNoFurther) {
  const std::string model =
      ":model a lares:ObjectRecognitionModel ; lares:providesModelFor "
      "lares:IkeaExpedit2x4 .\n";
  EXPECT_EQ(Refused(DocumentKind::kObjectModel, "shelf",
                    model + "lares:IkeaExpedit2x4 rdfs:subClassOf [ a owl:Restriction ; "
                            "owl:onProperty lares:properPhysicalParts ; owl:someValuesFrom "
                            "lares:IkeaExpeditDoor1 ] ."),
            "");
  EXPECT_NE(Refused(DocumentKind::kObjectModel, "shelf",
                    model + "lares:IkeaExpedit2x4 rdfs:subClassOf :Weapon ."),
            "");
  EXPECT_NE(
      Refused(DocumentKind::kObjectModel, "shelf",
              model + "lares:Cup rdfs:subClassOf [ a owl:Restriction ; owl:onProperty lares:on "
                      "; owl:someValuesFrom lares:Table ] ."),
      "");
}

// Every file of RoboEarth, in orders drawn at random, without editor rights.
TEST_F(AuthorityTest, RoboEarthsFilesLoadUnchangedInAnyOrder) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  struct File {
    DocumentKind kind;
    std::string path;
  };
  std::vector<File> files;
  for (const char* path :
       {"ontology/knowrob", "ontology/roboearth", "srdl/srdl2", "srdl/srdl2-action",
        "srdl/srdl2-cap", "srdl/srdl2-comp", "objects/vision_descriptors"}) {
    files.push_back({DocumentKind::kOntology, path});
  }
  for (const char* path :
       {"recipes/exploration-recipe", "recipes/object-search-recipe", "recipes/serve_drink"}) {
    files.push_back({DocumentKind::kRecipe, path});
  }
  for (const char* path :
       {"robots/PR2", "robots/amigo", "robots/amigo_roboearth", "robots/pioneer"}) {
    files.push_back({DocumentKind::kRobot, path});
  }
  for (const char* path : {"objects/cabinet_model", "objects/object_model"}) {
    files.push_back({DocumentKind::kObjectModel, path});
  }
  for (const char* path :
       {"maps/environment_map", "maps/ias_hospital_room", "maps/ias_hospital_room_2D_occupancy_map",
        "maps/ias_hospital_room_octomap", "maps/ias_hospital_room_vslam_map",
        "maps/ias_hospital_room_with_objects", "maps/map_hospital_room"}) {
    files.push_back({DocumentKind::kPrior, path});  // stands for an environment
  }
  std::mt19937 random(3);
  for (int round = 0; round < 2; ++round) {
    for (const File& file : files) {
      const std::filesystem::path path = folder / (file.path + ".owl");
      SCOPED_TRACE(file.path);
      if (file.kind == DocumentKind::kPrior) {
        EXPECT_NO_THROW(PutMap(path.stem().string(), ReadFile(path), path.filename().string()));
      } else {
        EXPECT_NO_THROW(PutFile(file.kind, path, true));
      }
    }
    if (round == 0) {
      for (const File& file : files) {
        if (file.kind == DocumentKind::kOntology) {
          knowledge_->Remove(file.kind, std::filesystem::path(file.path).stem().string());
        }
      }
    }
    std::shuffle(files.begin(), files.end(), random);
  }
  EXPECT_EQ(knowledge_->counts().clashes, 0U);
}

}  // namespace
}  // namespace lares::testing
