#include "server/api/context.h"
#include "server/api/documents.h"

namespace lares::api {

void AddRobotRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kRobot, "/v1/robots", "Robot", "Robots"};
  AddDocumentPutRoutes(routes, router, context);
  AddDocumentReadRoutes(routes, router, context);
}

}  // namespace lares::api
