#include "reasoner/prolog/answer_json.h"

#include <SWI-Prolog.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>

namespace lares::prolog {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kLargestExact = std::int64_t{1} << 53;  // of a double
constexpr std::string_view kBlankPrefix = "_:";

class Frame {
 public:
  Frame() : frame_(PL_open_foreign_frame()) {}
  ~Frame() { PL_discard_foreign_frame(frame_); }
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

 private:
  fid_t frame_;
};

Json Typed(const char* type) { return {{"type", type}}; }
Json Typed(const char* type, std::string value) {
  return {{"type", type}, {"value", std::move(value)}};
}
Json Cut(const char* why) { return {{"type", "cut"}, {"why", why}}; }

// Cuts before the first byte of a character.
std::size_t WholeCharacters(std::string_view text, std::size_t size) {
  if (size >= text.size()) return text.size();
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return size;
}

class Writer {
 public:
  Writer(const rdf::View& view, const AnswerLimits& limits) : view_(view), limits_(limits) {}

  Json Write(term_t term, int depth) {
    if (depth > limits_.max_depth) return Cut("depth");
    if (++nodes_ > limits_.max_nodes) return Cut("size");
    switch (PL_term_type(term)) {
      case PL_VARIABLE:
        return Variable(term);
      case PL_INTEGER:
        return Integer(term);
      case PL_RATIONAL:
        return Typed("rational", Text(term, CVT_NUMBER));
      case PL_FLOAT:
        return Float(term);
      case PL_ATOM:
        return Atom(Text(term, CVT_ATOM));
      case PL_STRING:
        return Text(term, CVT_STRING);
      case PL_NIL:
        return Json::array();
      case PL_LIST_PAIR:
        return List(term, depth);
      case PL_TERM:
        return Compound(term, depth);
      case PL_DICT:
        return Dict(term, depth);
      default:
        return Typed("opaque", Text(term, CVT_WRITE));
    }
  }

 private:
  // As UTF-8, within what is left of the limits.
  std::string Text(term_t term, unsigned kinds) {
    std::string text;
    PL_STRINGS_MARK();
    char* bytes = nullptr;
    std::size_t length = 0;
    if (PL_get_nchars(term, &length, &bytes, kinds | REP_UTF8 | BUF_STACK)) {
      const std::string_view whole(bytes, length);
      const std::size_t left = limits_.max_text_bytes - texts_;
      const std::size_t size =
          WholeCharacters(whole, std::min({length, limits_.max_one_text_bytes, left}));
      text.assign(whole.substr(0, size));
      texts_ += size;
      if (size < length) text += "…";
    }
    PL_STRINGS_RELEASE();
    PL_clear_exception();
    return text;
  }

  Json Variable(term_t term) {
    const std::string name = Text(term, CVT_VARIABLE);
    const auto [found, fresh] =
        variables_.emplace(name, "_" + std::to_string(variables_.size() + 1));
    return {{"type", "variable"}, {"name", found->second}};
  }

  Json Integer(term_t term) {
    std::int64_t number = 0;
    if (PL_get_int64(term, &number) && number >= -kLargestExact && number <= kLargestExact) {
      return number;
    }
    PL_clear_exception();
    return Typed("integer", Text(term, CVT_INTEGER));
  }

  Json Float(term_t term) {
    double number = 0;
    if (PL_get_float(term, &number) && std::isfinite(number)) return number;
    return Typed("float", Text(term, CVT_FLOAT));
  }

  // An IRI of the knowledge, or what can only be meant as one.
  Json Atom(std::string text) const {
    const rdf::Dictionary& dictionary = view_.dictionary();
    if (text.starts_with(kBlankPrefix)) {
      const std::string label = text.substr(kBlankPrefix.size());
      if (dictionary.Find({rdf::TermKind::kBlank, label, {}, {}})) return Typed("bnode", label);
    }
    const bool is_iri = text.find("://") != std::string::npos || dictionary.FindIri(text);
    return Typed(is_iri ? "uri" : "atom", std::move(text));
  }

