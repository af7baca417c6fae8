// Plans of ":Task" for ":robot", and looking things up in them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/recipes/world.h"

namespace lares::testing {

// Over the catalogue and, where given, `more`.
recipes::PlanResult MakePlanOf(const std::string& recipe, const recipes::PlanOptions& options,
                               const std::string& robot, const std::string& more = "");

// A failure and an empty one where there is none.
const recipes::State& StateOf(const recipes::Plan& plan, const std::string& id);
const recipes::Parameter& Input(const recipes::Plan& plan, const std::string& state_id,
                                const std::string& name);
std::vector<std::string> Ids(const recipes::Plan& plan);

#define ASSERT_PLAN(result)                                                 \
  ASSERT_TRUE((result).plan) << ::testing::PrintToString((result).problems) \
                             << ::testing::PrintToString(Labels((result).match.smallest_repair))

}  // namespace lares::testing
