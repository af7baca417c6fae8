#include "reasoner/profile/check.h"

#include "reasoner/profile/collector.h"
#include "reasoner/profile/consequences.h"
#include "reasoner/profile/declarations.h"
#include "reasoner/profile/document_index.h"
#include "reasoner/profile/expressions.h"
#include "reasoner/profile/structure.h"

namespace lares::profile {

Report Check(const Input& input, std::stop_token stop) {
  if (stop.stop_requested()) throw Error(Code::kTimeout, "the check took too long");
  const DocumentIndex index(input.document);
  Collector found(index, input.text, input.source);
  CheckStructure(index, found);
  CheckProfile(index, found);
  CheckDeclarations(index, input.catalogue, input.aliases, found);
  CheckConsequences(index, input.catalogue, input.aliases, found, std::move(stop));
  return found.Take();
}

}  // namespace lares::profile
