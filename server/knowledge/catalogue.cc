#include "server/knowledge/catalogue.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/aside.h"
#include "base/file.h"
#include "base/search_path.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/owl/update.h"

namespace lares::server {
namespace {

rdf::TermId Iri(const rdf::View& view, std::string_view space, std::string_view local) {
  return view.dictionary().InternIri(std::string(space) + std::string(local));
}

void IndexClasses(CatalogueState& catalogue) {
  const rdf::View& view = catalogue.view;
  const rdf::TermId label = Iri(view, rdf::kRdfs, "label");
  const auto add = [&](std::string_view name, rdf::TermId term) {
    std::vector<rdf::TermId>& terms = catalogue.classes_by_name[ToLower(name)];
    if (std::find(terms.begin(), terms.end(), term) == terms.end()) terms.push_back(term);
  };
  for (const rdf::TermId term :
       view.Subjects(Iri(view, rdf::kRdf, "type"), Iri(view, rdf::kOwl, "Class"))) {
    const rdf::TermView name = view.dictionary().Get(term);
    if (name.kind != rdf::TermKind::kIri) continue;
    add(LocalName(name.value), term);
    for (const rdf::TermId text : view.Objects(term, label)) {
      add(view.dictionary().Get(text).value, term);
    }
  }
}

}  // namespace

std::vector<rdf::Graph> LoadOwnModules(const rdf::AliasTable& aliases,
                                       rdf::Dictionary& dictionary) {
  std::vector<rdf::Graph> graphs;
  for (const char* folder : {"ontology", "recipes/skills"}) {
    for (const std::filesystem::path& file : ListShared(folder, ".ttl")) {
      rdf::ReadOptions options;
      options.source = file.filename().string();
      const rdf::Document document = rdf::ReadRdf(ReadFile(file), rdf::Format::kTurtle, options);
      graphs.push_back(
          rdf::MakeGraph(document, "module:" + file.stem().string(), aliases, dictionary));
    }
  }
  return graphs;
}

rdf::View CloseOwnModules(const std::shared_ptr<rdf::Dictionary>& dictionary,
                          std::vector<rdf::Graph> own) {
  const rdf::View empty(dictionary);
  return empty.With(owl::Materialise(empty, std::move(own)));
}

std::shared_ptr<const CatalogueState> MakeCatalogue(const rdf::View& own,
                                                    const std::vector<rdf::Graph>& stored,
                                                    std::uint64_t generation,
                                                    const CatalogueState* before) {
  auto catalogue = std::make_shared<CatalogueState>(CatalogueState{own, generation, 0, {}, {}});
  const bool is_kept_up = before != nullptr && before->view.layers().size() > own.layers().size();
  if (!stored.empty()) {
    catalogue->view = own.With(Aside([&] {
      return is_kept_up ? owl::Update(own, *before->view.layers().back(), stored)
                        : owl::Materialise(own, stored);
    }));
  }
  for (const auto& layer : catalogue->view.layers()) {
    catalogue->inferred += CountInferred(*layer);
    const bool is_own = layer == own.layers().front();
    for (const rdf::Graph& graph : layer->graphs()) {
      if (graph.name.starts_with("skill-template:")) continue;
      catalogue->modules.push_back({graph.name.substr(graph.name.find(':') + 1),
                                    is_own ? "built-in" : "stored", graph.triples.size()});
    }
  }
  IndexClasses(*catalogue);
  return catalogue;
}

std::size_t CountInferred(const rdf::Layer& layer) {
  const std::span<const rdf::Triple> all = layer.Range({});
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(),
                    [&](const rdf::Triple& triple) { return !layer.IsAsserted(triple); }));
}

bool IsPlace(const CatalogueState& catalogue, rdf::TermId kind) {
  const rdf::View& all = catalogue.view;
  const rdf::TermId sub_class = Iri(all, rdf::kRdfs, "subClassOf");
  const rdf::TermId place = Iri(all, rdf::kLares, "Place");
  if (kind == place) return true;
  const rdf::Layer& own = *all.layers().front();
  const bool own_knows = !own.Range({kind, sub_class, {}}).empty();
  return own_knows ? own.Contains({kind, sub_class, place})
                   : all.Contains({kind, sub_class, place});
}

recipes::Resource Describe(const rdf::View& view, rdf::TermId term) {
  return {std::string(view.dictionary().Get(term).value), view.Label(term), view.AsWritten(term)};
}

recipes::Resource Describe(const rdf::View& view, std::string_view iri) {
  if (const auto term = view.dictionary().FindIri(iri)) return Describe(view, *term);
  return {std::string(iri), std::string(LocalName(iri)), std::string(iri)};
}

namespace {

// "left_arm is ArmComponent and ManipulationEntity, which exclude each other", where two types of
// one thing clash; the premises one by one otherwise.
std::string DescribeClash(const rdf::View& view, const rdf::Clash& clash) {
  const rdf::TermId type = Iri(view, rdf::kRdf, "type");
  std::vector<rdf::Triple> types;
  std::string premises;
  for (const rdf::Triple& premise : clash.premises) {
    const bool is_schema = view.dictionary().Get(premise.object).value.starts_with(rdf::kOwl);
    if (premise.predicate == type && !is_schema) types.push_back(premise);
    premises += (premises.empty() ? " " : "; ") + view.Label(premise.subject) + " " +
                view.Label(premise.predicate) + " " + view.Label(premise.object);
  }
  if (types.size() == 2 && types[0].subject == types[1].subject) {
    return "contradiction (" + clash.rule + "): " + Describe(view, types[0].subject).label +
           " is " + view.Label(types[0].object) + " and " + view.Label(types[1].object) +
           ", which exclude each other";
  }
  return "contradiction (" + clash.rule + "):" + premises;
}

}  // namespace

std::vector<std::string> DescribeClashes(const rdf::View& view, std::size_t limit) {
  std::vector<std::string> sentences;
  if (view.layers().empty()) return sentences;
  std::set<std::string> seen;
  const std::vector<rdf::Clash>& clashes = view.layers().back()->clashes();
  for (const rdf::Clash& clash : clashes) {
    std::string sentence = DescribeClash(view, clash);
    if (!seen.insert(sentence).second) continue;
    if (sentences.size() == limit) {
      sentences.push_back("and further contradictions, " + std::to_string(clashes.size()) +
                          " in all");
      break;
    }
    sentences.push_back(std::move(sentence));
  }
  return sentences;
}

}  // namespace lares::server
