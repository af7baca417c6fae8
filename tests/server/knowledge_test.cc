#include "server/knowledge/knowledge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/lares_data.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using store::DocumentKind;
using ::testing::HasSubstr;
using KnowledgeTest = KnowledgeFixture;

Code CodeOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.code();
  }
  ADD_FAILURE() << "nothing was thrown";
  return Code::kInternal;
}

std::string CupMap(const std::string& extra) {
  return std::string(kPrefixes) +
         ":map a lares:SemanticEnvironmentMap .\n"
         ":cup1 a lares:Cup ; lares:describedInMap :map .\n"
         ":seen a lares:SemanticMapPerception ; lares:objectActedOn :cup1 ; lares:eventOccursAt "
         ":pose ; "
         "lares:startTime :timepoint_1700000000 .\n"
         ":pose a lares:RotationMatrix3D ; lares:m00 1.0 ; lares:m01 0.0 ; lares:m02 0.0 ; "
         "lares:m03 " +
         extra +
         " ; lares:m10 0.0 ; lares:m11 1.0 ; lares:m12 0.0 ; lares:m13 2.0 ; lares:m20 0.0 ; "
         "lares:m21 0.0 ; lares:m22 1.0 ; lares:m23 0.8 ; lares:m30 0.0 ; lares:m31 0.0 ; "
         "lares:m32 0.0 ; lares:m33 1.0 .\n";
}

TEST_F(KnowledgeTest, OwnModulesLoadWithoutContradiction) {
  EXPECT_GT(knowledge_->counts().asserted, 1000U);
  EXPECT_EQ(knowledge_->counts().clashes, 0U);
  EXPECT_EQ(knowledge_->ResolveClass("Cup").iri, "https://w3id.org/lares#Cup");
  EXPECT_EQ(knowledge_->ResolveClass("http://ias.cs.tum.edu/kb/knowrob.owl#Cup").iri,
            "https://w3id.org/lares#Cup");
}

TEST_F(KnowledgeTest, OwnModulesAreCleanWhenChecked) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(LARES_SOURCE_DIR) + "/ontology")) {
    if (entry.path().extension() != ".ttl") continue;
    const server::CheckAnswer answer =
        knowledge_->Check({"", entry.path().filename().string(), ReadFile(entry.path()), false});
    for (const profile::Finding& finding : answer.report.findings) {
      // A need is a restriction with owl:someValuesFrom above a class: it is read by the rules that
      // match robots, and not by the reasoner.
      const bool is_need =
          finding.message.starts_with("owl:someValuesFrom on the side of the superclass");
      EXPECT_TRUE(is_need || finding.kind == profile::Kind::kRemark)
          << ToString(finding.places.at(0)) << ": " << finding.message;
    }
  }
}

TEST_F(KnowledgeTest, CheckingKeepsNothingAndKnowsTheCatalogue) {
  const server::CheckAnswer answer = knowledge_->Check(
      {"", "x.ttl",
       "@prefix lares: <https://w3id.org/lares#> . @prefix owl: <http://www.w3.org/2002/07/owl#> "
       ".\n"
       "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n"
       "<urn:x> a owl:Class ;\n  rdfs:subClassOf lares:Cup, lares:SpatialThng .\n",
       false});
  ASSERT_EQ(answer.report.findings.size(), 1u);
  EXPECT_NE(answer.report.findings[0].message.find("SpatialThing"), std::string::npos);
  EXPECT_EQ(answer.report.findings[0].places[0].line, 4);
  EXPECT_TRUE(store_->ListDocuments(store::DocumentKind::kOntology).empty());
  EXPECT_THROW(knowledge_->Check({"", "x.ttl", "<urn:a> <urn:b", false}), Error);
}

