#include "reasoner/prolog/value.h"

#include "base/error.h"

namespace lares::prolog {
namespace {

const char* KindName(const Value& value) {
  static constexpr const char* kNames[] = {"an integer", "a float",    "an atom", "a string",
                                           "a list",     "a compound", "a dict",  "a record"};
  return kNames[value.data.index()];
}

[[noreturn]] void Fail(const char* wanted, const Value& value) {
  throw Error(Code::kInternal,
              std::string("a rule answered ") + KindName(value) + " where " + wanted + " belongs");
}

template <typename T>
const T& As(const Value& value, const char* wanted) {
  if (const T* found = std::get_if<T>(&value.data)) return *found;
  Fail(wanted, value);
}

}  // namespace

std::int64_t Value::integer() const { return As<std::int64_t>(*this, "an integer"); }

double Value::number() const {
  if (const auto* whole = std::get_if<std::int64_t>(&data)) return static_cast<double>(*whole);
  return As<double>(*this, "a number");
}

const std::string& Value::text() const {
  if (const auto* atom = std::get_if<Atom>(&data)) return atom->text;
  return As<String>(*this, "text").text;
}

const List& Value::list() const { return As<List>(*this, "a list"); }
const Compound& Value::compound() const { return As<Compound>(*this, "a compound"); }
const Dict& Value::dict() const { return As<Dict>(*this, "a dict"); }

const Value& Value::at(const std::string& key) const {
  if (const Value* found = find(key)) return *found;
  throw Error(Code::kInternal, "a rule answered a dict without the key \"" + key + "\"");
}

const Value* Value::find(const std::string& key) const {
  const Dict& entries = dict();
  const auto found = entries.find(key);
  return found == entries.end() ? nullptr : &found->second;
}

}  // namespace lares::prolog
