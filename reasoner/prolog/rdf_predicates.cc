#include "reasoner/prolog/rdf_predicates.h"

#include <SWI-Prolog.h>

#include <atomic>
#include <charconv>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "base/text.h"
#include "reasoner/prolog/cursor.h"
#include "reasoner/prolog/foreign.h"
#include "reasoner/prolog/goal.h"

namespace lares::prolog {
namespace {

// Set once by RegisterRdfPredicates(), before any goal runs.
functor_t literal_functor = 0;
atom_t all_atom = 0;

std::atomic<int> live_choice_points{0};

const Goal& RunningGoal() {
  if (const Goal* goal = CurrentGoal()) return *goal;
  ThrowExistenceError("rdf_view", "current");
}

// Throws PendingException when the goal's time is over. Failure-driven loops over a foreign
// predicate meet no call port where Prolog itself would look.
void CheckTime() {
  if (PL_handle_signals() < 0) throw PendingException();
}

// ---- Terms -------------------------------------------------------------------------------------

// One argument of a pattern: any term, one term, or literals of which a part is known.
struct Slot {
  bool matches_nothing = false;  // a term that the dictionary has never seen
  rdf::TermId id = rdf::kAnyTerm;
  bool is_partial_literal = false;
};

struct LiteralParts {
  term_t part[3];  // lexical form, datatype, language
};

LiteralParts PartsOf(term_t literal) {
  const term_t first = PL_new_term_refs(3);
  const LiteralParts parts{{first, first + 1, first + 2}};
  for (int i = 0; i < 3; ++i) _PL_get_arg(i + 1, literal, parts.part[i]);
  return parts;
}

void CheckLiteralPart(term_t part) {
  if (!PL_is_variable(part) && !PL_is_atom(part) && !PL_is_string(part)) {
    ThrowTypeError("atom", part);
  }
}

Slot LiteralSlot(const Goal& goal, term_t literal) {
  const LiteralParts parts = PartsOf(literal);
  Slot slot;
  for (const term_t part : parts.part) {
    CheckLiteralPart(part);
    if (PL_is_variable(part)) slot.is_partial_literal = true;
  }
  if (slot.is_partial_literal) return slot;
  const std::string lexical = TextOf(parts.part[0]), datatype = TextOf(parts.part[1]),
                    language = TextOf(parts.part[2]);
  const auto id =
      goal.view->dictionary().Find({rdf::TermKind::kLiteral, lexical, datatype, language});
  if (id) slot.id = *id;
  slot.matches_nothing = !id;
  return slot;
}

Slot SlotOf(const Goal& goal, term_t term) {
  if (PL_is_variable(term)) return {};
  if (PL_is_functor(term, literal_functor)) return LiteralSlot(goal, term);
  atom_t atom = 0;
  if (!PL_is_atom(term) || !PL_get_atom(term, &atom)) ThrowTypeError("rdf_term", term);
  const auto id = goal.cache->IdOf(atom);
  return id ? Slot{false, *id, false} : Slot{true, rdf::kAnyTerm, false};
}

bool UnifyLiteral(const TermCache::Atoms& atoms, term_t term) {
  if (PL_is_variable(term)) {
    const term_t arguments = PL_new_term_refs(3), literal = PL_new_term_ref();
    return PL_put_atom(arguments, atoms.value) && PL_put_atom(arguments + 1, atoms.datatype) &&
           PL_put_atom(arguments + 2, atoms.language) &&
           PL_cons_functor_v(literal, literal_functor, arguments) && PL_unify(term, literal);
  }
  if (!PL_is_functor(term, literal_functor)) return false;
  const LiteralParts parts = PartsOf(term);
  const AtomRef found[] = {atoms.value, atoms.datatype, atoms.language};
  for (int i = 0; i < 3; ++i) {
    if (PL_is_string(parts.part[i])) {
      const term_t text = PL_new_term_ref();
      if (!PL_put_atom(text, found[i]) || TextOf(text) != TextOf(parts.part[i])) return false;
    } else if (!PL_unify_atom(parts.part[i], found[i])) {
      return false;
    }
  }
  return true;
}

bool UnifyTerm(const Goal& goal, rdf::TermId id, term_t term) {
  const TermCache::Atoms atoms = goal.cache->AtomsOf(id);
  return atoms.datatype == 0 ? PL_unify_atom(term, atoms.value) : UnifyLiteral(atoms, term);
}

// ---- Patterns ----------------------------------------------------------------------------------

struct Query {
  bool is_empty = false;
  rdf::Pattern pattern;
};

// A partial literal narrows only when answers are unified.
Query QueryOf(const Goal& goal, term_t subject, term_t predicate, term_t object) {
  const Slot slots[] = {SlotOf(goal, subject), SlotOf(goal, predicate), SlotOf(goal, object)};
  Query query;
  query.pattern = {slots[0].id, slots[1].id, slots[2].id};
  query.is_empty = slots[0].matches_nothing || slots[1].matches_nothing ||
                   slots[2].matches_nothing || slots[0].is_partial_literal ||
                   slots[1].is_partial_literal;
  return query;
}

// What a choice point holds.
struct Choices {
  explicit Choices(Cursor rest) : cursor(std::move(rest)) { ++live_choice_points; }
  ~Choices() { --live_choice_points; }
  Choices(const Choices&) = delete;
  Choices& operator=(const Choices&) = delete;

