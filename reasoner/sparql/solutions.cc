#include "reasoner/sparql/solutions.h"

#include <string>

namespace lares::sparql {

using rdf::kAnyTerm;
using syntax::Node;

TripleCollector::TripleCollector(Context& context, std::size_t most)
    : context_(context), most_(most), triples_(3, context) {}

bool TripleCollector::Add(TermId subject, TermId predicate, TermId object) {
  if (subject == kAnyTerm || predicate == kAnyTerm || object == kAnyTerm) return false;
  if (context_.terms.Get(subject).kind == rdf::TermKind::kLiteral) return false;
  if (context_.terms.Get(predicate).kind != rdf::TermKind::kIri) return false;
  const std::array<TermId, 3> triple{subject, predicate, object};
  if (!triples_.Insert(triple).second) return false;
  if (triples_.size() > most_) {
    throw Error(Code::kTooLarge, "the answer has more than " + std::to_string(most_) + " triples")
        .WithHint("add LIMIT, or make the query more selective");
  }
  return true;
}

rdf::Document TripleCollector::ToDocument() const {
  rdf::Document document;
  document.prefixes = context_.query.prefixes;
  std::unordered_map<TermId, std::uint32_t> indices;
  Charge charge(context_.account);
  const auto index_of = [&](TermId id) {
    const auto [entry, is_new] =
        indices.emplace(id, static_cast<std::uint32_t>(document.terms.size()));
    if (is_new) {
      const rdf::TermView term = context_.terms.Get(id);
      charge.Add(sizeof(rdf::Term) + 48 + term.value.size() + term.datatype.size());
      document.terms.push_back({term.kind, std::string(term.value), std::string(term.datatype),
                                std::string(term.language)});
    }
    return entry->second;
  };
  charge.Add(triples_.size() * sizeof(rdf::Statement));
  for (std::size_t i = 0; i < triples_.size(); ++i) {
    const auto triple = triples_.At(i);
    document.statements.push_back({index_of(triple[0]), index_of(triple[1]), index_of(triple[2])});
  }
  return document;
}

void ConstructInto(TripleCollector& collector, Context& context, Plan& plan) {
  const auto& query = context.query;
  std::vector<TermId> blanks(query.blanks);
  RunPlan(context, plan, [&](Row& row) {
    std::fill(blanks.begin(), blanks.end(), kAnyTerm);
    const auto term_of = [&](const Node& node) {
      if (node.kind != Node::Kind::kBlank) return context.At(node, row);
      TermId& blank = blanks[node.index];
      if (blank == kAnyTerm) {
        const std::string label = context.FreshBlankLabel();
        blank = context.terms.Intern({rdf::TermKind::kBlank, label, {}, {}});
      }
      return blank;
    };
    for (const auto& triple : query.construct) {
      collector.Add(term_of(triple.subject), term_of(triple.predicate), term_of(triple.object));
    }
    return true;
  });
}

void DescribeInto(TripleCollector& collector, Context& context, Plan& plan) {
  RowSet resources(1, context);
  const auto add = [&](TermId id) {
    if (id != kAnyTerm) resources.Insert({&id, 1});
  };
  bool has_variables = false;
  for (const Node& node : context.query.describe) {
    has_variables = has_variables || node.is_variable();
    if (!node.is_variable()) add(context.constants[node.index]);
  }
  if (has_variables) {
    RunPlan(context, plan, [&](Row& row) {
      for (const Node& node : context.query.describe) add(context.At(node, row));
      return true;
    });
  }
  for (std::size_t i = 0; i < resources.size(); ++i) {
    const TermId resource = resources.At(i)[0];
    if (context.terms.Get(resource).kind == rdf::TermKind::kLiteral) continue;
    context.default_graph->ForEach({resource, {}, {}}, [&](const rdf::Triple& triple) {
      context.guard.Tick();
      collector.Add(triple.subject, triple.predicate, triple.object);
      if (context.terms.Get(triple.object).kind == rdf::TermKind::kBlank) add(triple.object);
      return true;
    });
  }
}

}  // namespace lares::sparql
