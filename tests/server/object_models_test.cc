// Object models in full: what is kept of them, how they are found, which are typical of a room.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/lares_data.h"
#include "tests/server/knowledge_fixture.h"

namespace lares::testing {
namespace {

using server::ObjectModelInfo;
using server::ObjectModelQuery;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

std::string Lares(const std::string& local) { return "https://w3id.org/lares#" + local; }

std::string Ply(const std::string& points, int count) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) +
         "\nproperty float x\nproperty float y\nproperty float z\nend_header\n" + points;
}

class ObjectModelsTest : public KnowledgeFixture {
 protected:
  // `more`: Turtle after "providesModelFor lares:Class".
  server::PutAnswer PutModel(const std::string& id, const std::string& of,
                             const std::string& more = "",
                             const std::vector<std::pair<std::string, std::string>>& files = {}) {
    server::PutRequest request;
    request.kind = store::DocumentKind::kObjectModel;
    request.id = id;
    request.file_name = id + ".ttl";
    request.bytes = std::string(kPrefixes) + ":" + id +
                    " a lares:ObjectRecognitionModel ; lares:providesModelFor " + of + " " + more +
                    " .\n";
    for (const auto& [name, bytes] : files) {
      request.files.push_back({name, "application/octet-stream", PutBlob(bytes)});
    }
    return knowledge_->Put(request);
  }
  server::PutAnswer PutRoboEarth(const std::filesystem::path& file) {
    return PutFile(store::DocumentKind::kObjectModel, file);
  }
  std::vector<std::string> Found(const ObjectModelQuery& query) {
    std::vector<std::string> ids;
    for (const ObjectModelInfo& info : knowledge_->ObjectModels(query)) {
      ids.push_back(info.document.id);
    }
    return ids;
  }
  std::vector<std::string> OfClass(const std::string& name) {
    return Found({name, "", "", "", ""});
  }
  ObjectModelInfo Only() {
    const auto all = knowledge_->ObjectModels({});
    EXPECT_EQ(all.size(), 1U);
    return all.at(0);
  }
  std::string Refused(const std::function<void()>& put) {
    try {
      put();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Code::kInvalid);
      EXPECT_THAT(knowledge_->ObjectModels({}), IsEmpty());
      return error.FullMessage();
    }
    ADD_FAILURE() << "was taken";
    return "";
  }
};

std::vector<std::string> Ids(const std::vector<server::TypicalAnswer::Model>& models) {
  std::vector<std::string> ids;
  for (const auto& model : models) ids.push_back(model.info.document.id);
  return ids;
}

TEST_F(ObjectModelsTest, AClassFindsWhatIsBelowItAndMoreGeneralModels) {
  PutModel("bottle", "lares:Bottle");
  PutModel("bed", "lares:Bed");
  EXPECT_THAT(OfClass("Container"), ElementsAre("bottle"));
  EXPECT_THAT(OfClass("Bottle"), ElementsAre("bottle"));
  EXPECT_THAT(OfClass("WineBottle"), ElementsAre("bottle"));
  EXPECT_THAT(OfClass("Cup"), IsEmpty());
  EXPECT_EQ(knowledge_->ObjectModels({"Bottle", "", "", "", ""})[0].fit,
            ObjectModelInfo::Fit::kSame);
  EXPECT_EQ(knowledge_->ObjectModels({"Container", "", "", "", ""})[0].fit,
            ObjectModelInfo::Fit::kKindOf);
  EXPECT_EQ(knowledge_->ObjectModels({"WineBottle", "", "", "", ""})[0].fit,
            ObjectModelInfo::Fit::kMoreGeneral);
  EXPECT_THROW(OfClass("Nonsense"), Error);
}

TEST_F(ObjectModelsTest, AClassOfTheDescriptionsOwnIsFoundByWhatItPutsItUnder) {
  PutModel("crate", ":OurCrate",
           ". :OurCrate a owl:Class ; rdfs:subClassOf :Crate . :Crate a owl:Class ; "
           "rdfs:subClassOf lares:Bottle");
  EXPECT_THAT(OfClass("Bottle"), ElementsAre("crate"));
  EXPECT_THAT(OfClass("Container"), ElementsAre("crate"));
  EXPECT_THAT(OfClass("WineBottle"), IsEmpty());
  Open();
  EXPECT_THAT(OfClass("Container"), ElementsAre("crate"));
}

