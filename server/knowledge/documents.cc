// Putting documents: read whole, understood, stored, and only then visible.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/aside.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "recipes/skill/skill_template.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/model_description.h"
#include "server/knowledge/named_place.h"
#include "server/knowledge/quarantine.h"
#include "server/knowledge/refusal.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

using nlohmann::json;
using recipes::Resource;
using store::DocumentKind;

json ToJson(const Resource& resource) {
  return {{"iri", resource.iri}, {"label", resource.label}, {"as_written", resource.as_written}};
}

json ToJson(const rdf::Remark& remark) {
  return {{"kind", remark.kind == rdf::Remark::Kind::kRepair ? "repair" : "warning"},
          {"line", remark.place.line},
          {"column", remark.place.column},
          {"message", remark.message}};
}

std::string StemOf(const std::string& file_name) {
  return std::filesystem::path(file_name).filename().stem().string();
}

json ToJson(const recipes::Declared& declared) {
  json value{{"name", declared.name}, {"type", declared.type}, {"optional", declared.optional}};
  if (!declared.unit.empty()) value["unit"] = declared.unit;
  if (!declared.below.iri.empty()) value["below"] = ToJson(declared.below);
  if (!declared.default_text.empty()) value["default"] = declared.default_text;
  return value;
}

void AddNames(const Resource& resource, std::vector<store::DocumentName>& names) {
  names.push_back({resource.iri, "iri", resource.iri});
  if (resource.as_written != resource.iri) {
    names.push_back({resource.as_written, "iri", resource.iri});
  }
  names.push_back({std::string(LocalName(resource.iri)), "local", resource.iri});
  if (resource.label != LocalName(resource.iri)) {
    names.push_back({resource.label, "label", resource.iri});
  }
}

// One document on its way in.
struct Incoming {
  const PutRequest& request;
  std::string source;
  rdf::Document content;
  rdf::Graph graph;
  rdf::View view;  // what it was understood against, itself included
  PutAnswer answer;
  json details = json::object();
  std::vector<store::DocumentName> names;
};

void Refuse(const Incoming& incoming, const std::vector<std::string>& problems) {
  if (problems.empty()) return;
  throw Error(Code::kInvalid, Join(problems, "\n"),
              PlaceOf(problems.front(), incoming.request.bytes, incoming.source));
}

void UnderstandRecipe(prolog::EnginePool& engines, Incoming& incoming) {
  incoming.answer.tasks = recipes::FindTasks(engines, incoming.view, incoming.graph.name);
  if (incoming.answer.tasks.empty()) {
    throw Error(Code::kInvalid, "describes no task: no class has sub-actions or state transitions",
                {incoming.source, 0, 0});
  }
  for (const std::string& each :
       recipes::FindSuspicions(engines, incoming.view, incoming.graph.name)) {
    incoming.answer.remarks.push_back({rdf::Remark::Kind::kWarning,
                                       PlaceOf(each, incoming.request.bytes, incoming.source),
                                       each});
  }
  std::vector<std::string> problems;
  const bool has_top = std::any_of(incoming.answer.tasks.begin(), incoming.answer.tasks.end(),
                                   [](const auto& task) { return task.top_level; });
  for (const recipes::Task& task : incoming.answer.tasks) {
    problems.insert(problems.end(), task.problems.begin(), task.problems.end());
    incoming.answer.warnings.insert(incoming.answer.warnings.end(), task.warnings.begin(),
                                    task.warnings.end());
    AddNames(task.task, incoming.names);
    if (task.top_level || !has_top) {
      incoming.names.push_back({incoming.request.id, "id", task.task.iri});
    }
    json steps = json::array();
    for (const Resource& step : task.steps) steps.push_back(ToJson(step));
    json parameters = json::array();
    for (const recipes::Declared& each : task.parameters) parameters.push_back(ToJson(each));
    incoming.details["tasks"].push_back(
        {{"task", ToJson(task.task)},
         {"top_level", task.top_level},
         {"form", task.state_machine ? "state-machine" : "partial-order"},
         {"steps", steps},
         {"parameters", parameters}});
  }
  Refuse(incoming, problems);
}

void UnderstandRobot(prolog::EnginePool& engines, Incoming& incoming) {
  try {
    incoming.answer.robots = recipes::FindRobots(engines, incoming.view, incoming.graph.name);
  } catch (const Error& error) {
    if (error.code() != Code::kInvalid || error.place()) throw;
    Refuse(incoming, {error.what()});
  }
  if (incoming.answer.robots.empty()) {
    throw Error(Code::kInvalid, "describes no robot: no individual is a Robot or has capabilities",
                {incoming.source, 0, 0});
  }
  for (const Resource& robot : incoming.answer.robots) {
    AddNames(robot, incoming.names);
    incoming.names.push_back({incoming.request.id, "id", robot.iri});
    incoming.details["robots"].push_back(ToJson(robot));
  }
}

