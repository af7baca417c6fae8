// A JSON text as a tree that knows where each value stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/rdf/reader.h"

namespace lares::rdf::jsonld {

struct Member;

struct Value {
  enum class Kind : std::uint8_t { kNull, kBoolean, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;
  bool boolean = false;
  std::uint32_t offset = 0;     // of its first byte
  std::string text;             // a string's content; a number as it was written
  std::vector<Value> items;     // of an array
  std::vector<Member> members;  // of an object, sorted by key, each key once

  bool is_string() const { return kind == Kind::kString; }
  bool is_null() const { return kind == Kind::kNull; }
  bool is_object() const { return kind == Kind::kObject; }
  bool is_array() const { return kind == Kind::kArray; }
  bool is_scalar() const { return !is_null() && !is_object() && !is_array(); }
  // Null when there is no such member.
  const Value* Find(std::string_view key) const;
};

struct Member {
  std::string key;
  std::uint32_t offset = 0;
  Value value;
};

// Whether both say the same, wherever they stand.
bool AreEqual(const Value& a, const Value& b);

// The one value of an array that is no array, or the array's: what "as an array" means everywhere.
template <typename Visit>
void ForEachItem(const Value& value, Visit&& visit) {
  if (!value.is_array()) return visit(value);
  for (const Value& item : value.items) visit(item);
}

// `text` is UTF-8. Throws with a place: kInvalid for what is no JSON and for an object with one key
// twice, kTooLarge beyond the options' depth (at most 1000) and beyond 4 000 000 values.
Value ParseJson(std::string_view text, const ReadOptions& options);

}  // namespace lares::rdf::jsonld
