#include "reasoner/sparql/regex.h"

#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>

#include <cstdint>
#include <utility>

#include "base/error.h"

namespace lares::sparql {
namespace {

constexpr std::uint32_t kMatchLimit = 5'000'000;
constexpr std::uint32_t kHeapLimitKib = 32 * 1024;
constexpr std::uint32_t kDepthLimit = 100'000;
constexpr std::size_t kMaxPatternBytes = 32u << 10;

constexpr std::string_view kNameStart = R"(\p{L}_:)";
constexpr std::string_view kNameCharacters = R"(\p{L}\p{M}\p{N}\-._:·)";

std::optional<std::uint32_t> Options(std::string_view flags) {
  std::uint32_t options = PCRE2_UTF | PCRE2_UCP | PCRE2_DOLLAR_ENDONLY | PCRE2_NEVER_BACKSLASH_C |
                          PCRE2_NO_AUTO_CAPTURE;
  options &= ~static_cast<std::uint32_t>(PCRE2_NO_AUTO_CAPTURE);
  for (const char flag : flags) {
    switch (flag) {
      case 'i':
        options |= PCRE2_CASELESS;
        break;
      case 's':
        options |= PCRE2_DOTALL;
        break;
      case 'm':
        options |= PCRE2_MULTILINE;
        break;
      case 'x':
        options |= PCRE2_EXTENDED;
        break;
      case 'q':
        options |= PCRE2_LITERAL;
        break;
      default:
        return std::nullopt;
    }
  }
  if ((options & PCRE2_LITERAL) != 0) {
    options &= PCRE2_LITERAL | PCRE2_UTF | PCRE2_CASELESS;
  }
  return options;
}

// XPath's syntax in PCRE's: what only one of them has is translated or refused.
std::optional<std::string> Translate(std::string_view pattern) {
  std::string out;
  bool in_class = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char c = pattern[i];
    const char next = i + 1 < pattern.size() ? pattern[i + 1] : '\0';
    if (c == '\\') {
      ++i;
      if (next == 'i' || next == 'I' || next == 'c' || next == 'C') {
        const std::string_view names = next == 'i' || next == 'I' ? kNameStart : kNameCharacters;
        const bool is_negated = next == 'I' || next == 'C';
        if (in_class && is_negated) return std::nullopt;
        if (!in_class) out += is_negated ? "[^" : "[";
        out += names;
        if (!in_class) out += ']';
        continue;
      }
      constexpr std::string_view kKnown = "nrt\\|.-^?*+{}()[]$pPsSdDwW123456789";
      if (next == '\0' || kKnown.find(next) == std::string_view::npos) return std::nullopt;
      out += c;
      out += next;
      continue;
    }
    if (in_class) {
      if (c == ']') in_class = false;
      if (c == '[') return std::nullopt;  // subtraction of classes, and POSIX classes
    } else if (c == '[') {
      in_class = true;
      out += c;
      if (next == '^') {
        out += next;
        ++i;
      }
      continue;
    } else if (c == '(' && next == '?' && pattern.substr(i, 3) != "(?:") {
      return std::nullopt;  // PCRE's groups and look-arounds
    } else if (c == '(' && next == '*') {
      return std::nullopt;  // PCRE's verbs
    } else if ((c == '*' || c == '+' || c == '?' || c == '}') && next == '+') {
      return std::nullopt;  // PCRE's possessive quantifiers
    }
    out += c;
  }
  return out;
}

}  // namespace

struct Regex::State {
  explicit State(pcre2_code* compiled)
      : code(compiled),
        data(pcre2_match_data_create_from_pattern(compiled, nullptr)),
        context(pcre2_match_context_create(nullptr)) {
    pcre2_set_match_limit(context, kMatchLimit);
    pcre2_set_heap_limit(context, kHeapLimitKib);
    pcre2_set_depth_limit(context, kDepthLimit);
  }
  ~State() {
    pcre2_match_context_free(context);
    pcre2_match_data_free(data);
    pcre2_code_free(code);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  bool Match(std::string_view text, std::size_t from) const {
    const int outcome = pcre2_match(code, reinterpret_cast<PCRE2_SPTR>(text.data()), text.size(),
                                    from, from == 0 ? 0 : PCRE2_NO_UTF_CHECK, data, context);
    if (outcome > 0) return true;
    if (outcome == PCRE2_ERROR_NOMATCH) return false;
    if (outcome == PCRE2_ERROR_MATCHLIMIT || outcome == PCRE2_ERROR_DEPTHLIMIT ||
        outcome == PCRE2_ERROR_HEAPLIMIT) {
      throw Error(Code::kTooLarge, "a regular expression takes too many steps to match")
          .WithHint("nested repetitions such as (a+)+ do that");
    }
    return false;
  }

  pcre2_code* code;
  pcre2_match_data* data;
  pcre2_match_context* context;
};

Regex::Regex(std::unique_ptr<State> state) : state_(std::move(state)) {}
Regex::~Regex() = default;
Regex::Regex(Regex&&) noexcept = default;
Regex& Regex::operator=(Regex&&) noexcept = default;

std::optional<Regex> Regex::Compile(std::string_view pattern, std::string_view flags) {
  const auto options = Options(flags);
  if (!options || pattern.size() > kMaxPatternBytes) return std::nullopt;
  const bool is_literal = (*options & PCRE2_LITERAL) != 0;
  const auto translated = is_literal ? std::string(pattern) : Translate(pattern);
  if (!translated) return std::nullopt;
  int error = 0;
  PCRE2_SIZE at = 0;
  pcre2_code* code = pcre2_compile(reinterpret_cast<PCRE2_SPTR>(translated->data()),
                                   translated->size(), *options, &error, &at, nullptr);
  if (code == nullptr) return std::nullopt;
  return Regex(std::make_unique<State>(code));
}

bool Regex::Matches(std::string_view text) const { return state_->Match(text, 0); }

std::optional<std::string> Regex::Replace(std::string_view text, std::string_view replacement,
                                          std::size_t max_bytes) const {
  if (state_->Match("", 0)) return std::nullopt;
  std::string out;
  std::size_t at = 0;
  while (at <= text.size() && state_->Match(text, at)) {
    const PCRE2_SIZE* groups = pcre2_get_ovector_pointer(state_->data);
    const std::size_t count = pcre2_get_ovector_count(state_->data);
    const std::size_t begin = groups[0];
    const std::size_t end = groups[1];
    if (end == begin) break;  // a look-around-free pattern that is not empty consumes something
    out.append(text.substr(at, begin - at));
    for (std::size_t i = 0; i < replacement.size(); ++i) {
      const char c = replacement[i];
      const char next = i + 1 < replacement.size() ? replacement[i + 1] : '\0';
      if (c == '\\') {
        if (next != '\\' && next != '$') return std::nullopt;
        out += next;
        ++i;
      } else if (c == '$') {
        if (next < '0' || next > '9') return std::nullopt;
        const auto group = static_cast<std::size_t>(next - '0');
        if (group < count && groups[2 * group] != PCRE2_UNSET) {
          out.append(text.substr(groups[2 * group], groups[2 * group + 1] - groups[2 * group]));
        }
        ++i;
      } else {
        out += c;
      }
    }
    at = end;
    if (out.size() > max_bytes) return std::nullopt;
  }
  out.append(text.substr(std::min(at, text.size())));
  return out;
}

}  // namespace lares::sparql
