#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/search_path.h"
#include "ontology/rdf/vocabulary.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/documents.h"

namespace lares::api {
namespace {

constexpr const char* kModules = "/v1/ontology/modules";

http::Response ListModules(const http::Request& request, const Context& context) {
  std::vector<server::Knowledge::Module> modules = context.knowledge.Modules();
  for (const store::DocumentInfo& aside :
       context.store.ListDocuments(store::DocumentKind::kQuarantined)) {
    constexpr std::string_view kPrefix = "ontology.";
    if (!aside.id.starts_with(kPrefix)) continue;
    modules.push_back({aside.id.substr(kPrefix.size()), "quarantined", 0});
  }
  return Page(
      request, modules.size(), [&](std::size_t i) { return modules[i].id; },
      [&](std::size_t i) {
        Json json{{"id", modules[i].id},
                  {"origin", modules[i].origin},
                  {"statements", modules[i].statements}};
        const auto document =
            context.store.FindDocument(store::DocumentKind::kOntology, modules[i].id);
        if (document) json["document"] = ToJson(*document);
        return json;
      });
}

// A module of ours, which is a file and no stored document.
std::optional<http::Response> BuiltInModule(const std::string& id) {
  for (const std::filesystem::path& file : ListShared("ontology", ".ttl")) {
    if (file.stem() != id) continue;
    http::Response response;
    response.headers.Set("Content-Type", "text/turtle");
    response.headers.Set("Accept-Ranges", "bytes");
    response.headers.Set("Content-Disposition", ContentDisposition(file.filename().string()));
    response.body = http::FileBody{file, 0, std::filesystem::file_size(file)};
    return response;
  }
  return std::nullopt;
}

http::Response CheckOntology(const http::Request& request, const Context& context) {
  Upload upload = ReadUpload(request, false);
  server::CheckRequest check;
  check.media_type = std::move(upload.media_type);
  check.file_name = std::move(upload.file_name);
  check.bytes = std::move(upload.bytes);
  check.recover = QueryFlag(request, "recover");
  return JsonAnswer(ToJson(context.knowledge.Check(check)));
}

http::Response ListAliases(const http::Request& request, const Context& context) {
  const std::vector<rdf::Alias>& aliases = context.knowledge.aliases().aliases();
  return Page(
      request, aliases.size(), [&](std::size_t i) { return aliases[i].alias; },
      [&](std::size_t i) {
        return Json{{"alias", aliases[i].alias},
                    {"canonical", aliases[i].canonical},
                    {"namespace", aliases[i].is_namespace},
                    {"reason", aliases[i].reason}};
      });
}

Json RelatedClasses(const rdf::View& view, const std::vector<rdf::TermId>& terms,
                    rdf::TermId self) {
  std::vector<std::pair<std::string, std::string>> related;  // label, IRI
  for (const rdf::TermId term : terms) {
    const rdf::TermView named = view.dictionary().Get(term);
    if (term == self || named.kind != rdf::TermKind::kIri) continue;
    related.emplace_back(view.Label(term), named.value);
  }
  std::sort(related.begin(), related.end());
  Json json = Json::array();
  for (const auto& [label, iri] : related) json.push_back({{"iri", iri}, {"label", label}});
  return json;
}

http::Response GetClass(const http::Request& request, const Context& context) {
  const recipes::Resource found = context.knowledge.ResolveClass(request.Param("name"));
  const rdf::View view = context.knowledge.Catalogue();
  Json json = ToJson(found);
  json["superclasses"] = json["subclasses"] = Json::array();
  const auto sub_class_of = view.dictionary().FindIri(std::string(rdf::kRdfs) + "subClassOf");
  const auto self = view.dictionary().FindIri(found.iri);
  if (self && sub_class_of) {
    json["superclasses"] = RelatedClasses(view, view.Objects(*self, *sub_class_of), *self);
    json["subclasses"] = RelatedClasses(view, view.Subjects(*sub_class_of, *self), *self);
  }
  return JsonAnswer(json);
}

}  // namespace

void AddOntologyRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kOntology, kModules, "OntologyModule",
                              "OntologyModules"};
  AddDocumentPutRoutes(routes, router, context);
  http::Router documents;
  AddDocumentReadRoutes(routes, documents, context);
  for (http::Route route : documents.routes()) {
    if (route.operation == "listOntologyModules") {
      route.handler = [&context](const http::Request& request) {
        return ListModules(request, context);
      };
    } else if (route.operation == "getOntologyModule") {
      route.handler = [&context, stored = route.handler](const http::Request& request) {
        const std::string& id = request.Param("id");
        if (!context.store.FindDocument(store::DocumentKind::kOntology, id)) {
          if (auto built_in = BuiltInModule(id)) return *built_in;
        }
        return stored(request);
      };
    }
    router.Add(std::move(route));
  }
  router.Add({"POST", "/v1/ontology/check", "checkOntology",
              [&context](const http::Request& request) { return CheckOntology(request, context); },
              RdfUploadTypes(), kMaxDocumentBytes + (1u << 20)});
  router.Add({"GET",
              "/v1/ontology/aliases",
              "listAliases",
              [&context](const http::Request& request) { return ListAliases(request, context); },
              {},
              0});
  router.Add({"GET",
              "/v1/ontology/classes/{name}",
              "getClass",
              [&context](const http::Request& request) { return GetClass(request, context); },
              {},
              0});
}

}  // namespace lares::api
