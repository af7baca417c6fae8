#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/text.h"
#include "server/api/answers.h"
#include "server/api/context.h"
#include "server/api/documents.h"
#include "server/api/quarantine.h"

namespace lares::api {
namespace {

constexpr const char* kCollection = "/v1/skill-templates";

Json ToJson(const recipes::SkillInput& input) {
  Json json{{"name", input.name},
            {"type", input.type},
            {"optional", input.optional},
            {"sources", input.sources}};
  if (!input.unit.empty()) json["unit"] = input.unit;
  return json;
}

Json ToJson(const recipes::SkillOutcome& outcome) {
  Json json{{"name", outcome.name}, {"means", nullptr}, {"effects", outcome.effects}};
  if (!outcome.means.iri.empty()) json["means"] = api::ToJson(outcome.means);
  return json;
}

Json ToJson(const recipes::SkillTemplate& each) {
  Json json{{"iri", each.iri.iri},
            {"label", each.iri.label},
            {"comment", each.comment},
            {"actions", api::ToJson(each.actions)},
            {"skill", each.skill},
            {"conditions", each.conditions},
            {"inputs", Json::array()},
            {"outputs", Json::array()},
            {"outcomes", Json::array()},
            {"claims", api::ToJson(each.claims)},
            {"preconditions", each.preconditions}};
  for (const recipes::SkillInput& input : each.inputs) json["inputs"].push_back(ToJson(input));
  for (const recipes::SkillOutput& output : each.outputs) {
    json["outputs"].push_back({{"name", output.name},
                               {"type", output.type},
                               {"key_property", api::ToJson(output.key_property)}});
  }
  for (const recipes::SkillOutcome& outcome : each.outcomes) {
    json["outcomes"].push_back(ToJson(outcome));
  }
  if (!each.retries.empty()) json["retries"] = each.retries;
  if (!each.time_limit_s.empty()) json["time_limit_s"] = each.time_limit_s;
  if (!each.tree_fragment.empty()) json["tree_fragment"] = each.tree_fragment;
  return json;
}

// The id of the stored document that says it; none of a built-in template.
Json DocumentOf(const Context& context, const std::string& iri) {
  for (const auto& [document, name] :
       context.store.FindByName(store::DocumentKind::kSkillTemplate, iri)) {
    return document.id;
  }
  return nullptr;
}

http::Response ListTemplates(const http::Request& request, Context& context) {
  const auto templates = context.knowledge.SkillTemplates();
  return Page(
      request, templates.size(), [&](std::size_t i) { return templates[i].iri.iri; },
      [&](std::size_t i) {
        Json json = ToJson(templates[i]);
        json["document"] = DocumentOf(context, templates[i].iri.iri);
        return json;
      });
}

}  // namespace

void AddSkillTemplateRoutes(http::Router& router, Context& context) {
  const DocumentRoutes routes{store::DocumentKind::kSkillTemplate, kCollection, "SkillTemplate",
                              "SkillTemplates"};
  AddDocumentPutRoutes(routes, router, context);
  http::Router documents;
  AddDocumentReadRoutes(routes, documents, context);
  for (http::Route route : documents.routes()) {
    if (route.operation == "listSkillTemplates") {
      route.handler = [&context](const http::Request& request) {
        return ListTemplates(request, context);
      };
    }
    router.Add(std::move(route));
  }
}

}  // namespace lares::api
