// Which stored object models are worth loading before a robot enters a kind of room: the thesis'
// load-typical-object-models (Algorithm 1 of chapter 4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ontology/triples/view.h"
#include "reasoner/places/prior.h"
#include "reasoner/prolog/engine_pool.h"

namespace lares::models {

// What the choice needs to know of a model. IRIs canonical.
struct Candidate {
  struct Kind {
    std::string class_iri;
    std::vector<std::string> above;  // classes that the model's own description puts it under
  };
  struct Algorithm {
    std::string iri;
    std::vector<std::string> classes;  // kinds of component that it is
  };
  std::string id;
  std::vector<Kind> kinds;            // what it is a model of
  std::vector<Algorithm> algorithms;  // any one of them will do; none: not stated
  std::uint64_t size_bytes = 0;       // of all that has to be loaded
};

struct TypicalOptions {
  std::string room_iri;
  std::string robot_iri;                   // empty: any robot
  bool strict = false;                     // a robot must be said to have the algorithm
  double min_probability = 0.01;           // rarer classes are left out
  std::optional<std::size_t> max_models;   // that are loaded
  std::optional<std::uint64_t> max_bytes;  // of all that are loaded together
  double lambda = 0.5;                     // as in PriorIndex::Rank

  void Check() const;  // throws kInvalid naming the field
};

enum class Verdict { kLoaded, kNotTypical, kTooRare, kRobotLacks, kTooMany, kTooLarge };

// "loaded", "not-typical", "too-rare", "robot-lacks-algorithm", "too-many", "too-large".
const char* ToString(Verdict verdict);

struct Choice {
  std::string id;
  Verdict verdict = Verdict::kNotTypical;
  std::string class_iri;             // of what it models, the most probable
  std::vector<std::string> counted;  // classes whose rows spoke for it
  bool counted_above = false;        // `counted` is one class above class_iri, not at or below it
  double probability = 0;            // P(class | room): of the things counted there, the share
  double probability_of_room = 0;    // P(room | class): of the things of the class, the share
  std::optional<std::string> robot_has;  // the kind of component that uses it; without a robot none
  std::size_t nth_of_its_class = 1;
  std::uint64_t size_bytes = 0;
  std::string why;  // a sentence
};

struct TypicalChoice {
  std::vector<std::string> places;  // classes of rooms whose rows were looked at
  bool places_above = false;        // one class above the room that was asked for
  std::vector<Choice> loaded;       // the first of each class first, the most probable first
  std::vector<Choice> left_out;     // by verdict, then likewise
  std::uint64_t size_bytes = 0;     // of those loaded
};

// `rooms` counts things in rooms (not on furniture). `view` holds the catalogue and, for a robot,
// its description. P(class | room) is eq. 4.1 of the thesis with Laplace's smoothing over all rows
// at or below the class and the room: (count + λ) / (N_room + λ·V); a class without rows of its own
// gets those of the nearest class above it. A budget takes the first model of every class before a
// second one of any; a model too large for what is left is passed over. Deterministic.
TypicalChoice ChooseTypical(prolog::EnginePool& engines, const rdf::View& view,
                            const places::PriorTable& rooms,
                            const std::vector<Candidate>& candidates,
                            const TypicalOptions& options);

}  // namespace lares::models