json FilesOf(const PutRequest& request) {
  json files = json::array();
  for (const AttachedFile& file : request.files) {
    files.push_back({{"file_name", file.file_name},
                     {"media_type", file.media_type},
                     {"sha256", file.blob.sha256},
                     {"size", file.blob.size}});
  }
  return files;
}

void UnderstandObjectModel(const store::Store& store, const CatalogueState& catalogue,
                           Incoming& incoming) {
  try {
    incoming.details.update(DescribeModels(catalogue, incoming.view, incoming.graph));
  } catch (const Error& error) {
    if (error.code() != Code::kInvalid || error.place()) throw;
    Refuse(incoming, {error.what()});
  }
  for (const json& each : incoming.details["models"]) {
    const Resource model = Describe(incoming.view, each["model"]["iri"].get<std::string>());
    AddNames(model, incoming.names);
    incoming.names.push_back({incoming.request.id, "id", model.iri});
  }
  json files = DescribeModelFiles(store, incoming.request.files);
  if (files.empty()) {
    const auto before = store.FindDocument(DocumentKind::kObjectModel, incoming.request.id);
    if (before) files = json::parse(before->details_json).value("files", json::array());
  }
  const json extents = ExtentsOf(incoming.details, files);
  if (!extents.is_null()) incoming.details["extents"] = extents;
  incoming.details["files"] = files;
}

void UnderstandSkillTemplates(prolog::EnginePool& engines, const std::string& graph,
                              Incoming& incoming) {
  const auto found = recipes::FindTemplates(engines, incoming.view, graph);
  if (found.empty()) {
    throw Error(Code::kInvalid, "describes no skill template: nothing is a SkillTemplate",
                {incoming.source, 0, 0});
  }
  std::vector<std::string> problems;
  for (const recipes::SkillTemplate& each : found) {
    problems.insert(problems.end(), each.problems.begin(), each.problems.end());
    incoming.answer.warnings.insert(incoming.answer.warnings.end(), each.warnings.begin(),
                                    each.warnings.end());
    AddNames(each.iri, incoming.names);
    incoming.names.push_back({incoming.request.id, "id", each.iri.iri});
    incoming.answer.skill_templates.push_back(each.iri);
    incoming.details["skill_templates"].push_back(ToJson(each.iri));
  }
  Refuse(incoming, problems);
}

store::DocumentInfo Store(store::Store& store, const Incoming& incoming) {
  const PutRequest& request = incoming.request;
  store::NewDocument document;
  document.kind = request.kind;
  document.id = request.id;
  document.media_type = request.media_type;
  document.file_name = request.file_name;
  document.bytes = request.bytes;
  json details = incoming.details;
  if (request.editor) details["editor"] = true;
  document.details_json = details.dump();
  document.names = incoming.names;
  document.if_match = request.if_match;
  return store.PutDocument(document);
}

// Documents that all questions are asked over; the others lie above the catalogue when asked for.
bool IsOfTheCatalogue(DocumentKind kind) {
  return kind == DocumentKind::kOntology || kind == DocumentKind::kSkillTemplate;
}

// Contradictions of the whole catalogue.
std::size_t ClashCount(const CatalogueState& catalogue) {
  std::size_t count = 0;
  for (const auto& layer : catalogue.view.layers()) count += layer->clash_count();
  return count;
}

PutAnswer RefuseOrKeepAside(store::Store& store, Incoming& incoming,
                            const Contradiction& contradiction) {
  if (!incoming.request.quarantine) throw ToRefusal(contradiction, incoming.source);
  incoming.answer.quarantined = contradiction.message;
  incoming.answer.document = KeepAside(store, incoming.request, contradiction.message);
  return incoming.answer;
}

PutAnswer PutPrior(store::Store& store, const rdf::AliasTable& aliases, const PutRequest& request) {
  const bool omics = request.prior_format == "omics";
  if (!omics && request.prior_format != "tsv") {
    throw Error(Code::kUnsupported,
                "'" + request.prior_format + "' is no format of a prior: it is omics or tsv");
  }
  const places::PriorTable table = places::ReadPrior(
      request.bytes, omics ? places::PriorFormat::kOmics : places::PriorFormat::kTsv, request.id,
      aliases);
  std::set<std::string> objects;
  std::set<std::string> spots;
  double count = 0;
  for (const places::PriorRow& row : table.rows) {
    objects.insert(row.object);
    spots.insert(row.place);
    count += row.count;
  }
  Incoming incoming{request, request.file_name, {}, {}, rdf::View(nullptr), {}, {}, {}};
  incoming.details = {{"title", table.title},      {"format", request.prior_format},
                      {"rows", table.rows.size()}, {"objects", objects.size()},
                      {"places", spots.size()},    {"count", count}};
  incoming.answer.document = Store(store, incoming);
  incoming.answer.statements = table.rows.size();
  return incoming.answer;
}

}  // namespace