TEST_F(ObjectModelsTest, MakersAlgorithmsAndKindsFindModels) {
  PutModel("a", "lares:Cup",
           "; a lares:PlanarObjectModel ; lares:createdBy :lab ; lares:createdByAlgorithm "
           "lares:SURFbasedObjectRecognition . :lab rdfs:label \"The Vision Lab\"");
  PutModel("b", "lares:Cup",
           "; <http://purl.org/dc/terms/creator> \"Ada\" ; "
           "lares:forAlgorithm \"ORBbasedObjectRecognition\"");
  EXPECT_THAT(Found({"", "", "vision lab", "", ""}), ElementsAre("a"));
  EXPECT_THAT(Found({"", "", "http://example.org/test#lab", "", ""}), ElementsAre("a"));
  EXPECT_THAT(Found({"", "", "lab", "", ""}), ElementsAre("a"));
  EXPECT_THAT(Found({"", "", "ada", "", ""}), ElementsAre("b"));
  EXPECT_THAT(Found({"", "", "Nobody", "", ""}), IsEmpty());
  EXPECT_THAT(Found({"", "", "", "SURFbasedObjectRecognition", ""}), ElementsAre("a"));
  EXPECT_THAT(Found({"", "", "", "ORBbasedObjectRecognition", ""}), ElementsAre("b"));
  EXPECT_THAT(Found({"", "", "", "ImageFeatureBasedObjectRecognition", ""}), ElementsAre("a", "b"));
  EXPECT_THAT(Found({"", "", "", "", "PlanarObjectModel"}), ElementsAre("a"));
  EXPECT_THAT(Found({"", "", "", "", "ObjectRecognitionModel"}), ElementsAre("a", "b"));
  EXPECT_THAT(Found({"Cup", "", "Ada", "", "ObjectRecognitionModel"}), ElementsAre("b"));
}

TEST_F(ObjectModelsTest, ARoomFindsWhatIsTypicalOfIt) {
  PutModel("bed", "lares:Bed");
  PutModel("skillet", "lares:Skillet");
  const auto found = knowledge_->ObjectModels({"", "HospitalRoom", "", "", ""});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].document.id, "bed");
  EXPECT_GT(*found[0].probability, 0.05);
  EXPECT_THAT(found[0].why, HasSubstr("hospital room"));
  EXPECT_THAT(Found({"", "Kitchen", "", "", ""}), ElementsAre("skillet"));
  EXPECT_THROW(Found({"", "Bed", "", "", ""}), Error);  // no kind of place
}

TEST_F(ObjectModelsTest, SizesComeFromTheDescriptionThenTheFiles) {
  PutModel("box", "lares:Cup", "", {{"shape.ply", Ply("0 0 0\n0.5 1 2\n", 2)}});
  ObjectModelInfo info = Only();
  ASSERT_TRUE(info.extents);
  EXPECT_THAT(info.extents->size_m, ElementsAre(0.5, 1, 2));
  EXPECT_EQ(info.extents->from, "the points of shape.ply");
  // The files of the version before stay, and what is known of them.
  PutModel("box", "lares:Cup", "; lares:roboearthObjID \"box.1\"");
  info = Only();
  EXPECT_EQ(info.document.version, 2);
  ASSERT_EQ(info.files.size(), 1U);
  EXPECT_THAT(info.extents->size_m, ElementsAre(0.5, 1, 2));
  EXPECT_EQ(info.size_bytes, info.document.blob.size + info.files[0].blob.size);
  PutModel("box", "lares:Cup",
           "; lares:widthOfObject 0.1 ; lares:heightOfObject 0.2 ; lares:depthOfObject 0.3");
  EXPECT_THAT(Only().extents->size_m, ElementsAre(0.1, 0.2, 0.3));
  EXPECT_TRUE(Only().extents->axes_known);
}

TEST_F(ObjectModelsTest, FaultyModelsAreRefusedAndNothingIsKept) {
  EXPECT_THAT(Refused([&] {
                PutModel("a", "lares:Cup", "", {{"face.ply", "not ply"}});
              }),
              HasSubstr("face.ply"));
  EXPECT_THAT(Refused([&] {
                PutModel("a", "lares:Cup", "", {{"meta.xml", "<model><name>"}});
              }),
              HasSubstr("meta.xml:1"));
  EXPECT_THAT(Refused([&] { PutModel("a", "lares:Cup", "; lares:widthOfObject \"wide\""); }),
              HasSubstr("widthOfObject"));
  EXPECT_THAT(Refused([&] { PutModel("a", "lares:Cup", "; lares:widthOfObject -1"); }),
              HasSubstr("less than nothing"));
  EXPECT_THAT(Refused([&] { PutModel("a", "\"a cup\""); }), HasSubstr("for a text"));
}

