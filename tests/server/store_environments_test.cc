#include <gmock/gmock.h>

#include "base/hash.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class EnvironmentTest : public StoreTest {
 protected:
  static std::vector<std::string> Contents(const EnvironmentVersion& version) {
    std::vector<std::string> contents;
    for (const LayerInfo& layer : version.layers) {
      contents.push_back(layer.name + "=" + layer.blob.sha256.substr(0, 8));
    }
    return contents;
  }
  static std::string Entry(const std::string& name, const std::string& bytes) {
    return name + "=" + Sha256Hex(bytes).substr(0, 8);
  }
};

TEST_F(EnvironmentTest, FirstVersionCreatesTheEnvironmentWithEveryField) {
  NewVersion version = Version("ward", {Layer("semantic", PutBlob("rdf"))});
  version.type_iri = "https://w3id.org/lares#HospitalRoom";
  version.label = "Zimmer «3»";
  version.author = "Ada";
  version.note = "first walk";
  version.layers[0].facts = {{"objects", "12"}, {"größe", "2 × 3"}};
  const EnvironmentVersion put = store_->PutVersion(version);
  EXPECT_EQ(put.number, 1);
  Reopen();

  const auto info = store_->FindEnvironment("ward");
  ASSERT_TRUE(info);
  EXPECT_EQ(info->id, "ward");
  EXPECT_EQ(info->type_iri, version.type_iri);
  EXPECT_EQ(info->label, version.label);
  EXPECT_EQ(info->created, put.created);
  EXPECT_EQ(info->latest, 1);

  const EnvironmentVersion got = store_->GetVersion("ward", 1);
  EXPECT_EQ(got.environment, "ward");
  EXPECT_EQ(got.number, 1);
  EXPECT_EQ(got.created, put.created);
  EXPECT_EQ(got.author, "Ada");
  EXPECT_EQ(got.note, "first walk");
  EXPECT_EQ(got.etag(), put.etag());
  EXPECT_THAT(got.changed_layers, ElementsAre("semantic"));
  ASSERT_EQ(got.layers.size(), 1U);
  EXPECT_EQ(got.layers[0].file_name, "semantic.dat");
  EXPECT_EQ(got.layers[0].media_type, "application/octet-stream");
  EXPECT_EQ(got.layers[0].blob.sha256, Sha256Hex("rdf"));
  EXPECT_EQ(got.layers[0].blob.size, 3U);
  EXPECT_EQ(got.layers[0].facts, version.layers[0].facts);
}

TEST_F(EnvironmentTest, UnchangedLayersAreCarriedOver) {
  store_->PutVersion(
      Version("e", {Layer("semantic", PutBlob("s1")), Layer("grid", PutBlob("g1"))}));
  const EnvironmentVersion two = store_->PutVersion(
      Version("e", {Layer("semantic", PutBlob("s2")), Layer("octomap", PutBlob("o2"))}));
  EXPECT_EQ(two.number, 2);
  EXPECT_THAT(Contents(two),
              ElementsAre(Entry("grid", "g1"), Entry("octomap", "o2"), Entry("semantic", "s2")));
  EXPECT_THAT(two.changed_layers, ElementsAre("octomap", "semantic"));
  EXPECT_THAT(Contents(store_->GetVersion("e", 1)),
              ElementsAre(Entry("grid", "g1"), Entry("semantic", "s1")));
  EXPECT_EQ(store_->GetVersion("e", 2).layers[0].facts.at("made-by"), "test");
}

TEST_F(EnvironmentTest, LayersCanBeRemovedButNotTheLast) {
  store_->PutVersion(Version("e", {Layer("a", PutBlob("1")), Layer("b", PutBlob("2"))}));
  NewVersion without_a = Version("e", {});
  without_a.removed_layers = {"a"};
  const EnvironmentVersion two = store_->PutVersion(without_a);
  EXPECT_THAT(Contents(two), ElementsAre(Entry("b", "2")));
  EXPECT_THAT(store_->GetVersion("e", 2).changed_layers, ElementsAre("a"));
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(without_a); }), Code::kInvalid);
  NewVersion without_any = Version("e", {});
  without_any.removed_layers = {"b"};
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(without_any); }), Code::kInvalid);
  EXPECT_EQ(store_->FindEnvironment("e")->latest, 2);
}

TEST_F(EnvironmentTest, ALayerGivenAsItStandsIsNotChanged) {
  store_->PutVersion(Version("e", {Layer("a", PutBlob("1")), Layer("b", PutBlob("2"))}));
  const EnvironmentVersion two =
      store_->PutVersion(Version("e", {Layer("a", PutBlob("1")), Layer("b", PutBlob("3"))}));
  EXPECT_THAT(two.changed_layers, ElementsAre("b"));
}

