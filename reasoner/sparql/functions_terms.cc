#include <cstdio>

#include "ontology/rdf/iri_resolve.h"
#include "ontology/rdf/term_checks.h"
#include "reasoner/sparql/expression.h"

namespace lares::sparql {

using syntax::Op;
using Kind = Value::Kind;

namespace {

std::string Uuid(Context& context) {
  std::uint64_t high = context.random();
  std::uint64_t low = context.random();
  high = (high & ~0xF000ULL) | 0x4000ULL;  // version 4 (RFC 9562)
  low = (low & ~(3ULL << 62)) | (2ULL << 62);
  char text[40];
  std::snprintf(text, sizeof text, "%08llx-%04llx-%04llx-%04llx-%012llx",
                static_cast<unsigned long long>(high >> 32),
                static_cast<unsigned long long>(high >> 16 & 0xFFFF),
                static_cast<unsigned long long>(high & 0xFFFF),
                static_cast<unsigned long long>(low >> 48),
                static_cast<unsigned long long>(low & 0xFFFFFFFFFFFFULL));
  return text;
}

Value ToIri(const Value& value, const Context& context) {
  if (value.kind == Kind::kIri) return value;
  if (value.kind != Kind::kString) return {};
  std::string iri(value.text());
  if (!context.query.base_iri.empty()) {
    iri.clear();
    rdf::ResolveIri(value.text(), context.query.base_iri, iri);
  }
  return rdf::IsAbsoluteIri(iri) ? MakeIri(std::move(iri)) : Value{};
}

Value Blank(Arguments arguments, Context& context) {
  if (arguments.empty()) return MakeBlank(context.FreshBlankLabel());
  if (arguments[0].kind != Kind::kString) return {};
  const auto known = context.blanks.find(arguments[0].text());
  if (known != context.blanks.end()) return MakeBlank(known->second);
  std::string label = context.FreshBlankLabel();
  context.blanks.emplace(std::string(arguments[0].text()), label);
  return MakeBlank(std::move(label));
}

bool LanguageMatches(std::string_view tag, std::string_view range) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (range == "*") return !tag.empty();
  if (tag.size() < range.size()) return false;
  for (std::size_t i = 0; i < range.size(); ++i) {
    if (lower(tag[i]) != lower(range[i])) return false;
  }
  return tag.size() == range.size() || tag[range.size()] == '-';
}

Value WithLanguage(const Value& text, const Value& tag, Context& context) {
  if (text.kind != Kind::kString || tag.kind != Kind::kString || tag.text().empty()) return {};
  const TermId id = context.terms.Intern({rdf::TermKind::kLiteral, text.text(), {}, tag.text()});
  return context.ValueAt(id);
}

Value WithDatatype(const Value& text, const Value& type, Context& context) {
  if (text.kind != Kind::kString || type.kind != Kind::kIri) return {};
  const TermId id = context.terms.Intern({rdf::TermKind::kLiteral, text.text(), type.text(), {}});
  return context.ValueAt(id);
}

bool IsSame(const Value& a, const Value& b) {
  return (a.kind == Kind::kIri) == (b.kind == Kind::kIri) &&
         (a.kind == Kind::kBlank) == (b.kind == Kind::kBlank) && a.text() == b.text() &&
         (!a.is_literal() || (a.datatype() == b.datatype() && a.term.language == b.term.language));
}

}  // namespace

Value CallTermFunction(Op op, Arguments arguments, Context& context) {
  const auto argument = [&]() -> const Value& { return arguments[0]; };
  switch (op) {
    case Op::kStr:
      if (argument().kind == Kind::kBlank) return {};
      return MakeString(std::string(argument().text()));
    case Op::kLang:
      if (!argument().is_literal()) return {};
      return MakeString(std::string(argument().term.language));
    case Op::kLangMatches:
      if (!arguments[0].is_text() || !arguments[1].is_text()) return {};
      return MakeBoolean(LanguageMatches(arguments[0].text(), arguments[1].text()));
    case Op::kDatatype:
      if (!argument().is_literal()) return {};
      return MakeIri(std::string(argument().datatype()));
    case Op::kIri:
      return ToIri(argument(), context);
    case Op::kBnode:
      return Blank(arguments, context);
    case Op::kUuid:
      return MakeIri("urn:uuid:" + Uuid(context));
    case Op::kStruuid:
      return MakeString(Uuid(context));
    case Op::kStrlang:
      return WithLanguage(arguments[0], arguments[1], context);
    case Op::kStrdt:
      return WithDatatype(arguments[0], arguments[1], context);
    case Op::kSameTerm:
      return MakeBoolean(IsSame(arguments[0], arguments[1]));
    case Op::kIsIri:
      return MakeBoolean(argument().kind == Kind::kIri);
    case Op::kIsBlank:
      return MakeBoolean(argument().kind == Kind::kBlank);
    case Op::kIsLiteral:
      return MakeBoolean(argument().is_literal());
    case Op::kIsNumeric:
      return MakeBoolean(argument().is_numeric());
    default:
      return {};
  }
}

}  // namespace lares::sparql
