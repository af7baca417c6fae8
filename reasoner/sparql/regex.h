// Regular expressions of XPath and XQuery Functions 3.0, section 5.6. The one door to PCRE2.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace lares::sparql {

class Regex {
 public:
  // Nothing when the pattern or a flag (i, s, m, x, q) is not valid.
  static std::optional<Regex> Compile(std::string_view pattern, std::string_view flags);
  ~Regex();
  Regex(Regex&&) noexcept;
  Regex& operator=(Regex&&) noexcept;

  // Both throw kTooLarge when matching takes more than its bounded effort.
  bool Matches(std::string_view text) const;
  // Every match replaced; $1 … $9 and \$ as in fn:replace. Nothing when the pattern matches the
  // empty text, the replacement is malformed or the outcome exceeds `max_bytes`.
  std::optional<std::string> Replace(std::string_view text, std::string_view replacement,
                                     std::size_t max_bytes) const;

 private:
  struct State;
  explicit Regex(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace lares::sparql
