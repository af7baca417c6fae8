// Reading values of elements, with findings that name element, attribute and line.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robots/urdf/finding.h"
#include "robots/urdf/raw.h"
#include "robots/urdf/xml_tree.h"

namespace lares::urdf {

// Collects what is wrong while a tree is read; what cannot be read is absent.
class Reading {
 public:
  explicit Reading(std::string source) : source_(std::move(source)) {}

  void Add(Finding::Severity severity, std::string code, int line, std::string message,
           std::string remedy = "");
  void Fault(std::string code, int line, std::string message, std::string remedy = "") {
    Add(Finding::Severity::kError, std::move(code), line, std::move(message), std::move(remedy));
  }

  // A finite number below 1e15. `what` names it: "attribute 'x' of <y>".
  std::optional<double> Number(std::string_view text, const std::string& what, int line);
  std::optional<double> Attribute(const Element& element, std::string_view attribute);
  // As many numbers as there are entries, apart by spaces.
  template <std::size_t N>
  std::optional<std::array<double, N>> Numbers(std::string_view text, const std::string& what,
                                               int line);
  std::optional<std::array<double, 3>> Vector(const Element& element, std::string_view attribute);
  // The number that a child element's text is; nothing when there is no such child.
  std::optional<double> ChildNumber(const Element& element, std::string_view child);
  // The <origin> below `element`; the identity when there is none.
  RawPose Origin(const Element& element);
  // Six numbers of an element's text, as SDF writes poses.
  RawPose PoseText(const Element& element);
  // Two numbers of an element's text.
  std::optional<std::array<double, 2>> Pair(const Element& element);
  // The attribute `name`, a finding when it is missing, empty or unusable as a name.
  std::string Name(const Element& element, std::string_view attribute, const std::string& of);

  std::vector<Finding> TakeFindings() { return std::move(findings_); }

 private:
  std::string source_;
  std::vector<Finding> findings_;
};

}  // namespace lares::urdf
