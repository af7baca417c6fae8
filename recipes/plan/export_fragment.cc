#include "recipes/plan/export_fragment.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "base/text.h"

namespace lares::recipes {
namespace {

constexpr std::size_t kMaxBytes = 4096;
constexpr std::size_t kMaxDepth = 16;
constexpr long long kWeek_ms = 7LL * 24 * 3600 * 1000;

struct Rule {
  const char* name;
  const char* attribute;
  long long most;  // the least is 1
};
constexpr Rule kRules[] = {{"Timeout", "msec", kWeek_ms},
                           {"RetryUntilSuccessful", "num_attempts", 101},
                           {"Delay", "delay_msec", kWeek_ms}};

const Rule* FindRule(const std::string& name) {
  const auto rule = std::find_if(std::begin(kRules), std::end(kRules),
                                 [&](const Rule& each) { return each.name == name; });
  return rule == std::end(kRules) ? nullptr : rule;
}

struct Tag {
  enum class Kind { kOpen, kClose, kEmpty } kind = Kind::kOpen;
  std::string name;
  std::map<std::string, std::string> attributes;
};

// Tags one after another. The first thing that is none ends it with `problem`.
class TagReader {
 public:
  explicit TagReader(const std::string& text) : text_(text) {}

  // Nothing at the end, or with a problem.
  std::optional<Tag> Next() {
    SkipSpace();
    if (at_ == text_.size()) return std::nullopt;
    if (!Take('<')) return Fail("text stands between the elements");
    if (At('!') || At('?')) return Fail("declarations, comments and CDATA are not taken here");
    Tag tag;
    if (Take('/')) tag.kind = Tag::Kind::kClose;
    tag.name = Name();
    if (tag.name.empty()) return Fail("an element has no name");
    if (tag.kind != Tag::Kind::kClose && !ReadAttributes(tag)) return std::nullopt;
    SkipSpace();
    if (tag.kind != Tag::Kind::kClose && Take('/')) tag.kind = Tag::Kind::kEmpty;
    if (!Take('>')) return Fail("the tag <" + tag.name + " does not end");
    return tag;
  }

  const std::string& problem() const { return problem_; }

