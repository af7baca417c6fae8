// The house keeps its order: who may include whom, which door a library stands behind, and a
// README in each folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Each may include itself and what stands before it.
const std::vector<std::string> kFolders = {"base",     "ontology", "perception", "mapping",
                                           "reasoner", "recipes",  "robots",     "server"};

// A library's header may appear in the .cc files of one folder only.
const std::map<std::string, std::string> kDoors = {{"serd/", "ontology/rdf"},
                                                   {"raptor2", "ontology/rdf"},
                                                   {"libxml/", "ontology/rdf"},
                                                   {"SWI-Prolog.h", "reasoner/prolog"},
                                                   {"SWI-Stream.h", "reasoner/prolog"},
                                                   {"sqlite3.h", "server/store"},
                                                   {"libpq-fe.h", "server/store"},
                                                   {"openssl/ssl.h", "server/http"},
                                                   {"zstd", "server/http"},
                                                   {"png.h", "mapping/picture"},
                                                   {"httplib.h", "server/http"},
                                                   {"octomap/", "mapping/environment"},
                                                   {"ceres/", "mapping/slam"},
                                                   {"pcre2.h", "reasoner/sparql"},
                                                   {"urdf_parser/", "robots/urdf"},
                                                   {"console_bridge/", "robots/urdf"}};

// Costly to compile: never in a header.
const std::vector<std::string> kNotInHeaders = {"nlohmann/json.hpp", "spdlog/", "CLI/"};

struct Include {
  std::string file;    // relative to the source folder
  std::string header;  // as written between the quotes or brackets
  bool quoted = false;
};

fs::path Root() { return LARES_SOURCE_DIR; }

bool IsHeader(const std::string& file) { return file.ends_with(".h"); }

std::string TopFolder(const std::string& path) { return path.substr(0, path.find('/')); }

std::vector<Include> IncludesOf(const fs::path& file) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> includes;
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    std::smatch match;
    if (std::regex_search(line, match, kInclude)) {
      includes.push_back({fs::relative(file, Root()).string(), match[2], match[1] == "\""});
    }
  }
  return includes;
}

std::vector<Include> AllIncludes() {
  std::vector<Include> all;
  for (const std::string& folder : kFolders) {
    if (!fs::exists(Root() / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(Root() / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cc") continue;
      for (Include& include : IncludesOf(entry.path())) all.push_back(std::move(include));
    }
  }
  return all;
}

// -1 for a folder outside the house.
int Rank(const std::string& folder) {
  const auto at = std::find(kFolders.begin(), kFolders.end(), folder);
  return at == kFolders.end() ? -1 : static_cast<int>(at - kFolders.begin());
}

bool MayInclude(const std::string& file, const std::string& header) {
  const int from = Rank(TopFolder(file));
  const int to = Rank(TopFolder(header));
  if (to < 0 || to > from) return false;
  if (TopFolder(file) == "reasoner" && TopFolder(header) == "mapping") {
    return header.starts_with("mapping/semantic/") || header.starts_with("mapping/environment/");
  }
  return true;
}

TEST(HouseTest, FoldersIncludeOnlyWhatStandsAboveThem) {
  int checked = 0;
  for (const Include& include : AllIncludes()) {
    if (!include.quoted || !fs::exists(Root() / include.header)) continue;
    EXPECT_TRUE(MayInclude(include.file, include.header))
        << include.file << " may not include " << include.header;
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(HouseTest, QuotedIncludesAreWrittenFromTheRepositoryRoot) {
  for (const Include& include : AllIncludes()) {
    if (!include.quoted) continue;
    EXPECT_TRUE(fs::exists(Root() / include.header)) << include.file << ": " << include.header;
  }
}

TEST(HouseTest, TheRuleItselfRefusesAnUpwardArrow) {
  EXPECT_FALSE(MayInclude("base/error.cc", "server/store/store.h"));
  EXPECT_FALSE(MayInclude("reasoner/places/prior.cc", "mapping/slam/map.h"));
  EXPECT_TRUE(MayInclude("reasoner/places/prior.cc", "mapping/semantic/map_object.h"));
  EXPECT_TRUE(MayInclude("server/cli/main.cc", "base/error.h"));
}

TEST(HouseTest, HeavyLibrariesStayBehindOneDoor) {
  for (const Include& include : AllIncludes()) {
    for (const auto& [header, door] : kDoors) {
      if (include.quoted || !include.header.starts_with(header)) continue;
      EXPECT_TRUE(include.file.starts_with(door + "/")) << include.file << ": " << include.header;
      EXPECT_FALSE(IsHeader(include.file)) << include.file << ": " << include.header;
    }
  }
}

TEST(HouseTest, HeadersStayLight) {
  for (const Include& include : AllIncludes()) {
    for (const std::string& costly : kNotInHeaders) {
      EXPECT_FALSE(IsHeader(include.file) && include.header.starts_with(costly))
          << include.file << ": " << include.header;
    }
  }
}

TEST(HouseTest, EveryFolderHasAReadmeOfTenToTwentyFiveLines) {
  std::vector<std::string> folders = kFolders;
  folders.insert(folders.end(), {"tests", "demo", "clients", "packaging"});
  for (const std::string& folder : folders) {
    std::ifstream text(Root() / folder / "README.md");
    ASSERT_TRUE(text.good()) << folder << "/README.md is missing";
    const auto lines = std::count(std::istreambuf_iterator<char>(text), {}, '\n');
    EXPECT_GE(lines, 10) << folder;
    EXPECT_LE(lines, 25) << folder;
  }
}

}  // namespace
