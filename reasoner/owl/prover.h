// Why a triple holds: a proof with as few steps as can be, found when asked for.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stop_token>

#include "ontology/triples/view.h"
#include "reasoner/owl/proof.h"

namespace lares::owl {

struct ProofOptions {
  std::size_t max_work = 20'000'000;  // triples looked at for one proof; beyond it kTooLarge
  std::stop_token stop;               // kTimeout
};

// Proofs over one closed view. What one question works out serves the next. One thread at a time.
class Prover {
 public:
  explicit Prover(rdf::View view);
  ~Prover();
  Prover(const Prover&) = delete;
  Prover& operator=(const Prover&) = delete;

  // A proof of least cost: each step costs 1 and the cost of its premises, asserted triples cost
  // nothing (so a part that is used twice counts twice, and is shown once). Among equals the one
  // found first, which depends on the view alone. None when the triple does not hold. What is true
  // of everything (x owl:sameAs x, c ⊑ c …) is one step without premises.
  std::optional<Proof> Why(const rdf::Triple& triple, const ProofOptions& options = {});
  // Of one of the contradictions that the layers list, the one of least cost. None when there is
  // none.
  std::optional<Proof> WhyContradiction(const ProofOptions& options = {});

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace lares::owl
