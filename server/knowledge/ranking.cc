// Every stored robot against one task.
#include "server/knowledge/ranking.h"

#include <algorithm>
#include <utility>

#include "base/aside.h"
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/offers.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

using store::DocumentKind;

std::string KeyOf(const CatalogueState& catalogue, const std::string& source_key,
                  const std::string& target) {
  return source_key + "|" + target + "|" + std::to_string(catalogue.generation);
}

// The documents over exactly this catalogue; not among the overlays, where a hundred robots would
// push out all others.
rdf::View ViewOver(const CatalogueState& catalogue, const std::vector<OverlaySource>& sources) {
  rdf::View view = catalogue.view;
  for (const OverlaySource& source : sources) {
    const rdf::Graph graph = source.read();
    view = view.With(Aside([&] { return owl::Materialise(view, {graph}); }));
  }
  return view;
}

}  // namespace

std::shared_ptr<const recipes::Needs> Knowledge::State::NeedsOf(
    const std::shared_ptr<const CatalogueState>& base, const store::DocumentInfo& recipe,
    const std::string& task_iri) {
  std::vector<OverlaySource> sources;
  for (const store::DocumentInfo& nested : NestedIn(recipe)) {
    sources.push_back(SourceOf(GraphName(nested.kind, nested.id), nested));
  }
  sources.push_back(SourceOf(GraphName(recipe.kind, recipe.id), recipe));
  std::string key;
  for (const OverlaySource& source : sources) key += source.key + "|";
  return match_memory.needs.Get(KeyOf(*base, key, task_iri), [&] {
    return recipes::FindNeeds(engines, ViewOver(*base, sources), task_iri);
  });
}

std::shared_ptr<const recipes::RobotProfile> Knowledge::State::ProfileOf(
    const std::shared_ptr<const CatalogueState>& base, const store::DocumentInfo& robot,
    const std::string& robot_iri) {
  const OverlaySource source = SourceOf(GraphName(robot.kind, robot.id), robot);
  return match_memory.profiles.Get(KeyOf(*base, source.key, robot_iri), [&] {
    return recipes::DescribeRobot(engines, ViewOver(*base, {source}), robot_iri);
  });
}

std::vector<recipes::Offer> Knowledge::State::OffersFor(
    const store::DocumentInfo& recipe, const std::string& task_iri,
    const store::EnvironmentVersion* environment,
    const std::vector<recipes::Resource>& also_sought) {
  const auto base = catalogue();
  std::vector<recipes::Resource> sought = NeedsOf(base, recipe, task_iri)->sought;
  sought.insert(sought.end(), also_sought.begin(), also_sought.end());
  std::vector<recipes::Offer> offers = ModelOffers(store, base->view, sought);
  if (environment == nullptr) return offers;
  std::vector<recipes::Offer> maps = MapOffers(*environment);
  std::move(maps.begin(), maps.end(), std::back_inserter(offers));
  return offers;
}

std::vector<recipes::Resource> Knowledge::ObjectsAskedFor(const PlanRequest& request) {
  const auto catalogue = state_->catalogue();
  const rdf::View& view = catalogue->view;
  const rdf::Dictionary& dictionary = view.dictionary();
  const auto sub_class = dictionary.FindIri(std::string(rdf::kRdfs) + "subClassOf");
  const auto object = dictionary.FindIri(std::string(rdf::kLares) + "PhysicalObject");
  std::vector<recipes::Resource> classes;
  if (!sub_class || !object) return classes;
  for (const auto& [name, value] : request.set) {
    // No class, or one of several: planning says so where it matters.
    auto term = dictionary.FindIri(state_->aliases.Canonical(value));
    const auto named = catalogue->classes_by_name.find(ToLower(value));
    if (named != catalogue->classes_by_name.end() && named->second.size() == 1) {
      term = named->second.front();
    }
    if (term && view.Contains({*term, *sub_class, *object})) {
      classes.push_back(Describe(view, *term));
    }
  }
  return classes;
}

recipes::MatchReport Knowledge::MatchTask(const PlanRequest& request) {
  const Resolved recipe = Resolve(DocumentKind::kRecipe, request.task);
  const Resolved robot = Resolve(DocumentKind::kRobot, request.robot);
  for (const Resolved* one : {&recipe, &robot}) {
    if (!one->target_iri.empty()) continue;
    throw Error(Code::kNotFound, "'" + one->document.id + "' describes nothing to use");
  }
  std::optional<store::EnvironmentVersion> environment;
  if (!request.environment.empty()) {
    environment = state_->store.GetVersion(request.environment, request.environment_version);
  }
  const auto base = state_->catalogue();
  recipes::MatchOptions options;
  options.strict = request.strict;
  options.offers =
      state_->OffersFor(recipe.document, recipe.target_iri, environment ? &*environment : nullptr,
                        ObjectsAskedFor(request));
  return recipes::Match(*state_->NeedsOf(base, recipe.document, recipe.target_iri),
                        *state_->ProfileOf(base, robot.document, robot.target_iri), options);
}

RobotsAnswer Knowledge::RankRobots(const RobotsRequest& request) {
  const Resolved recipe = Resolve(DocumentKind::kRecipe, request.task);
  if (recipe.target_iri.empty()) {
    throw Error(Code::kNotFound, "'" + recipe.document.id + "' describes nothing to use");
  }
  std::optional<store::EnvironmentVersion> environment;
  if (!request.environment.empty()) {
    environment = state_->store.GetVersion(request.environment, request.environment_version);
  }
  recipes::MatchOptions options;
  options.strict = request.strict;
  options.offers =
      state_->OffersFor(recipe.document, recipe.target_iri, environment ? &*environment : nullptr);
  const auto base = state_->catalogue();
  const auto needs = state_->NeedsOf(base, recipe.document, recipe.target_iri);
  RobotsAnswer answer;
  answer.task = needs->task;
  for (const store::DocumentInfo& document : state_->store.ListDocuments(DocumentKind::kRobot)) {
    for (const store::DocumentName& name : document.names) {
      if (name.kind != "id") continue;
      const auto profile = state_->ProfileOf(base, document, name.target);
      answer.robots.push_back({document.id, recipes::Rank(*needs, *profile, options)});
    }
  }
  std::sort(answer.robots.begin(), answer.robots.end(),
            [](const auto& a, const auto& b) { return recipes::RanksBefore(a.ranked, b.ranked); });
  return answer;
}

}  // namespace lares::server
