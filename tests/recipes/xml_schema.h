// XML Schema, by libxml2.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace lares::testing {

class XmlSchema {
 public:
  // Throws std::runtime_error when it is no schema.
  explicit XmlSchema(const std::filesystem::path& file);
  ~XmlSchema();
  // One line for each violation; not well-formed counts as one.
  std::vector<std::string> Violations(const std::string& xml) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::testing