std::vector<std::string> AbsentImports(const rdf::Document& document,
                                       const std::vector<Knowledge::Module>& modules,
                                       const rdf::AliasTable& aliases) {
  std::vector<std::string> warnings;
  for (const std::string& import : document.imports) {
    std::string_view name = import;
    while (!name.empty() && (name.back() == '#' || name.back() == '/')) name.remove_suffix(1);
    const std::string file(name.substr(name.find_last_of('/') + 1));
    const std::string stem = StemOf(file);
    const bool is_module = std::any_of(modules.begin(), modules.end(),
                                       [&](const auto& module) { return module.id == stem; });
    const bool is_aliased =
        std::any_of(aliases.aliases().begin(), aliases.aliases().end(), [&](const auto& alias) {
          return alias.is_namespace && alias.alias.ends_with("/" + file + "#");
        });
    if (!is_module && !is_aliased) {
      warnings.push_back("imports <" + import +
                         ">, which is not in the local catalogue; nothing is fetched");
    }
  }
  return warnings;
}

PutAnswer Knowledge::Put(const PutRequest& original) {
  PutRequest request = original;
  if (request.id.empty()) request.id = StemOf(request.file_name);
  if (!IsIdentifier(request.id)) {
    throw Error(Code::kInvalid, "'" + request.id +
                                    "' cannot be an id: letters, digits, '.', '_' "
                                    "and '-', at most 128, not beginning with '.' or '-'");
  }
  if (request.file_name.empty()) request.file_name = request.id;
  if (request.kind == DocumentKind::kPrior) {
    return PutPrior(state_->store, state_->aliases, request);
  }
  const rdf::Format format = rdf::GuessFormat(request.media_type, request.file_name, request.bytes);
  request.media_type = rdf::MediaType(format);
  rdf::ReadOptions options =
      OptionsFor(GraphName(request.kind, request.id), request.file_name, state_->aliases);
  options.recover = request.recover;
  Incoming incoming{request,
                    request.file_name,
                    rdf::ReadRdf(request.bytes, format, options),
                    {},
                    rdf::View(state_->dictionary),
                    {},
                    json::object(),
                    {}};
  incoming.graph = rdf::MakeGraph(incoming.content, GraphName(request.kind, request.id),
                                  state_->aliases, *state_->dictionary);
  incoming.answer.remarks = incoming.content.remarks;
  incoming.answer.statements = incoming.graph.triples.size();

  if (IsOfTheCatalogue(request.kind)) {
    PutAnswer answer = PutOntology(request, incoming.graph, incoming.content);
    if (request.kind == DocumentKind::kSkillTemplate) state_->overlays.Wait();
    return answer;
  }

  const auto base = state_->catalogue();
  if (!request.editor) {
    authority::JudgeOptions judge;
    if (request.kind == DocumentKind::kObjectModel) {
      judge.described = authority::ModelledClasses(incoming.graph, *state_->dictionary);
    }
    state_->CheckAuthority(*base, incoming.graph, {request.bytes, incoming.source}, judge);
  }
  rdf::View below = base->view;
  if (request.kind == DocumentKind::kRecipe) {
    std::vector<OverlaySource> nested;
    for (const store::DocumentInfo& each : state_->NestedIn(incoming.graph, request.id)) {
      nested.push_back(state_->SourceOf(GraphName(each.kind, each.id), each));
      incoming.details["nests"].push_back(each.id);
    }
    below = state_->overlays.Get({base->view, base->generation}, nested, nullptr).view;
  }
  incoming.view = below.With(Aside([&] { return owl::Materialise(below, {incoming.graph}); }));
  const auto& layer = *incoming.view.layers().back();
  incoming.answer.inferred = CountInferred(layer);
  incoming.answer.warnings = AbsentImports(incoming.content, base->modules, state_->aliases);
  for (std::string& clash : DescribeClashes(incoming.view)) {
    incoming.answer.warnings.push_back(std::move(clash));
  }
  if (const auto found = state_->Convict(*base, incoming.view, incoming.graph)) {
    return RefuseOrKeepAside(state_->store, incoming, *found);
  }
  switch (request.kind) {
    case DocumentKind::kRecipe:
      UnderstandRecipe(state_->engines, incoming);
      break;
    case DocumentKind::kRobot:
      UnderstandRobot(state_->engines, incoming);
      if (!request.files.empty()) incoming.details["files"] = FilesOf(request);
      break;
    default:
      UnderstandObjectModel(state_->store, *base, incoming);
      break;
  }
  incoming.details["statements"] = incoming.answer.statements;
  for (const rdf::Remark& remark : incoming.answer.remarks) {
    incoming.details["remarks"].push_back(ToJson(remark));
  }
  if (!incoming.answer.warnings.empty()) incoming.details["warnings"] = incoming.answer.warnings;
  incoming.answer.document = Store(state_->store, incoming);
  ForgetKeptAside(state_->store, request.kind, request.id);
  state_->changes.Notify();
  return incoming.answer;
}

