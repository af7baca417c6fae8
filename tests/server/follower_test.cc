// Two servers over one PostgreSQL: what one is told, the other knows.
#include "server/knowledge/follower.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/server/knowledge_fixture.h"
#include "tests/server/own_postgres.h"

namespace lares::testing {
namespace {

using store::DocumentKind;

class TwoServersTest : public ::testing::Test {
 protected:
  TwoServersTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lares-two-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) std::abort();
    folder_ = pattern;
    const std::string connection = store::testing::SharedPostgres().NewDatabase();
    for (Server& server : servers_) {
      server.store = store::OpenPostgresStore({connection, folder_});
      server.knowledge = std::make_unique<server::Knowledge>(*server.store, Engines());
    }
  }
  ~TwoServersTest() override {
    for (Server& server : servers_) {
      server.knowledge.reset();
      server.store.reset();
    }
    std::filesystem::remove_all(folder_);
  }

  static void PutClass(server::Knowledge& knowledge, const std::string& id,
                       const std::string& body) {
    server::PutRequest request;
    request.kind = DocumentKind::kOntology;
    request.id = id;
    request.file_name = id + ".ttl";
    request.bytes = std::string(kPrefixes) + body;
    knowledge.Put(request);
  }
  static bool Knows(server::Knowledge& knowledge, const std::string& name) {
    try {
      knowledge.ResolveClass(name);
      return true;
    } catch (const Error&) {
      return false;
    }
  }
  static bool SoonKnows(server::Knowledge& knowledge, const std::string& name, bool known) {
    for (int tries = 0; tries < 200; ++tries) {
      if (Knows(knowledge, name) == known) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
    return false;
  }

  struct Server {
    std::unique_ptr<store::Store> store;
    std::unique_ptr<server::Knowledge> knowledge;
  };
  std::filesystem::path folder_;
  Server servers_[2];
};

TEST_F(TwoServersTest, ClassPutAtOneIsSoonKnownAtTheOtherAndForgottenAgain) {
  const server::Follower follower(*servers_[1].knowledge, std::chrono::milliseconds(20));
  PutClass(*servers_[0].knowledge, "mine", ":Gizmo a owl:Class .");
  EXPECT_TRUE(SoonKnows(*servers_[1].knowledge, "Gizmo", true));
  servers_[0].knowledge->Remove(DocumentKind::kOntology, "mine");
  EXPECT_TRUE(SoonKnows(*servers_[1].knowledge, "Gizmo", false));
}

TEST_F(TwoServersTest, APutIsJudgedByWhatTheOtherServerTookMeanwhile) {
  PutClass(*servers_[0].knowledge, "a",
           ":Hot a owl:Class ; owl:disjointWith :Cold . :Cold a owl:Class .");
  // No follower: the put itself looks.
  EXPECT_THROW(PutClass(*servers_[1].knowledge, "b", ":stove a :Hot, :Cold ."), Error);
  EXPECT_TRUE(Knows(*servers_[1].knowledge, "Cold"));
}

TEST_F(TwoServersTest, DocumentsAboveTheCatalogueAreThereAtOnce) {
  server::PutRequest request;
  request.kind = DocumentKind::kRobot;
  request.id = "bot";
  request.file_name = "bot.ttl";
  request.bytes = std::string(kPrefixes) + ":bot a lares:Robot .";
  servers_[0].knowledge->Put(request);
  EXPECT_EQ(servers_[1].knowledge->Resolve(DocumentKind::kRobot, "bot").document.version, 1);
}

}  // namespace
}  // namespace lares::testing
