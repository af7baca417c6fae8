// The closure of files that others wrote: RoboEarth's robots, LUBM.
#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.h"
#include "base/search_path.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"
#include "tests/lares_data.h"
#include "tests/ontology/test_graph.h"

namespace lares::owl {
namespace {

namespace fs = std::filesystem;
using lares::testing::TermOf;

class OwlDataTest : public ::testing::Test {
 protected:
  rdf::Graph Read(const fs::path& path) {
    const std::string bytes = ReadFile(path);
    rdf::ReadOptions options;
    options.source = path.filename().string();
    options.base_iri = "http://example.org/" + options.source;
    const rdf::Format format = rdf::GuessFormat("", options.source, bytes);
    return rdf::MakeGraph(rdf::ReadRdf(bytes, format, options), options.source, aliases_,
                          *dictionary_);
  }
  rdf::View Over(const rdf::View& below, std::vector<rdf::Graph> graphs) {
    return below.With(Materialise(below, std::move(graphs)));
  }
  rdf::View Catalogue(const fs::path& roboearth) {
    std::vector<rdf::Graph> graphs;
    for (const char* name :
         {"ontology/knowrob.owl", "ontology/roboearth.owl", "srdl/srdl2.owl", "srdl/srdl2-comp.owl",
          "srdl/srdl2-cap.owl", "srdl/srdl2-action.owl"}) {
      graphs.push_back(Read(roboearth / name));
    }
    return Over(rdf::View(dictionary_), std::move(graphs));
  }
  // The parts of `whole` (an IRI), by local name, that are of a class.
  std::set<std::string> Parts(const rdf::View& view, const std::string& whole,
                              std::string_view type) {
    std::set<std::string> names;
    const rdf::TermId a = TermOf("a", *dictionary_);
    const rdf::TermId wanted = TermOf(type, *dictionary_);
    for (const rdf::TermId part : view.Objects(TermOf("<" + whole + ">", *dictionary_),
                                               TermOf("lares:subComponent", *dictionary_))) {
      if (!view.Contains({part, a, wanted})) continue;
      names.emplace(LocalName(dictionary_->Get(part).value));
    }
    return names;
  }

