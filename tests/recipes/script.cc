#include "tests/recipes/script.h"

#include <cctype>
#include <stdexcept>

namespace lares::testing {
namespace {

// The script language: strings in single quotes, names, == || ?: and :=, brackets.
class Script {
 public:
  Script(const std::string& code, std::map<std::string, std::string>& blackboard)
      : code_(code), blackboard_(blackboard) {}

  std::string Run() {
    const std::size_t assign = code_.find(":=");
    if (assign != std::string::npos) {
      const std::string name = Name();
      Expect(":=");
      return blackboard_[name] = Whole();
    }
    return Whole();
  }

 private:
  std::string Whole() {
    const std::string value = Conditional();
    SkipSpace();
    if (at_ != code_.size()) throw std::runtime_error("rest of script: " + code_.substr(at_));
    return value;
  }
  void SkipSpace() {
    while (at_ < code_.size() && code_[at_] == ' ') ++at_;
  }
  bool Take(const std::string& token) {
    SkipSpace();
    if (code_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }
  void Expect(const std::string& token) {
    if (!Take(token)) throw std::runtime_error("expected " + token + " in " + code_);
  }
  std::string Name() {
    SkipSpace();
    const std::size_t start = at_;
    while (at_ < code_.size() &&
           (std::isalnum(static_cast<unsigned char>(code_[at_])) != 0 || code_[at_] == '_')) {
      ++at_;
    }
    if (at_ == start) throw std::runtime_error("expected a name in " + code_);
    return code_.substr(start, at_ - start);
  }
  // As in the real language a ternary's last operand is no ternary, unless in brackets.
  std::string Conditional() {
    const std::string condition = Or();
    if (!Take("?")) return condition;
    const std::string yes = Conditional();
    Expect(":");
    const std::string no = Or();
    return condition == "true" ? yes : no;
  }
  std::string Or() {
    std::string value = Comparison();
    while (Take("||")) {
      const std::string other = Comparison();
      value = value == "true" || other == "true" ? "true" : "false";
    }
    return value;
  }
  std::string Comparison() {
    const std::string left = Atom();
    if (!Take("==")) return left;
    return left == Atom() ? "true" : "false";
  }
  std::string Atom() {
    if (Take("(")) {
      const std::string value = Conditional();
      Expect(")");
      return value;
    }
    if (Take("'")) {
      const std::size_t end = code_.find('\'', at_);
      const std::string value = code_.substr(at_, end - at_);
      at_ = end + 1;
      return value;
    }
    const std::string name = Name();
    if (name == "true" || name == "false") return name;
    const auto entry = blackboard_.find(name);
    if (entry == blackboard_.end()) throw std::runtime_error("no entry " + name);
    return entry->second;
  }

  const std::string& code_;
  std::map<std::string, std::string>& blackboard_;
  std::size_t at_ = 0;
};

}  // namespace

std::string RunScript(const std::string& code, std::map<std::string, std::string>& blackboard) {
  return Script(code, blackboard).Run();
}

}  // namespace lares::testing
