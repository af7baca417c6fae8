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
  std::size_t max_work = 2'000'000;  // triples looked at for one proof; beyond it kTooLarge
  std::stop_token stop;              // kTimeout
};

class ProofSearch;

// Proofs over one closed view. What one question works out serves the next. One thread at a time.
class Prover {
 public:
  explicit Prover(rdf::View view);
  ~Prover();
  Prover(const Prover&) = delete;
  Prover& operator=(const Prover&) = delete;

  // A proof of least cost: each step costs 1 and the cost of its premises, asserted triples cost
  // nothing (so a part that is used twice counts twice, and is shown once). Among equals the one
  // found first, which depends on the view alone. None when the triple does not hold. What holds
  // without being stored (on_demand.h) is one step without premises; only where there is no proof
  // without such premises are they looked at, and with them what holds of literals and no view
  // shows: in such a proof a literal may be a subject, as the rules allow. `triple` may be such a
  // one too.
  std::optional<Proof> Why(const rdf::Triple& triple, const ProofOptions& options = {});
  // Of one of the contradictions that the layers list, the one of least cost. None when there is
  // none. That two values differ is dt-diff, a premise of eq-diff1.
  std::optional<Proof> WhyContradiction(const ProofOptions& options = {});

 private:
  template <typename Ask>
  std::optional<Proof> Try(const ProofOptions& options, const Ask& ask);

  rdf::View view_;
  std::unique_ptr<ProofSearch> plain_;      // over what is stored
  std::unique_ptr<ProofSearch> computing_;  // and over what holds on demand; made when needed
};

}  // namespace lares::owl