  std::shared_ptr<rdf::Dictionary> dictionary_ = std::make_shared<rdf::Dictionary>();
  rdf::AliasTable aliases_ =
      rdf::AliasTable::FromTsv(ReadFile(FindShared("ontology/aliases.tsv")), "aliases.tsv");
};

TEST_F(OwlDataTest, AmigoHasItsArmsAndItsCamera) {
  LARES_REQUIRE_DATA(roboearth, "roboearth");
  const rdf::View view = Over(Catalogue(roboearth), {Read(roboearth / "robots/amigo.owl")});
  const std::string amigo = "http://ias.cs.tum.edu/kb/amigo.owl#amigo_robot1";
  EXPECT_EQ(Parts(view, amigo, "lares:ArmComponent"),
            (std::set<std::string>{"left_arm", "right_arm"}));
  EXPECT_TRUE(Parts(view, amigo, "lares:Camera").contains("amigo_openni_camera"));
}

TEST_F(OwlDataTest, ThePr2HasItsWideStereoCameras) {
  LARES_REQUIRE_DATA(roboearth, "roboearth");
  const rdf::View view = Over(Catalogue(roboearth), {Read(roboearth / "robots/PR2.owl")});
  const std::string pr2 = "http://ias.cs.tum.edu/kb/PR2.owl#PR2Robot1";
  const std::set<std::string> cameras = Parts(view, pr2, "lares:Camera");
  EXPECT_TRUE(cameras.contains("pr2_wide_stereo_l_stereo_camera_frame"))
      << Join({cameras.begin(), cameras.end()}, " ");
  EXPECT_FALSE(Parts(view, pr2, "lares:ArmComponent").empty());
}

TEST_F(OwlDataTest, ThePioneerHasACircleOfPartsAndNoArm) {
  LARES_REQUIRE_DATA(roboearth, "roboearth");
  const rdf::View view = Over(Catalogue(roboearth), {Read(roboearth / "robots/pioneer.owl")});
  const std::string pioneer = "http://ias.cs.tum.edu/kb/ari.owl#ari_robot1";
  EXPECT_TRUE(Parts(view, pioneer, "lares:ArmComponent").empty());
  EXPECT_FALSE(Parts(view, pioneer, "lares:Camera").empty());
  const rdf::TermId robot = TermOf("<" + pioneer + ">", *dictionary_);
  EXPECT_TRUE(view.Contains({robot, TermOf("lares:subComponent", *dictionary_), robot}));
}

TEST_F(OwlDataTest, OneRobotKnowsNothingOfAnother) {
  LARES_REQUIRE_DATA(roboearth, "roboearth");
  const rdf::View catalogue = Catalogue(roboearth);
  const rdf::View pioneer = Over(catalogue, {Read(roboearth / "robots/pioneer.owl")});
  const rdf::View amigo = Over(catalogue, {Read(roboearth / "robots/amigo.owl")});
  const rdf::TermId arm = TermOf("<http://ias.cs.tum.edu/kb/amigo.owl#left_arm>", *dictionary_);
  EXPECT_EQ(pioneer.Estimate({arm, {}, {}}), 0U);
  EXPECT_GT(amigo.Estimate({arm, {}, {}}), 0U);
}

std::string ReadGzip(const fs::path& path) {
  std::string text;
  std::array<char, 1 << 16> buffer{};
  gzFile file = gzopen(path.c_str(), "rb");
  for (int n = 0; (n = gzread(file, buffer.data(), buffer.size())) > 0;) {
    text.append(buffer.data(), static_cast<std::size_t>(n));
  }
  gzclose(file);
  return text;
}

// First column of a reference answer.
std::set<std::string> Answers(const fs::path& path) {
  std::set<std::string> answers;
  std::istringstream lines(ReadFile(path));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const std::string first(Trim(Split(line, ',')[0]));
    if (!first.empty()) answers.insert(first);
  }
  return answers;
}

TEST_F(OwlDataTest, LubmAnswersAreTheReferenceAnswers) {
  LARES_REQUIRE_DATA(lubm, "conformance/lubm");
  const rdf::View ontology = Over(rdf::View(dictionary_), {Read(lubm / "ontology/univ-bench.ttl")});
  const rdf::Document document =
      rdf::ReadRdf(ReadGzip(lubm / "lubm-1-0-0.nt.gz"), rdf::Format::kNTriples, {});
  const rdf::View view = Over(ontology, {rdf::MakeGraph(document, "lubm", aliases_, *dictionary_)});
  EXPECT_EQ(view.layers()[1]->asserted_size(), 99'565U);

  const auto id = [&](const std::string& term) { return TermOf(term, *dictionary_); };
  const auto word = [&](const std::string& name) {
    return id("<http://www.lehigh.edu/~zhp2/2004/0401/univ-bench.owl#" + name + ">");
  };
  const rdf::TermId a = id("a");
  const auto text = [&](rdf::TermId term) { return std::string(dictionary_->Get(term).value); };
  // Things of a class for which a triple holds.
  const auto select = [&](const char* type, auto&& holds) {
    std::set<std::string> found;
    for (const rdf::TermId x : view.Subjects(a, word(type))) {
      if (holds(x)) found.insert(text(x));
    }
    return found;
  };
  const rdf::TermId department = id("<http://www.Department0.University0.edu>");
  const rdf::TermId university = id("<http://www.University0.edu>");
  const auto expect = [&](int query, const std::set<std::string>& found) {
    EXPECT_EQ(found,
              Answers(lubm / "answers" / ("answers_query" + std::to_string(query) + ".csv")));
  };
  expect(5, select("Person", [&](rdf::TermId x) {
           return view.Contains({x, word("memberOf"), department});
         }));
  expect(6, select("Student", [](rdf::TermId) { return true; }));
  expect(11, select("ResearchGroup", [&](rdf::TermId x) {
           return view.Contains({x, word("subOrganizationOf"), university});
         }));
  expect(12, select("Chair", [&](rdf::TermId x) {
           for (const rdf::TermId y : view.Objects(x, word("worksFor"))) {
             if (view.Contains({y, word("subOrganizationOf"), university})) return true;
           }
           return false;
         }));
  expect(13, select("Person", [&](rdf::TermId x) {
           return view.Contains({university, word("hasAlumnus"), x});
         }));
}

}  // namespace
}  // namespace lares::owl