  Cursor cursor;
};

bool UnifyTriple(const Goal& goal, const rdf::Pattern& pattern, const rdf::Triple& triple,
                 term_t arguments) {
  return (pattern.subject != rdf::kAnyTerm || UnifyTerm(goal, triple.subject, arguments)) &&
         (pattern.predicate != rdf::kAnyTerm || UnifyTerm(goal, triple.predicate, arguments + 1)) &&
         (pattern.object != rdf::kAnyTerm || UnifyTerm(goal, triple.object, arguments + 2));
}

// Unifies the next triple that unifies; false when there is none.
bool UnifyNext(const Goal& goal, Cursor& cursor, term_t arguments) {
  const rdf::Pattern& pattern = cursor.pattern();
  const fid_t frame = PL_open_foreign_frame();
  rdf::Triple triple;
  bool found = false;
  while (!found && cursor.Next(&triple)) {
    found = UnifyTriple(goal, pattern, triple, arguments);
    if (found) break;
    if (PL_exception(0)) {
      PL_close_foreign_frame(frame);
      throw PendingException();
    }
    PL_rewind_foreign_frame(frame);
  }
  PL_close_foreign_frame(frame);
  return found;
}

foreign_t Answer(const Goal& goal, std::unique_ptr<Choices> choices, term_t arguments) {
  if (!UnifyNext(goal, choices->cursor, arguments)) return FALSE;
  if (choices->cursor.Done()) return TRUE;
  PL_retry_address(choices.release());
}

// The first answer; a choice point is made only when there may be more.
foreign_t FirstAnswer(const Goal& goal, Cursor cursor, term_t arguments) {
  if (!UnifyNext(goal, cursor, arguments)) return FALSE;
  if (cursor.Done()) return TRUE;
  PL_retry_address(new Choices(std::move(cursor)));
}

foreign_t NextAnswer(control_t control, term_t arguments) {
  std::unique_ptr<Choices> choices(static_cast<Choices*>(PL_foreign_context_address(control)));
  if (PL_foreign_control(control) == PL_PRUNED) return TRUE;
  return Guard([&] {
    CheckTime();
    return Answer(RunningGoal(), std::move(choices), arguments);
  });
}

// match(?S, ?P, ?O, +Origin)
foreign_t Match(term_t arguments, int /*arity*/, control_t control) {
  if (PL_foreign_control(control) != PL_FIRST_CALL) return NextAnswer(control, arguments);
  return Guard([&]() -> foreign_t {
    CheckTime();
    const Goal& goal = RunningGoal();
    const Query query = QueryOf(goal, arguments, arguments + 1, arguments + 2);
    if (query.is_empty) return FALSE;
    atom_t origin = 0;
    if (!PL_get_atom(arguments + 3, &origin)) ThrowTypeError("origin", arguments + 3);
    const auto which = origin == all_atom ? rdf::Origin::kAll : rdf::Origin::kAsserted;
    return FirstAnswer(goal, Cursor(goal.view, query.pattern, which), arguments);
  });
}

std::string RequiredAtom(term_t term, const char* type) {
  if (PL_is_variable(term)) ThrowInstantiationError();
  if (!PL_is_atom(term) && !PL_is_string(term)) ThrowTypeError(type, term);
  return TextOf(term);
}

// match_in(?S, ?P, ?O, +Graph)
foreign_t MatchIn(term_t arguments, int /*arity*/, control_t control) {
  if (PL_foreign_control(control) != PL_FIRST_CALL) return NextAnswer(control, arguments);
  return Guard([&]() -> foreign_t {
    CheckTime();
    const Goal& goal = RunningGoal();
    const std::string name = RequiredAtom(arguments + 3, "atom");
    const Query query = QueryOf(goal, arguments, arguments + 1, arguments + 2);
    const rdf::Graph* graph = FindGraph(*goal.view, name);
    if (query.is_empty || graph == nullptr) return FALSE;
    return FirstAnswer(goal, Cursor(goal.view, query.pattern, *graph), arguments);
  });
}

// ---- The rest ----------------------------------------------------------------------------------

bool UnifyText(term_t term, std::string_view text) {
  return PL_unify_chars(term, PL_ATOM | REP_UTF8, text.size(), text.data());
}

// graphs(-Names)
foreign_t Graphs(term_t arguments, int /*arity*/, control_t /*control*/) {
  return Guard([&]() -> foreign_t {
    const term_t rest = PL_copy_term_ref(arguments), head = PL_new_term_ref();
    for (const auto& layer : RunningGoal().view->layers()) {
      for (const rdf::Graph& graph : layer->graphs()) {
        if (!PL_unify_list(rest, head, rest) || !UnifyText(head, graph.name)) return FALSE;
      }
    }
    return PL_unify_nil(rest);
  });
}

// The id of an IRI or blank node; nothing when the dictionary has never seen it.
std::optional<rdf::TermId> ResourceId(const Goal& goal, term_t term, const char* type) {
  atom_t atom = 0;
  if (PL_is_variable(term)) ThrowInstantiationError();
  if (!PL_is_atom(term) || !PL_get_atom(term, &atom)) ThrowTypeError(type, term);
  return goal.cache->IdOf(atom);
}

// as_written(+Iri, -Original)
foreign_t AsWritten(term_t arguments, int /*arity*/, control_t /*control*/) {
  return Guard([&]() -> foreign_t {
    const Goal& goal = RunningGoal();
    const auto id = ResourceId(goal, arguments, "iri");
    const std::string text = TextOf(arguments);
    if (!id || text.starts_with("_:")) return UnifyText(arguments + 1, text);
    return UnifyText(arguments + 1, goal.view->AsWritten(*id));
  });
}

// label(+Term, -Label)
foreign_t Label(term_t arguments, int /*arity*/, control_t /*control*/) {
  return Guard([&]() -> foreign_t {
    const Goal& goal = RunningGoal();
    if (PL_is_functor(arguments, literal_functor)) {
      const term_t lexical = PartsOf(arguments).part[0];
      return UnifyText(arguments + 1, RequiredAtom(lexical, "atom"));
    }
    const auto id = ResourceId(goal, arguments, "rdf_term");
    if (id) return UnifyText(arguments + 1, goal.view->Label(*id));
    return UnifyText(arguments + 1, LocalName(TextOf(arguments)));
  });
}

// The digits may be led by '+', which from_chars refuses.
std::string_view WithoutPlus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

template <typename Number>
bool ParseWhole(std::string_view text, Number* number) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), *number);
  return result.ec == std::errc() && result.ptr == text.data() + text.size();
}