  Json List(term_t term, int depth) {
    std::size_t length = 0;
    if (PL_skip_list(term, 0, &length) != PL_LIST) return PartialList(term, depth);
    const Frame frame;
    const term_t rest = PL_copy_term_ref(term), head = PL_new_term_ref();
    Json list = Json::array();
    while (PL_get_list(rest, head, rest)) {
      if (nodes_ >= limits_.max_nodes) {
        list.push_back(Cut("size"));
        break;
      }
      list.push_back(Write(head, depth + 1));
    }
    return list;
  }

  // [a, b|Rest]: its elements and what stands where the end should.
  Json PartialList(term_t term, int depth) {
    const Frame frame;
    const term_t rest = PL_copy_term_ref(term), head = PL_new_term_ref();
    Json list{{"type", "partial-list"}, {"elements", Json::array()}};
    while (PL_get_list(rest, head, rest)) {
      if (nodes_ >= limits_.max_nodes) {
        list["rest"] = Cut("size");
        return list;
      }
      list["elements"].push_back(Write(head, depth + 1));
    }
    list["rest"] = Write(rest, depth + 1);
    return list;
  }

  Json Compound(term_t term, int depth) {
    const Frame frame;
    atom_t name = 0;
    std::size_t arity = 0;
    if (!PL_get_compound_name_arity(term, &name, &arity)) return Cut("size");
    const term_t argument = PL_new_term_ref();
    std::string functor;
    if (PL_put_atom(argument, name)) functor = Text(argument, CVT_ATOM);
    if (functor == "literal" && arity == 3) {
      if (auto literal = Literal(term); !literal.is_null()) return literal;
    }
    Json compound{{"type", "compound"}, {"name", functor}, {"arguments", Json::array()}};
    for (std::size_t i = 1; i <= arity; ++i) {
      if (nodes_ >= limits_.max_nodes) {
        compound["arguments"].push_back(Cut("size"));
        break;
      }
      _PL_get_arg(i, term, argument);
      compound["arguments"].push_back(Write(argument, depth + 1));
    }
    return compound;
  }

  // Null when not every part is text.
  Json Literal(term_t term) {
    const term_t first = PL_new_term_refs(3);
    for (int i = 0; i < 3; ++i) {
      _PL_get_arg(i + 1, term, first + i);
      if (!PL_is_atom(first + i) && !PL_is_string(first + i)) return nullptr;
    }
    constexpr unsigned kText = CVT_ATOM | CVT_STRING;
    Json literal = Typed("literal", Text(first, kText));
    const std::string datatype = Text(first + 1, kText), language = Text(first + 2, kText);
    if (!datatype.empty()) literal["datatype"] = datatype;
    if (!language.empty()) literal["xml:lang"] = language;
    return literal;
  }

  Json Dict(term_t term, int depth) {
    static const predicate_t dict_pairs = PL_predicate("dict_pairs", 3, "system");
    const Frame frame;
    const term_t arguments = PL_new_term_refs(3);
    if (!PL_put_term(arguments, term) ||
        !PL_call_predicate(nullptr, PL_Q_NODEBUG | PL_Q_CATCH_EXCEPTION, dict_pairs, arguments)) {
      return Cut("size");
    }
    const term_t rest = arguments + 2, pair = PL_new_term_ref(), part = PL_new_term_ref();
    Json values = Json::object();
    while (PL_get_list(rest, pair, rest) && nodes_ < limits_.max_nodes) {
      _PL_get_arg(1, pair, part);
      const std::string key = Text(part, CVT_ATOM | CVT_INTEGER);
      _PL_get_arg(2, pair, part);
      values[key] = Write(part, depth + 1);
    }
    return {{"type", "dict"}, {"values", values}};
  }

  const rdf::View& view_;
  const AnswerLimits& limits_;
  std::size_t nodes_ = 0;
  std::size_t texts_ = 0;
  std::map<std::string, std::string> variables_;
};

}  // namespace

std::string AnswerJson(const rdf::View& view, const std::vector<Binding>& bindings,
                       const AnswerLimits& limits) {
  Writer writer(view, limits);
  Json answer = Json::object();
  for (const auto& [name, term] : bindings) {
    answer[name] = PL_is_acyclic(term) ? writer.Write(term, 0) : Typed("cyclic");
  }
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace lares::prolog
