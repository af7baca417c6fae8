#include "tests/recipes/pddl_planner.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <stdexcept>

namespace lares::testing {
namespace {

struct Expression {
  std::string word;  // empty: a list
  std::vector<Expression> items;
  bool is_list = false;
};

[[noreturn]] void Fail(const std::string& what) { throw std::runtime_error("PDDL: " + what); }

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  Expression Whole() {
    Expression expression = Next();
    SkipSpace();
    if (at_ != text_.size()) Fail("text after the end");
    return expression;
  }

 private:
  void SkipSpace() {
    while (at_ < text_.size()) {
      if (text_[at_] == ';') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }
  Expression Next() {
    SkipSpace();
    if (at_ == text_.size()) Fail("it ends too early");
    Expression expression;
    if (text_[at_] != '(') {
      expression.word = Word();
      return expression;
    }
    ++at_;
    expression.is_list = true;
    for (SkipSpace(); at_ < text_.size() && text_[at_] != ')'; SkipSpace()) {
      expression.items.push_back(Next());
    }
    if (at_ == text_.size()) Fail("a bracket is not closed");
    ++at_;
    return expression;
  }
  std::string Word() {
    const std::size_t start = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != ':' &&
          c != '?') {
        break;
      }
      ++at_;
    }
    if (start == at_) Fail(std::string("unexpected '") + text_[at_] + "'");
    return text_.substr(start, at_ - start);
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

// A name begins with a letter; the language does not tell cases apart, and the exports write lower.
std::string Name(const Expression& expression) {
  const std::string& word = expression.word;
  if (expression.is_list || word.empty() ||
      std::isalpha(static_cast<unsigned char>(word[0])) == 0) {
    Fail("'" + word + "' is no name");
  }
  for (const char c : word) {
    if (c == ':' || c == '?' || std::isupper(static_cast<unsigned char>(c)) != 0) {
      Fail("'" + word + "' is no name in lower case");
    }
  }
  return word;
}

void ExpectWord(const Expression& expression, const std::string& word) {
  if (expression.is_list || expression.word != word) Fail("expected " + word);
}

const std::vector<Expression>& List(const Expression& expression) {
  if (!expression.is_list) Fail("expected a list instead of '" + expression.word + "'");
  return expression.items;
}

// "a b - t c - u" from `from` on: name → type.
std::map<std::string, std::string> TypedNames(const std::vector<Expression>& items,
                                              std::size_t from, bool variables) {
  std::map<std::string, std::string> typed;
  std::vector<std::string> waiting;
  for (std::size_t i = from; i < items.size(); ++i) {
    if (items[i].word == "-") {
      if (waiting.empty() || ++i == items.size()) Fail("a type without names");
      for (const std::string& name : waiting) {
        if (!typed.emplace(name, Name(items[i])).second) Fail(name + " is declared twice");
      }
      waiting.clear();
    } else if (variables) {
      if (items[i].word.size() < 2 || items[i].word[0] != '?') Fail("expected a variable");
      waiting.push_back(items[i].word);
    } else {
      waiting.push_back(Name(items[i]));
    }
  }
  if (!waiting.empty()) Fail(waiting.front() + " has no type");
  return typed;
}

class Domain {
 public:
  Domain(const Expression& whole, PddlTask& task) : task_(task) {
    const auto& parts = List(whole);
    if (parts.size() < 2) Fail("a domain has parts");
    ExpectWord(parts[0], "define");
    ExpectWord(List(parts[1]).at(0), "domain");
    name_ = Name(List(parts[1]).at(1));
    // The order of the language's definition.
    static const std::vector<std::string> kOrder = {":requirements", ":types", ":constants",
                                                    ":predicates", ":action"};
    std::size_t stage = 0;
    for (std::size_t i = 2; i < parts.size(); ++i) {
      const auto& part = List(parts[i]);
      const auto at = std::find(kOrder.begin(), kOrder.end(), part.at(0).word) - kOrder.begin();
      if (at == static_cast<std::ptrdiff_t>(kOrder.size()) ||
          static_cast<std::size_t>(at) < stage) {
        Fail("unexpected part " + part.at(0).word);
      }
      stage = static_cast<std::size_t>(at);
      Read(part, stage);
    }
  }

  const std::string& name() const { return name_; }

  std::string Atom(const Expression& expression) const {
    const auto& items = List(expression);
    if (items.empty()) Fail("an empty atom");
    const auto predicate = predicates_.find(Name(items[0]));
    if (predicate == predicates_.end()) Fail("unknown predicate " + items[0].word);
    if (predicate->second.size() + 1 != items.size()) Fail("wrong arity of " + items[0].word);
    std::string text = "(" + items[0].word;
    for (std::size_t i = 1; i < items.size(); ++i) {
      const auto constant = constants_.find(Name(items[i]));
      if (constant == constants_.end()) Fail("unknown constant " + items[i].word);
      if (constant->second != predicate->second[i - 1]) Fail("wrong type of " + items[i].word);
      text += " " + items[i].word;
    }
    return text + ")";
  }

