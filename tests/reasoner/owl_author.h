// Random ontologies for tests.
#pragma once

#include <random>
#include <string>

namespace lares::testing {

// Writes statements about a few classes (:C0 …), restrictions (:R0 …), properties, individuals and
// lists, so few that rules meet. Each draws its shape at random, in the subset of Turtle that
// GraphOf reads. Equal seeds write equal texts.
class Author {
 public:
  // Without `equality` no shape makes two things one.
  explicit Author(unsigned seed, bool equality = true) : random_(seed), equality_(equality) {}

  std::string Statement();  // a line
  std::string Text(int statements);
  unsigned Below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }

 private:
  std::string Name(char kind);

  std::mt19937 random_;
  bool equality_;
};

}  // namespace lares::testing
