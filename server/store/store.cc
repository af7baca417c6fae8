#include "server/store/store.h"

#include "server/store/sqlite_store.h"

namespace lares::store {

std::string_view ToString(DocumentKind kind) {
  switch (kind) {
    case DocumentKind::kOntology:
      return "ontology";
    case DocumentKind::kRecipe:
      return "recipe";
    case DocumentKind::kRobot:
      return "robot";
    case DocumentKind::kObjectModel:
      return "object-model";
    case DocumentKind::kPrior:
      return "prior";
    case DocumentKind::kSkillTemplate:
      return "skill-template";
    case DocumentKind::kQuarantined:
      return "quarantined";
  }
  return "ontology";
}

std::string_view ToString(Origin origin) {
  switch (origin) {
    case Origin::kPut:
      return "put";
    case Origin::kRollback:
      return "rollback";
    case Origin::kMerge:
      return "merge";
  }
  return "put";
}

std::unique_ptr<Store> OpenSqliteStore(const StoreOptions& options) {
  return OpenSqliteStore(options, Seams{});
}

}  // namespace lares::store