  // "(and …)" or one literal.
  void Literals(const Expression& expression, std::set<std::string>& yes,
                std::set<std::string>& no) const {
    const auto& items = List(expression);
    if (!items.empty() && items[0].word == "and") {
      for (std::size_t i = 1; i < items.size(); ++i) Literals(items[i], yes, no);
    } else if (!items.empty() && items[0].word == "not") {
      if (items.size() != 2) Fail("not takes one atom");
      no.insert(Atom(items[1]));
    } else {
      yes.insert(Atom(expression));
    }
  }

 private:
  void Read(const std::vector<Expression>& part, std::size_t stage) {
    if (stage == 0) {
      std::set<std::string> requirements;
      for (std::size_t i = 1; i < part.size(); ++i) requirements.insert(part[i].word);
      if (requirements != std::set<std::string>{":strips", ":typing", ":negative-preconditions"}) {
        Fail("other requirements");
      }
    } else if (stage == 1) {
      types_ = TypedNames(part, 1, false);
    } else if (stage == 2) {
      constants_ = TypedNames(part, 1, false);
      for (const auto& [name, type] : constants_) CheckType(type);
    } else if (stage == 3) {
      for (std::size_t i = 1; i < part.size(); ++i) AddPredicate(List(part[i]));
    } else {
      AddAction(part);
    }
  }
  void CheckType(const std::string& type) const {
    if (types_.count(type) == 0) Fail("unknown type " + type);
  }
  void AddPredicate(const std::vector<Expression>& items) {
    std::vector<std::string> types;
    for (const auto& [variable, type] : TypedNames(items, 1, true)) {
      CheckType(type);
      types.push_back(type);
    }
    if (!predicates_.emplace(Name(items.at(0)), types).second) Fail("a predicate twice");
  }
  void AddAction(const std::vector<Expression>& items) {
    if (items.size() != 8) Fail("an action has parameters, precondition and effect");
    PddlTask::Action action;
    action.name = Name(items[1]);
    for (const PddlTask::Action& other : task_.actions) {
      if (other.name == action.name) Fail("the action " + action.name + " twice");
    }
    ExpectWord(items[2], ":parameters");
    if (!List(items[3]).empty()) Fail("actions are grounded");
    ExpectWord(items[4], ":precondition");
    Literals(items[5], action.needs, action.refuses);
    ExpectWord(items[6], ":effect");
    Literals(items[7], action.adds, action.deletes);
    for (const std::string& atom : action.adds) {
      if (action.deletes.count(atom) > 0) Fail(action.name + " adds and deletes " + atom);
    }
    task_.actions.push_back(std::move(action));
  }

  std::string name_;
  std::map<std::string, std::string> types_;
  std::map<std::string, std::string> constants_;
  std::map<std::string, std::vector<std::string>> predicates_;
  PddlTask& task_;
};

void ReadProblem(const Expression& whole, const Domain& domain, PddlTask& task) {
  const auto& parts = List(whole);
  if (parts.size() != 5) Fail("a problem has a name, a domain, init and goal");
  ExpectWord(parts[0], "define");
  ExpectWord(List(parts[1]).at(0), "problem");
  Name(List(parts[1]).at(1));
  ExpectWord(List(parts[2]).at(0), ":domain");
  if (Name(List(parts[2]).at(1)) != domain.name()) Fail("of another domain");
  ExpectWord(List(parts[3]).at(0), ":init");
  for (std::size_t i = 1; i < List(parts[3]).size(); ++i) {
    if (!task.init.insert(domain.Atom(parts[3].items[i])).second) Fail("said twice at the start");
  }
  ExpectWord(List(parts[4]).at(0), ":goal");
  std::set<std::string> not_goal;
  domain.Literals(List(parts[4]).at(1), task.goal, not_goal);
  if (!not_goal.empty()) Fail("a negative goal");
}

bool Includes(const std::set<std::string>& all, const std::set<std::string>& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

bool Applies(const PddlTask::Action& action, const std::set<std::string>& facts) {
  return Includes(facts, action.needs) &&
         std::none_of(action.refuses.begin(), action.refuses.end(),
                      [&](const std::string& atom) { return facts.count(atom) > 0; });
}

}  // namespace

PddlTask ReadPddl(const std::string& domain_text, const std::string& problem_text) {
  PddlTask task;
  const Domain domain(Reader(domain_text).Whole(), task);
  ReadProblem(Reader(problem_text).Whole(), domain, task);
  return task;
}

std::optional<std::vector<std::string>> FindPddlPlan(const PddlTask& task) {
  using Facts = std::set<std::string>;
  struct Step {
    Facts before;
    std::string action;
  };
  std::map<Facts, Step> reached{{task.init, {}}};
  std::deque<Facts> open{task.init};
  while (!open.empty()) {
    const Facts facts = std::move(open.front());
    open.pop_front();
    if (Includes(facts, task.goal)) {
      std::vector<std::string> plan;
      for (Facts at = facts; at != task.init; at = reached.at(at).before) {
        plan.push_back(reached.at(at).action);
      }
      std::reverse(plan.begin(), plan.end());
      return plan;
    }
    for (const PddlTask::Action& action : task.actions) {
      if (!Applies(action, facts)) continue;
      Facts next = facts;
      for (const std::string& atom : action.deletes) next.erase(atom);
      next.insert(action.adds.begin(), action.adds.end());
      if (reached.emplace(next, Step{facts, action.name}).second) open.push_back(next);
    }
  }
  return std::nullopt;
}

}  // namespace lares::testing
