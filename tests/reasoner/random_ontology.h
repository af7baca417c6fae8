// Random small ontologies that use every construct of OWL 2 RL, in the text of test_graph.h.
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace lares::testing {

// Statements about a few classes (:C0…), properties (:P0…), restrictions (:R0…), lists (:L0, :L1)
// and individuals (:I0…); each draws its shape at random. Equal seeds give equal texts.
// Without `equality` no shape makes two things one; with `values` some write one literal in several
// ways, or speak of datatypes.
class Author {
 public:
  explicit Author(unsigned seed, bool equality = true, bool values = false)
      : random_(seed), equality_(equality), values_(values) {}

  std::string Statement();
  std::string Text(int statements);
  unsigned Below(unsigned limit) { return static_cast<unsigned>(random_() % limit); }

 private:
  std::string_view Shape();
  std::string Name(char kind);

  std::mt19937 random_;
  bool equality_;
  bool values_;
};

}  // namespace lares::testing
