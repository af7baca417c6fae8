#include "tests/recipes/json_schema.h"

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace lares::testing {
namespace {

using nlohmann::json;

class Validator {
 public:
  explicit Validator(const json& root) : root_(root) {}

  void Check(const json& schema, const json& value, const std::string& path) {
    for (const auto& [keyword, argument] : schema.items()) {
      if (!CheckKeyword(keyword, argument, schema, value, path)) {
        Fail(path, "unknown keyword " + keyword);
      }
    }
  }
  std::vector<std::string> violations;

 private:
  bool CheckKeyword(const std::string& keyword, const json& argument, const json& schema,
                    const json& value, const std::string& path) {
    static const std::set<std::string> kNotes = {"$schema", "$id", "title", "description", "$defs"};
    if (kNotes.count(keyword) > 0) return true;
    if (keyword == "$ref") {
      Check(root_.at(json::json_pointer(argument.get<std::string>().substr(1))), value, path);
    } else if (keyword == "type") {
      if (!HasType(argument, value)) Fail(path, "is no " + argument.get<std::string>());
    } else if (keyword == "const") {
      if (value != argument) Fail(path, "is not " + argument.dump());
    } else if (keyword == "enum") {
      if (std::find(argument.begin(), argument.end(), value) == argument.end()) {
        Fail(path, value.dump() + " is none of " + argument.dump());
      }
    } else if (keyword == "oneOf") {
      CheckOneOf(argument, value, path);
    } else {
      return CheckText(keyword, argument, value, path) ||
             CheckArray(keyword, argument, value, path) ||
             CheckObject(keyword, argument, schema, value, path);
    }
    return true;
  }

  bool CheckText(const std::string& keyword, const json& argument, const json& value,
                 const std::string& path) {
    if (keyword == "minLength") {
      if (value.is_string() && value.get<std::string>().size() < argument.get<std::size_t>()) {
        Fail(path, "is too short");
      }
    } else if (keyword == "maxLength") {
      if (value.is_string() && value.get<std::string>().size() > argument.get<std::size_t>()) {
        Fail(path, "is too long");
      }
    } else if (keyword == "minimum") {
      if (value.is_number() && value < argument) Fail(path, "is too small");
    } else if (keyword == "exclusiveMinimum") {
      if (value.is_number() && value <= argument) Fail(path, "is too small");
    } else if (keyword == "maximum") {
      if (value.is_number() && value > argument) Fail(path, "is too large");
    } else if (keyword == "pattern") {
      if (value.is_string() &&
          !std::regex_search(value.get<std::string>(), std::regex(argument.get<std::string>()))) {
        Fail(path, value.dump() + " does not match " + argument.dump());
      }
    } else {
      return false;
    }
    return true;
  }

  bool CheckArray(const std::string& keyword, const json& argument, const json& value,
                  const std::string& path) {
    if (keyword == "minItems") {
      if (value.is_array() && value.size() < argument.get<std::size_t>()) {
        Fail(path, "has too few items");
      }
    } else if (keyword == "items") {
      for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
        Check(argument, value[i], path + "/" + std::to_string(i));
      }
    } else {
      return false;
    }
    return true;
  }

  bool CheckObject(const std::string& keyword, const json& argument, const json& schema,
                   const json& value, const std::string& path) {
    if (keyword == "required") {
      for (const json& name : argument) {
        if (value.is_object() && !value.contains(name)) Fail(path, "lacks " + name.dump());
      }
    } else if (keyword == "properties") {
      for (const auto& [name, property] : argument.items()) {
        if (value.is_object() && value.contains(name)) {
          Check(property, value.at(name), path + "/" + name);
        }
      }
    } else if (keyword == "additionalProperties") {
      if (!value.is_object()) return true;
      for (const auto& [name, item] : value.items()) {
        if (schema.contains("properties") && schema["properties"].contains(name)) continue;
        if (argument.is_boolean()) {
          if (!argument.get<bool>()) Fail(path, "has the unknown member " + name);
        } else {
          Check(argument, item, path + "/" + name);
        }
      }
    } else {
      return false;
    }
    return true;
  }

  void CheckOneOf(const json& schemas, const json& value, const std::string& path) {
    int matches = 0;
    std::string reasons;
    for (const json& schema : schemas) {
      Validator inner(root_);
      inner.Check(schema, value, path);
      matches += inner.violations.empty() ? 1 : 0;
      for (const std::string& reason : inner.violations) reasons += " | " + reason;
    }
    if (matches != 1) Fail(path, "matches " + std::to_string(matches) + " of oneOf" + reasons);
  }

  static bool HasType(const json& type, const json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    return type == "null" && value.is_null();
  }

  void Fail(const std::string& path, const std::string& what) {
    violations.push_back(path + ": " + what);
  }

  const json& root_;
};

}  // namespace

std::vector<std::string> ValidateJson(const json& schema, const json& value) {
  Validator validator(schema);
  validator.Check(schema, value, "");
  return validator.violations;
}

}  // namespace lares::testing
