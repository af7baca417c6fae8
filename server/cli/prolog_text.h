// Answers of Prolog goals as people read them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lares::cli {

using Json = nlohmann::ordered_json;

// A value of an answer in Prolog's notation: lares:'Cup', 'http://x/y', "text", [1, 2], f(X);
// "grüne Tasse"@de and "1"^^xsd:integer for literals, '…' in angle brackets for what was cut.
std::string PrologText(const Json& value);

// "X = 1, Y = lares:'Cup'"; "yes" for an answer without variables. Variables that nothing is known
// of are left out.
std::string AnswerText(const Json& answer);

}  // namespace lares::cli