foreign_t UnifyNumber(term_t term, std::string_view lexical) {
  const std::string_view text = WithoutPlus(Trim(lexical));
  std::int64_t whole = 0;
  if (ParseWhole(text, &whole)) return PL_unify_int64(term, whole);
  double number = 0;
  if (!ParseWhole(text, &number) || !std::isfinite(number)) return FALSE;
  return PL_unify_float(term, number);
}

// number(+Literal, -Number)
foreign_t Number(term_t arguments, int /*arity*/, control_t /*control*/) {
  return Guard([&]() -> foreign_t {
    if (PL_is_variable(arguments)) ThrowInstantiationError();
    if (PL_is_atom(arguments)) return FALSE;
    if (!PL_is_functor(arguments, literal_functor)) ThrowTypeError("rdf_term", arguments);
    return UnifyNumber(arguments + 1, RequiredAtom(PartsOf(arguments).part[0], "atom"));
  });
}

using Predicate = foreign_t (*)(term_t, int, control_t);

void Register(const char* name, int arity, Predicate predicate, int flags = 0) {
  // Prolog's type for foreign functions says nothing of their arguments.
  const auto untyped = reinterpret_cast<pl_function_t>(reinterpret_cast<void (*)()>(predicate));
  if (!PL_register_foreign_in_module("rdf_edge", name, arity, untyped, PL_FA_VARARGS | flags)) {
    throw Error(Code::kInternal, std::string("Prolog refuses the predicate ") + name);
  }
}

}  // namespace

void RegisterRdfPredicates() {
  literal_functor = PL_new_functor(PL_new_atom("literal"), 3);
  all_atom = PL_new_atom("all");
  Register("match", 4, Match, PL_FA_NONDETERMINISTIC);
  Register("match_in", 4, MatchIn, PL_FA_NONDETERMINISTIC);
  Register("graphs", 1, Graphs);
  Register("as_written", 2, AsWritten);
  Register("label", 2, Label);
  Register("number", 2, Number);
}

int LiveChoicePoints() { return live_choice_points; }

}  // namespace lares::prolog
