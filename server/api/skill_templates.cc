#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "server/api/answers.h"
#include "server/api/context.h"

namespace lares::api {
namespace {

struct Template {
  std::string iri;
  Json json;
};

// What the catalogue asserts of a template, under the local names of its properties.
Json Describe(const rdf::View& view, rdf::TermId term) {
  std::map<std::string, std::vector<std::string>> properties;
  view.ForEach(
      {term, rdf::kAnyTerm, rdf::kAnyTerm},
      [&](const rdf::Triple& triple) {
        const rdf::TermView object = view.dictionary().Get(triple.object);
        if (object.kind == rdf::TermKind::kBlank) return true;
        const std::string name(LocalName(view.dictionary().Get(triple.predicate).value));
        if (name != "type" && name != "label") properties[name].emplace_back(object.value);
        return true;
      },
      rdf::Origin::kAsserted);
  Json json{{"iri", view.dictionary().Get(term).value}, {"label", view.Label(term)}};
  for (auto& [name, values] : properties) {
    std::sort(values.begin(), values.end());
    json["properties"][name] = values;
  }
  return json;
}

std::vector<Template> Templates(const rdf::View& view) {
  std::vector<Template> templates;
  const auto type = view.dictionary().FindIri(std::string(rdf::kRdf) + "type");
  const auto skill = view.dictionary().FindIri(std::string(rdf::kLares) + "SkillTemplate");
  if (!type || !skill) return templates;
  for (const rdf::TermId term : view.Subjects(*type, *skill)) {
    const rdf::TermView named = view.dictionary().Get(term);
    if (named.kind != rdf::TermKind::kIri) continue;
    templates.push_back({std::string(named.value), Describe(view, term)});
  }
  std::sort(templates.begin(), templates.end(),
            [](const Template& a, const Template& b) { return a.iri < b.iri; });
  return templates;
}

}  // namespace

void AddSkillTemplateRoutes(http::Router& router, Context& context) {
  router.Add({"GET",
              "/v1/skill-templates",
              "listSkillTemplates",
              [&context](const http::Request& request) {
                const std::vector<Template> templates = Templates(context.knowledge.Catalogue());
                return Page(
                    request, templates.size(), [&](std::size_t i) { return templates[i].iri; },
                    [&](std::size_t i) { return templates[i].json; });
              },
              {},
              0});
}

}  // namespace lares::api
