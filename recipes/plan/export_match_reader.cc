#include "recipes/plan/export_match_reader.h"

#include "recipes/plan/export_words.h"

namespace lares::recipes {
namespace {

constexpr int kMaxDepth = 64;  // of findings below findings
constexpr std::int64_t kMaxFile_bytes = std::int64_t{1} << 50;

std::optional<double> ReadBound(JsonMembers& members, const char* name) {
  const std::optional<JsonNode> node = members.Optional(name);
  return node ? std::optional<double>(ReadNumber(*node)) : std::nullopt;
}

Measure ReadMeasure(const JsonNode& node) {
  JsonMembers members(node);
  Measure measure;
  measure.quantity = ReadResource(members.Required("quantity"));
  measure.unit = ReadText(members.Required("unit"));
  JsonMembers required(members.Required("required"));
  measure.at_least = ReadBound(required, "at_least");
  measure.at_most = ReadBound(required, "at_most");
  required.RefuseOthers();
  const JsonNode actual = members.Required("actual");
  if (!actual.IsNull()) measure.actual = ReadNumber(actual);
  static constexpr std::array kVerdicts = {Measure::Verdict::kMet, Measure::Verdict::kUnknown,
                                           Measure::Verdict::kInsufficient};
  measure.verdict = ReadOneOf(members.Required("verdict"), kVerdicts, ToString);
  measure.short_by = ReadBound(members, "short_by").value_or(0);
  measure.short_by_percent = ReadBound(members, "short_by_percent");
  measure.stated_by = ReadResource(members.Required("stated_by"));
  members.RefuseOthers();
  return measure;
}

Offer ReadOffer(const JsonNode& node) {
  JsonMembers members(node);
  Offer offer;
  offer.class_iri = ReadText(members.Required("class"));
  offer.for_what = ReadText(members.Required("for"));
  offer.document = ReadText(members.Required("document"));
  offer.file = ReadText(members.Required("file"));
  offer.link = ReadText(members.Required("link"));
  offer.sha256 = ReadText(members.Required("sha256"));
  offer.size_bytes =
      static_cast<std::uint64_t>(ReadWhole(members.Required("size_bytes"), kMaxFile_bytes));
  members.RefuseOthers();
  return offer;
}

Finding ReadFinding(const JsonNode& node, int depth) {
  if (depth > kMaxDepth) node.Fail("lies too deep");
  JsonMembers members(node);
  Finding finding;
  const JsonNode kind = members.Required("kind");
  const std::string kind_name = ReadText(kind);
  if (kind_name != "capability" && kind_name != "component") {
    kind.Fail("must be one of capability, component");
  }
  finding.kind = kind_name == "capability" ? Finding::Kind::kCapability : Finding::Kind::kComponent;
  finding.what = ReadResource(members.Required("what"));
  static constexpr std::array kAvailabilities = {
      Availability::kAvailable, Availability::kOnMakersWord, Availability::kDownloadable,
      Availability::kDerivable, Availability::kInsufficient, Availability::kMissing};
  finding.availability = ReadOneOf(members.Required("availability"), kAvailabilities, ToString);
  finding.asserted = ReadBoolean(members.Required("asserted"));
  finding.provided_by = ReadResources(members.Required("provided_by"));
  finding.dependencies = ReadArray(members.Required("dependencies"), [&](const JsonNode& each) {
    return ReadFinding(each, depth + 1);
  });
  finding.measures = ReadArrayIfThere(members, "measures", ReadMeasure);
  finding.downloads = ReadArrayIfThere(members, "downloads", ReadOffer);
  finding.explanation = ReadText(members.Required("explanation"));
  members.RefuseOthers();
  return finding;
}

Finding ReadTopFinding(const JsonNode& node) { return ReadFinding(node, 1); }

Need ReadNeed(const JsonNode& node) {
  JsonMembers members(node);
  Need need{ReadResource(members.Required("step")), ReadResource(members.Required("capability")),
            ReadResources(members.Required("inherited_through"))};
  members.RefuseOthers();
  return need;
}

StepRequirement ReadRequirement(const JsonNode& node) {
  JsonMembers members(node);
  StepRequirement requirement{ReadResources(members.Required("steps")),
                              ReadTopFinding(members.Required("finding"))};
  members.RefuseOthers();
  return requirement;
}

Download ReadDownload(const JsonNode& node) {
  JsonMembers members(node);
  Download download{ReadResource(members.Required("what")), ReadOffer(members.Required("offer"))};
  members.RefuseOthers();
  return download;
}

Measure ReadLimits(const JsonNode& node) {
  JsonMembers members(node);
  Measure bound;
  bound.quantity = ReadResource(members.Required("quantity"));
  bound.unit = ReadText(members.Required("unit"));
  bound.at_least = ReadBound(members, "at_least");
  bound.at_most = ReadBound(members, "at_most");
  members.RefuseOthers();
  return bound;
}

RepairItem ReadRepairItem(const JsonNode& node) {
  JsonMembers members(node);
  RepairItem item;
  item.what = ReadResource(members.Required("what"));
  item.bounds = ReadArrayIfThere(members, "bounds", ReadLimits);
  item.cost = ReadNumber(members.Required("cost"));
  item.text = ReadText(members.Required("text"));
  members.RefuseOthers();
  return item;
}

Repair ReadRepair(const JsonNode& node) {
  JsonMembers members(node);
  Repair repair{ReadArray(members.Required("add"), ReadRepairItem),
                ReadNumber(members.Required("cost"))};
  members.RefuseOthers();
  return repair;
}

}  // namespace

MatchReport ReadMatch(const JsonNode& node) {
  JsonMembers members(node);
  MatchReport match;
  match.task = ReadResource(members.Required("task"));
  match.robot = ReadResource(members.Required("robot"));
  match.feasible = ReadBoolean(members.Required("feasible"));
  match.needs = ReadArray(members.Required("needs"), ReadNeed);
  match.capabilities = ReadArray(members.Required("capabilities"), ReadTopFinding);
  match.requirements = ReadArrayIfThere(members, "requirements", ReadRequirement);
  match.downloads = ReadArrayIfThere(members, "downloads", ReadDownload);
  match.smallest_repair = ReadResources(members.Required("smallest_repair"));
  match.repairs = ReadArrayIfThere(members, "repairs", ReadRepair);
  const auto smallest = members.Optional("repair_is_smallest");
  match.repair_is_smallest = !smallest || ReadBoolean(*smallest);
  match.warnings = ReadTexts(members.Required("warnings"));
  members.RefuseOthers();
  return match;
}

}  // namespace lares::recipes
