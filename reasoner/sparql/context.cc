#include "reasoner/sparql/context.h"

#include <chrono>

#include "base/text.h"
#include "reasoner/sparql/operator.h"

namespace lares::sparql {
namespace {

const NamedGraph& Find(const Dataset& dataset, const std::string& iri) {
  for (const NamedGraph& graph : dataset.named) {
    if (graph.iri == iri) return graph;
  }
  std::vector<std::string> known;
  for (const NamedGraph& graph : dataset.named) known.push_back(graph.iri);
  throw Error(Code::kNotFound, "FROM names a graph that is not here: <" + iri + ">")
      .WithCandidates(SimilarNames(iri, known));
}

std::uint64_t Seed() {
  std::random_device device;
  return std::uint64_t{device()} << 32 | device();
}

}  // namespace

Context::Context(const syntax::Query& asked, const Dataset& of, const Limits& limits,
                 std::stop_token stop)
    : query(asked),
      dataset(of),
      account(limits.max_memory_bytes),
      guard(limits.timeout, std::move(stop)),
      terms(of.default_graph.dictionary(), account),
      base_row(asked.columns.size()),
      random(Seed()) {
  constants.reserve(query.terms.size());
  constant_values.reserve(query.terms.size());
  for (const rdf::Term& term : query.terms) {
    constants.push_back(terms.Intern(term.view()));
    constant_values.push_back(ValueOf(term.view(), constants.back()));
  }
  terms.Keep();
  using namespace std::chrono;
  now = DateTimeText(duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count());
  OpenGraphs();
}

Context::~Context() = default;

void Context::OpenGraphs() {
  const bool has_clauses = !query.from.empty() || !query.from_named.empty();
  if (has_clauses) {
    std::vector<std::span<const rdf::Triple>> lists;
    for (const std::string& iri : query.from) lists.push_back(Find(dataset, iri).triples);
    sources.push_back(std::make_unique<ListSource>(lists, account));
  } else {
    sources.push_back(std::make_unique<ViewSource>(dataset.default_graph));
  }
  default_graph = sources.back().get();
  const auto open = [&](const NamedGraph& graph) {
    sources.push_back(std::make_unique<ListSource>(graph.triples, account));
    named.push_back({terms.Intern({rdf::TermKind::kIri, graph.iri, {}, {}}), sources.back().get()});
  };
  if (has_clauses) {
    for (const std::string& iri : query.from_named) open(Find(dataset, iri));
  } else if (query.uses_graphs) {
    for (const NamedGraph& graph : dataset.named) open(graph);
  }
  terms.Keep();
}

const Regex* Context::RegexOf(std::string_view pattern, std::string_view flags) {
  constexpr std::size_t kMostKept = 64;
  std::pair<std::string, std::string> key(pattern, flags);
  auto known = regexes.find(key);
  if (known == regexes.end()) {
    if (regexes.size() >= kMostKept) regexes.clear();
    known = regexes.emplace(std::move(key), Regex::Compile(pattern, flags)).first;
  }
  return known->second ? &*known->second : nullptr;
}

std::string Context::FreshBlankLabel() {
  for (;;) {
    std::string label = "made" + std::to_string(++next_blank);
    if (!dataset.default_graph.dictionary().Find({rdf::TermKind::kBlank, label, {}, {}})) {
      return label;
    }
  }
}

}  // namespace lares::sparql