TEST_F(KnowledgeTest, ATaskAnswersToIdIriLocalNameAndNoOther) {
  Put(DocumentKind::kRecipe, "walk", WalkRecipe("Walk", 2));
  for (const char* name : {"walk", "Walk", "http://example.org/test#Walk"}) {
    EXPECT_EQ(knowledge_->Resolve(DocumentKind::kRecipe, name).target_iri,
              "http://example.org/test#Walk")
        << name;
  }
  EXPECT_EQ(CodeOf([&] { knowledge_->Resolve(DocumentKind::kRecipe, "Wolk"); }), Code::kNotFound);
}

TEST_F(KnowledgeTest, OneNameForTwoDocumentsIsAmbiguousAndBothAreListed) {
  Put(DocumentKind::kRecipe, "walk-a", WalkRecipe("Walk", 2));
  Put(DocumentKind::kRecipe, "walk-b", WalkRecipe("Walk", 3));
  try {
    knowledge_->Resolve(DocumentKind::kRecipe, "Walk");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kAmbiguous);
    EXPECT_THAT(error.what(), HasSubstr("walk-a"));
    EXPECT_THAT(error.what(), HasSubstr("walk-b"));
  }
}

TEST_F(KnowledgeTest, RecipesThatReuseOneIriDoNotContaminateEachOther) {
  Put(DocumentKind::kRecipe, "walk-a", WalkRecipe("Walk", 2));
  Put(DocumentKind::kRecipe, "walk-b", WalkRecipe("Walk", 3));
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover"));
  const auto count_skills = [&](const std::string& recipe) {
    const auto answer = knowledge_->MakePlan({recipe, "rover"});
    EXPECT_TRUE(answer.result.plan) << ::testing::PrintToString(answer.result.problems);
    if (!answer.result.plan) return std::ptrdiff_t{-1};
    const auto& states = answer.result.plan->states;
    return std::count_if(states.begin(), states.end(), [](const recipes::State& state) {
      return state.kind == recipes::State::Kind::kSkill;
    });
  };
  EXPECT_EQ(count_skills("walk-a"), 2);
  EXPECT_EQ(count_skills("walk-b"), 3);
}

TEST_F(KnowledgeTest, ARefusedRecipeLeavesNothingAndNamesAPlace) {
  std::string broken = WalkRecipe("Walk", 2);
  broken +=
      ":order9 a lares:PartialOrdering-Strict ; lares:occursBeforeInOrdering :Step2 ; "
      "lares:occursAfterInOrdering :Step1 .\n"
      ":Walk rdfs:subClassOf [ a owl:Restriction ; owl:onProperty lares:orderingConstraints ; "
      "owl:hasValue :order9 ] .\n";
  try {
    Put(DocumentKind::kRecipe, "walk", broken);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
    ASSERT_TRUE(error.place().has_value());
    EXPECT_GT(error.place()->line, 0);
  }
  EXPECT_TRUE(store_->ListDocuments(DocumentKind::kRecipe).empty());
}

constexpr char kTextBesideResource[] =
    "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
    "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\">\n"
    "<rdf:Description rdf:about=\"http://example.org/a\"><rdfs:label "
    "rdf:resource=\"http://example.org/x\">stop</rdfs:label></rdf:Description></rdf:RDF>\n";

TEST_F(KnowledgeTest, AnUndeclaredEntityOfAKnownNamespaceIsRepairedOnRequestAndStaysReadable) {
  server::PutRequest request;
  request.kind = DocumentKind::kRobot;
  request.file_name = "rover.owl";
  request.bytes =
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
      "xmlns:knowrob=\"&knowrob;\">\n"
      "<knowrob:Robot rdf:about=\"http://example.org/rover\"/>\n</rdf:RDF>\n";
  EXPECT_EQ(CodeOf([&] { knowledge_->Put(request); }), Code::kInvalid);
  request.recover = true;
  const auto answer = knowledge_->Put(request);
  ASSERT_EQ(answer.remarks.size(), 1U);
  EXPECT_EQ(answer.remarks[0].kind, rdf::Remark::Kind::kRepair);
  Put(DocumentKind::kRecipe, "walk", WalkRecipe("Walk", 1));
  EXPECT_FALSE(knowledge_->MakePlan({"walk", "rover"}).result.match.feasible);
}

