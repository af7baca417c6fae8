// The W3C's RDF 1.1 test suites, and which of their cases are known to fail.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "tests/lares_data.h"
#include "tests/ontology/isomorphism.h"

namespace lares::rdf {
namespace {

constexpr std::string_view kManifest = "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#";
constexpr std::string_view kRdfTest = "http://www.w3.org/ns/rdftest#";

struct Case {
  std::string name;
  std::string kind;    // "TestTurtleEval", …
  std::string action;  // relative to the manifest
  std::string result;  // empty for syntax tests
};

struct Suite {
  std::string folder;
  Format format;
  std::map<std::string, std::string> known_failures;  // case → why
};

// The archive, unpacked once for all suites.
class UnpackedSuites {
 public:
  explicit UnpackedSuites(const std::filesystem::path& archive) {
    std::string pattern = (std::filesystem::temp_directory_path() / "lares-w3c-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) return;
    folder_ = pattern;
    const std::string command = "tar -xzf '" + archive.string() + "' -C '" + pattern + "'";
    is_ready_ = std::system(command.c_str()) == 0;
  }
  ~UnpackedSuites() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }
  bool is_ready() const { return is_ready_; }
  std::filesystem::path folder() const { return folder_ / "rdf" / "rdf11"; }

 private:
  std::filesystem::path folder_;
  bool is_ready_ = false;
};

class Manifest {
 public:
  Manifest(const std::filesystem::path& file, std::string base) : base_(std::move(base)) {
    ReadOptions options;
    options.source = file.filename().string();
    options.base_iri = base_ + "manifest.ttl";
    document_ = ReadRdf(ReadFile(file), Format::kTurtle, options);
    for (const Statement& s : document_.statements) {
      properties_[s.subject][document_.terms[s.predicate].value] = document_.terms[s.object].value;
    }
  }

  std::vector<Case> Cases() const {
    std::vector<Case> cases;
    for (const auto& [subject, row] : properties_) {
      const std::string kind = Get(row, std::string(kRdf) + "type");
      const std::string action = Get(row, std::string(kManifest) + "action");
      if (!kind.starts_with(kRdfTest) || action.empty()) continue;
      const std::string id = document_.terms[subject].value;
      cases.push_back({id.substr(id.find('#') + 1), kind.substr(kRdfTest.size()), Local(action),
                       Local(Get(row, std::string(kManifest) + "result"))});
    }
    return cases;
  }

 private:
  using Row = std::map<std::string, std::string>;
  static std::string Get(const Row& row, const std::string& property) {
    const auto entry = row.find(property);
    return entry == row.end() ? "" : entry->second;
  }
  std::string Local(const std::string& iri) const {
    return iri.starts_with(base_) ? iri.substr(base_.size()) : "";
  }

  std::string base_;
  Document document_;
  std::map<std::uint32_t, Row> properties_;
};

// What went wrong; nothing when the case passes.
std::optional<std::string> Run(const Case& test, const std::filesystem::path& folder, Format format,
                               const std::string& base) {
  ReadOptions options;
  options.source = test.action;
  options.base_iri = base + test.action;
  const bool is_negative = test.kind.find("Negative") != std::string::npos;
  try {
    const Document document = ReadRdf(ReadFile(folder / test.action), format, options);
    if (is_negative) return "accepted";
    if (test.result.empty()) return std::nullopt;
    ReadOptions expected_options;
    expected_options.source = test.result;
    const Document expected = ReadRdf(
        ReadFile(folder / test.result),
        test.result.ends_with(".nq") ? Format::kNQuads : Format::kNTriples, expected_options);
    if (testing::AreIsomorphic(document, expected)) return std::nullopt;
    return "differs: got\n" + testing::Lines(document) + "instead of\n" + testing::Lines(expected);
  } catch (const Error& error) {
    if (is_negative && error.code() == Code::kInvalid && error.place() && error.place()->line > 0 &&
        error.place()->column > 0) {
      return std::nullopt;
    }
    return error.FullMessage();
  }
}

void RunSuite(const Suite& suite) {
  LARES_REQUIRE_DATA(archive, "conformance/rdf-tests/rdf11.tar.gz");
  static const UnpackedSuites suites(archive);
  ASSERT_TRUE(suites.is_ready());
  const std::filesystem::path folder = suites.folder() / suite.folder;
  const std::string base = "https://w3c.github.io/rdf-tests/rdf/rdf11/" + suite.folder + "/";
  std::size_t passed = 0;
  const std::vector<Case> cases = Manifest(folder / "manifest.ttl", base).Cases();
  for (const Case& test : cases) {
    const auto failure = Run(test, folder, suite.format, base);
    passed += failure ? 0 : 1;
    const auto known = suite.known_failures.find(test.name);
    if (known == suite.known_failures.end()) {
      EXPECT_FALSE(failure) << test.name << ": " << failure.value_or("");
    } else {
      EXPECT_TRUE(failure) << test.name << " passes now: take it out of the list";
    }
  }
  EXPECT_GT(cases.size(), 50u);
  std::printf("%s: %zu of %zu\n", suite.folder.c_str(), passed, cases.size());
}

TEST(W3cRdf, Turtle) { RunSuite({"rdf-turtle", Format::kTurtle, {}}); }
TEST(W3cRdf, TriG) { RunSuite({"rdf-trig", Format::kTriG, {}}); }
TEST(W3cRdf, NTriples) { RunSuite({"rdf-n-triples", Format::kNTriples, {}}); }
TEST(W3cRdf, NQuads) { RunSuite({"rdf-n-quads", Format::kNQuads, {}}); }
TEST(W3cRdf, RdfXml) { RunSuite({"rdf-xml", Format::kRdfXml, {}}); }

}  // namespace
}  // namespace lares::rdf
