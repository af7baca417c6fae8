// What the commands for recipes, robots and ontology modules share.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "server/cli/command.h"
#include "server/cli/remote.h"

namespace lares::cli {

struct DocumentCommand {
  std::string collection;  // "/v1/recipes"
  std::string noun;        // "recipe"
  // What of a stored document is worth a line of the list, beside id and version.
  std::string column;
  std::function<std::string(const Json&)> cell;
  std::string kind;  // as it begins the ids of what is kept aside; empty: as the noun
  // Where given: adds options to `put`, and lines to what is printed of an answer to it.
  std::function<void(CLI::App& put, struct PutOptions& options)> more_options = {};
  std::function<std::string(const Json& answer)> more_summary = {};
  std::string files = "RDF files; the id is the file's stem";
};

struct PutOptions {
  std::vector<std::string> files;
  std::string id;
  bool recover = false;
  bool editor = false;
  bool quarantine = false;
  std::string if_match;
  std::multimap<std::string, std::string> query;
};

// What a stored recipe or robot answers to: its labels, or the local names of its IRIs.
std::string NamesOf(const Json& document);

// The file's stem, or `id`. Throws kInvalid when it is no identifier.
std::string IdFor(const std::filesystem::path& file, const std::string& id);

// Sends each file, prints what came of it; goes on after a refusal and throws the first one at the
// end.
void PutDocuments(const DocumentCommand& command, const PutOptions& put, const Options& options);
void ListDocuments(const DocumentCommand& command, const Options& options);
void GetDocument(const DocumentCommand& command, const std::string& id, int version,
                 const std::string& out, const Options& options);
void RemoveDocuments(const DocumentCommand& command, const std::vector<std::string>& ids,
                     const Options& options);

// Takes documents that were kept aside, now that they may contradict nothing.
void ReleaseDocuments(const DocumentCommand& command, const std::vector<std::string>& ids,
                      bool editor, const Options& options);

// Adds put, list, get, remove and release below `app`.
void AddDocumentCommands(CLI::App& app, const DocumentCommand& command, const Options& options,
                         const std::string& example_file);

// "recipe.owl:715:6: malformed comment" and the lines below it, to standard error.
void PrintError(const std::exception& error);

}  // namespace lares::cli