TEST_F(KnowledgeTest, RepeatingWhatIsKnownInfersNothing) {
  const auto answer =
      Put(DocumentKind::kOntology, "echo",
          std::string(kPrefixes) + "lares:Cup rdfs:subClassOf lares:DrinkingVessel .\n");
  EXPECT_EQ(answer.statements, 1U);
  EXPECT_EQ(answer.inferred, 0U);
}

TEST_F(KnowledgeTest, WhatWasAcceptedNeverKeepsTheServerFromStarting) {
  try {
    Put(DocumentKind::kOntology, "odd", kTextBesideResource, "odd.owl");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Code::kInvalid);
  }
  EXPECT_NO_THROW(Open());
}

TEST_F(KnowledgeTest, AStoredDocumentThatCannotBeReadIsSetAsideAndNamed) {
  store_->PutDocument(
      {DocumentKind::kOntology, "torn", "text/turtle", "torn.ttl", "<a> <b> ", "{}", {}, ""});
  Open();
  const auto modules = knowledge_->Modules();
  const auto torn = std::find_if(modules.begin(), modules.end(),
                                 [](const auto& module) { return module.id == "torn"; });
  ASSERT_NE(torn, modules.end());
  EXPECT_THAT(torn->origin, HasSubstr("torn.ttl:1"));
}

TEST_F(KnowledgeTest, AnotherOntologysNotionOfAPlaceMakesNoCupboardARoom) {
  const auto rooms_of = [&] {
    std::vector<std::string> names;
    for (const auto& room : knowledge_->Where({"Cup", "", "", 0}).rooms)
      names.push_back(room.place.iri);
    return names;
  };
  const auto before = rooms_of();
  PutAsEditor(
      DocumentKind::kOntology, "containers",
      std::string(kPrefixes) + "lares:Cupboard a owl:Class ; rdfs:subClassOf lares:Place .\n");
  EXPECT_EQ(rooms_of(), before);
}

TEST_F(KnowledgeTest, ATypeThatIsNoPlaceIsRefused) {
  store::NewVersion version;
  version.environment = "x";
  version.type_iri = "Cup";
  version.layers.push_back({"semantic", "m.ttl", "", PutBlob(CupMap("1.0")), {}});
  EXPECT_EQ(CodeOf([&] { knowledge_->PutVersion(version); }), Code::kInvalid);
  version.type_iri = "Kitchen";
  EXPECT_EQ(knowledge_->PutVersion(version).version.number, 1);
}

TEST_F(KnowledgeTest, ADocumentThatIsNoMapIsNoSemanticLayer) {
  EXPECT_EQ(CodeOf([&] { PutMap("flat", WalkRecipe("Walk", 2)); }), Code::kInvalid);
  const auto empty =
      PutMap("flat", std::string(kPrefixes) + ":m a lares:SemanticEnvironmentMap .\n");
  EXPECT_THAT(empty.warnings, ::testing::Contains(HasSubstr("no object")));
}

TEST_F(KnowledgeTest, AContradictionIsToldAsASentence) {
  try {
    Put(DocumentKind::kRobot, "rover",
        BaseOnlyRobot("rover") +
            ":Cat a owl:Class ; owl:disjointWith lares:MobileBase .\n"
            ":rover_base a :Cat .\n");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("which exclude each other"));
  }
}

TEST_F(KnowledgeTest, RelativeIrisOfADocumentWithoutBaseBelongToTheDocument) {
  std::string recipe = WalkRecipe("Walk", 1);
  recipe += "<> a owl:Ontology . <#Patrol> a owl:Class ; rdfs:subClassOf :Walk .\n";
  Put(DocumentKind::kRecipe, "walk", recipe);
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover"));
  EXPECT_TRUE(knowledge_->MakePlan({"Walk", "rover"}).result.plan);
}

TEST_F(KnowledgeTest, ADocumentWithoutRobotIsNoRobot) {
  EXPECT_EQ(
      CodeOf([&] { Put(DocumentKind::kRobot, "r", std::string(kPrefixes) + ":a :b :c .\n"); }),
      Code::kInvalid);
}

