#include <gmock/gmock.h>

#include "base/hash.h"
#include "tests/server/store_fixture.h"

namespace lares::store::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr DocumentKind kRecipe = DocumentKind::kRecipe;

class DocumentTest : public StoreTest {
 protected:
  std::string BytesOf(const DocumentInfo& info) { return store_->ReadBlob(info.blob.sha256); }
  std::vector<std::string> Answering(const std::string& text, DocumentKind kind = kRecipe) {
    std::vector<std::string> found;
    for (const auto& [document, name] : store_->FindByName(kind, text)) {
      found.push_back(document.id + ":" + std::to_string(document.version) + ">" + name.target);
    }
    return found;
  }
};

NewDocument Named(const std::string& id, const std::string& bytes,
                  std::vector<DocumentName> names) {
  NewDocument document = Recipe(id, bytes);
  document.names = std::move(names);
  return document;
}

TEST_F(DocumentTest, EveryFieldComesBackAfterReopening) {
  NewDocument document = Named("search", std::string("a\0b", 3),
                               {{"http://x#Search", "iri", "http://x#Search"},
                                {"Suche \"überall\"", "label", "http://x#Search"}});
  document.details_json = R"({"tasks": ["größer", 3]})";
  const Time before = Now();
  const DocumentInfo put = store_->PutDocument(document);
  Reopen();
  const auto found = store_->FindDocument(kRecipe, "search");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, kRecipe);
  EXPECT_EQ(found->id, "search");
  EXPECT_EQ(found->version, 1);
  EXPECT_EQ(found->media_type, "text/turtle");
  EXPECT_EQ(found->file_name, "search.ttl");
  EXPECT_EQ(found->blob.sha256, Sha256Hex(document.bytes));
  EXPECT_EQ(found->blob.size, 3U);
  EXPECT_EQ(BytesOf(*found), document.bytes);
  EXPECT_EQ(found->details_json, document.details_json);
  EXPECT_GE(found->received, before);
  EXPECT_EQ(found->received, put.received);
  ASSERT_EQ(found->names.size(), 2U);
  EXPECT_EQ(found->names[1].text, "Suche \"überall\"");
  EXPECT_EQ(found->names[1].kind, "label");
  EXPECT_EQ(found->names[1].target, "http://x#Search");
  EXPECT_EQ(found->etag(), put.etag());
}

TEST_F(DocumentTest, EachPutAddsAVersionAndAllStayReadable) {
  EXPECT_EQ(store_->PutDocument(Recipe("a", "one")).version, 1);
  EXPECT_EQ(store_->PutDocument(Recipe("a", "two")).version, 2);
  EXPECT_EQ(store_->PutDocument(Recipe("a", "one")).version, 3);
  EXPECT_EQ(BytesOf(store_->GetDocument(kRecipe, "a", 1)), "one");
  EXPECT_EQ(BytesOf(store_->GetDocument(kRecipe, "a", 2)), "two");
  EXPECT_EQ(store_->GetDocument(kRecipe, "a", 0).version, 3);
  const std::vector<DocumentInfo> log = store_->DocumentLog(kRecipe, "a");
  ASSERT_EQ(log.size(), 3U);
  EXPECT_EQ(log[0].version, 3);
  EXPECT_EQ(log[2].version, 1);
}

TEST_F(DocumentTest, RepeatingAPutChangesNothing) {
  const DocumentInfo first = store_->PutDocument(Recipe("a", "one"));
  NewDocument again = Recipe("a", "one");
  again.details_json = R"({"other": 1})";
  again.names = {{"other", "label", "x"}};
  const DocumentInfo second = store_->PutDocument(again);
  EXPECT_EQ(second.version, 1);
  EXPECT_EQ(second.received, first.received);
  EXPECT_EQ(second.details_json, "{}");
  EXPECT_THAT(Answering("other"), IsEmpty());

  again.file_name = "renamed.ttl";
  EXPECT_EQ(store_->PutDocument(again).version, 2);
  again.media_type = "application/rdf+xml";
  EXPECT_EQ(store_->PutDocument(again).version, 3);
}

