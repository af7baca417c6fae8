#include "reasoner/prolog/runtime.h"

#include <SWI-Prolog.h>

#include <mutex>

#include "base/error.h"
#include "reasoner/prolog/bundled_rules.h"
#include "reasoner/prolog/goal.h"
#include "reasoner/prolog/rdf_predicates.h"
#include "reasoner/prolog/thread_engine.h"

namespace lares::prolog {
namespace {

// Runs in the goal's own thread. A signal may arrive late, when the engine has its next goal.
void OnDeadline(int /*signal*/) {
  const Goal* goal = CurrentGoal();
  if (goal == nullptr || std::chrono::steady_clock::now() < goal->deadline) return;
  const term_t exception = PL_new_term_ref();
  if (PL_put_atom_chars(exception, kDeadlineBall)) PL_raise_exception(exception);
}

int InstallDeadlineSignal() {
  pl_sigaction_t action{};
  action.sa_cfunction = OnDeadline;
  action.sa_flags = PLSIG_SYNC;
  return PL_sigaction(0, &action, nullptr);
}

int Initialise() {
  const auto rules = BundledRules();
  // "lares" is not looked for: the state holds all that Prolog needs.
  static const char* arguments[] = {"lares",        "-q",           "-f",
                                    "none",         "--no-signals", "--no-packs",
                                    "--sigalert=0", "--no-tty",     "--no-debug-on-interrupt",
                                    nullptr};
  constexpr int kCount = static_cast<int>(std::size(arguments)) - 1;
  if (!PL_set_resource_db_mem(rules.data(), rules.size()) ||
      !PL_initialise(kCount, const_cast<char**>(arguments))) {
    throw Error(Code::kInternal, "SWI-Prolog does not start");
  }
  RegisterRdfPredicates();
  const int signal = InstallDeadlineSignal();
  PL_set_engine(nullptr, nullptr);  // the first engine belongs to nobody
  if (signal <= 0) throw Error(Code::kInternal, "SWI-Prolog gives no signal");
  return signal;
}

}  // namespace

int StartProlog() {
  static const int signal = Initialise();
  return signal;
}

void LoadRuleFile(const std::filesystem::path& file) {
  static std::mutex mutex;
  constexpr std::size_t kStackLimit = 256u << 20;
  StartProlog();
  const std::lock_guard lock(mutex);
  AttachThreadEngine(kStackLimit);
  const fid_t frame = PL_open_foreign_frame();
  const term_t argument = PL_new_term_ref();
  const std::string path = file.string();
  const bool loaded = PL_put_atom_nchars(argument, path.size(), path.data()) &&
                      PL_call_predicate(nullptr, PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION,
                                        PL_predicate("load_test_file", 1, "edge"), argument);
  PL_discard_foreign_frame(frame);
  if (!loaded) throw Error(Code::kInvalid, "the rule file did not load", Place{path});
}

}  // namespace lares::prolog