PutAnswer Knowledge::PutOntology(const PutRequest& request, const rdf::Graph& graph,
                                 const rdf::Document& content) {
  const std::lock_guard lock(state_->ontology_mutex);
  const std::unique_ptr<store::Hold> among_servers = state_->store.HoldCatalogue();
  state_->TakeOverCatalogue();
  std::map<std::string, rdf::Graph> next = state_->stored_graphs;
  next[graph.name] = graph;
  std::vector<rdf::Graph> stored;
  for (const auto& [id, other] : next) stored.push_back(other);
  const auto before = state_->catalogue();
  const authority::Claim claim =
      authority::MakeClaim(content, graph, state_->aliases, *state_->dictionary);
  if (!request.editor) {
    const authority::Owners owners = state_->authority.OwnersWith(graph.name, claim);
    RefuseTrespasses(before->view, graph, authority::FindTrespasses(before->view, graph, owners),
                     {request.bytes, request.file_name});
  }
  auto catalogue = MakeCatalogue(state_->own, stored, before->generation + 1, before.get());
  Incoming incoming{request, request.file_name, {}, {}, catalogue->view, {}, json::object(), {}};
  incoming.answer.remarks = content.remarks;
  incoming.answer.statements = graph.triples.size();
  if (ClashCount(*catalogue) > ClashCount(*before)) {
    return RefuseOrKeepAside(state_->store, incoming, *FindContradiction(catalogue->view));
  }
  const auto& layer = *catalogue->view.layers().back();
  incoming.answer.inferred = CountInferred(layer);
  incoming.answer.warnings = AbsentImports(content, catalogue->modules, state_->aliases);
  for (std::string& clash : DescribeClashes(catalogue->view)) {
    incoming.answer.warnings.push_back(std::move(clash));
  }
  if (request.kind == DocumentKind::kSkillTemplate) {
    UnderstandSkillTemplates(state_->engines, graph.name, incoming);
  }
  incoming.details["statements"] = incoming.answer.statements;
  incoming.answer.document = Store(state_->store, incoming);
  ForgetKeptAside(state_->store, request.kind, request.id);
  state_->taken_over[graph.name] = incoming.answer.document.version;
  state_->authority.Put(graph.name, claim, incoming.answer.document.received, request.editor);
  state_->stored_graphs = std::move(next);
  state_->Publish(std::move(catalogue));
  state_->changes.Notify();
  return incoming.answer;
}

void Knowledge::Remove(DocumentKind kind, const std::string& id) {
  if (!IsOfTheCatalogue(kind)) {
    state_->store.DeleteDocument(kind, id);
    state_->changes.Notify();
    return;
  }
  RemoveFromCatalogue(kind, id);
  state_->changes.Notify();
  if (kind == DocumentKind::kSkillTemplate) state_->overlays.Wait();
}

void Knowledge::RemoveFromCatalogue(DocumentKind kind, const std::string& id) {
  const std::lock_guard lock(state_->ontology_mutex);
  const std::unique_ptr<store::Hold> among_servers = state_->store.HoldCatalogue();
  state_->TakeOverCatalogue();
  state_->store.DeleteDocument(kind, id);
  const std::string graph_name = GraphName(kind, id);
  state_->taken_over.erase(graph_name);
  state_->stored_graphs.erase(graph_name);
  state_->authority.Remove(graph_name);
  std::vector<rdf::Graph> stored;
  for (const auto& [other_id, graph] : state_->stored_graphs) stored.push_back(graph);
  const auto before = state_->catalogue();
  state_->Publish(MakeCatalogue(state_->own, stored, before->generation + 1, before.get()));
}

PutAnswer Knowledge::Release(const std::string& quarantine_id, bool editor) {
  PutRequest request = KeptAside(state_->store, quarantine_id);
  request.editor = request.editor || editor;
  return Put(request);
}

}  // namespace lares::server
