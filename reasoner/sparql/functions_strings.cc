#include <locale.h>
#include <wctype.h>

#include <cctype>
#include <cmath>

#include "reasoner/sparql/expression.h"
#include "reasoner/sparql/unicode.h"

namespace lares::sparql {

using syntax::Op;
using Kind = Value::Kind;

namespace {

// 17.4.3.1: the second has no language, or the first one's.
bool AreCompatible(const Value& a, const Value& b) {
  if (!a.is_text() || !b.is_text()) return false;
  return b.kind == Kind::kString ||
         (a.kind == Kind::kLanguageString && a.term.language == b.term.language);
}

// Simple case mapping of Unicode, whatever the process's locale.
char32_t Fold(char32_t c, bool to_upper) {
  static const locale_t locale = newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
  if (locale == nullptr)
    return c < 0x80 ? static_cast<char32_t>(to_upper ? std::toupper(static_cast<int>(c))
                                                     : std::tolower(static_cast<int>(c)))
                    : c;
  const auto wide = static_cast<wint_t>(c);
  return static_cast<char32_t>(to_upper ? towupper_l(wide, locale) : towlower_l(wide, locale));
}

std::string ChangeCase(std::string_view text, bool to_upper) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const char32_t c = NextCharacter(text, at);
    if (to_upper && c == 0xDF) {
      out += "SS";
    } else {
      AppendCharacter(Fold(c, to_upper), out);
    }
  }
  return out;
}

std::string EncodeForUri(std::string_view text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == '~';
    if (is_plain) {
      out += c;
    } else {
      out += '%';
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
  }
  return out;
}

Value Concat(Arguments arguments, Context& context) {
  std::string text;
  bool has_one_language = !arguments.empty();
  for (const Value& argument : arguments) {
    if (!argument.is_text()) return {};
    if (text.size() + argument.text().size() > context.account.limit()) {
      throw Error(Code::kTooLarge, "CONCAT makes more text than the query may hold");
    }
    text += argument.text();
    has_one_language = has_one_language && argument.kind == Kind::kLanguageString &&
                       argument.term.language == arguments[0].term.language;
  }
  context.guard.Work(text.size());
  return has_one_language ? MakeStringLike(arguments[0], std::move(text))
                          : MakeString(std::move(text));
}

std::optional<double> NumberOf(const Value& value) {
  if (!value.is_numeric()) return std::nullopt;
  return std::floor(AsDouble(value) + 0.5);
}

// fn:substring: characters whose position p has start ≤ p < start + length, counted from 1.
Value Substring(Arguments arguments) {
  const auto start = NumberOf(arguments[1]);
  if (!arguments[0].is_text() || !start) return {};
  const std::string_view text = arguments[0].text();
  double end = static_cast<double>(text.size()) + 1;
  if (arguments.size() == 3) {
    const auto length = NumberOf(arguments[2]);
    if (!length) return {};
    end = std::min(end, *start + *length);
  }
  const double begin = std::max(*start, 1.0);
  if (!(begin < end)) return MakeStringLike(arguments[0], "");  // also for NaN
  const std::size_t first = ByteOfCharacter(text, static_cast<std::size_t>(begin) - 1);
  const std::size_t last = ByteOfCharacter(text, static_cast<std::size_t>(end) - 1);
  return MakeStringLike(arguments[0], std::string(text.substr(first, last - first)));
}

Value Around(Op op, const Value& text, const Value& part) {
  if (!AreCompatible(text, part)) return {};
  const std::size_t at = text.text().find(part.text());
  if (at == std::string_view::npos) return MakeString("");
  return MakeStringLike(
      text, std::string(op == Op::kStrbefore ? text.text().substr(0, at)
                                             : text.text().substr(at + part.text().size())));
}

Value Contains(Op op, const Value& text, const Value& part) {
  if (!AreCompatible(text, part)) return {};
  switch (op) {
    case Op::kContains:
      return MakeBoolean(text.text().find(part.text()) != std::string_view::npos);
    case Op::kStrstarts:
      return MakeBoolean(text.text().starts_with(part.text()));
    default:
      return MakeBoolean(text.text().ends_with(part.text()));
  }
}

Value MatchRegex(Arguments arguments, Context& context) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i].kind != Kind::kString) return {};
  }
  if (!arguments[0].is_text()) return {};
  const Regex* regex =
      context.RegexOf(arguments[1].text(), arguments.size() == 3 ? arguments[2].text() : "");
  if (regex == nullptr) return {};
  context.guard.Work(arguments[0].text().size());
  return MakeBoolean(regex->Matches(arguments[0].text()));
}

Value Replace(Arguments arguments, Context& context) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i].kind != Kind::kString) return {};
  }
  if (!arguments[0].is_text()) return {};
  const Regex* regex =
      context.RegexOf(arguments[1].text(), arguments.size() == 4 ? arguments[3].text() : "");
  if (regex == nullptr) return {};
  context.guard.Work(arguments[0].text().size());
  auto text = regex->Replace(arguments[0].text(), arguments[2].text(), context.account.limit());
  return text ? MakeStringLike(arguments[0], std::move(*text)) : Value{};
}

}  // namespace

Value CallStringFunction(Op op, Arguments arguments, Context& context) {
  if (op == Op::kConcat) return Concat(arguments, context);
  const Value& text = arguments[0];
  if (!text.is_text()) return {};
  context.guard.Work(text.text().size());
  switch (op) {
    case Op::kStrlen:
      return MakeInteger(static_cast<std::int64_t>(CharacterCount(text.text())));
    case Op::kUcase:
    case Op::kLcase:
      return MakeStringLike(text, ChangeCase(text.text(), op == Op::kUcase));
    case Op::kEncodeForUri:
      return MakeString(EncodeForUri(text.text()));
    case Op::kContains:
    case Op::kStrstarts:
    case Op::kStrends:
      return Contains(op, text, arguments[1]);
    case Op::kStrbefore:
    case Op::kStrafter:
      return Around(op, text, arguments[1]);
    case Op::kSubstr:
      return Substring(arguments);
    case Op::kRegex:
      return MatchRegex(arguments, context);
    case Op::kReplace:
      return Replace(arguments, context);
    default:
      return {};
  }
}

}  // namespace lares::sparql