TEST_F(KnowledgeTest, WhatLacksIsNamedAndCapableRobotsAreListed) {
  Put(DocumentKind::kRecipe, "walk", WalkRecipe("Walk", 1));
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover"));
  Put(DocumentKind::kRobot, "statue",
      std::string(kPrefixes) +
          ":statue a lares:Robot ; lares:subComponent :eye .\n:eye a lares:Camera .\n");
  const auto answer = knowledge_->MakePlan({"walk", "statue"});
  EXPECT_FALSE(answer.result.plan);
  EXPECT_FALSE(answer.result.match.feasible);
  ASSERT_EQ(answer.result.match.smallest_repair.size(), 1U);
  EXPECT_EQ(answer.result.match.smallest_repair[0].iri, "https://w3id.org/lares#MobileBase");
  ASSERT_EQ(answer.capable_robots.size(), 1U);
  EXPECT_EQ(answer.capable_robots[0].label, "rover");
}

TEST_F(KnowledgeTest, RobotsAreRankedByTheSmallestChangeAndRankedAnewWhenTheyChange) {
  Put(DocumentKind::kRecipe, "walk", WalkRecipe("Walk", 1));
  const std::string bare = std::string(kPrefixes) +
                           ":statue a lares:Robot ; lares:subComponent :eye .\n"
                           ":eye a lares:Camera .\n";
  Put(DocumentKind::kRobot, "statue", bare);
  Put(DocumentKind::kRobot, "rover", BaseOnlyRobot("rover"));
  const auto ranked = [&] { return knowledge_->RankRobots({"Walk", "", 0, false}).robots; };
  ASSERT_EQ(ranked().size(), 2U);
  EXPECT_EQ(ranked()[0].document, "rover");
  EXPECT_TRUE(ranked()[0].ranked.feasible);
  EXPECT_EQ(ranked()[1].ranked.cost, 200);
  ASSERT_EQ(ranked()[1].ranked.repair.add.size(), 1U);
  EXPECT_EQ(ranked()[1].ranked.repair.add[0].what.iri, "https://w3id.org/lares#MobileBase");
  // Who was asked is not among those that nearly can.
  EXPECT_TRUE(knowledge_->MakePlan({"walk", "statue"}).nearest_robots.empty());
  Put(DocumentKind::kRobot, "bust", std::string(kPrefixes) + ":bust a lares:Robot .\n");
  const auto refused = knowledge_->MakePlan({"walk", "statue"});
  ASSERT_EQ(refused.nearest_robots.size(), 1U);
  EXPECT_EQ(refused.nearest_robots[0].document, "bust");
  knowledge_->Remove(DocumentKind::kRobot, "bust");

  Put(DocumentKind::kRobot, "statue", bare + ":statue lares:subComponent :b . :b a lares:Base .\n");
  EXPECT_FALSE(ranked()[1].ranked.feasible) << "a base of its own version, yet none that moves";
  Put(DocumentKind::kRobot, "statue",
      bare + ":statue lares:subComponent :b . :b a lares:MobileBase .\n");
  EXPECT_TRUE(ranked()[1].ranked.feasible);
  EXPECT_EQ(CodeOf([&] {
              knowledge_->RankRobots({"Walk", "nowhere", 0, false});
            }),
            Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { knowledge_->RankRobots({"Fly", "", 0, false}); }), Code::kNotFound);
}

