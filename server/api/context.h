// What the handlers work with.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "reasoner/prolog_worker/workers.h"
#include "server/access/access.h"
#include "server/api/text_cache.h"
#include "server/api/watch_hub.h"
#include "server/http/metrics.h"
#include "server/http/router.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/snapshots.h"
#include "server/store/store.h"

namespace lares::api {

// Outlives the router whose handlers use it.
struct Context {
  store::Store& store;
  server::Knowledge& knowledge;
  std::shared_ptr<http::Metrics> metrics = std::make_shared<http::Metrics>();
  std::shared_ptr<TextCache> listed = std::make_shared<TextCache>();  // documents in lists
  std::shared_ptr<prolog::Workers> workers = std::make_shared<prolog::Workers>();  // for goals
  std::shared_ptr<server::Snapshots> snapshots = std::make_shared<server::Snapshots>();
  std::shared_ptr<WatchHub> watches;       // made with its routes
  std::filesystem::path backups;           // where this server's backups go; empty: nowhere
  std::string openapi;                     // the document, made once all routes are known
  std::shared_ptr<access::Access> access;  // made with the service
  http::OriginRules origins;
  std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now();
};

// One for each resource; together they are the whole interface.
void AddOntologyRoutes(http::Router& router, Context& context);
void AddTokenRoutes(http::Router& router, Context& context);
void AddAuditRoutes(http::Router& router, Context& context);
void AddPriorRoutes(http::Router& router, Context& context);
void AddRecipeRoutes(http::Router& router, Context& context);
void AddRobotGridRoutes(http::Router& router, Context& context);
void AddRobotRoutes(http::Router& router, Context& context);
void AddSkillTemplateRoutes(http::Router& router, Context& context);
void AddObjectModelRoutes(http::Router& router, Context& context);
void AddBackupRoutes(http::Router& router, Context& context);
void AddBlobRoutes(http::Router& router, Context& context);
void AddUploadRoutes(http::Router& router, Context& context);
void AddEnvironmentRoutes(http::Router& router, Context& context);
void AddEnvironmentUploadRoute(http::Router& router, Context& context);
void AddEnvironmentVersionRoutes(http::Router& router, Context& context);
void AddEnvironmentDownloadRoutes(http::Router& router, Context& context);
void AddPlanRoutes(http::Router& router, Context& context);
void AddPlanDiffRoutes(http::Router& router, Context& context);
void AddLikelyPlaceRoutes(http::Router& router, Context& context);
void AddPrologRoutes(http::Router& router, Context& context);
void AddQuarantineRoutes(http::Router& router, Context& context);
void AddReasonRoutes(http::Router& router, Context& context);
void AddSparqlRoutes(http::Router& router, Context& context);
void AddWatchRoutes(http::Router& router, Context& context);
void AddOperationRoutes(http::Router& router, Context& context);

}  // namespace lares::api
