#include "server/api/quarantine.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/api/answers.h"
#include "server/api/documents.h"
#include "server/api/environments.h"
#include "server/api/scope.h"
#include "server/http/problem.h"
#include "server/knowledge/quarantine.h"
#include "server/knowledge/refusal.h"

namespace lares::api {
namespace {

constexpr const char* kCollection = "/v1/quarantine";

// A fault of the interface that says what the refusal says.
http::ProblemError ToProblemError(const server::Refusal& refusal) {
  const bool foreign = refusal.kind() == server::Refusal::Kind::kForeignTerm;
  http::ProblemError problem(foreign ? "foreign-term" : "contradiction", refusal.what(),
                             *refusal.place());
  problem.WithMembers(refusal.members_json());
  problem.WithHint(refusal.hint());
  return problem;
}

template <typename Work>
auto Translated(const Work& work) {
  try {
    return work();
  } catch (const server::Refusal& refusal) {
    throw ToProblemError(refusal);
  }
}

bool ReadEditor(const http::Request& request) {
  const bool editor = QueryFlag(request, "editor");
  if (editor) CheckIsEditor(request);
  return editor;
}

http::Response Release(const http::Request& request, Context& context) {
  const bool editor = ReadEditor(request);
  const std::string& id = request.Param("id");
  if (!MaySee(request, store::DocumentKind::kQuarantined, id)) {
    throw Error(Code::kNotFound, "no document '" + id + "' is kept aside")
        .WithHint("lares quarantine list shows those that are");
  }
  if (id.starts_with(server::QuarantineIdOfEnvironment(""))) {
    return VersionCreated(Translated([&] { return context.knowledge.ReleaseVersion(id, editor); }));
  }
  return JsonAnswer(ToJson(Translated([&] { return context.knowledge.Release(id, editor); })));
}

}  // namespace

void ReadRights(const http::Request& request, server::PutRequest& put) {
  put.editor = ReadEditor(request);
  put.quarantine = QueryFlag(request, "quarantine");
}

server::Knowledge::VersionRights ReadVersionRights(const http::Request& request) {
  return {ReadEditor(request), QueryFlag(request, "quarantine")};
}

server::PutAnswer Put(Context& context, const server::PutRequest& put) {
  return Translated([&] { return context.knowledge.Put(put); });
}

server::Knowledge::VersionAnswer PutVersion(Context& context, const store::NewVersion& version,
                                            const server::Knowledge::VersionRights& rights) {
  return Translated([&] { return context.knowledge.PutVersion(version, rights); });
}

void AddQuarantineRoutes(http::Router& router, Context& context) {
  AddDocumentReadRoutes({store::DocumentKind::kQuarantined, kCollection, "QuarantinedDocument",
                         "QuarantinedDocuments"},
                        router, context);
  router.Add({"POST",
              std::string(kCollection) + "/{id}/release",
              "releaseQuarantinedDocument",
              [&context](const http::Request& request) { return Release(request, context); },
              {},
              0});
}

}  // namespace lares::api