TEST_F(EnvironmentTest, TypeAndLabelStayUnlessGiven) {
  NewVersion version = Version("e", {Layer("a", PutBlob("1"))});
  version.type_iri = "t1";
  version.label = "l1";
  const Time created = store_->PutVersion(version).created;
  version.type_iri = "";
  version.label = "l2";
  store_->PutVersion(version);
  EXPECT_EQ(store_->FindEnvironment("e")->type_iri, "t1");
  EXPECT_EQ(store_->FindEnvironment("e")->label, "l2");
  EXPECT_EQ(store_->FindEnvironment("e")->created, created);
  EXPECT_EQ(store_->GetVersion("e", 1).label, "l1");
  EXPECT_EQ(store_->GetVersion("e", 2).label, "l2");
  EXPECT_EQ(store_->GetVersion("e", 2).type_iri, "t1");
  EXPECT_EQ(store_->Log("e").back().label, "l1");
}

TEST_F(EnvironmentTest, LogIsNewestFirstAndVersionZeroTheLatest) {
  for (const char* bytes : {"1", "2", "3"}) {
    store_->PutVersion(Version("e", {Layer("a", PutBlob(bytes)), Layer("b", PutBlob("b"))}));
  }
  store_->PutVersion(Version("other", {Layer("a", PutBlob("x"))}));
  const std::vector<EnvironmentVersion> log = store_->Log("e");
  ASSERT_EQ(log.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(log[i].number, 3 - i);
    EXPECT_THAT(Contents(log[i]), ElementsAre(Entry("a", std::to_string(3 - i)), Entry("b", "b")));
  }
  EXPECT_EQ(store_->GetVersion("e", 0).number, 3);
}

TEST_F(EnvironmentTest, ListIsById) {
  for (const char* id : {"b", "c", "a"}) store_->PutVersion(Version(id, {Layer("x", PutBlob(id))}));
  EXPECT_THAT(IdsOf(store_->ListEnvironments()), ElementsAre("a", "b", "c"));
}

TEST_F(EnvironmentTest, ConditionsHoldForEnvironmentsToo) {
  const std::vector<LayerInfo> layers = {Layer("a", PutBlob("1"))};
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(Version("e", layers, "*")); }),
            Code::kPreconditionFailed);
  const EnvironmentVersion one = store_->PutVersion(Version("e", layers, "none"));
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(Version("e", layers, "none")); }),
            Code::kPreconditionFailed);
  const EnvironmentVersion two = store_->PutVersion(Version("e", layers, one.etag()));
  const Error error = ErrorOf([&] { store_->PutVersion(Version("e", layers, one.etag())); });
  EXPECT_EQ(error.code(), Code::kPreconditionFailed);
  EXPECT_THAT(error.what(), HasSubstr(two.etag()));
  EXPECT_EQ(store_->PutVersion(Version("e", layers, "*")).number, 3);
}

TEST_F(EnvironmentTest, AbsentBlobIsRefusedAndNothingIsCreated) {
  const Blob absent{Sha256Hex("never put"), 9};
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(Version("e", {Layer("a", absent)})); }),
            Code::kNotFound);
  EXPECT_FALSE(store_->FindEnvironment("e"));
}

TEST_F(EnvironmentTest, SizeIsTakenFromTheFile) {
  Blob blob = PutBlob("12345");
  blob.size = 0;
  EXPECT_EQ(store_->PutVersion(Version("e", {Layer("a", blob)})).layers[0].blob.size, 5U);
}

TEST_F(EnvironmentTest, WhatCannotBeStoredIsInvalid) {
  const Blob blob = PutBlob("1");
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(Version("e", {})); }), Code::kInvalid);
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(Version("../e", {Layer("a", blob)})); }),
            Code::kInvalid);
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(Version("e", {Layer("a b", blob)})); }),
            Code::kInvalid);
  EXPECT_EQ(CodeOf([&] {
              store_->PutVersion(Version("e", {Layer("a", blob), Layer("a", blob)}));
            }),
            Code::kInvalid);
  NewVersion both = Version("e", {Layer("a", blob)});
  both.removed_layers = {"a"};
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(both); }), Code::kInvalid);
  NewVersion note = Version("e", {Layer("a", blob)});
  note.note = "\xff";
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(note); }), Code::kInvalid);
  NewVersion fact = Version("e", {Layer("a", blob)});
  fact.layers[0].facts["x"] = "\xff";
  EXPECT_EQ(CodeOf([&] { store_->PutVersion(fact); }), Code::kInvalid);
  EXPECT_THAT(store_->ListEnvironments(), IsEmpty());
}

TEST_F(EnvironmentTest, UnknownEnvironmentsAndVersionsAreNotFound) {
  store_->PutVersion(Version("e", {Layer("a", PutBlob("1"))}));
  EXPECT_FALSE(store_->FindEnvironment("f"));
  EXPECT_EQ(CodeOf([&] { store_->GetVersion("f", 0); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->GetVersion("e", 2); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->GetVersion("e", -1); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->Log("f"); }), Code::kNotFound);
}

}  // namespace
}  // namespace lares::store::testing