TEST_F(KnowledgeTest, AStoredModelIsOnOfferToARobotThatLacksOne) {
  const std::string search =
      std::string(kPrefixes) +
      ":Search a owl:Class ; rdfs:subClassOf lares:PurposefulAction ,\n"
      "  [ a owl:Restriction ; owl:onProperty lares:subAction ; owl:someValuesFrom :look ] .\n"
      ":look a owl:Class ; rdfs:subClassOf lares:Perceiving ,\n"
      "  [ a owl:Restriction ; owl:onProperty lares:dependsOnCapability ;\n"
      "    owl:someValuesFrom lares:ObjectRecognitionCapability ] ,\n"
      "  [ a owl:Restriction ; owl:onProperty lares:detectedObject ;\n"
      "    owl:someValuesFrom lares:Bottle ] .\n";
  Put(DocumentKind::kRecipe, "search", search);
  Put(DocumentKind::kRobot, "rover",
      std::string(kPrefixes) +
          ":rover a lares:Robot ; lares:subComponent :see .\n"
          ":see a lares:ObjectRecognitionComponent .\n");
  const auto ranked = [&] { return knowledge_->RankRobots({"search", "", 0, false}).robots.at(0); };
  EXPECT_FALSE(ranked().ranked.feasible);
  Put(DocumentKind::kObjectModel, "cup",
      std::string(kPrefixes) +
          ":m a lares:PlanarObjectModel ; lares:providesModelFor lares:Cup .\n");
  EXPECT_FALSE(ranked().ranked.feasible) << "a model of something else";
  Put(DocumentKind::kObjectModel, "bottle",
      std::string(kPrefixes) +
          ":b a lares:PlanarObjectModel ; lares:providesModelFor lares:DrinkingBottle .\n");
  EXPECT_TRUE(ranked().ranked.feasible);
  ASSERT_EQ(ranked().ranked.downloads.size(), 1U);
  EXPECT_DOUBLE_EQ(ranked().ranked.cost.value(), 0.1);
  const auto match = knowledge_->MakePlan({"search", "rover"}).result.match;
  ASSERT_EQ(match.downloads.size(), 1U);
  EXPECT_EQ(match.downloads[0].offer.document, "object-model:bottle");
  EXPECT_EQ(match.downloads[0].offer.sha256.size(), 64U);
}

TEST_F(KnowledgeTest, AbsentImportsAreWarningsAndNothingIsFetched) {
  const auto answer =
      Put(DocumentKind::kRobot, "rover",
          BaseOnlyRobot("rover") +
              "<http://example.org/test> a owl:Ontology ; owl:imports "
              "<http://192.0.2.1/other.owl> , <http://ias.cs.tum.edu/kb/srdl2-comp.owl> .\n");
  ASSERT_EQ(answer.warnings.size(), 1U);
  EXPECT_THAT(answer.warnings[0], HasSubstr("192.0.2.1/other.owl"));
}

TEST_F(KnowledgeTest, AnOntologyDocumentChangesAnswersUntilItIsRemoved) {
  const std::string module =
      std::string(kPrefixes) + ":Gobbet a owl:Class ; rdfs:subClassOf lares:Cup .\n";
  EXPECT_EQ(CodeOf([&] { knowledge_->ResolveClass("Gobbet"); }), Code::kNotFound);
  Put(DocumentKind::kOntology, "gobbets", module);
  EXPECT_EQ(knowledge_->ResolveClass("Gobbet").iri, "http://example.org/test#Gobbet");
  Open();
  EXPECT_EQ(knowledge_->ResolveClass("gobbet").iri, "http://example.org/test#Gobbet");
  knowledge_->Remove(DocumentKind::kOntology, "gobbets");
  EXPECT_EQ(CodeOf([&] { knowledge_->ResolveClass("Gobbet"); }), Code::kNotFound);
}

TEST_F(KnowledgeTest, TwoEnvironmentsUnderTheSameIrisNeverMeet) {
  PutMap("left", CupMap("1.5"));
  PutMap("right", CupMap("-1.5"));
  for (const auto& [environment, x] : {std::pair{"left", 1.5}, std::pair{"right", -1.5}}) {
    const auto objects = knowledge_->MapObjects(environment, 0);
    ASSERT_EQ(objects.size(), 1U) << environment;
    ASSERT_TRUE(objects[0].map_from_object);
    EXPECT_NEAR(objects[0].map_from_object->translation_m.x(), x, 1e-9);
  }
}

