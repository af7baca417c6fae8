// The catalogue out of the store: at start, and when another server of the store changed it.
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {

void Knowledge::State::Restore(const std::string& id) {
  const std::unique_lock lock(catalogue_mutex);
  std::erase_if(set_aside, [&](const Module& module) { return module.id == id; });
}

void Knowledge::State::SetAside(const std::string& id, const Error& error) {
  Restore(id);
  const std::unique_lock lock(catalogue_mutex);
  set_aside.push_back({id, "set aside: " + error.FullMessage(), 0});
}

bool Knowledge::State::TakeOverCatalogue() {
  std::vector<store::DocumentInfo> documents = store.ListDocuments(store::DocumentKind::kOntology);
  for (store::DocumentInfo& skills : store.ListDocuments(store::DocumentKind::kSkillTemplate)) {
    documents.push_back(std::move(skills));
  }
  bool changed = false;
  std::set<std::string> present;
  for (const store::DocumentInfo& document : documents) {
    const std::string name = GraphName(document.kind, document.id);
    present.insert(name);
    if (taken_over[name] == document.version) continue;
    taken_over[name] = document.version;
    changed = true;
    try {
      const rdf::Document content =
          ReadStored(store, aliases, name, document.blob, document.media_type, document.file_name);
      rdf::Graph graph = rdf::MakeGraph(content, name, aliases, *dictionary);
      authority.Put(name, authority::MakeClaim(content, graph, aliases, *dictionary),
                    store.DocumentLog(document.kind, document.id).back().received,
                    nlohmann::json::parse(document.details_json).value("editor", false));
      stored_graphs[name] = std::move(graph);
      Restore(document.id);
    } catch (const Error& error) {
      // One document that cannot be read any more must not keep all others from being served.
      stored_graphs.erase(name);
      SetAside(document.id, error);
    }
  }
  for (auto it = taken_over.begin(); it != taken_over.end();) {
    if (present.count(it->first) > 0) {
      ++it;
      continue;
    }
    changed = true;
    stored_graphs.erase(it->first);
    authority.Remove(it->first);
    it = taken_over.erase(it);
  }
  const std::shared_ptr<const CatalogueState> before = catalogue();
  if (!changed && before != nullptr) return false;
  std::vector<rdf::Graph> stored;
  for (const auto& [name, graph] : stored_graphs) stored.push_back(graph);
  Publish(MakeCatalogue(own, stored, before == nullptr ? 1 : before->generation + 1, before.get()));
  return true;
}

bool Knowledge::Refresh() {
  bool changed = false;
  {
    const std::lock_guard lock(state_->ontology_mutex);
    changed = state_->TakeOverCatalogue();
  }
  if (changed) state_->changes.Notify();
  return changed;
}

}  // namespace lares::server
