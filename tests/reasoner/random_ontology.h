// Random small ontologies that use every construct of OWL 2 RL, in the text of test_graph.h.
#pragma once

#include <random>
#include <string>

namespace lares::testing {

// Statements about a few classes (:C0…), properties (:P0…), restrictions (:R0…), lists (:L0, :L1)
// and individuals (:I0…); each draws its shape at random. Equal seeds give equal texts.
// Without `equality` no shape makes two things one.
class Author {
 public:
  explicit Author(unsigned seed, bool equality = true) : random_(seed), equality_(equality) {}

  std::string Statement();
  std::string Text(int statements);
  unsigned Below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }

 private:
  std::string Name(char kind);

  std::mt19937 random_;
  bool equality_;
};

}  // namespace lares::testing
