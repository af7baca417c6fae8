// The W3C's SPARQL 1.0 and 1.1 query tests as they are published: manifests, queries and data.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "reasoner/sparql/query.h"

namespace lares::sparql::testing {

struct Case {
  std::string name;
  std::string kind;           // "QueryEvaluationTest", …
  std::string query, result;  // files, as those below
  std::vector<std::string> data, graphs;
};

// An archive, unpacked as long as this lives.
class Unpacked {
 public:
  explicit Unpacked(const std::filesystem::path& archive);
  ~Unpacked();
  Unpacked(const Unpacked&) = delete;
  Unpacked& operator=(const Unpacked&) = delete;

  bool is_ready() const { return is_ready_; }
  std::filesystem::path folder() const { return folder_ / "sparql"; }

 private:
  std::filesystem::path folder_;
  bool is_ready_ = false;
};

// What the IRIs of a folder's files begin with.
std::string BaseOf(const std::string& folder_name);
// The cases that a folder's manifest lists. Throws Error when it cannot be read.
std::vector<Case> ReadManifest(const std::filesystem::path& folder, const std::string& base);
// The graphs of one case, with those that its query, `text`, takes by FROM.
Dataset ReadDataset(const Case& test, const std::filesystem::path& folder, const std::string& base,
                    const std::string& text);

}  // namespace lares::sparql::testing
