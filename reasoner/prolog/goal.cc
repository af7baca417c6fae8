#include "reasoner/prolog/goal.h"

#include "base/error.h"

namespace lares::prolog {
namespace {

thread_local const Goal* current_goal = nullptr;

}  // namespace

const Goal* CurrentGoal() { return current_goal; }

GoalScope::GoalScope(const Goal& goal) {
  if (current_goal != nullptr) throw Error(Code::kInternal, "a goal was started inside a goal");
  current_goal = &goal;
}

GoalScope::~GoalScope() { current_goal = nullptr; }

}  // namespace lares::prolog
