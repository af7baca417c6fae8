#include <sstream>

#include "recipes/plan/export.h"

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

void WriteState(std::ostream& out, const State& state) {
  out << "  " << Quoted(state.id) << " [";
  if (state.kind == State::Kind::kEnd) {
    out << "shape=doublecircle, fontsize=10, margin=0, color="
        << (state.success ? "darkgreen" : "firebrick") << ", label=" << Quoted(state.label);
  } else {
    // Two parts, escaped apart: the line break between them is Graphviz's.
    out << "label=\"" << Escaped(state.label) << "\\n" << Escaped(state.skill) << '"';
  }
  out << "];\n";
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

}  // namespace

std::string ToDot(const Plan& plan) {
  std::ostringstream out;
  out << "digraph " << Quoted(plan.task.label) << " {\n"
      << "  label=" << Quoted(plan.task.label + " by " + plan.robot.label) << ";\n"
      << "  labelloc=t;\n  fontname=Helvetica;\n"
      << "  node [shape=box, style=rounded, fontname=Helvetica];\n"
      << "  edge [fontname=Helvetica, fontsize=10];\n"
      << "  \"[start]\" [shape=point, width=0.15, label=\"\"];\n";
  for (const State& state : plan.states) WriteState(out, state);
  out << "  \"[start]\" -> " << Quoted(plan.start) << ";\n";
  for (const Transition& transition : plan.transitions) WriteTransition(out, transition);
  out << "}\n";
  return out.str();
}

}  // namespace lares::recipes
