#include "server/api/api.h"

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
  AddEnvironmentRoutes(router, context);
  AddEnvironmentUploadRoute(router, context);
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
  return router;
}

std::shared_ptr<const http::Service> MakeService(Context& context) {
  http::Router router = MakeRouter(context);
  context.openapi = MakeOpenApi(router.routes());
  return std::make_shared<http::Service>(std::move(router), context.metrics);
}

}  // namespace lares::api
