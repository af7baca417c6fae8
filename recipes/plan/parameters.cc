#include "recipes/plan/parameters.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/error.h"
#include "base/rigid_transform.h"
#include "base/text.h"
#include "recipes/naming.h"

namespace lares::recipes {

namespace {

using prolog::Value;

double ToNumber(std::string_view text) {
  text = Trim(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole ? number : std::numeric_limits<double>::quiet_NaN();
}

RigidTransform ToTransform(const rdf::View& view, const prolog::Compound& matrix) {
  const prolog::List& entries = matrix.arguments.at(1).list();
  Eigen::Matrix4d outer_from_inner;
  for (int i = 0; i < 16; ++i) {
    outer_from_inner(i / 4, i % 4) = ToNumber(entries.at(static_cast<std::size_t>(i)).text());
  }
  try {
    return FromMatrix(outer_from_inner);
  } catch (const Error& error) {
    const Resource resource = MakeResource(view, matrix.arguments.at(0).text());
    throw Error(Code::kInvalid, "the matrix '" + resource.label + "' <" + resource.as_written +
                                    ">: " + error.what());
  }
}

double Rounded(double value) {
  const double rounded = std::round(value * 1e6) / 1e6;
  return rounded == 0 ? 0 : rounded;  // no "-0"
}

std::string PoseText(const RigidTransform& frame_from_pose) {
  const Eigen::Vector3d& t = frame_from_pose.translation_m;
  Eigen::Quaterniond q = frame_from_pose.rotation.normalized();
  if (q.w() < 0) q.coeffs() *= -1;
  std::string text;
  for (const double value : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}) {
    if (!text.empty()) text += ' ';
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.6g", Rounded(value));
    text += buffer;
  }
  return text;
}

void SetValue(const rdf::View& view, const prolog::Compound& value, Parameter& parameter) {
  if (value.name == "matrices") {
    RigidTransform frame_from_pose;
    for (const Value& matrix : value.arguments.at(0).list()) {
      frame_from_pose = frame_from_pose * ToTransform(view, matrix.compound());
    }
    parameter.value = PoseText(frame_from_pose);
    parameter.frame = value.arguments.at(1).text();
  } else if (value.name == "pose") {
    parameter.value = value.arguments.at(0).text();
    parameter.frame = value.arguments.at(1).text();
  } else if (value.name == "iris") {
    std::vector<std::string> iris;
    for (const Value& iri : value.arguments.at(0).list()) iris.push_back(iri.text());
    parameter.value = Join(iris, " ");
  } else if (value.name == "key") {
    parameter.value = "{" + value.arguments.at(0).text() + "}";
  } else {
    parameter.value = value.arguments.at(0).text();
  }
}

Parameter::Source ToSource(const std::string& name) {
  if (name == "robot") return Parameter::Source::kRobot;
  if (name == "environment") return Parameter::Source::kEnvironment;
  if (name == "template") return Parameter::Source::kTemplate;
  if (name == "step") return Parameter::Source::kStep;
  if (name == "request") return Parameter::Source::kRequest;
  return Parameter::Source::kRecipe;
}

}  // namespace

std::string_view ToString(Parameter::Source source) {
  switch (source) {
    case Parameter::Source::kRecipe:
      return "recipe";
    case Parameter::Source::kRobot:
      return "robot";
    case Parameter::Source::kEnvironment:
      return "environment";
    case Parameter::Source::kTemplate:
      return "template";
    case Parameter::Source::kStep:
      return "step";
    case Parameter::Source::kRequest:
      return "request";
  }
  return "recipe";
}

Parameter ToParameter(const rdf::View& view, const prolog::Value& value) {
  Parameter parameter;
  parameter.name = value.at("name").text();
  parameter.type = value.at("type").text();
  parameter.unit = value.at("unit").text();
  parameter.text = MakeSentence(view, value.at("text"));
  parameter.source = ToSource(value.at("source").text());
  parameter.origin = MakeResource(view, value.at("origin").text());
  SetValue(view, value.at("value").compound(), parameter);
  return parameter;
}

}  // namespace lares::recipes
