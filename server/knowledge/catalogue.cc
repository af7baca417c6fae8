#include "server/knowledge/catalogue.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/file.h"
#include "base/search_path.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"

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

std::shared_ptr<const CatalogueState> MakeCatalogue(
    const std::shared_ptr<rdf::Dictionary>& dictionary, const std::vector<rdf::Graph>& own,
    const std::vector<rdf::Graph>& stored, std::uint64_t generation) {
  auto catalogue =
      std::make_shared<CatalogueState>(CatalogueState{rdf::View(dictionary), generation, {}, {}});
  std::vector<rdf::Graph> graphs;
  for (const auto& [origin, group] : {std::pair{"built-in", &own}, std::pair{"stored", &stored}}) {
    for (const rdf::Graph& graph : *group) {
      catalogue->modules.push_back(
          {graph.name.substr(graph.name.find(':') + 1), origin, graph.triples.size()});
      graphs.push_back(graph);
    }
  }
  const rdf::View empty(dictionary);
  catalogue->view = empty.With(owl::Materialise(empty, std::move(graphs)));
  IndexClasses(*catalogue);
  return catalogue;
}

recipes::Resource Describe(const rdf::View& view, rdf::TermId term) {
  return {std::string(view.dictionary().Get(term).value), view.Label(term), view.AsWritten(term)};
}

recipes::Resource Describe(const rdf::View& view, std::string_view iri) {
  if (const auto term = view.dictionary().FindIri(iri)) return Describe(view, *term);
  return {std::string(iri), std::string(LocalName(iri)), std::string(iri)};
}

std::vector<std::string> DescribeClashes(const rdf::View& view, std::size_t limit) {
  std::vector<std::string> sentences;
  if (view.layers().empty()) return sentences;
  std::set<std::string> seen;
  const std::vector<rdf::Clash>& clashes = view.layers().back()->clashes();
  for (const rdf::Clash& clash : clashes) {
    std::string sentence = "contradiction (" + clash.rule + "):";
    for (const rdf::Triple& premise : clash.premises) {
      sentence += " " + view.Label(premise.subject) + " " + view.Label(premise.predicate) + " " +
                  view.Label(premise.object) + ";";
    }
    if (sentence.ends_with(';')) sentence.pop_back();
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
