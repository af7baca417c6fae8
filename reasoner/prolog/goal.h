// The goal that the calling thread runs. Inside this folder only.
#pragma once

#include <chrono>
#include <memory>

#include "ontology/triples/view.h"
#include "reasoner/prolog/term_cache.h"

namespace lares::prolog {

struct Goal {
  std::shared_ptr<const rdf::View> view;
  std::shared_ptr<TermCache> cache;
  std::chrono::steady_clock::time_point deadline;
};

// Null outside a goal. The running goal belongs to the thread, so goals of different threads never
// see each other's views.
const Goal* CurrentGoal();

// Makes `goal` the thread's for its own lifetime.
class GoalScope {
 public:
  explicit GoalScope(const Goal& goal);
  ~GoalScope();
  GoalScope(const GoalScope&) = delete;
  GoalScope& operator=(const GoalScope&) = delete;
};

}  // namespace lares::prolog
