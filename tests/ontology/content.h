// The project's own knowledge, loaded for tests, with short ways to ask it.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/aliases.h"
#include "ontology/rdf/document.h"
#include "ontology/triples/view.h"

namespace lares::testing {

std::filesystem::path SourceFolder();
rdf::AliasTable OurAliases();
// ontology/*.ttl, by name.
std::vector<std::filesystem::path> ModuleFiles();
rdf::Document ReadDocument(const std::filesystem::path& file, bool recover = false);

// Documents under canonical names in one layer, with what follows from subClassOf chains worked
// out when asked; no other inference. Names are local names of lares#, or whole IRIs.
class Content {
 public:
  explicit Content(const std::vector<std::filesystem::path>& files, bool recover = false);

  const rdf::View& view() const { return view_; }
  rdf::TermId Id(std::string_view name) const;  // kAnyTerm when never mentioned
  // Local name of a lares# term; the IRI or lexical form otherwise.
  std::string Name(rdf::TermId term) const;
  // Terms that some document states to be a `type` ("owl:Class", "Affordance").
  std::set<std::string> Declared(std::string_view type) const;
  std::set<std::string> Values(std::string_view subject, std::string_view property) const;
  // The named classes above `name`, itself included.
  std::set<std::string> Above(std::string_view name) const;
  // Fillers of "some" restrictions on `property` above `name`.
  std::set<std::string> Some(std::string_view name, std::string_view property) const;
  // Capabilities that a task needs: its own and those of its sub-actions, in any depth.
  std::set<std::string> Needs(std::string_view task) const;

 private:
  std::set<rdf::TermId> AboveIds(rdf::TermId id) const;
  void Members(rdf::TermId list, std::vector<rdf::TermId>& members) const;

  rdf::View view_;
};

}  // namespace lares::testing
