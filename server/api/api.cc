#include "server/api/api.h"

#include "base/error.h"
#include "server/api/openapi.h"

namespace lares::api {

http::Router MakeRouter(Context& context) {
  http::Router router;
  AddOperationRoutes(router, context);
  AddOntologyRoutes(router, context);
  AddPriorRoutes(router, context);
  AddRecipeRoutes(router, context);
  AddRobotRoutes(router, context);
  AddSkillTemplateRoutes(router, context);
  AddObjectModelRoutes(router, context);
  AddBackupRoutes(router, context);
  AddEnvironmentRoutes(router, context);
  AddEnvironmentUploadRoute(router, context);
  AddEnvironmentVersionRoutes(router, context);
  AddEnvironmentDownloadRoutes(router, context);
  AddUploadRoutes(router, context);
  AddBlobRoutes(router, context);
  AddRobotGridRoutes(router, context);
  AddQuarantineRoutes(router, context);
  AddPlanRoutes(router, context);
  AddPlanDiffRoutes(router, context);
  AddLikelyPlaceRoutes(router, context);
  AddPrologRoutes(router, context);
  AddReasonRoutes(router, context);
  AddSparqlRoutes(router, context);
  AddWatchRoutes(router, context);
  AddTokenRoutes(router, context);
  AddAuditRoutes(router, context);
  return router;
}

namespace {

// Better no server than one with a door that nobody thought of.
void CheckRoles(const http::Router& router, const access::AccessTable& table) {
  for (const http::Route& route : router.routes()) {
    if (table.Has(route.operation)) continue;
    throw Error(Code::kInternal, "operation " + route.operation + " has no x-lares-role");
  }
}

}  // namespace

std::shared_ptr<const http::Service> MakeService(Context& context) {
  if (context.access == nullptr) {
    context.access =
        std::make_shared<access::Access>(context.store, access::AccessTable(OperationsJson()));
  }
  http::Router router = MakeRouter(context);
  CheckRoles(router, context.access->table());
  context.openapi = MakeOpenApi(router.routes());
  return std::make_shared<http::Service>(
      std::move(router), http::ServiceOptions{context.metrics, context.access, context.origins});
}

}  // namespace lares::api
