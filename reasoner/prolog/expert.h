// Goals that experts write, run in this process. The process is the limit: see
// reasoner/prolog_worker/, which is the only caller outside of tests.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "ontology/triples/view.h"

namespace lares::prolog {

struct ExpertLimits {
  std::size_t max_answers = 1000;
  std::size_t stack_limit_bytes = 256u << 20;
  bool prove = true;  // refuse what is not proved to be read-only; false in tests of the process
};

// What is wrong with a goal. `kind`: syntax, refused, unbound, type, domain, existence, evaluation,
// memory, thrown.
struct GoalFault {
  std::string kind;
  std::string message;
  int line = 0;  // from 1; 0: not known
  int column = 0;
};

struct GoalEnd {
  std::size_t answers = 0;
  bool complete = true;  // false: there may be more answers than were asked for
  std::optional<GoalFault> fault;
};

// Runs the goal on the calling thread, which must be the only one that uses Prolog; `on_answer`
// gets each answer as a JSON object (see answer_json.h) and returns false to end the goal. No
// answer and no fault is "no". Nothing inside bounds its time, and its memory only roughly.
GoalEnd RunExpertGoal(const rdf::View& view, std::string_view text, const ExpertLimits& limits,
                      const std::function<bool(std::string)>& on_answer);

// Starts Prolog, without a thread of its own for collecting garbage.
void StartExpertProlog();

}  // namespace lares::prolog
