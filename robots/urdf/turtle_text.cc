#include "robots/urdf/turtle_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace lares::urdf {
namespace {

constexpr std::string_view kLares = "https://w3id.org/lares#";

bool IsPlain(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

}  // namespace

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else if (static_cast<unsigned char>(c) >= 32) {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string English(std::string_view text) { return Quoted(text) + "@en"; }

std::string Double(double value) {
  std::array<char, 40> text{};
  // Rounding errors of rotations are no figures.
  std::snprintf(text.data(), text.size(), "%.9g", std::abs(value) < 1e-12 ? 0.0 : value);
  return "\"" + std::string(text.data()) + "\"^^xsd:double";
}

std::string Term(const std::string& iri) {
  if (iri.starts_with(kLares)) {
    const std::string local = iri.substr(kLares.size());
    if (!local.empty() && std::all_of(local.begin(), local.end(), IsPlain)) return "lares:" + local;
  }
  return "<" + iri + ">";
}

std::string Names::Take(std::string_view wanted) {
  std::string name;
  for (const char c : wanted) {
    std::array<char, 8> encoded{};
    const auto byte = static_cast<unsigned char>(c);
    std::snprintf(encoded.data(), encoded.size(), "%%%02X", byte);
    name += IsPlain(c) && !(name.empty() && c == '-') ? std::string(1, c) : encoded.data();
  }
  std::string chosen = name;
  for (int i = 2; !taken_.insert(chosen).second; ++i) chosen = name + "_" + std::to_string(i);
  return ":" + chosen;
}

Node& Node::Add(const std::string& predicate, const std::string& object) {
  const auto at = std::find_if(predicates_.begin(), predicates_.end(),
                               [&](const auto& known) { return known.first == predicate; });
  if (at == predicates_.end()) {
    predicates_.push_back({predicate, {object}});
  } else if (std::find(at->second.begin(), at->second.end(), object) == at->second.end()) {
    at->second.push_back(object);
  }
  return *this;
}

Node& Node::AddText(const std::string& predicate, std::string_view text) {
  return text.empty() ? *this : Add(predicate, Quoted(text));
}

Node& Node::AddDouble(const std::string& predicate, double value) {
  return Add(predicate, Double(value));
}

std::string Node::Text() const {
  std::string text = subject_;
  for (std::size_t i = 0; i < predicates_.size(); ++i) {
    text += (i == 0 ? " " : " ;\n    ") + predicates_[i].first + " ";
    for (std::size_t k = 0; k < predicates_[i].second.size(); ++k) {
      text += (k == 0 ? "" : " , ") + predicates_[i].second[k];
    }
  }
  return text + " .\n\n";
}

}  // namespace lares::urdf
