#include "reasoner/prolog/engine_pool.h"

#include <SWI-Prolog.h>

#include <condition_variable>
#include <functional>
#include <mutex>

#include "base/error.h"
#include "reasoner/prolog/goal.h"
#include "reasoner/prolog/record.h"
#include "reasoner/prolog/runtime.h"
#include "reasoner/prolog/terms.h"
#include "reasoner/prolog/thread_engine.h"
#include "reasoner/prolog/watchdog.h"

namespace lares::prolog {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMaxMessage = 8192;

// ---- Exceptions --------------------------------------------------------------------------------

std::optional<Code> CodeOfName(std::string_view name) {
  for (int i = 0; i <= static_cast<int>(Code::kInternal); ++i) {
    if (ToString(static_cast<Code>(i)) == name) return static_cast<Code>(i);
  }
  return std::nullopt;
}

// The message that Prolog would print.
std::string MessageOf(term_t exception) {
  const term_t arguments = PL_new_term_refs(2);
  std::string text;
  if (PL_put_term(arguments, exception) &&
      PL_call_predicate(nullptr, PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION,
                        PL_predicate("error_text", 2, "edge"), arguments)) {
    text = TextOf(arguments + 1);
  }
  if (text.empty()) text = "a rule failed in a way that Prolog cannot put into words";
  if (text.size() > kMaxMessage) text = text.substr(0, kMaxMessage) + " …";
  return text;
}

bool HasFunctor(term_t term, const char* name, std::size_t arity) {
  atom_t found = 0;
  std::size_t found_arity = 0;
  return PL_get_name_arity(term, &found, &found_arity) && found_arity == arity &&
         std::string_view(PL_atom_chars(found)) == name;
}

term_t ArgumentOf(term_t term, std::size_t index) {
  const term_t argument = PL_new_term_ref();
  _PL_get_arg(index, term, argument);
  return argument;
}

// error(Formal, Context) is what its Formal is.
term_t FormalOf(term_t exception) {
  return HasFunctor(exception, "error", 2) ? ArgumentOf(exception, 1) : exception;
}

Error ErrorOf(term_t exception) {
  const term_t formal = FormalOf(exception);
  if (HasFunctor(formal, "lares_error", 2)) {
    const term_t message = ArgumentOf(formal, 2);
    std::string text = TextOf(message);
    if (text.empty()) text = MessageOf(exception);
    const auto code = CodeOfName(TextOf(ArgumentOf(formal, 1)));
    return Error(code.value_or(Code::kInternal), text);
  }
  if (HasFunctor(formal, "resource_error", 1)) {
    return Error(Code::kTooLarge,
                 "a rule needs more memory than it may have: " + MessageOf(exception));
  }
  return Error(Code::kInternal, MessageOf(exception));
}

// ---- A query -----------------------------------------------------------------------------------

// Closes the query, and with it every choice point, in whatever way it is left.
class Query {
 public:
  Query(predicate_t predicate, term_t arguments)
      : id_(PL_open_query(nullptr, PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION | PL_Q_EXT_STATUS, predicate,
                          arguments)) {
    if (id_ == nullptr) {
      PL_clear_exception();
      throw Error(Code::kTooLarge, "a goal does not fit Prolog's stacks");
    }
  }
  ~Query() { PL_close_query(id_); }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  // PL_S_TRUE, PL_S_LAST or PL_S_FALSE; an exception is thrown as an Error.
  int Next(Clock::time_point deadline) {
    const int status = PL_next_solution(id_);
    if (status != PL_S_EXCEPTION) return status;
    const term_t exception = PL_exception(id_);
    if (Clock::now() >= deadline && TextOf(exception) == kDeadlineBall) {
      throw Error(Code::kTimeout, "a rule took longer than it may");
    }
    throw ErrorOf(exception);
  }

 private:
  qid_t id_;
};

class ForeignFrame {
 public:
  ForeignFrame() : frame_(PL_open_foreign_frame()) {}
  ~ForeignFrame() { PL_discard_foreign_frame(frame_); }
  ForeignFrame(const ForeignFrame&) = delete;
  ForeignFrame& operator=(const ForeignFrame&) = delete;

