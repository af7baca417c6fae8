// The one door to SWI-Prolog: bundled rule modules, pooled engines, goals over a pinned view.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/prolog/value.h"

namespace lares::prolog {

struct Options {
  int engines = 4;  // goals that may run at once; others wait
  std::size_t stack_limit_bytes = 256u << 20;
};

struct Limits {
  std::chrono::milliseconds time{10'000};  // kTimeout beyond it
  std::size_t max_answers = 100'000;       // kTooLarge beyond it
};

// Goals run only predicates of our own bundled modules (reasoner/rules/*.pl). While a goal runs,
// rdf/3, rdf_asserted/3 and the like answer from `view`, which stays pinned until the goal has
// ended in whatever way. A goal runs on the calling thread, on an engine which that thread keeps
// for its next goal. Thread-safe; one per process.
class EnginePool {
 public:
  explicit EnginePool(const Options& options = {});
  ~EnginePool();
  EnginePool(const EnginePool&) = delete;
  EnginePool& operator=(const EnginePool&) = delete;

  // Calls module:predicate(inputs…, Answer). The first answer; nothing for "no". An uncaught Prolog
  // exception is an Error: lares_error(Code, Message) gives that code ("not-found", …) and text,
  // anything else kInternal with the message that Prolog would print.
  std::optional<Value> Once(const rdf::View& view, const std::string& module,
                            const std::string& predicate, const std::vector<Value>& inputs,
                            const Limits& limits = {});
  // The same, the answer kept in Prolog's own form, to be an input of other goals; null for "no".
  RecordRef Keep(const rdf::View& view, const std::string& module, const std::string& predicate,
                 const std::vector<Value>& inputs, const Limits& limits = {});
  // All answers, in order.
  std::vector<Value> All(const rdf::View& view, const std::string& module,
                         const std::string& predicate, const std::vector<Value>& inputs,
                         const Limits& limits = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lares::prolog
