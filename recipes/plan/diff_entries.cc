#include "recipes/plan/diff_entries.h"

#include <cstdio>

#include "recipes/plan/export_words.h"

namespace lares::recipes {

namespace {

std::string Exact(const Resource& resource) {
  return resource.iri + "\n" + resource.label + "\n" + resource.as_written;
}

std::string Chain(const Need& need) {
  return Listed(need.inherited_through, [](const Resource& each) { return Exact(each); });
}

// "max range at least 3 m: has 5 m"
std::string Text(const Measure& measure) {
  std::string text = NameOf(measure.quantity);
  if (measure.at_least) text += " at least " + NumberText(*measure.at_least);
  if (measure.at_most) text += " at most " + NumberText(*measure.at_most);
  text += " " + measure.unit + ": ";
  return text + (measure.actual ? "has " + NumberText(*measure.actual) + " " + measure.unit
                                : std::string("not known"));
}

std::string Exact(const Measure& measure) {
  return Exact(measure.quantity) + "\n" + Text(measure) + "\n" + Exact(measure.stated_by) + "\n" +
         std::string(ToString(measure.verdict)) + "\n" + NumberText(measure.short_by) + "\n" +
         (measure.short_by_percent ? NumberText(*measure.short_by_percent) : "");
}

std::string Exact(const Offer& offer) {
  return Join({offer.class_iri, offer.for_what, offer.document, offer.file, offer.link,
               offer.sha256, std::to_string(offer.size_bytes)},
              "\n");
}

std::string Exact(const Finding& finding) {
  const auto exact = [](const auto& each) { return "(" + Exact(each) + ")"; };
  return Exact(finding.what) + "\n" + std::string(ToString(finding.availability)) +
         (finding.asserted ? "\nasserted\n" : "\n") + finding.explanation + "\n" +
         Listed(finding.provided_by, exact) + "\n" + Listed(finding.dependencies, exact) + "\n" +
         Listed(finding.measures, exact) + "\n" + Listed(finding.downloads, exact);
}

// "SonyCamera by <…#camera1>; …", for everything below that some part provides.
std::string Providers(const Finding& finding) {
  std::vector<std::string> parts;
  for (const Resource& part : finding.provided_by) {
    parts.push_back(std::string(LocalName(finding.what.as_written)) + " by <" + part.iri + ">");
  }
  for (const Finding& dependency : finding.dependencies) {
    const std::string below = Providers(dependency);
    if (!below.empty()) parts.push_back(below);
  }
  return Join(parts, "; ");
}

// "robot: camera_link on base_footprint"
std::string Origin(const Parameter& parameter) {
  std::string why(ToString(parameter.source));
  if (!parameter.origin.iri.empty()) why += ": " + NameOf(parameter.origin);
  if (!parameter.frame.empty()) why += " on " + parameter.frame;
  return why;
}

}  // namespace

std::string NameOf(const Resource& resource) {
  const std::string name(LocalName(resource.as_written));
  if (resource.label.empty() || resource.label == name) return name;
  return resource.label + " <" + name + ">";
}

std::string NumberText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", number);
  return text;
}

Entries TextEntries(const std::vector<std::string>& texts) {
  Entries entries;
  for (const std::string& text : texts) entries.push_back({text, "", text, {text, ""}});
  return entries;
}

Entries FluentEntries(const std::vector<Fluent>& fluents) {
  Entries entries;
  for (const Fluent& fluent : fluents) {
    const std::string key = (fluent.holds ? "+" : "-") + fluent.name + "\n" + fluent.argument;
    entries.push_back({key, "", key, {ToText(fluent), ""}});
  }
  return entries;
}

Entries EffectEntries(const std::vector<Effect>& effects) {
  Entries entries;
  for (const Effect& effect : effects) {
    const std::string text = ToText(effect.fluent);
    const std::string key = effect.outcome + (effect.fluent.holds ? "\n+" : "\n-") +
                            effect.fluent.name + "\n" + effect.fluent.argument;
    entries.push_back({key, "after " + effect.outcome, key, {text, ""}});
  }
  return entries;
}

