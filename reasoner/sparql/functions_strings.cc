#include <cmath>
#include <cwctype>

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

// Simple case mapping of the scripts that have one and where upper and lower stand in a fixed
// relation: Latin, Greek, Cyrillic, Armenian.
char32_t Fold(char32_t c, bool to_upper) {
  const auto between = [&](char32_t first, char32_t last) { return c >= first && c <= last; };
  if (c < 0x80) {
    if (to_upper && between('a', 'z')) return c - 32;
    if (!to_upper && between('A', 'Z')) return c + 32;
    return c;
  }
  if (to_upper) {
    if (c == 0xB5) return 0x39C;
    if (c == 0xFF) return 0x178;
    if (c == 0x3C2) return 0x3A3;
    if ((between(0xE0, 0xFE) && c != 0xF7) || (between(0x3B1, 0x3C9)) || between(0x430, 0x44F)) {
      return c - 32;
    }
    if (between(0x450, 0x45F)) return c - 80;
    if (between(0x561, 0x586)) return c - 48;
  } else {
    if (c == 0x178) return 0xFF;
    if ((between(0xC0, 0xDE) && c != 0xD7) || (between(0x391, 0x3A9) && c != 0x3A2) ||
        between(0x410, 0x42F)) {
      return c + 32;
    }
    if (between(0x400, 0x40F)) return c + 80;
    if (between(0x531, 0x556)) return c + 48;
  }
  // Pairs side by side: upper is even, or odd in two stretches.
  const bool is_even_upper =
      between(0x100, 0x137) || between(0x14A, 0x177) || between(0x1DE, 0x1EF) ||
      between(0x1F8, 0x21F) || between(0x222, 0x233) || between(0x3D8, 0x3EF) ||
      between(0x460, 0x481) || between(0x48A, 0x4BF) || between(0x4D0, 0x52F) ||
      between(0x1E00, 0x1E95) || between(0x1EA0, 0x1EFF);
  const bool is_odd_upper = between(0x139, 0x148) || between(0x179, 0x17E) || between(0x1CD, 0x1DC);
  if (c == 0x130 || c == 0x131) return c;
  if (is_even_upper) return to_upper ? c & ~1U : c | 1U;
  if (is_odd_upper) return to_upper ? (c % 2 == 0 ? c - 1 : c) : (c % 2 == 1 ? c + 1 : c);
  return c;
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