TEST_F(KnowledgeTest, AMappedInstanceIsAnsweredAsSeenBesideTheRanking) {
  PutMap("flat", CupMap("1.5"));
  const auto answer = knowledge_->Where({"DrinkingVessel", "", "flat", 0});
  ASSERT_EQ(answer.seen.size(), 1U);
  EXPECT_EQ(answer.seen[0].object.iri, "http://example.org/test#cup1");
  EXPECT_NEAR(answer.seen[0].object.map_from_object->translation_m.y(), 2.0, 1e-9);
  EXPECT_TRUE(knowledge_->Where({"Bed", "", "flat", 0}).seen.empty());
}

TEST_F(KnowledgeTest, WithoutAPriorOurOwnTableAnswersAndIsNamed) {
  const auto answer = knowledge_->Where({"Cup", "", "", 0});
  EXPECT_EQ(answer.prior, "lares");
  ASSERT_FALSE(answer.rooms.empty());
  double sum = 0;
  for (const auto& room : answer.rooms) sum += room.probability;
  EXPECT_NEAR(sum, 1.0, 1e-6);
  EXPECT_GE(answer.rooms.front().probability, answer.rooms.back().probability);
}

TEST_F(KnowledgeTest, NanInAMapIsRefusedAndTheEnvironmentIsNotMade) {
  EXPECT_EQ(CodeOf([&] { PutMap("flat", CupMap("\"NaN\"^^xsd:double")); }), Code::kInvalid);
  EXPECT_FALSE(store_->FindEnvironment("flat").has_value());
}

TEST_F(KnowledgeTest, AnUnknownTypeOfPlaceIsRefused) {
  store::NewVersion version;
  version.environment = "x";
  version.type_iri = "Kitchn";
  version.layers.push_back({"semantic", "m.ttl", "", PutBlob(CupMap("1.0")), {}});
  EXPECT_EQ(CodeOf([&] { knowledge_->PutVersion(version); }), Code::kNotFound);
}

TEST_F(KnowledgeTest, RenderingsHoldTheSameObjects) {
  PutMap("flat", CupMap("1.5"));
  const std::string xml = knowledge_->RenderSemantic("flat", 0, rdf::Format::kRdfXml);
  EXPECT_THAT(xml, HasSubstr("<?xml"));
  PutMap("again", xml, "map.owl");
  EXPECT_EQ(knowledge_->MapObjects("again", 0).size(), 1U);
}

TEST_F(KnowledgeTest, ObjectModelsAreFoundByTheirClassAndItsSuperclasses) {
  Put(DocumentKind::kObjectModel, "my-cup",
      std::string(kPrefixes) +
          ":model a lares:ObjectRecognitionModel ; lares:providesModelFor lares:Cup .\n");
  EXPECT_EQ(knowledge_->ObjectModels({"Cup", "", "", "", ""}).size(), 1U);
  EXPECT_EQ(knowledge_->ObjectModels({"DrinkingVessel", "", "", "", ""}).size(), 1U);
  EXPECT_EQ(knowledge_->ObjectModels({"Bed", "", "", "", ""}).size(), 0U);
  EXPECT_EQ(knowledge_->ObjectModels({"", "", "", "", ""}).size(), 1U);
}

TEST_F(KnowledgeTest, RoboEarthMapsOfOneRoomStayApart) {
  LARES_REQUIRE_DATA(maps, "roboearth/maps");
  const std::string plain = ReadFile(maps / "ias_hospital_room.owl");
  PutMap("plain", plain, "ias_hospital_room.owl");
  PutMap("objects", ReadFile(maps / "ias_hospital_room_with_objects.owl"), "with_objects.owl");
  const auto bottles = knowledge_->Where({"Bottle", "", "plain", 0}).seen;
  ASSERT_EQ(bottles.size(), 1U);
  EXPECT_THAT(bottles[0].object.iri, HasSubstr("bottle1"));
  EXPECT_EQ(store_->ReadBlob(store_->GetVersion("plain", 1).layers[0].blob.sha256), plain);
}

}  // namespace
}  // namespace lares::testing
