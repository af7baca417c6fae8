#include <cstdio>
#include <sstream>

#include "base/text.h"
#include "recipes/plan/export.h"
#include "recipes/plan/export_words.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

void WriteInputs(std::ostream& out, const State& state) {
  for (const Parameter& input : state.inputs) {
    out << "       " << input.name << " = " << (input.text.empty() ? input.value : input.text);
    if (input.type == "pose" && KeyOf(input.value).empty()) {
      out << " (" << input.value << (input.frame.empty() ? "" : " in " + input.frame) << ")";
    }
    out << "  [" << ToString(input.source) << "]\n";
  }
}

void WriteWays(std::ostream& out, const Plan& plan, const State& state) {
  for (const Transition& transition : plan.transitions) {
    if (transition.from != state.id) continue;
    if (transition.added && transition.outcome == "failed") continue;  // said once, below
    out << "       " << transition.outcome << " -> " << transition.to;
    if (transition.added) out << "  (added: " << transition.reason << ")";
    out << "\n";
  }
}

void WriteNotes(std::ostream& out, const std::vector<std::string>& notes, const char* title) {
  if (notes.empty()) return;
  out << title << "\n";
  for (const std::string& note : notes) out << "  - " << note << "\n";
}

// As its document spells it: what a person would search a robot's or recipe's file for.
std::string Name(const Resource& resource) { return std::string(LocalName(resource.as_written)); }

// The name, and the label where it says more.
std::string FullName(const Resource& resource) {
  const std::string name = Name(resource);
  return resource.label == name ? name : name + " (" + resource.label + ")";
}

std::string Joined(const std::vector<Resource>& resources, const char* separator) {
  std::string text;
  for (const Resource& resource : resources) {
    if (!text.empty()) text += separator;
    text += Name(resource);
  }
  return text;
}

const char* Mark(Availability availability) {
  switch (availability) {
    case Availability::kAvailable:
      return "yes ";
    case Availability::kOnMakersWord:
      return "word";
    case Availability::kDownloadable:
      return "load";
    case Availability::kInsufficient:
      return "LOW ";
    default:
      return "NO  ";
  }
}

void WriteFinding(std::ostream& out, const Finding& finding, int depth) {
  out << "  " << std::string(static_cast<std::size_t>(2 * depth), ' ') << Mark(finding.availability)
      << " " << Name(finding.what) << ": " << finding.explanation << "\n";
  if (finding.availability == Availability::kAvailable) return;
  for (const Finding& dependency : finding.dependencies) WriteFinding(out, dependency, depth + 1);
}

std::string NameOf(const RepairItem& item) {
  const std::size_t bounds = item.text.size() - std::min(item.text.size(), item.what.label.size());
  return Name(item.what) + item.text.substr(item.text.size() - bounds);
}

void WriteRepairs(std::ostream& out, const MatchReport& report) {
  for (std::size_t i = 0; i < report.repairs.size(); ++i) {
    const Repair& repair = report.repairs[i];
    if (i == 0) {
      out << (report.repair_is_smallest ? "The smallest repair is to add: "
                                        : "A repair is to add: ");
    } else {
      out << "  or to add: ";
    }
    for (std::size_t j = 0; j < repair.add.size(); ++j) {
      out << (j == 0 ? "" : ", ") << NameOf(repair.add[j]);
    }
    out << (i == 0 ? ".\n" : "\n");
  }
}

std::string Texts(const std::vector<Fluent>& fluents) {
  std::vector<std::string> texts;
  for (const Fluent& fluent : fluents) texts.push_back(ToText(fluent));
  return Join(texts, ", ");
}

void WriteConditions(std::ostream& out, const State& state) {
  const std::string attempts = AttemptsText(state);
  if (!attempts.empty()) out << "       " << attempts << "\n";
  if (!state.claims.empty()) out << "       uses " << Joined(state.claims, ", ") << "\n";
  if (!state.preconditions.empty()) out << "       needs " << Texts(state.preconditions) << "\n";
  std::map<std::string, std::vector<Fluent>> effects;
  for (const Effect& effect : state.effects) effects[effect.outcome].push_back(effect.fluent);
  for (const auto& [outcome, fluents] : effects) {
    out << "       after " << outcome << ": " << Texts(fluents) << "\n";
  }
}