 private:
  std::optional<Tag> Fail(const std::string& what) {
    problem_ = what + " (at byte " + std::to_string(at_ + 1) + ")";
    return std::nullopt;
  }
  bool At(char c) const { return at_ < text_.size() && text_[at_] == c; }
  bool Take(char c) {
    if (!At(c)) return false;
    ++at_;
    return true;
  }
  void SkipSpace() {
    while (at_ < text_.size() && (At(' ') || At('\t') || At('\n') || At('\r'))) ++at_;
  }
  std::string Name() {
    const std::size_t start = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || At('_'))) {
      ++at_;
    }
    return text_.substr(start, at_ - start);
  }
  bool ReadAttributes(Tag& tag) {
    for (;;) {
      const std::size_t before = at_;
      SkipSpace();
      if (At('/') || At('>') || at_ == text_.size()) return true;
      if (before == at_) return Fail("a space is missing in <" + tag.name).has_value();
      const std::string name = Name();
      if (name.empty() || !Take('=')) {
        return Fail("an attribute of <" + tag.name + "> is malformed").has_value();
      }
      const char quote = At('\'') ? '\'' : '"';
      const std::size_t end = Take(quote) ? text_.find(quote, at_) : std::string::npos;
      if (end == std::string::npos) {
        return Fail("the value of '" + name + "' is not in quotes").has_value();
      }
      const std::string value = text_.substr(at_, end - at_);
      if (value.find_first_of("<&") != std::string::npos) {
        return Fail("the value of '" + name + "' holds < or &").has_value();
      }
      at_ = end + 1;
      if (!tag.attributes.emplace(name, value).second) {
        return Fail("<" + tag.name + "> has the attribute '" + name + "' twice").has_value();
      }
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::string problem_;
};

std::optional<long long> WholeNumber(const std::string& text) {
  long long number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

void ReadDecorator(const Tag& tag, TreeFragment& fragment) {
  std::vector<std::string>& problems = fragment.problems;
  const Rule* rule = FindRule(tag.name);
  if (rule == nullptr) {
    problems.push_back("<" + tag.name +
                       "> cannot be used; around a skill may be Timeout, RetryUntilSuccessful and "
                       "Delay");
    return;
  }
  for (const auto& [name, value] : tag.attributes) {
    if (name != rule->attribute && name != "name") {
      problems.push_back("<" + tag.name + "> has no attribute '" + name + "'");
    }
  }
  const auto written = tag.attributes.find(rule->attribute);
  if (written == tag.attributes.end()) {
    problems.push_back("<" + tag.name + "> lacks '" + rule->attribute + "'");
    return;
  }
  const auto number = WholeNumber(written->second);
  if (!number || *number < 1 || *number > rule->most) {
    problems.push_back("'" + std::string(rule->attribute) + "' of <" + tag.name +
                       "> must be a whole number from 1 to " + std::to_string(rule->most) +
                       ", not '" + written->second + "'");
    return;
  }
  fragment.decorators.push_back({tag.name, rule->attribute, *number});
}

// The time that is over for sure before the skill runs, against each limit around it.
void CheckTimes(TreeFragment& fragment) {
  const auto& decorators = fragment.decorators;
  for (std::size_t i = 0; i < decorators.size(); ++i) {
    if (decorators[i].name != "Timeout") continue;
    long long waits_ms = 0;
    for (std::size_t j = i + 1; j < decorators.size(); ++j) {
      if (decorators[j].name == "Delay") waits_ms += decorators[j].number;
    }
    if (waits_ms >= decorators[i].number) {
      fragment.problems.push_back("a Timeout of " + std::to_string(decorators[i].number) +
                                  " ms leaves no time to the skill, which is delayed by " +
                                  std::to_string(waits_ms) + " ms");
    }
  }
}

class FragmentParser {
 public:
  explicit FragmentParser(const std::string& xml) : tags_(xml) {}

  TreeFragment Parse() {
    while (auto tag = tags_.Next()) {
      if (tag->kind == Tag::Kind::kClose) {
        if (!Close(*tag)) return Done();
      } else if (!Open(*tag)) {
        return Done();
      }
    }
    if (!tags_.problem().empty()) {
      Problem(tags_.problem());
    } else if (!open_.empty()) {
      Problem("<" + open_.back().name + "> is not closed");
    } else if (skills_ == 0) {
      Problem("there is no <Skill/> in it");
    }
    return Done();
  }

 private:
  void Problem(const std::string& sentence) { fragment_.problems.push_back(sentence); }

  bool Open(const Tag& tag) {
    if (open_.empty() && roots_++ > 0) return Problem("there is more than one root"), false;
    if (!open_.empty() && open_.back().children++ > 0) {
      Problem(skills_ > 0 && tag.name == "Skill"
                  ? "<Skill/> stands in it more than once"
                  : "<" + open_.back().name + "> holds more than one element");
      return false;
    }
    if (tag.name == "Skill") {
      ++skills_;
      if (!tag.attributes.empty()) Problem("<Skill/> takes no attributes");
    } else {
      ReadDecorator(tag, fragment_);
      if (tag.kind == Tag::Kind::kEmpty) Problem("<" + tag.name + "> holds nothing");
    }
    if (tag.kind == Tag::Kind::kOpen) open_.push_back({tag.name});
    if (open_.size() <= kMaxDepth) return true;
    Problem("it is more than " + std::to_string(kMaxDepth) + " elements deep");
    return false;
  }

  bool Close(const Tag& tag) {
    if (open_.empty() || open_.back().name != tag.name) {
      Problem("</" + tag.name + "> closes nothing that is open");
      return false;
    }
    if (open_.back().children == 0 && tag.name != "Skill") {
      Problem("<" + tag.name + "> holds nothing");
    }
    if (open_.back().children > 0 && tag.name == "Skill") Problem("<Skill/> holds an element");
    open_.pop_back();
    return true;
  }

  TreeFragment Done() {
    if (fragment_.problems.empty()) CheckTimes(fragment_);
    if (!fragment_.problems.empty()) fragment_.decorators.clear();
    return std::move(fragment_);
  }

  struct OpenElement {
    std::string name;
    int children = 0;
  };
  TagReader tags_;
  std::vector<OpenElement> open_;
  int roots_ = 0;
  int skills_ = 0;
  TreeFragment fragment_;
};

}  // namespace

TreeFragment ParseTreeFragment(const std::string& xml) {
  TreeFragment fragment;
  if (xml.size() > kMaxBytes) {
    fragment.problems.push_back("it is longer than " + std::to_string(kMaxBytes) + " bytes");
  } else if (!IsUtf8(xml)) {
    fragment.problems.emplace_back("it is no UTF-8");
  } else {
    fragment = FragmentParser(xml).Parse();
  }
  return fragment;
}

std::vector<std::string> TreeFragmentProblems(const std::string& xml) {
  return ParseTreeFragment(xml).problems;
}

}  // namespace lares::recipes
