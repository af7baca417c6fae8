#include "reasoner/owl/proof.h"

#include <algorithm>

namespace lares::owl {

std::size_t Proof::steps() const {
  return static_cast<std::size_t>(std::count_if(
      nodes.begin(), nodes.end(), [](const ProofNode& node) { return !node.is_asserted(); }));
}

}  // namespace lares::owl
