#include "tests/recipes/behavior_tree.h"

#include <cctype>
#include <stdexcept>

namespace lares::testing {
namespace {

class XmlParser {
 public:
  explicit XmlParser(const std::string& text) : text_(text) {}

  XmlElement Document() {
    SkipMisc();
    XmlElement root = Element();
    SkipMisc();
    if (at_ != text_.size()) Fail("text after the root");
    return root;
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw std::runtime_error(what + " at " + std::to_string(at_));
  }
  bool At(const std::string& token) const { return text_.compare(at_, token.size(), token) == 0; }
  void Expect(const std::string& token) {
    if (!At(token)) Fail("expected " + token);
    at_ += token.size();
  }
  void SkipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  void SkipMisc() {
    for (;;) {
      SkipSpace();
      const std::string end = At("<?") ? "?>" : At("<!--") ? "-->" : "";
      if (end.empty()) return;
      const std::size_t found = text_.find(end, at_);
      if (found == std::string::npos) Fail("unterminated");
      at_ = found + end.size();
    }
  }
  std::string Name() {
    const std::size_t start = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  text_[at_] == '_' || text_[at_] == '-')) {
      ++at_;
    }
    if (at_ == start) Fail("expected a name");
    return text_.substr(start, at_ - start);
  }
  std::string Text(char end) {
    std::string value;
    while (at_ < text_.size() && text_[at_] != end) {
      if (text_[at_] == '<') Fail("bare <");
      if (text_[at_] == '&') {
        value += Reference();
      } else {
        value += text_[at_++];
      }
    }
    return value;
  }
  char Reference() {
    static const std::map<std::string, char> kNames = {{"&amp;", '&'},  {"&lt;", '<'},
                                                       {"&gt;", '>'},   {"&quot;", '"'},
                                                       {"&#10;", '\n'}, {"&#9;", '\t'}};
    for (const auto& [name, c] : kNames) {
      if (!At(name)) continue;
      at_ += name.size();
      return c;
    }
    Fail("unknown reference");
  }
  XmlElement Element() {
    Expect("<");
    XmlElement element;
    element.name = Name();
    for (SkipSpace(); !At("/>") && !At(">"); SkipSpace()) {
      const std::string name = Name();
      Expect("=\"");
      if (!element.attributes.emplace(name, Text('"')).second) Fail("attribute twice");
      Expect("\"");
    }
    if (At("/>")) {
      at_ += 2;
      return element;
    }
    Expect(">");
    for (;;) {
      element.text += Text('<');
      SkipMisc();
      if (At("</")) break;
      element.children.push_back(Element());
    }
    Expect("</" + element.name + ">");
    return element;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

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

const XmlElement& Tree(const XmlElement& root, const std::string& id) {
  for (const XmlElement& child : root.children) {
    if (child.name == "BehaviorTree" && child.attributes.at("ID") == id) return child;
  }
  throw std::runtime_error("no tree " + id);
}

}  // namespace

XmlElement ParseXml(const std::string& text) { return XmlParser(text).Document(); }

BehaviorTree::BehaviorTree(const std::string& xml, Run run)
    : root_(ParseXml(xml)), run_(std::move(run)) {
  if (root_.name != "root" || root_.attributes.at("BTCPP_format") != "4") {
    throw std::runtime_error("no BehaviorTree.CPP v4 document");
  }
}

TickStatus BehaviorTree::RunToEnd(int max_ticks) {
  const XmlElement& tree = Tree(root_, root_.attributes.at("main_tree_to_execute"));
  if (tree.children.size() != 1) throw std::runtime_error("a tree has one root");
  // Only the loop runs over several ticks, and nothing before it has to be remembered but that it
  // was done: a Sequence goes on where it was.
  const XmlElement& top = tree.children.front();
  if (top.name != "Sequence") return Tick(top);
  for (const XmlElement& child : top.children) {
    TickStatus status = Tick(child);
    while (status == TickStatus::kRunning && max_ticks-- > 0) status = Tick(child);
    if (status != TickStatus::kSuccess) return status;
  }
  return TickStatus::kSuccess;
}

TickStatus BehaviorTree::Tick(const XmlElement& element) {
  if (element.name == "Sequence" || element.name == "Fallback") {
    const auto goes_on = element.name == "Sequence" ? TickStatus::kSuccess : TickStatus::kFailure;
    for (const XmlElement& child : element.children) {
      const TickStatus status = Tick(child);
      if (status != goes_on) return status;
    }
    return goes_on;
  }
  if (element.name == "ForceSuccess") {
    const TickStatus status = Tick(element.children.at(0));
    return status == TickStatus::kRunning ? status : TickStatus::kSuccess;
  }
  if (element.name == "KeepRunningUntilFailure") {
    const TickStatus status = Tick(element.children.at(0));
    return status == TickStatus::kFailure ? status : TickStatus::kRunning;
  }
  if (element.name == "Script") {
    Evaluate(element.attributes.at("code"));
    return TickStatus::kSuccess;
  }
  if (element.name == "ScriptCondition") {
    return Evaluate(element.attributes.at("code")) == "true" ? TickStatus::kSuccess
                                                             : TickStatus::kFailure;
  }
  return RunSkill(element);
}

TickStatus BehaviorTree::RunSkill(const XmlElement& element) {
  const std::string outcome = run_(element.attributes.at("name"));
  const std::string& port = element.attributes.at("outcome");
  blackboard_[port.substr(1, port.size() - 2)] = outcome;
  return outcome == "failed" ? TickStatus::kFailure : TickStatus::kSuccess;
}

std::string BehaviorTree::Evaluate(const std::string& code) {
  return Script(code, blackboard_).Run();
}

}  // namespace lares::testing
