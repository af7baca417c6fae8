#include "reasoner/prolog/expert.h"

#include <SWI-Prolog.h>

#include "base/error.h"
#include "base/text.h"
#include "reasoner/prolog/answer_json.h"
#include "reasoner/prolog/goal.h"
#include "reasoner/prolog/runtime.h"
#include "reasoner/prolog/thread_engine.h"

namespace lares::prolog {
namespace {

constexpr int kQueryFlags = PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION | PL_Q_EXT_STATUS;

// Closes the query, and with it every choice point, in whatever way it is left.
class Query {
 public:
  Query(const char* name, int arity, const char* module, term_t arguments)
      : id_(PL_open_query(nullptr, kQueryFlags, PL_predicate(name, arity, module), arguments)) {
    if (id_ == nullptr) throw Error(Code::kTooLarge, "a goal does not fit Prolog's stacks");
  }
  ~Query() { PL_close_query(id_); }
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  int Next() { return PL_next_solution(id_); }
  term_t exception() { return PL_exception(id_); }
  // Keeps what the query bound.
  void Keep() { PL_cut_query(std::exchange(id_, nullptr)); }

 private:
  qid_t id_;
};

int Number(term_t term) {
  int number = 0;
  return PL_get_integer(term, &number) ? number : 0;
}

GoalFault FaultOf(term_t exception) {
  const term_t arguments = PL_new_term_refs(5);
  if (arguments != 0 && PL_put_term(arguments, exception) &&
      PL_call_predicate(nullptr, PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION,
                        PL_predicate("expert_error", 5, "expert"), arguments)) {
    return {TextOf(arguments + 1), TextOf(arguments + 2), Number(arguments + 3),
            Number(arguments + 4)};
  }
  PL_clear_exception();
  return {"thrown", "the goal failed in a way that Prolog cannot put into words"};
}

// The list of Name=Variable.
std::vector<Binding> ReadBindings(term_t list) {
  std::vector<Binding> bindings;
  const term_t rest = PL_copy_term_ref(list), pair = PL_new_term_ref();
  while (PL_get_list(rest, pair, rest)) {
    const term_t name = PL_new_term_ref(), variable = PL_new_term_ref();
    _PL_get_arg(1, pair, name);
    _PL_get_arg(2, pair, variable);
    bindings.emplace_back(TextOf(name), variable);
  }
  return bindings;
}

struct Prepared {
  term_t goal = 0;
  std::vector<Binding> bindings;
  std::optional<GoalFault> fault;
};

Prepared Prepare(std::string_view text, bool prove) {
  if (!IsUtf8(text)) return {0, {}, GoalFault{"syntax", "the goal is not UTF-8"}};
  if (text.find('\0') != std::string_view::npos) {
    return {0, {}, GoalFault{"syntax", "the goal has a character of code 0"}};
  }
  const term_t arguments = PL_new_term_refs(3);
  if (!PL_put_chars(arguments, PL_STRING | REP_UTF8, text.size(), text.data())) {
    PL_clear_exception();
    return {0, {}, GoalFault{"memory", "the goal's text does not fit Prolog's stacks"}};
  }
  Query query(prove ? "expert_goal" : "expert_goal_unproved", 3, "expert", arguments);
  const int status = query.Next();
  if (status == PL_S_EXCEPTION) return {0, {}, FaultOf(query.exception())};
  if (status == PL_S_FALSE) return {0, {}, GoalFault{"refused", "the goal cannot be proved safe"}};
  query.Keep();
  return {arguments + 1, ReadBindings(arguments + 2), {}};
}

}  // namespace

GoalEnd RunExpertGoal(const rdf::View& view, std::string_view text, const ExpertLimits& limits,
                      const std::function<bool(std::string)>& on_answer) {
  AttachThreadEngine(limits.stack_limit_bytes);
  const Goal goal{std::make_shared<const rdf::View>(view), TermCache::For(view.shared_dictionary()),
                  std::chrono::steady_clock::time_point::max()};
  const GoalScope scope(goal);
  const Prepared prepared = Prepare(text, limits.prove);
  GoalEnd end;
  end.fault = prepared.fault;
  if (end.fault) return end;
  Query query("call", 1, "system", prepared.goal);
  while (true) {
    const int status = query.Next();
    if (status == PL_S_EXCEPTION) end.fault = FaultOf(query.exception());
    if (status != PL_S_TRUE && status != PL_S_LAST) return end;
    ++end.answers;
    const bool go_on = on_answer(AnswerJson(view, prepared.bindings));
    if (status == PL_S_LAST) return end;
    if (!go_on || end.answers >= limits.max_answers) {
      end.complete = false;
      return end;
    }
  }
}

void StartExpertProlog() {
  StartProlog();
  constexpr std::size_t kStackLimit = 256u << 20;
  AttachThreadEngine(kStackLimit);
  const fid_t frame = PL_open_foreign_frame();
  const term_t argument = PL_new_term_ref();
  const bool done = PL_put_bool(argument, FALSE) &&
                    PL_call_predicate(nullptr, PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION,
                                      PL_predicate("set_prolog_gc_thread", 1, "system"), argument);
  PL_discard_foreign_frame(frame);
  if (!done) throw Error(Code::kInternal, "Prolog keeps a thread for its garbage");
}

}  // namespace lares::prolog