Entries SettingEntries(const Plan& plan) {
  Entries entries;
  for (const Setting& setting : plan.settings) {
    std::string value = setting.text.empty() ? setting.value : setting.text;
    if (!setting.unit.empty()) value += " " + setting.unit;
    std::string why = setting.is_default ? "the default" : "asked for";
    if (!setting.was.empty()) why += ", instead of " + setting.was;
    const std::string exact =
        Join({setting.type, setting.unit, setting.value, setting.text, why}, "\n");
    entries.push_back({setting.name, setting.name, exact, {value, why}});
  }
  return entries;
}

Entries NeedEntries(const Plan& plan) {
  Entries entries;
  for (const Need& need : plan.match.needs) {
    const std::string through =
        Listed(need.inherited_through, [](const Resource& each) { return NameOf(each); });
    entries.push_back({need.step.iri + "\n" + need.capability.iri,
                       NameOf(need.capability),
                       Exact(need.step) + "\n" + Exact(need.capability) + "\n" + Chain(need),
                       {"needed by " + NameOf(need.step), "through " + through}});
  }
  return entries;
}

Entries RequirementEntries(const Plan& plan) {
  Entries entries;
  for (const StepRequirement& requirement : plan.match.requirements) {
    const Finding& finding = requirement.finding;
    const auto name = [](const Resource& each) { return NameOf(each); };
    const auto exact = [](const Resource& each) { return Exact(each); };
    const auto measure = [](const Measure& each) { return Text(each); };
    entries.push_back(
        {finding.what.iri,
         std::string(LocalName(finding.what.as_written)),
         Exact(finding) + "\n" + Listed(requirement.steps, exact),
         {std::string(ToString(finding.availability)), Listed(finding.measures, measure)},
         "of " + Listed(requirement.steps, name) + " by " + Listed(finding.provided_by, exact)});
  }
  return entries;
}

Entries DownloadEntries(const Plan& plan) {
  Entries entries;
  for (const Download& download : plan.match.downloads) {
    const Offer& offer = download.offer;
    entries.push_back({download.what.iri + "\n" + offer.document + "\n" + offer.file,
                       std::string(LocalName(download.what.as_written)),
                       Exact(download.what) + "\n" + Exact(offer),
                       {offer.document + " " + offer.file, "for " + offer.for_what},
                       offer.link + " " + offer.sha256});
  }
  return entries;
}

Entries FindingEntries(const Plan& plan) {
  Entries entries;
  for (const Finding& finding : plan.match.capabilities) {
    entries.push_back({finding.what.iri,
                       std::string(LocalName(finding.what.as_written)),
                       Exact(finding),
                       {std::string(ToString(finding.availability)), finding.explanation},
                       Providers(finding)});
  }
  return entries;
}

Entries InputEntries(const State& state) {
  Entries entries;
  for (const Parameter& input : state.inputs) {
    std::string value = input.value;
    if (!input.unit.empty()) value += " " + input.unit;
    if (!input.text.empty() && input.text != input.value) value += " (" + input.text + ")";
    const std::string exact = Join({input.type, input.unit, input.value, input.frame, input.text,
                                    std::string(ToString(input.source)), Exact(input.origin)},
                                   "\n");
    const std::string iri = input.origin.iri.empty() ? "" : " <" + input.origin.iri + ">";
    entries.push_back({input.name, input.name, exact, {value, Origin(input)}, Origin(input) + iri});
  }
  return entries;
}

Entries OutputEntries(const State& state) {
  Entries entries;
  for (const auto& [output, key] : state.outputs) {
    entries.push_back({output, output, key, {"{" + key + "}", ""}});
  }
  return entries;
}

Entries ClaimEntries(const State& state) {
  Entries entries;
  for (const Resource& claim : state.claims) {
    entries.push_back({claim.iri, "", Exact(claim), {NameOf(claim), ""}});
  }
  return entries;
}

}  // namespace lares::recipes