 private:
  fid_t frame_;
};

// What becomes of an answer; false for no further ones.
using Accept = std::function<bool(term_t)>;

// Calls `accept` for each answer until it returns false. Needs an attached engine.
void Run(const std::string& module, const std::string& predicate, const std::vector<Value>& inputs,
         Clock::time_point deadline, const Accept& accept) {
  const ForeignFrame frame;
  const int arity = static_cast<int>(inputs.size()) + 1;
  const term_t arguments = PL_new_term_refs(arity);
  for (std::size_t i = 0; i < inputs.size(); ++i) PutValue(inputs[i], arguments + i);
  Query query(PL_predicate(predicate.c_str(), arity, module.c_str()), arguments);
  int status = PL_S_TRUE;
  while (status == PL_S_TRUE) {
    status = query.Next(deadline);
    if (status == PL_S_FALSE || !accept(arguments + inputs.size())) return;
  }
}

}  // namespace

// ---- The pool ----------------------------------------------------------------------------------

struct EnginePool::State {
  explicit State(const Options& wanted)
      : options(wanted), watchdog(StartProlog()), free(wanted.engines) {}

  const Options options;
  Watchdog watchdog;
  std::mutex mutex;
  std::condition_variable freed;
  int free;  // goals that may start now
};

namespace {

// Engines that wait on their threads for a next goal; beyond it a thread gives its own back.
constexpr int kIdleEngines = 32;

// Leave to run a goal, and an engine of the calling thread to run it on.
template <typename Pool>
class Lease {
 public:
  Lease(Pool& pool, Clock::time_point deadline) : pool_(pool) {
    std::unique_lock lock(pool_.mutex);
    if (!pool_.freed.wait_until(lock, deadline, [&] { return pool_.free > 0; })) {
      throw Error(Code::kTimeout, "every Prolog engine was busy for too long");
    }
    --pool_.free;
  }
  ~Lease() {
    if (is_spent_ || LiveThreadEngines() > kIdleEngines) DropThreadEngine();
    {
      const std::lock_guard lock(pool_.mutex);
      ++pool_.free;
    }
    pool_.freed.notify_one();
  }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

  // The engine's stacks have grown to their limit: the next goal gets a fresh one.
  void MarkSpent() { is_spent_ = true; }

 private:
  Pool& pool_;
  bool is_spent_ = false;
};

template <typename Pool>
void Solve(Pool& pool, const rdf::View& view, const std::string& module,
           const std::string& predicate, const std::vector<Value>& inputs, const Limits& limits,
           const Accept& accept) {
  if (CurrentGoal() != nullptr) throw Error(Code::kInternal, "a goal was started inside a goal");
  const Clock::time_point deadline = Clock::now() + limits.time;
  Lease<Pool> lease(pool, deadline);
  AttachThreadEngine(pool.options.stack_limit_bytes);
  const Goal goal{std::make_shared<const rdf::View>(view), TermCache::For(view.shared_dictionary()),
                  deadline};
  const GoalScope scope(goal);
  const Watchdog::Watch watch(pool.watchdog, deadline);
  try {
    Run(module, predicate, inputs, deadline, accept);
  } catch (const Error& error) {
    if (error.code() == Code::kTooLarge) lease.MarkSpent();
    throw;
  }
}

}  // namespace

EnginePool::EnginePool(const Options& options) {
  if (options.engines < 1) throw Error(Code::kInvalid, "engines must be at least 1");
  state_ = std::make_unique<State>(options);
}

EnginePool::~EnginePool() = default;

std::optional<Value> EnginePool::Once(const rdf::View& view, const std::string& module,
                                      const std::string& predicate,
                                      const std::vector<Value>& inputs, const Limits& limits) {
  std::optional<Value> answer;
  Solve(*state_, view, module, predicate, inputs, limits, [&](term_t term) {
    answer = GetValue(term);
    return false;
  });
  return answer;
}

RecordRef EnginePool::Keep(const rdf::View& view, const std::string& module,
                           const std::string& predicate, const std::vector<Value>& inputs,
                           const Limits& limits) {
  RecordRef answer;
  Solve(*state_, view, module, predicate, inputs, limits, [&](term_t term) {
    answer = std::make_shared<const Record>(term);
    return false;
  });
  return answer;
}

std::vector<Value> EnginePool::All(const rdf::View& view, const std::string& module,
                                   const std::string& predicate, const std::vector<Value>& inputs,
                                   const Limits& limits) {
  std::vector<Value> answers;
  Solve(*state_, view, module, predicate, inputs, limits, [&](term_t term) {
    if (answers.size() == limits.max_answers) {
      throw Error(Code::kTooLarge, module + ":" + predicate + " has more than " +
                                       std::to_string(limits.max_answers) + " answers");
    }
    answers.push_back(GetValue(term));
    return true;
  });
  return answers;
}

}  // namespace lares::prolog
