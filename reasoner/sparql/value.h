// Terms as the values that operators work on (SPARQL 1.1, section 17).
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reasoner/sparql/date_time.h"
#include "reasoner/sparql/decimal.h"
#include "reasoner/sparql/terms.h"

namespace lares::sparql {

struct Value {
  enum class Kind {
    kError,  // also: unbound
    kBlank,
    kIri,
    kBoolean,
    kInteger,  // xsd:integer and what derives from it
    kDecimal,
    kFloat,
    kDouble,
    kDateTime,
    kDate,
    kTime,
    kString,  // simple literals and xsd:string
    kLanguageString,
    kOther,  // datatypes that are not known, and literals that are not well-formed
  };
  Kind kind = Kind::kError;
  TermId id{};         // of the term that it came from; kAnyTerm when computed
  rdf::TermView term;  // likewise; of computed strings: kind, datatype, language
  std::string made;    // lexical form of what was computed
  bool is_made = false;
  Decimal decimal;    // of kInteger, kDecimal
  double number = 0;  // of kFloat, kDouble
  bool boolean = false;
  DateTime time;

  bool is_error() const { return kind == Kind::kError; }
  bool is_numeric() const { return kind >= Kind::kInteger && kind <= Kind::kDouble; }
  bool is_literal() const { return kind >= Kind::kBoolean; }
  bool is_text() const { return kind == Kind::kString || kind == Kind::kLanguageString; }
  // The IRI, label or lexical form.
  std::string_view text() const { return is_made ? std::string_view(made) : term.value; }
  std::string_view datatype() const;  // of literals; never empty
};

inline constexpr std::string_view kXsdInteger = "http://www.w3.org/2001/XMLSchema#integer";
inline constexpr std::string_view kXsdDecimal = "http://www.w3.org/2001/XMLSchema#decimal";
inline constexpr std::string_view kXsdFloat = "http://www.w3.org/2001/XMLSchema#float";
inline constexpr std::string_view kXsdDouble = "http://www.w3.org/2001/XMLSchema#double";
inline constexpr std::string_view kXsdBoolean = "http://www.w3.org/2001/XMLSchema#boolean";
inline constexpr std::string_view kXsdString = "http://www.w3.org/2001/XMLSchema#string";
inline constexpr std::string_view kXsdDateTime = "http://www.w3.org/2001/XMLSchema#dateTime";
inline constexpr std::string_view kXsdDate = "http://www.w3.org/2001/XMLSchema#date";
inline constexpr std::string_view kXsdTime = "http://www.w3.org/2001/XMLSchema#time";
inline constexpr std::string_view kXsdDuration = "http://www.w3.org/2001/XMLSchema#dayTimeDuration";
inline constexpr std::string_view kRdfLangString =
    "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString";

// The value points into the term's storage.
Value ValueOf(const rdf::TermView& term, TermId id);

Value MakeBoolean(bool boolean);
Value MakeInteger(std::int64_t integer);
Value MakeNumber(Value::Kind kind, const std::optional<Decimal>& decimal);  // kInteger, kDecimal
Value MakeNumber(Value::Kind kind, double number);                          // kFloat, kDouble
Value MakeString(std::string text);
// With the language of `like` when it has one; a simple literal otherwise.
Value MakeStringLike(const Value& like, std::string text);
Value MakeTyped(std::string text, std::string_view datatype);  // datatype must outlive it
Value MakeIri(std::string iri);
Value MakeBlank(std::string label);

// The term of a value that is no error.
TermId Intern(const Value& value, Terms& terms);

double AsDouble(const Value& numeric);
std::string DoubleText(double number, bool is_float);

// 17.2.2; nothing for a type error.
std::optional<bool> EffectiveBoolean(const Value& value);
// 17.3, 17.4.1.7: "=", nothing for a type error.
std::optional<bool> EqualValues(const Value& a, const Value& b);
// -1, 0, 1, kUnordered for NaN; nothing for a type error.
inline constexpr int kUnordered = 2;
std::optional<int> CompareValues(const Value& a, const Value& b);
// The order of ORDER BY, MIN and MAX, made total: nothing, blank nodes, IRIs, literals; values that
// can be compared by value. Negative, 0, positive.
int OrderValues(const Value& a, const Value& b);

}  // namespace lares::sparql
