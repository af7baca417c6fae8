#include "reasoner/prolog/terms.h"

#include <SWI-Prolog.h>

#include <deque>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "reasoner/prolog/record.h"

namespace lares::prolog {
namespace {

// Term references made inside are given back at its end; what they refer to stays.
class Frame {
 public:
  Frame() : frame_(PL_open_foreign_frame()) {}
  ~Frame() { PL_close_foreign_frame(frame_); }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

 private:
  fid_t frame_;
};

[[noreturn]] void FailFull() {
  PL_clear_exception();
  throw Error(Code::kTooLarge, "a value does not fit Prolog's stacks");
}

void Check(int succeeded) {
  if (!succeeded) FailFull();
}

const std::string& CheckText(const std::string& text) {
  if (!IsUtf8(text)) throw Error(Code::kInvalid, "text for a rule is not UTF-8");
  return text;
}

// Owned reference to an atom.
class AtomHandle {
 public:
  explicit AtomHandle(const std::string& text)
      : atom_(PL_new_atom_mbchars(REP_UTF8, CheckText(text).size(), text.data())) {
    if (atom_ == 0) FailFull();
  }
  ~AtomHandle() { PL_unregister_atom(atom_); }
  AtomHandle(const AtomHandle&) = delete;
  AtomHandle& operator=(const AtomHandle&) = delete;
  atom_t get() const { return atom_; }

 private:
  atom_t atom_;
};

void CheckDepth(int depth) {
  if (depth > kMaxDepth) throw Error(Code::kTooLarge, "a value for a rule is nested too deeply");
}

void Put(const Value& value, term_t term, int depth);

struct Putter {
  term_t term;
  int depth;

  void operator()(std::int64_t number) const { Check(PL_put_int64(term, number)); }
  void operator()(double number) const { Check(PL_put_float(term, number)); }
  void operator()(const Atom& atom) const { Check(PL_put_atom(term, AtomHandle(atom.text).get())); }
  void operator()(const String& string) const {
    CheckText(string.text);
    Check(PL_put_chars(term, PL_STRING | REP_UTF8, string.text.size(), string.text.data()));
  }
  void operator()(const List& list) const {
    const Frame frame;
    const term_t head = PL_new_term_ref();
    Check(PL_put_nil(term));
    for (auto element = list.rbegin(); element != list.rend(); ++element) {
      Put(*element, head, depth + 1);
      Check(PL_cons_list(term, head, term));
    }
  }
  void operator()(const Compound& compound) const {
    const Frame frame;
    const std::size_t arity = compound.arguments.size();
    const functor_t functor = PL_new_functor(AtomHandle(compound.name).get(), arity);
    if (arity == 0) {
      Check(PL_put_variable(term) && PL_unify_compound(term, functor));
      return;
    }
    const term_t arguments = PL_new_term_refs(static_cast<int>(arity));
    for (std::size_t i = 0; i < arity; ++i) Put(compound.arguments[i], arguments + i, depth + 1);
    Check(PL_cons_functor_v(term, functor, arguments));
  }
  void operator()(const Dict& dict) const {
    const Frame frame;
    const term_t values = PL_new_term_refs(static_cast<int>(dict.size()));
    std::deque<AtomHandle> handles;
    std::vector<atom_t> keys;
    for (const auto& [key, value] : dict) {
      Put(value, values + keys.size(), depth + 1);
      handles.emplace_back(key);
      keys.push_back(handles.back().get());
    }
    Check(PL_put_dict(term, 0, keys.size(), keys.data(), values));
  }
  void operator()(const RecordRef& record) const { record->Put(term); }
};

void Put(const Value& value, term_t term, int depth) {
  CheckDepth(depth);
  std::visit(Putter{term, depth}, value.data);
}

[[noreturn]] void FailKind(const char* what) {
  throw Error(Code::kInternal, std::string("a rule answered ") + what);
}

class Reader {
 public:
  Value Read(term_t term, int depth) {
    CheckDepth(depth);
    if (++nodes_ > kMaxNodes) throw Error(Code::kTooLarge, "a rule's answer is too large");
    switch (PL_term_type(term)) {
      case PL_INTEGER:
        return {ReadInteger(term)};
      case PL_FLOAT:
        return {ReadFloat(term)};
      case PL_ATOM:
        return {Atom{TextOf(term)}};
      case PL_STRING:
        return {String{TextOf(term)}};
      case PL_NIL:
        return {List{}};
      case PL_LIST_PAIR:
        return {ReadList(term, depth)};
      case PL_TERM:
        return {ReadCompound(term, depth)};
      case PL_DICT:
        return {ReadDict(term, depth)};
      case PL_VARIABLE:
        FailKind("an unbound variable");
      case PL_RATIONAL:
        FailKind("a rational number");
      default:
        FailKind("a stream or another opaque thing");
    }
  }