TEST_F(DocumentTest, KindsHaveIdsOfTheirOwn) {
  NewDocument robot = Recipe("a", "robot");
  robot.kind = DocumentKind::kRobot;
  store_->PutDocument(Recipe("a", "recipe"));
  EXPECT_EQ(store_->PutDocument(robot).version, 1);
  EXPECT_EQ(BytesOf(*store_->FindDocument(DocumentKind::kRobot, "a")), "robot");
  EXPECT_EQ(BytesOf(*store_->FindDocument(kRecipe, "a")), "recipe");
  EXPECT_FALSE(store_->FindDocument(DocumentKind::kOntology, "a"));
}

TEST_F(DocumentTest, ListHasTheNewestVersionsById) {
  store_->PutDocument(Recipe("b", "1"));
  store_->PutDocument(Named("a", "1", {{"old", "label", "t"}}));
  store_->PutDocument(Named("a", "2", {{"n1", "label", "t"}, {"n2", "local", "t"}}));
  store_->PutDocument(Named("c", "3", {{"n3", "label", "t"}}));
  const std::vector<DocumentInfo> list = store_->ListDocuments(kRecipe);
  EXPECT_THAT(IdsOf(list), ElementsAre("a", "b", "c"));
  EXPECT_EQ(list[0].version, 2);
  ASSERT_EQ(list[0].names.size(), 2U);
  EXPECT_EQ(list[0].names[0].text, "n1");
  EXPECT_THAT(list[1].names, IsEmpty());
  EXPECT_EQ(list[2].names[0].text, "n3");
}

TEST_F(DocumentTest, DeletedDocumentDisappearsButItsVersionsStay) {
  store_->PutDocument(Named("a", "one", {{"thing", "label", "t"}}));
  store_->DeleteDocument(kRecipe, "a");
  EXPECT_FALSE(store_->FindDocument(kRecipe, "a"));
  EXPECT_THAT(store_->ListDocuments(kRecipe), IsEmpty());
  EXPECT_THAT(Answering("thing"), IsEmpty());
  EXPECT_EQ(BytesOf(store_->GetDocument(kRecipe, "a", 1)), "one");
  EXPECT_EQ(store_->DocumentLog(kRecipe, "a").size(), 1U);
  EXPECT_EQ(CodeOf([&] { store_->DeleteDocument(kRecipe, "a"); }), Code::kNotFound);
}

TEST_F(DocumentTest, PutAfterDeletionContinuesTheNumbers) {
  store_->PutDocument(Recipe("a", "one"));
  store_->DeleteDocument(kRecipe, "a");
  EXPECT_EQ(store_->PutDocument(Recipe("a", "one")).version, 2);
  EXPECT_TRUE(store_->FindDocument(kRecipe, "a"));
  EXPECT_EQ(store_->DocumentLog(kRecipe, "a").size(), 2U);
}

TEST_F(DocumentTest, NamesAreFoundInNewestVersionsOnly) {
  store_->PutDocument(Named("a", "1", {{"Old", "label", "t1"}}));
  store_->PutDocument(Named("a", "2", {{"New", "label", "t2"}}));
  EXPECT_THAT(Answering("Old"), IsEmpty());
  EXPECT_THAT(Answering("New"), ElementsAre("a:2>t2"));
}

TEST_F(DocumentTest, LabelsAndLocalsIgnoreCaseButIrisDoNot) {
  store_->PutDocument(Named("a", "1",
                            {{"http://x#FindBottle", "iri", "1"},
                             {"FindBottle", "local", "2"},
                             {"Find a Bottle", "label", "3"}}));
  EXPECT_THAT(Answering("http://x#FindBottle"), ElementsAre("a:1>1"));
  EXPECT_THAT(Answering("HTTP://x#findbottle"), IsEmpty());
  EXPECT_THAT(Answering("findbottle"), ElementsAre("a:1>2"));
  EXPECT_THAT(Answering("FIND A BOTTLE"), ElementsAre("a:1>3"));
  EXPECT_THAT(Answering("find a"), IsEmpty());
  EXPECT_THAT(Answering("%"), IsEmpty());
}

