// Prolog terms as C++ values.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace lares::prolog {

// Atoms carry IRIs too: in rules an IRI is an atom, a literal is literal(Lexical, Datatype,
// Language) with atoms or strings inside, a blank node is '_:label'.
struct Atom {
  std::string text;
  friend bool operator==(const Atom&, const Atom&) = default;
};
struct String {
  std::string text;
  friend bool operator==(const String&, const String&) = default;
};
// As an input only: an answer that was kept (EnginePool::Keep).
class Record;
using RecordRef = std::shared_ptr<const Record>;
struct Value;
using List = std::vector<Value>;
struct Compound {
  std::string name;
  List arguments;
  friend bool operator==(const Compound&, const Compound&) = default;
};
// A SWI-Prolog dict with atom keys, whatever its tag.
using Dict = std::map<std::string, Value>;

struct Value {
  std::variant<std::int64_t, double, Atom, String, List, Compound, Dict, RecordRef> data;

  friend bool operator==(const Value&, const Value&) = default;

  // Typed access; each throws kInternal naming what was found instead.
  std::int64_t integer() const;
  double number() const;            // integers too
  const std::string& text() const;  // atom or string
  const List& list() const;
  const Compound& compound() const;
  const Dict& dict() const;
  const Value& at(const std::string& key) const;    // of a dict; throws when absent
  const Value* find(const std::string& key) const;  // of a dict; null when absent
};

}  // namespace lares::prolog
