// An independent reader of OWL/XML takes what we write, and understands it as we meant it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "base/file.h"
#include "ontology/rdf/merge.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"

namespace lares::rdf {
namespace {

constexpr const char* kKonclude = "/usr/bin/Konclude";

class Konclude : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kKonclude)) GTEST_SKIP() << "Konclude is not installed";
    std::string pattern = (std::filesystem::temp_directory_path() / "konclude-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  // What it prints of itself. The class hierarchy, as OWL/XML, is in "out.owx".
  std::string Classify(const Document& document) {
    WriteFileAtomically(folder_ / "in.owx", WriteRdf(document, Format::kOwlXml));
    const std::string command = "timeout 60 " + std::string(kKonclude) +
                                " classification -w 2 -i " + (folder_ / "in.owx").string() +
                                " -o " + (folder_ / "out.owx").string() + " > " +
                                (folder_ / "log").string() + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return ReadFile(folder_ / "log");
  }

  std::filesystem::path folder_;
};

Document Turtle(const std::string& text) {
  ReadOptions options;
  options.source = "x";
  return ReadRdf(text, Format::kTurtle, options);
}

TEST_F(Konclude, UnderstandsRestrictionsAndChainsAsTheyWereMeant) {
  const std::string log = Classify(Turtle(
      "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . "
      "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . "
      ":p a owl:ObjectProperty . :q a owl:ObjectProperty ; owl:propertyChainAxiom ( :p :p ) . "
      ":A a owl:Class ; rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; "
      "owl:someValuesFrom [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :B ] ] . "
      ":B a owl:Class . :C a owl:Class ; owl:equivalentClass [ a owl:Restriction ; "
      "owl:onProperty :q ; owl:someValuesFrom :B ] ."));
  EXPECT_THAT(log, ::testing::Not(::testing::HasSubstr("{error}")));
  // A has a p that has a p that is a B: so it has a q that is a B, and is a C.
  ReadOptions options;
  options.source = "out.owx";
  const Document hierarchy = ReadRdf(ReadFile(folder_ / "out.owx"), Format::kOwlXml, options);
  const std::string lines = WriteRdf(hierarchy, Format::kNTriples);
  EXPECT_THAT(lines,
              ::testing::HasSubstr(
                  "<http://e/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/C> ."));
}

TEST_F(Konclude, ReadsAllOfOurOntology) {
  std::vector<Document> modules;
  const std::filesystem::path folder = std::filesystem::path(LARES_SOURCE_DIR) / "ontology";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ttl") continue;
    ReadOptions options;
    options.source = entry.path().filename().string();
    options.base_iri = "http://base/";
    modules.push_back(ReadRdf(ReadFile(entry.path()), Format::kTurtle, options));
  }
  const std::string log = Classify(MergeOntologies(modules));
  EXPECT_THAT(log, ::testing::Not(::testing::HasSubstr("{error}")));
  EXPECT_THAT(ReadFile(folder_ / "out.owx"), ::testing::HasSubstr("https://w3id.org/lares#Cup"));
}

}  // namespace
}  // namespace lares::rdf
