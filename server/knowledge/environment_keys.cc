#include "server/knowledge/environment_keys.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "mapping/semantic/place_facts.h"
#include "ontology/rdf/vocabulary.h"
#include "server/knowledge/derived.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

constexpr std::size_t kMaxValueBytes = 1000;  // longer ones are nothing to search for

void Add(const std::string& field, const std::vector<std::string>& values,
         std::vector<store::SearchKey>& keys) {
  for (const std::string& value : values) {
    if (!value.empty() && value.size() <= kMaxValueBytes && IsUtf8(value) &&
        value.find('\0') == std::string::npos) {
      keys.push_back({field, value});
    }
  }
}

bool HasSemantic(const std::vector<store::LayerInfo>& layers) {
  return std::any_of(layers.begin(), layers.end(),
                     [](const store::LayerInfo& layer) { return layer.name == "semantic"; });
}

// The class and whatever environments have that is a kind of it.
std::vector<std::string> KindsOf(const rdf::View& view, const std::string& class_iri,
                                 const std::vector<std::string>& known) {
  const rdf::TermId sub_class = view.dictionary().InternIri(std::string(rdf::kRdfs) + "subClassOf");
  const auto of = view.dictionary().FindIri(class_iri);
  std::vector<std::string> kinds{class_iri};
  if (!of) return kinds;
  for (const std::string& value : known) {
    const auto term = view.dictionary().FindIri(value);
    if (term && value != class_iri && view.Contains({*term, sub_class, *of})) {
      kinds.push_back(value);
    }
  }
  return kinds;
}

void AddText(const std::string& field, const std::string& value,
             std::vector<store::SearchCondition>& conditions) {
  if (!value.empty()) conditions.push_back({field, {value}, false});
}

// Word by word, split as the store splits what it keeps.
void AddWords(const std::string& text, std::vector<store::SearchCondition>& conditions) {
  std::string word;
  const auto end = [&](bool prefix) {
    if (!word.empty()) conditions.push_back({"word", {word}, prefix});
    word.clear();
  };
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0) {
      word += c;
    } else {
      end(c == '*');
    }
  }
  end(false);
}

}  // namespace

std::vector<store::SearchKey> KeysOf(const rdf::View& view,
                                     const std::vector<semantic::MapObject>& objects) {
  const semantic::PlaceFacts facts = semantic::ReadPlaceFacts(view, objects);
  std::vector<store::SearchKey> keys;
  Add("room-number", facts.room_numbers, keys);
  Add("street", facts.streets, keys);
  Add("street", facts.cities, keys);
  Add("building", facts.buildings, keys);
  Add("level", facts.levels, keys);
  Add("type", facts.place_classes, keys);
  Add("holds", facts.held_classes, keys);
  return keys;
}

std::vector<store::SearchKey> Knowledge::State::KeysOfVersion(
    const store::EnvironmentVersion& version) {
  if (!HasSemantic(version.layers)) return {};
  const rdf::View view = WithoutDerived(ViewOf({nullptr, nullptr, &version}));
  return KeysOf(view, semantic::ReadMapObjects(view));
}

std::optional<std::vector<store::SearchKey>> Knowledge::State::KeysOfCarried(
    const store::NewVersion& version) {
  const auto& removed = version.removed_layers;
  if (std::find(removed.begin(), removed.end(), "semantic") != removed.end()) {
    return std::vector<store::SearchKey>{};
  }
  if (version.restored == 0) return std::nullopt;
  return KeysOfVersion(store.GetVersion(version.environment, version.restored));
}

std::vector<store::EnvironmentInfo> Knowledge::SearchEnvironments(const EnvironmentQuery& query) {
  store::EnvironmentSearch search;
  std::vector<store::SearchCondition>& all = search.all_of;
  AddText("room-number", query.room_number, all);
  AddText("street", query.street, all);
  AddText("building", query.building, all);
  AddText("level", query.level, all);
  const rdf::View catalogue = Catalogue();
  const auto add_class = [&](const std::string& field, const std::string& name) {
    all.push_back({field,
                   KindsOf(catalogue, ResolveClass(name).iri, state_->store.SearchValues(field)),
                   false});
  };
  if (!query.type.empty()) add_class("type", query.type);
  for (const std::string& name : query.holds) add_class("holds", name);
  for (const std::string& layer : query.layers) all.push_back({"layer", {layer}, false});
  AddWords(query.text, all);
  search.changed_from = query.changed_from;
  search.changed_until = query.changed_until;
  search.after = query.after;
  search.limit = query.limit;
  return state_->store.SearchEnvironments(search);
}

void Knowledge::IndexEnvironments() {
  for (const std::string& id : state_->store.EnvironmentsWithoutKeys()) {
    try {
      const store::EnvironmentVersion head = state_->store.GetVersion(id, 0);
      state_->store.PutKeys(id, head.number, state_->KeysOfVersion(head));
    } catch (const Error& error) {
      if (error.code() == Code::kUnavailable) throw;
    }
  }
}

}  // namespace lares::server
