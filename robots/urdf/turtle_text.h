// Pieces of Turtle.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lares::urdf {

std::string Quoted(std::string_view text);   // "…" with escapes
std::string English(std::string_view text);  // "…"@en
std::string Double(double value);            // "0.5"^^xsd:double
std::string Term(const std::string& iri);    // lares:Camera, or <…>

// Local names of one document, each given once.
class Names {
 public:
  // `wanted` with what Turtle does not take percent-encoded, and a number where it is taken.
  std::string Take(std::string_view wanted);

 private:
  std::set<std::string> taken_;
};

// One subject with its predicates and objects.
class Node {
 public:
  explicit Node(std::string subject) : subject_(std::move(subject)) {}
  Node& Add(const std::string& predicate, const std::string& object);
  Node& AddText(const std::string& predicate, std::string_view text);  // nothing when empty
  Node& AddDouble(const std::string& predicate, double value);
  std::string Text() const;  // with a full stop and an empty line

 private:
  std::string subject_;
  std::vector<std::pair<std::string, std::vector<std::string>>> predicates_;
};

}  // namespace lares::urdf