TEST_F(ObjectModelsTest, TypicalModelsOfARoomForARobot) {
  PutModel("bed", "lares:Bed", "; lares:createdByAlgorithm lares:SURFbasedObjectRecognition");
  PutModel("cabinet", "lares:Cabinet");
  PutModel("skillet", "lares:Skillet");
  server::TypicalRequest request;
  request.room = "hospital room";
  const auto any = knowledge_->TypicalModels(request);
  EXPECT_EQ(any.room.iri, Lares("HospitalRoom"));
  EXPECT_EQ(any.prior, "lares");
  EXPECT_THAT(Ids(any.loaded), ElementsAre("bed", "cabinet"));
  EXPECT_THAT(Ids(any.left_out), ElementsAre("skillet"));
  EXPECT_EQ(any.loaded[0].of.iri, Lares("Bed"));
  EXPECT_EQ(any.size_bytes, any.loaded[0].info.size_bytes + any.loaded[1].info.size_bytes);

  Put(store::DocumentKind::kRobot, "seer",
      BaseOnlyRobot("seer") +
          ":seer lares:subComponent :eye . :eye a lares:ORBbasedObjectRecognition .\n");
  request.robot = "seer";
  const auto seer = knowledge_->TypicalModels(request);
  EXPECT_THAT(Ids(seer.loaded), ElementsAre("cabinet"));
  ASSERT_THAT(Ids(seer.left_out), ElementsAre("bed", "skillet"));
  EXPECT_THAT(seer.left_out[0].choice.why, HasSubstr("seer has no SURF object recognition"));

  request.robot = "";
  request.max_models = 1;
  EXPECT_THAT(Ids(knowledge_->TypicalModels(request).loaded), ElementsAre("bed"));
  request.room = "Cup";
  EXPECT_THROW(knowledge_->TypicalModels(request), Error);
  request.room = "HospitalRoom";
  request.robot = "nobody";
  EXPECT_THROW(knowledge_->TypicalModels(request), Error);
}

TEST_F(ObjectModelsTest, AnImportedTableAnswersInsteadOfOurs) {
  PutModel("bed", "lares:Bed");
  PutModel("cup", "lares:Cup");
  server::PutRequest prior;
  prior.kind = store::DocumentKind::kPrior;
  prior.id = "ward";
  prior.file_name = "ward.tsv";
  prior.prior_format = "tsv";
  prior.bytes = "Cup\tHospitalRoom\t3\tcounted\n";
  knowledge_->Put(prior);
  server::TypicalRequest request;
  request.room = "HospitalRoom";
  request.prior = "ward";
  const auto answer = knowledge_->TypicalModels(request);
  EXPECT_THAT(Ids(answer.loaded), ElementsAre("cup"));
  EXPECT_THAT(answer.loaded[0].choice.probability, DoubleNear(1, 1e-9));
}

TEST_F(ObjectModelsTest, RoboEarthsModelsAreUnderstoodAsTheyAre) {
  LARES_REQUIRE_DATA(objects, "roboearth/objects");
  PutRoboEarth(objects / "cabinet_model.owl");
  PutRoboEarth(objects / "object_model.owl");
  EXPECT_THAT(OfClass("Cabinet"), ElementsAre("cabinet_model"));
  EXPECT_THAT(OfClass("Cup"), ElementsAre("object_model"));
  EXPECT_THAT(OfClass("Plate"), ElementsAre("object_model"));
  EXPECT_THAT(Found({"", "", "", "RoboEarthObjRecSystem", "PlanarObjectModel"}),
              ElementsAre("cabinet_model", "object_model"));
  const ObjectModelInfo cup = knowledge_->ObjectModels({"Cup", "", "", "", ""})[0];
  EXPECT_EQ(cup.created, "2010-07-08T14:39:00+02:00");
  ASSERT_TRUE(cup.extents);
  EXPECT_THAT(cup.extents->size_m, ElementsAre(0.052, 0.072, 0.052));
  EXPECT_EQ(cup.extents->from, "its description");
  server::TypicalRequest request;
  request.room = "HospitalRoom";
  request.min_probability = 0.005;
  EXPECT_THAT(Ids(knowledge_->TypicalModels(request).loaded),
              UnorderedElementsAre("cabinet_model", "object_model"));
}

}  // namespace
}  // namespace lares::testing