void WriteSettings(std::ostream& out, const Plan& plan) {
  if (!plan.settings.empty()) out << "Settings:\n";
  for (const Setting& setting : plan.settings) {
    out << "  " << setting.name << " = " << (setting.text.empty() ? setting.value : setting.text);
    if (!setting.unit.empty()) out << " " << setting.unit;
    if (!setting.is_default) out << "  [asked for]";
    if (!setting.was.empty()) out << "  (instead of " << setting.was << ")";
    out << "\n";
  }
  if (!plan.assumptions.empty()) {
    out << "At the start it must be so: " << Texts(plan.assumptions) << ".\n";
  }
  if (!plan.done.empty()) out << "Done already: " << Join(plan.done, ", ") << ".\n";
  if (!plan.given.empty()) out << "Known from that: " << Join(plan.given, ", ") << ".\n";
}

void WriteState(std::ostream& out, const Plan& plan, const State& state, int number) {
  char label[8];
  std::snprintf(label, sizeof label, "%3d. ", number % 1000);
  out << label << state.id << ": ";
  if (state.kind == State::Kind::kParallel) {
    out << "side by side " << Join(state.members, ", ") << "\n";
  } else {
    out << state.skill;
    if (!state.parallel.empty()) out << "  (side by side, in " << state.parallel << ")";
    out << "\n";
  }
  WriteInputs(out, state);
  WriteConditions(out, state);
  WriteWays(out, plan, state);
}

}  // namespace

std::string AttemptsText(const State& state) {
  if (!state.tree_fragment.empty()) return "in the template's own decorators";
  std::string text;
  if (state.retries > 0) text = "up to " + std::to_string(state.retries + 1) + " times";
  if (state.time_limit_s > 0) {
    char limit[32];
    std::snprintf(limit, sizeof limit, "%.4g s", state.time_limit_s);
    text += text.empty() ? std::string("at most ") + limit : std::string(", ") + limit + " each";
  }
  return text;
}

std::string_view ToString(Measure::Verdict verdict) {
  switch (verdict) {
    case Measure::Verdict::kMet:
      return "met";
    case Measure::Verdict::kUnknown:
      return "unknown";
    case Measure::Verdict::kInsufficient:
      return "insufficient";
  }
  return "unknown";
}

std::string ToText(const Plan& plan) {
  std::ostringstream out;
  out << "Plan: " << FullName(plan.task) << ", for " << plan.robot.label;
  if (!plan.environment.empty()) {
    out << ", in " << plan.environment << " (version " << plan.environment_version << ")";
  }
  out << "\n";
  WriteSettings(out, plan);
  int number = 0;
  bool fails = false;
  for (const State& state : plan.states) {
    if (state.kind != State::Kind::kEnd) WriteState(out, plan, state, ++number);
  }
  for (const Transition& transition : plan.transitions) {
    fails = fails || (transition.added && transition.outcome == "failed");
  }
  if (fails) {
    out << "Where a step can fail and the recipe does not say what then, the plan ends as "
           "failed.\n";
  }
  WriteNotes(out, plan.notes, "Notes:");
  WriteNotes(out, plan.match.warnings, "Warnings:");
  return out.str();
}

std::string ToText(const MatchReport& report) {
  std::ostringstream out;
  out << report.robot.label << (report.feasible ? " can do " : " cannot do ")
      << FullName(report.task) << ".\n";
  if (!report.needs.empty()) out << "The steps need:\n";
  for (const Need& need : report.needs) {
    out << "  " << Name(need.step) << " needs " << Name(need.capability);
    if (need.inherited_through.size() > 1) {
      out << "  (through " << Joined(need.inherited_through, " < ") << ")";
    }
    out << "\n";
  }
  if (!report.capabilities.empty()) out << "The robot has:\n";
  for (const Finding& finding : report.capabilities) WriteFinding(out, finding, 0);
  if (!report.requirements.empty()) out << "The steps require in numbers:\n";
  for (const StepRequirement& requirement : report.requirements) {
    WriteFinding(out, requirement.finding, 0);
  }
  if (!report.downloads.empty()) out << "To be downloaded:\n";
  for (const Download& download : report.downloads) {
    out << "  " << Name(download.what) << ": " << download.offer.document << " "
        << download.offer.file << "\n";
  }
  WriteRepairs(out, report);
  WriteNotes(out, report.warnings, "Warnings:");
  return out.str();
}

}  // namespace lares::recipes