 private:
  static std::int64_t ReadInteger(term_t term) {
    std::int64_t number = 0;
    if (!PL_get_int64(term, &number)) FailKind("an integer beyond 64 bits");
    return number;
  }

  static double ReadFloat(term_t term) {
    double number = 0;
    if (!PL_get_float(term, &number)) FailKind("no float");
    return number;
  }

  List ReadList(term_t term, int depth) {
    const Frame frame;
    std::size_t length = 0;
    const term_t rest = PL_copy_term_ref(term);
    if (PL_skip_list(term, 0, &length) != PL_LIST) FailKind("a list without an end");
    const term_t head = PL_new_term_ref();
    List list;
    list.reserve(length);
    while (PL_get_list(rest, head, rest)) list.push_back(Read(head, depth + 1));
    return list;
  }

  Compound ReadCompound(term_t term, int depth) {
    const Frame frame;
    atom_t name = 0;
    std::size_t arity = 0;
    if (!PL_get_compound_name_arity(term, &name, &arity)) FailKind("no compound");
    const term_t argument = PL_new_term_ref();
    Check(PL_put_atom(argument, name));
    Compound compound{TextOf(argument), {}};
    compound.arguments.reserve(arity);
    for (std::size_t i = 1; i <= arity; ++i) {
      _PL_get_arg(i, term, argument);
      compound.arguments.push_back(Read(argument, depth + 1));
    }
    return compound;
  }

  Dict ReadDict(term_t term, int depth) {
    static const predicate_t dict_pairs = PL_predicate("dict_pairs", 3, "system");
    const Frame frame;
    const term_t arguments = PL_new_term_refs(3);
    Check(PL_put_term(arguments, term));
    Check(PL_call_predicate(nullptr, PL_Q_NODEBUG | PL_Q_PASS_EXCEPTION, dict_pairs, arguments));
    const term_t rest = arguments + 2, pair = PL_new_term_ref(), part = PL_new_term_ref();
    Dict dict;
    while (PL_get_list(rest, pair, rest)) {
      _PL_get_arg(1, pair, part);
      if (!PL_is_atom(part)) FailKind("a dict with a key that is no atom");
      std::string key = TextOf(part);
      _PL_get_arg(2, pair, part);
      dict.emplace(std::move(key), Read(part, depth + 1));
    }
    return dict;
  }

  std::size_t nodes_ = 0;
};

}  // namespace

void PutValue(const Value& value, TermRef term) { Put(value, term, 0); }

Value GetValue(TermRef term) {
  if (!PL_is_acyclic(term)) FailKind("a cyclic term");
  return Reader().Read(term, 0);
}

std::string TextOf(TermRef term) {
  std::string text;
  PL_STRINGS_MARK();
  char* bytes = nullptr;
  std::size_t length = 0;
  constexpr unsigned kFlags = CVT_ATOM | CVT_STRING | REP_UTF8 | BUF_STACK;
  if (PL_get_nchars(term, &length, &bytes, kFlags)) text.assign(bytes, length);
  PL_STRINGS_RELEASE();
  return text;
}

}  // namespace lares::prolog
