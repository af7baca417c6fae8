#include "base/error.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/documents.h"
#include "server/api/once.h"

namespace lares::api {
namespace {

const std::vector<std::string>& PriorUploadTypes() {
  static const std::vector<std::string> types = [] {
    std::vector<std::string> all = RdfUploadTypes();
    all.insert(all.end(), {"text/tab-separated-values", "text/plain"});
    return all;
  }();
  return types;
}

}  // namespace

void AddPriorRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kPrior, "/v1/priors", "Prior", "Priors"};
  const http::Handler put =
      Once(context, [&context, collection = routes.collection](const http::Request& request) {
        server::PutRequest prior =
            ToPutRequest(store::DocumentKind::kPrior, request, context.store);
        prior.prior_format = request.Query("format").value_or("");
        if (prior.prior_format != "omics" && prior.prior_format != "tsv") {
          throw Error(Code::kInvalid, "?format= must be 'omics' or 'tsv'");
        }
        const bool existed = context.store.FindDocument(prior.kind, prior.id).has_value();
        return PutAnswerToResponse(context.knowledge.Put(prior), collection, existed);
      });
  router.Add({"PUT", "/v1/priors/{id}", "putPrior", put, PriorUploadTypes(),
              kMaxDocumentBytes + (1u << 20)});
  AddDocumentReadRoutes(routes, router, context);
}

}  // namespace lares::api
