#include "recipes/match/profile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "recipes/naming.h"

namespace lares::recipes {

namespace {

using prolog::Atom;
using prolog::Value;

// The finite number that a literal spells, whatever its datatype.
std::optional<double> NumberOf(const rdf::TermView& term) {
  if (term.kind != rdf::TermKind::kLiteral) return {};
  std::string_view text = Trim(term.value);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return {};
  if (!std::isfinite(number)) return {};
  return number;
}

std::string IriOf(const rdf::View& view, rdf::TermId id) {
  const rdf::TermView term = view.dictionary().Get(id);
  return (term.kind == rdf::TermKind::kBlank ? "_:" : "") + std::string(term.value);
}

RobotProfile::Part Describe(const rdf::View& view, rdf::TermId id) {
  RobotProfile::Part part;
  const std::string iri = IriOf(view, id);
  part.what = {iri, view.Label(id), view.AsWritten(id)};
  view.ForEach({id, {}, {}}, [&](const rdf::Triple& triple) {
    const auto number = NumberOf(view.dictionary().Get(triple.object));
    if (!number) return true;
    const auto known =
        std::find_if(part.quantities.begin(), part.quantities.end(),
                     [&](const auto& one) { return one.property == triple.predicate; });
    if (known == part.quantities.end()) {
      part.quantities.push_back({triple.predicate, *number, *number});
    } else {
      known->least = std::min(known->least, *number);
      known->most = std::max(known->most, *number);
    }
    return true;
  });
  return part;
}

void ReadParts(const rdf::View& view, rdf::TermId robot, RobotProfile& profile) {
  rdf::Dictionary& dictionary = view.dictionary();
  const rdf::TermId sub_component = dictionary.InternIri(std::string(rdf::kLares) + "subComponent");
  const rdf::TermId type = dictionary.InternIri(std::string(rdf::kRdf) + "type");
  std::map<std::string, rdf::TermId> parts;  // by IRI
  for (const rdf::TermId part : view.Objects(robot, sub_component)) {
    if (dictionary.Kind(part) != rdf::TermKind::kLiteral) parts.emplace(IriOf(view, part), part);
  }
  std::map<rdf::TermId, std::set<std::size_t>> by_type;
  for (const auto& [iri, part] : parts) {
    for (const rdf::TermId one : view.Objects(part, type))
      by_type[one].insert(profile.parts.size());
    profile.parts.push_back(Describe(view, part));
  }
  for (const auto& [one, having] : by_type) {
    profile.by_type.push_back({one, {having.begin(), having.end()}});
  }
}

void ReadClaims(const rdf::View& view, const Value& claims, RobotProfile& profile) {
  const rdf::TermId sub_class = view.dictionary().InternIri(std::string(rdf::kRdfs) + "subClassOf");
  for (const Value& claim : claims.list()) {
    RobotProfile::Claim& read = profile.claims.emplace_back();
    read.what = MakeResource(view, claim.text());
    read.term = view.dictionary().InternIri(claim.text());
    read.above = view.Objects(read.term, sub_class);
    read.above.push_back(read.term);
    std::sort(read.above.begin(), read.above.end());
    read.above.erase(std::unique(read.above.begin(), read.above.end()), read.above.end());
  }
}

}  // namespace

RobotProfile DescribeRobot(prolog::EnginePool& engines, const rdf::View& view,
                           const std::string& robot_iri) {
  const auto claims = engines.Once(view, "matching", "profile", {Value{Atom{robot_iri}}});
  if (!claims) throw Error(Code::kInternal, "matching:profile gave no answer");
  if (const auto* failure = std::get_if<prolog::Compound>(&claims->data)) {
    throw Error(Code::kNotFound, MakeSentence(view, failure->arguments.at(0)));
  }
  RobotProfile profile;
  profile.robot = MakeResource(view, robot_iri);
  if (const auto robot = view.dictionary().FindIri(robot_iri)) {
    profile.self = Describe(view, *robot);
    ReadParts(view, *robot, profile);
  }
  ReadClaims(view, *claims, profile);
  return profile;
}

}  // namespace lares::recipes