TEST_F(DocumentTest, OneNameMayLeadToSeveralDocumentsOfItsKind) {
  store_->PutDocument(Named("b", "1", {{"x", "label", "tb"}}));
  store_->PutDocument(Named("a", "2", {{"X", "label", "ta"}, {"x", "local", "tl"}}));
  NewDocument robot = Named("r", "3", {{"x", "label", "tr"}});
  robot.kind = DocumentKind::kRobot;
  store_->PutDocument(robot);
  EXPECT_THAT(Answering("x"), ElementsAre("a:1>ta", "a:1>tl", "b:1>tb"));
  EXPECT_THAT(Answering("x", DocumentKind::kRobot), ElementsAre("r:1>tr"));
}

TEST_F(DocumentTest, EtagMustBeTheCurrentOne) {
  const DocumentInfo one = store_->PutDocument(Recipe("a", "one"));
  const DocumentInfo two = store_->PutDocument(Recipe("a", "two", one.etag()));
  const Error error = ErrorOf([&] { store_->PutDocument(Recipe("a", "three", one.etag())); });
  EXPECT_EQ(error.code(), Code::kPreconditionFailed);
  EXPECT_THAT(error.what(), HasSubstr(two.etag()));
  EXPECT_EQ(store_->FindDocument(kRecipe, "a")->version, 2);
}

TEST_F(DocumentTest, StarNeedsTheDocumentAndNoneItsAbsence) {
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(Recipe("a", "1", "*")); }), Code::kPreconditionFailed);
  EXPECT_EQ(store_->PutDocument(Recipe("a", "1", "none")).version, 1);
  // Even with the same bytes: whoever says "none" wants to be the one who created it.
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(Recipe("a", "1", "none")); }),
            Code::kPreconditionFailed);
  const DocumentInfo two = store_->PutDocument(Recipe("a", "2", "*"));
  store_->DeleteDocument(kRecipe, "a");
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(Recipe("a", "3", "*")); }), Code::kPreconditionFailed);
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(Recipe("a", "3", two.etag())); }),
            Code::kPreconditionFailed);
  EXPECT_EQ(store_->PutDocument(Recipe("a", "3", "none")).version, 3);
}

TEST_F(DocumentTest, RefusedPutLeavesNoBlob) {
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(Recipe("a", "unwanted", "*")); }),
            Code::kPreconditionFailed);
  EXPECT_EQ(CodeOf([&] { store_->BlobPath(Sha256Hex("unwanted")); }), Code::kNotFound);
}

TEST_F(DocumentTest, WhatCannotBeStoredIsInvalid) {
  for (const std::string& id :
       {std::string(), std::string("a/b"), std::string(".hidden"), std::string("-x"),
        std::string(129, 'a'), std::string("a b"), std::string("a\0b", 3)}) {
    EXPECT_EQ(CodeOf([&] { store_->PutDocument(Recipe(id, "x")); }), Code::kInvalid) << id;
    EXPECT_FALSE(store_->FindDocument(kRecipe, id));
  }
  NewDocument document = Recipe("a", "x");
  document.file_name = "\xff.ttl";
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(document); }), Code::kInvalid);
  document = Named("a", "x", {{"\xc3", "label", "t"}});
  EXPECT_EQ(CodeOf([&] { store_->PutDocument(document); }), Code::kInvalid);
  EXPECT_THAT(store_->ListDocuments(kRecipe), IsEmpty());
}

TEST_F(DocumentTest, BytesNeedNotBeText) {
  const std::string bytes("\xff\xfe\0\x80", 4);
  EXPECT_EQ(BytesOf(store_->PutDocument(Recipe("a", bytes))), bytes);
}

TEST_F(DocumentTest, UnknownDocumentsAndVersionsAreNotFound) {
  store_->PutDocument(Recipe("a", "1"));
  EXPECT_EQ(CodeOf([&] { store_->GetDocument(kRecipe, "b", 1); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->GetDocument(kRecipe, "a", 2); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->GetDocument(kRecipe, "a", -1); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->DocumentLog(kRecipe, "b"); }), Code::kNotFound);
  EXPECT_EQ(CodeOf([&] { store_->DeleteDocument(kRecipe, "b"); }), Code::kNotFound);
  EXPECT_FALSE(store_->FindDocument(kRecipe, "A"));
}

}  // namespace
}  // namespace lares::store::testing
