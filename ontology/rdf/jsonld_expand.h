// JSON-LD in expanded form: every name an IRI, every value an object.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/jsonld_context.h"
#include "ontology/rdf/jsonld_value.h"

namespace lares::rdf::jsonld {

// A node, a value or a list of the expanded form.
struct Object {
  std::uint32_t offset = 0;       // of the JSON value that it was
  std::optional<std::string> id;  // "" for one that is no IRI
  std::vector<std::string> types;
  bool has_types = false;
  const Value* value = nullptr;  // of a value object
  std::optional<std::string> language;
  bool has_direction = false;
  std::optional<std::string> index;
  std::optional<std::vector<Object>> list, set, graph, included;
  std::map<std::string, std::vector<Object>> properties;
  std::map<std::string, std::vector<Object>> reverse;

  bool is_node() const { return value == nullptr && !list && !set; }
};

// The expansion algorithm of the JSON-LD 1.1 API (W3C 2020, 5.1). The objects point into `root` and
// into the expander.
class Expander {
 public:
  // `fail` throws; `warn` is told of what means nothing and is left out.
  Expander(std::string base, Fail fail, Fail warn)
      : contexts_(std::move(base), fail), fail_(std::move(fail)), warn_(std::move(warn)) {}

  std::vector<Object> Expand(const Value& root);

 private:
  // What became of one JSON value.
  struct Result {
    bool is_array = false;
    std::vector<Object> objects;  // none and no array: null
  };

  // One JSON object that is being expanded.
  struct Work {
    Object& result;
    const std::string* active_property = nullptr;
    ContextPtr active;
    ContextPtr type_scoped;
    bool is_json = false;  // its type is @json
    bool has_value = false;
    bool has_id = false;
    std::vector<std::string> seen;  // keywords, to find two that are the same
  };

  Result ExpandElement(const ContextPtr& active, const std::string* property, const Value& element,
                       bool from_map);
  Result ExpandArray(const ContextPtr& active, const std::string* property, const Value& element,
                     bool from_map);
  Result ExpandObject(ContextPtr active, const std::string* property, const Value& element,
                      bool from_map);
  ContextPtr WithTypes(const ContextPtr& active, const Value& element, bool& is_json);
  bool MustRevert(const Context& active, const Value& element);
  void ExpandMembers(Work& work, const Value& element);
  void ExpandKeyword(Work& work, const std::string& keyword, const Value& value);
  void ExpandTypes(Work& work, const Value& value);
  void ExpandReverse(Work& work, const Value& value);
  void ExpandIncluded(Work& work, const Value& value);
  void ExpandProperty(Work& work, const std::string& key, const std::string& property,
                      const Value& value);
  void ExpandNested(Work& work, const std::string& key, const Value& value);
  std::vector<Object> ExpandLanguageMap(const Work& work, const Value& map);
  std::vector<Object> ExpandIndexMap(const Work& work, const std::string& key,
                                     const TermDefinition& term, const Value& map);
  void PlaceInIndex(const Work& work, const TermDefinition& term, const Member& entry,
                    Object& object);
  Object ExpandValue(const Context& active, const std::string& property, const Value& value);
  Result Finish(Work& work, const std::string* property);
  void CheckValueObject(const Object& object, bool& is_null);
  void AddReverse(Object& result, const std::string& property, std::vector<Object> objects);

  std::optional<std::string> Iri(const Context& active, std::string_view value,
                                 ContextReader::Against against) {
    return contexts_.ExpandIri(active, value, against);
  }
  std::string Id(const Context& active, std::string_view value) {
    return Iri(active, value, {true, false}).value_or("");
  }

  ContextReader contexts_;
  Fail fail_;
  Fail warn_;
  std::deque<Value> made_;  // values that the text does not have
};

}  // namespace lares::rdf::jsonld
