#include "server/api/context.h"
#include "server/api/documents.h"
#include "server/api/recipe_robots.h"

namespace lares::api {

void AddRecipeRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kRecipe, "/v1/recipes", "Recipe", "Recipes"};
  AddDocumentPutRoutes(routes, router, context);
  AddDocumentReadRoutes(routes, router, context);
  AddRecipeRobotRoute(router, context);
}

}  // namespace lares::api
