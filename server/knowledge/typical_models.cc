// load-typical-object-models: the choice among the stored models, with names.
#include <map>
#include <utility>

#include "base/error.h"
#include "server/knowledge/object_models.h"
#include "server/knowledge/state.h"

namespace lares::server {

TypicalAnswer Knowledge::TypicalModels(const TypicalRequest& request) {
  TypicalAnswer answer;
  answer.prior = request.prior.empty() ? "lares" : request.prior;
  const auto tables = FindPrior(answer.prior);
  answer.prior_title = tables->title;
  const auto catalogue = state_->catalogue();
  answer.room = ResolveClass(request.room);
  const auto room = catalogue->view.dictionary().FindIri(answer.room.iri);
  if (!room || !IsPlace(*catalogue, *room)) {
    throw Error(Code::kInvalid, "'" + answer.room.label + "' is no kind of place")
        .WithHint("a room is a class of places, such as Kitchen or HospitalRoom");
  }
  models::TypicalOptions options;
  options.room_iri = answer.room.iri;
  options.strict = request.strict;
  options.max_models = request.max_models;
  options.max_bytes = request.max_bytes;
  if (request.min_probability) options.min_probability = *request.min_probability;
  rdf::View view = catalogue->view;
  if (!request.robot.empty()) {
    const Resolved robot = Resolve(store::DocumentKind::kRobot, request.robot);
    options.robot_iri = robot.target_iri;
    view = state_->ViewOf({&robot.document, nullptr, nullptr});
    answer.robot = Describe(view, robot.target_iri);
  }

  std::map<std::string, ObjectModelInfo> stored;
  std::vector<models::Candidate> candidates;
  for (ObjectModelInfo& info : StoredObjectModels(state_->store)) {
    candidates.push_back(ToCandidate(info));
    stored.emplace(info.document.id, std::move(info));
  }
  models::TypicalChoice choice =
      models::ChooseTypical(state_->engines, view, tables->rooms, candidates, options);
  for (const std::string& place : choice.places) answer.places.push_back(Describe(view, place));
  answer.places_above = choice.places_above;
  answer.size_bytes = choice.size_bytes;
  const auto named = [&](std::vector<models::Choice>& chosen) {
    std::vector<TypicalAnswer::Model> named_ones;
    for (models::Choice& one : chosen) {
      auto& info = stored.at(one.id);
      recipes::Resource of;
      for (const auto& kind : info.classes) {
        if (kind.iri == one.class_iri) of = kind;
      }
      named_ones.push_back({std::move(info), of, std::move(one)});
    }
    return named_ones;
  };
  answer.loaded = named(choice.loaded);
  answer.left_out = named(choice.left_out);
  return answer;
}

}  // namespace lares::server
