// Ontologies that others made, in OWL's own syntaxes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/file.h"
#include "tests/lares_data.h"
#include "tests/ontology/rdf_test_support.h"

namespace lares::rdf {
namespace {

using testing::AreIsomorphic;
using testing::Named;

constexpr Format kOwlFormats[] = {Format::kOwlFunctional, Format::kOwlXml};

std::vector<std::filesystem::path> Files(const std::filesystem::path& folder,
                                         const std::string& extension) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Document ReadFileOf(const std::filesystem::path& path) {
  const std::string bytes = ReadFile(path);
  ReadOptions options = Named(path.filename().string());
  options.base_iri = "http://base/";
  options.recover = true;
  return ReadRdf(bytes, GuessFormat("", path.filename().string(), bytes), options);
}

void ExpectSameInOwl(const Document& document, const std::filesystem::path& file) {
  for (const Format format : kOwlFormats) {
    const Document again = ReadRdf(WriteRdf(document, format), format, Named("written"));
    EXPECT_TRUE(AreIsomorphic(document, again)) << file << " as " << MediaType(format);
  }
}

TEST(RealOwl, EverySomaFileIsReadAsPublished) {
  LARES_REQUIRE_DATA(folder, "soma");
  const auto files = Files(folder, ".owl");
  EXPECT_EQ(files.size(), 15u);
  for (const auto& file : files) {
    const Document document = ReadFileOf(file);
    EXPECT_EQ(document.format, Format::kOwlFunctional) << file;
    EXPECT_TRUE(document.remarks.empty()) << file;
    EXPECT_GE(document.statements.size(), 11u) << file;
  }
}

TEST(RealOwl, EverySomaFileIsTheSameAfterWriting) {
  LARES_REQUIRE_DATA(folder, "soma");
  for (const auto& file : Files(folder, ".owl")) ExpectSameInOwl(ReadFileOf(file), file);
}

std::uint32_t TermOf(Document& document, const Term& term) {
  const auto found = std::find(document.terms.begin(), document.terms.end(), term);
  if (found != document.terms.end()) {
    return static_cast<std::uint32_t>(found - document.terms.begin());
  }
  document.terms.push_back(term);
  return static_cast<std::uint32_t>(document.terms.size() - 1);
}

// What OWL 2 says beyond a document of OWL 1 or one without a header: owl:members for
// owl:distinctMembers, the types of restrictions, and that there is an ontology.
void TranslateOwl1(Document& document) {
  const std::string owl = "http://www.w3.org/2002/07/owl#";
  for (Term& term : document.terms) {
    if (term.value == owl + "distinctMembers") term.value = owl + "members";
  }
  const std::uint32_t type =
      TermOf(document, Term::Iri("http://www.w3.org/1999/02/22-rdf-syntax-ns#type"));
  const std::uint32_t restriction = TermOf(document, Term::Iri(owl + "Restriction"));
  const std::uint32_t ontology = TermOf(document, Term::Iri(owl + "Ontology"));
  const std::uint32_t on_property = TermOf(document, Term::Iri(owl + "onProperty"));
  const std::vector<Statement> statements = document.statements;
  bool has_header = false;
  for (const Statement& s : statements) {
    has_header = has_header || (s.predicate == type && s.object == ontology);
    if (s.predicate == on_property) document.statements.push_back({s.subject, type, restriction});
  }
  if (!has_header) {
    document.statements.push_back({TermOf(document, Term::Blank("header")), type, ontology});
  }
}

TEST(RealOwl, OurOwnModulesAreTheSameAfterWriting) {
  for (const auto& file : Files(std::filesystem::path(LARES_SOURCE_DIR) / "ontology", ".ttl")) {
    Document document = ReadFileOf(file);
    TranslateOwl1(document);
    ExpectSameInOwl(document, file);
  }
}

TEST(RealOwl, RoboEarthsFilesAreTheSameButForClassExpressionsThatNothingUses) {
  LARES_REQUIRE_DATA(folder, "roboearth");
  std::map<std::string, std::size_t> left_out;
  for (const auto& file : Files(folder, ".owl")) {
    Document document = ReadFileOf(file);
    TranslateOwl1(document);
    const std::size_t count = WriteAxioms(document, Format::kOwlFunctional).left_out.size();
    if (count != 0) {
      left_out[file.filename().string()] = count;
      EXPECT_THROW(WriteRdf(document, Format::kOwlXml), Error) << file;
    } else {
      ExpectSameInOwl(document, file);
    }
  }
  EXPECT_EQ(left_out, (std::map<std::string, std::size_t>{{"object-search-recipe.owl", 9},
                                                          {"serve_drink.owl", 13}}));
}

}  // namespace
}  // namespace lares::rdf
