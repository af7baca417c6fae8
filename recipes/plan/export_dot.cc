#include <sstream>

#include "recipes/plan/export.h"
#include "recipes/plan/export_words.h"
#include "recipes/plan/shape.h"

namespace lares::recipes {

namespace {

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    if (c == '\n') {
      escaped += "\\n";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string Quoted(const std::string& text) { return '"' + Escaped(text) + '"'; }

void WriteEnd(std::ostream& out, const State& state) {
  out << "  " << Quoted(state.id) << " [shape=doublecircle, fontsize=10, margin=0, color="
      << (state.success ? "darkgreen" : "firebrick") << ", label=" << Quoted(state.label) << "];\n";
}

// Parts are escaped apart: the line breaks between them are Graphviz's.
void WriteSkill(std::ostream& out, const State& state, const char* indent) {
  out << indent << Quoted(state.id) << " [label=\"" << Escaped(state.label) << "\\n"
      << Escaped(state.skill);
  const std::string attempts = AttemptsText(state);
  if (!attempts.empty()) out << "\\n" << Escaped(attempts);
  out << "\"];\n";
}

// A box around the members, with a bar on top of them that the ways lead to and from.
void WriteParallel(std::ostream& out, const Plan& plan, const State& state) {
  out << "  subgraph " << Quoted("cluster_" + state.id) << " {\n"
      << "    label=\"side by side\";\n    labeljust=l;\n    fontsize=10;\n"
      << "    style=\"rounded,filled\";\n    color=gray70;\n    fillcolor=gray96;\n    "
      << Quoted(state.id)
      << " [shape=box, style=filled, fillcolor=black, height=0.06, width=1.6, fixedsize=true, "
         "label=\"\", tooltip="
      << Quoted(state.label) << "];\n";
  for (const std::string& id : state.members) {
    if (const State* member = FindState(plan, id)) WriteSkill(out, *member, "    ");
  }
  for (const std::string& id : state.members) {
    out << "    " << Quoted(state.id) << " -> " << Quoted(id)
        << " [arrowhead=none, color=gray50];\n";
  }
  out << "  }\n";
}

void WriteState(std::ostream& out, const Plan& plan, const State& state) {
  if (state.kind == State::Kind::kEnd) {
    WriteEnd(out, state);
  } else if (state.kind == State::Kind::kParallel) {
    WriteParallel(out, plan, state);
  } else if (state.parallel.empty()) {
    WriteSkill(out, state, "  ");
  }
}

void WriteTransition(std::ostream& out, const Transition& transition) {
  out << "  " << Quoted(transition.from) << " -> " << Quoted(transition.to)
      << " [label=" << Quoted(transition.outcome);
  if (transition.added) {
    out << ", style=dashed";
    if (transition.outcome == "failed") out << ", color=gray60, fontcolor=gray60";
    if (!transition.reason.empty()) out << ", tooltip=" << Quoted(transition.reason);
  }
  out << "];\n";
}

// What the plan was asked for and takes for granted, in a note beside it.
void WriteNote(std::ostream& out, const Plan& plan) {
  std::string note;
  for (const Setting& setting : plan.settings) {
    note += Escaped(setting.name + " = " + (setting.text.empty() ? setting.value : setting.text)) +
            (setting.unit.empty() ? "" : " " + Escaped(setting.unit)) + "\\l";
  }
  if (!plan.assumptions.empty()) note += "at the start:\\l";
  for (const Fluent& fluent : plan.assumptions) note += "  " + Escaped(ToText(fluent)) + "\\l";
  if (note.empty()) return;
  out << "  \"[note]\" [shape=note, style=filled, fillcolor=lightyellow, fontsize=10, label=\""
      << note << "\"];\n";
}

}  // namespace

std::string ToDot(const Plan& plan) {
  std::ostringstream out;
  out << "digraph " << Quoted(plan.task.label) << " {\n"
      << "  label=" << Quoted(plan.task.label + " by " + plan.robot.label) << ";\n"
      << "  labelloc=t;\n  fontname=Helvetica;\n"
      << "  node [shape=box, style=rounded, fontname=Helvetica];\n"
      << "  edge [fontname=Helvetica, fontsize=10];\n"
      << "  \"[start]\" [shape=point, width=0.15, label=\"\"];\n";
  WriteNote(out, plan);
  for (const State& state : plan.states) WriteState(out, plan, state);
  out << "  \"[start]\" -> " << Quoted(plan.start) << ";\n";
  for (const Transition& transition : plan.transitions) WriteTransition(out, transition);
  out << "}\n";
  return out.str();
}

}  // namespace lares::recipes
