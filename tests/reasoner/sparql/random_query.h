// Random small graphs and queries over them, in the part of SPARQL that Rasqal knows as well.
#pragma once

#include <random>
#include <string>

namespace lares::sparql::testing {

// Equal seeds give equal texts. http://example.org/ is the empty prefix, declared in each text.
class QueryAuthor {
 public:
  explicit QueryAuthor(unsigned seed) : random_(seed) {}

  // Turtle: a few resources, some of them blank, whose :n are integers, :v literals of many kinds
  // and :p and :q resources.
  std::string Data();
  // SELECT. One with ORDER BY has only the keys of its order as columns, and each is an integer:
  // so its rows and their order are certain. One with LIMIT and no ORDER BY is certain in the
  // number of its rows only.
  std::string Query();

  bool HasLimitOnly() const { return has_limit_ && !has_order_; }

 private:
  unsigned Below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }
  template <std::size_t N>
  std::string OneOf(const char* const (&words)[N]) {
    return words[Below(N)];
  }
  std::string Variable();
  std::string Resource();
  std::string Literal();
  std::string TriplePattern();
  std::string Group(int depth);
  std::string Number(int depth);
  std::string Condition(int depth);
  std::string OrderedQuery();

  std::mt19937 random_;
  bool has_order_ = false;
  bool has_limit_ = false;
};

}  // namespace lares::sparql::testing
