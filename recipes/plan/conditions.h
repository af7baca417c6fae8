// What must be so before a skill runs, and what is so afterwards.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recipes/plan/plan.h"

namespace lares::recipes {

// "not holding(object)": as written in a skill template, the argument being the name of an input or
// output, "*" or empty. None for anything else.
std::optional<Fluent> ParseFluent(std::string_view text);

// With what `state` binds in place of the name of an input or output; an input that is left open
// gives an empty argument.
Fluent Ground(Fluent fluent, const State& state);

// Whether one is about what the other is about: the same name, and the same argument, or one
// argument and "*".
bool Touches(const Fluent& a, const Fluent& b);

struct Simulation {
  std::vector<Fluent> assumptions;    // what must be so at the start, by name
  std::vector<std::string> problems;  // one sentence each, with the way that leads there
  bool complete = true;               // false: too many situations, not all were looked at
};
// Goes through everything that may be so in each state. `brought_about` is what earlier steps have
// done, in their order: a problem where it contradicts what must be so at the start.
Simulation Simulate(const Plan& plan, const std::vector<Fluent>& brought_about = {});

}  // namespace lares::recipes
