// Lares beside Konclude, an independent reasoner of OWL 2 DL, on one file of OWL/XML for both.
//
// Within OWL 2 RL its rules find every atomic assertion that follows (OWL 2 Profiles, theorem PR1),
// so both must find the same. That covers the classes and properties too, for each class has a
// member here that nothing else is said of, and each object property a pair. On all of the part
// that is valid OWL 2 DL, Lares may conclude less, never anything else: there the classes are
// compared (Konclude 0.7 crashes at finding the types of RoboEarth's individuals).
//
// konclude_bench NAME FILE… : rows for the ontologies FILE… taken together (measure.h tells their
// form); what is punned, left out or different goes to standard error.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "benchmarks/konclude.h"
#include "benchmarks/measure.h"
#include "benchmarks/owl_parts.h"
#include "ontology/rdf/document_builder.h"
#include "ontology/rdf/merge.h"
#include "ontology/rdf/owl_syntax/owl_writers.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/owl/materialise.h"
#include "reasoner/owl/prover.h"

namespace lares::bench {
namespace {

namespace fs = std::filesystem;
const std::string kType = std::string(rdf::kRdf) + "type";
const std::string kSubClassOf = std::string(rdf::kRdfs) + "subClassOf";
constexpr std::size_t kLinesShown = 20;
constexpr const char* kProbe = "http://example.org/probe/";

// ---- What both are given ------------------------------------------------------------------------

rdf::Document ReadAll(const std::vector<std::string>& files) {
  std::vector<rdf::Document> documents;
  for (const std::string& file : files) {
    rdf::ReadOptions options;
    options.source = file;
    options.base_iri = "http://example.org/" + fs::path(file).filename().string();
    const std::string bytes = ReadFile(file);
    documents.push_back(ReadRdf(bytes, rdf::GuessFormat("", file, bytes), options));
  }
  return rdf::MergeOntologies(documents);
}

std::vector<std::string> NamesOf(const rdf::Document& document,
                                 const std::vector<rdf::OwlNode>& axioms, rdf::Construct kind) {
  std::set<std::string> names;
  for (const rdf::OwlNode& axiom : axioms) {
    if (axiom.construct != rdf::Construct::kDeclaration) continue;
    const rdf::OwlNode& entity = axiom.arguments[0];
    const rdf::OwlNode& name =
        entity.kind == rdf::OwlNode::Kind::kConstruct ? entity.arguments[0] : entity;
    if (entity.construct == kind) names.insert(document.terms[name.term].value);
  }
  return {names.begin(), names.end()};
}

std::string ToOwlXml(const rdf::Document& document, std::vector<rdf::OwlNode> axioms) {
  rdf::OwlOntology ontology;
  ontology.axioms = std::move(axioms);
  return rdf::PrintOwlXml(document, ontology);
}

struct Probed {
  std::string owl_xml;
  std::vector<std::string> properties;                 // object properties declared
  std::map<std::string, std::string> class_of_member;  // that stands for it
};

// The axioms with a member for each class and a pair for each object property that they declare.
Probed WithProbes(const rdf::Document& document, std::vector<rdf::OwlNode> axioms) {
  rdf::Document probed = document;
  probed.prefixes.clear();
  const auto iri = [&](const std::string& value) {
    probed.terms.push_back({rdf::TermKind::kIri, value, "", ""});
    return rdf::OwlNode::Leaf(rdf::OwlNode::Kind::kIri,
                              static_cast<std::uint32_t>(probed.terms.size() - 1));
  };
  Probed result;
  std::size_t count = 0;
  for (const std::string& name : NamesOf(document, axioms, rdf::Construct::kClass)) {
    if (name.starts_with(rdf::kOwl)) continue;
    const std::string member = kProbe + std::to_string(++count);
    result.class_of_member[member] = name;
    axioms.push_back(rdf::OwlNode::Of(rdf::Construct::kClassAssertion, {iri(name), iri(member)}));
  }
  result.properties = NamesOf(document, axioms, rdf::Construct::kObjectProperty);
  std::erase_if(result.properties,
                [](const std::string& name) { return name.starts_with(rdf::kOwl); });
  for (const std::string& name : result.properties) {
    ++count;
    axioms.push_back(rdf::OwlNode::Of(rdf::Construct::kObjectPropertyAssertion,
                                      {iri(name), iri(kProbe + std::to_string(count) + "/from"),
                                       iri(kProbe + std::to_string(count) + "/to")}));
  }
  result.owl_xml = ToOwlXml(probed, std::move(axioms));
  return result;
}

// ---- Lares --------------------------------------------------------------------------------------

bool IsName(const rdf::View& view, rdf::TermId term) {
  return view.dictionary().Kind(term) == rdf::TermKind::kIri;
}

rdf::View Closed(const fs::path& file) {
  rdf::ReadOptions options;
  options.source = file.filename().string();
  const rdf::View empty(std::make_shared<rdf::Dictionary>());
  const rdf::Document document = ReadRdf(ReadFile(file), rdf::Format::kOwlXml, options);
  return empty.With(
      owl::Materialise(empty, {rdf::MakeGraph(document, "it", {}, empty.dictionary())}));
}

std::string ToText(const rdf::View& view, const rdf::Triple& triple) {
  const auto text = [&](rdf::TermId term) {
    return std::string(view.dictionary().Get(term).value);
  };
  return text(triple.subject) + ' ' + text(triple.predicate) + ' ' + text(triple.object);
}

Conclusions ByLares(const fs::path& file, const std::vector<std::string>& properties) {
  const rdf::View view = Closed(file);
  Conclusions found;
  found.is_consistent = view.layers()[0]->clashes().empty();
  const auto add = [&](const std::string& property) {
    view.ForEach({{}, view.dictionary().InternIri(property), {}}, [&](const rdf::Triple& triple) {
      if (IsName(view, triple.subject) && IsName(view, triple.object)) {
        found.facts.insert(ToText(view, triple));
      }
      return true;
    });
  };
  add(kType);
  for (const std::string& property : properties) add(property);
  return found;
}

// What contradictions rest on: the premises of all, and of one of them all that is asserted.
struct Contradictions {
  Facts premises, asserted;
};

Contradictions ContradictionsIn(const fs::path& file) {
  const rdf::View view = Closed(file);
  Contradictions found;
  for (const rdf::Clash& clash : view.layers()[0]->clashes()) {
    for (const rdf::Triple& premise : clash.premises) found.premises.insert(ToText(view, premise));
  }
  if (found.premises.empty()) return found;
  const auto proof = owl::Prover(view).WhyContradiction();
  for (const owl::ProofNode& node : proof->nodes) {
    if (node.rule.empty()) found.asserted.insert(ToText(view, node.triple));
  }
  return found;
}

// ---- Both ---------------------------------------------------------------------------------------

// What holds of everything, and what only declares.
void DropTrivial(Facts& facts) {
  std::erase_if(facts, [](const std::string& fact) {
    const std::string object = fact.substr(fact.rfind(' ') + 1);
    return object.starts_with(rdf::kOwl) || object.starts_with(rdf::kRdfs) ||
           object.starts_with(rdf::kRdf);
  });
}

std::vector<std::string> Less(const Facts& all, const Facts& some) {
  std::vector<std::string> rest;
  std::set_difference(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(rest));
  return rest;
}

void Tell(const char* what, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::cerr << what << " (" << lines.size() << ")\n";
  const std::size_t shown = std::min(lines.size(), kLinesShown);
  for (std::size_t i = 0; i < shown; ++i) std::cerr << "  " << lines[i] << '\n';
  if (shown < lines.size()) std::cerr << "  and " << lines.size() - shown << " more\n";
}

// "s p o" for an axiom that is one triple of names and literals; else "".
std::string FactOf(const rdf::Document& document, const rdf::OwlNode& axiom) {
  const auto& a = axiom.arguments;
  if (a.size() < 2 || std::any_of(a.begin(), a.end(), [](const rdf::OwlNode& node) {
        return node.kind == rdf::OwlNode::Kind::kConstruct;
      })) {
    return "";
  }
  const auto text = [&](std::size_t i) { return document.terms[a[i].term].value; };
  switch (axiom.construct) {
    case rdf::Construct::kDataPropertyAssertion:
    case rdf::Construct::kObjectPropertyAssertion:
      return text(1) + ' ' + text(0) + ' ' + text(2);
    case rdf::Construct::kClassAssertion:
      return text(1) + ' ' + kType + ' ' + text(0);
    case rdf::Construct::kDataPropertyRange:
      return text(0) + ' ' + std::string(rdf::kRdfs) + "range " + text(1);
    case rdf::Construct::kDisjointClasses:
      return text(0) + ' ' + std::string(rdf::kOwl) + "disjointWith " + text(1);
    default:
      return "";
  }
}

// Leaves out the assertions (types last), data ranges and disjointnesses that contradictions rest
// on, until there are none (a class that can have no member is one, as each has a member here).
// From what is inconsistent everything follows, which is nothing to compare.
void LeaveOutContradictions(const rdf::Document& document, const fs::path& file,
                            std::vector<rdf::OwlNode>& axioms) {
  std::vector<std::string> left_out;
  const auto leave_out = [&](const Facts& facts, bool with_types) {
    return std::erase_if(axioms, [&](const rdf::OwlNode& axiom) {
             const bool is_type = axiom.construct == rdf::Construct::kClassAssertion;
             if (is_type && !with_types) return false;
             const std::string fact = FactOf(document, axiom);
             if (!facts.contains(fact)) return false;
             left_out.push_back(fact);
             return true;
           }) > 0;
  };
  while (true) {
    WriteFileAtomically(file, WithProbes(document, axioms).owl_xml);
    const Contradictions found = ContradictionsIn(file);
    if (!leave_out(found.premises, false) && !leave_out(found.asserted, false) &&
        !leave_out(found.asserted, true)) {
      break;
    }
  }
  Tell("left out, being part of a contradiction", left_out);
}

// Where Konclude and Lares differ it is asked twice more: missing is what it says each time, wrong
// what it never says.
struct Difference {
  std::vector<std::string> missing, wrong;
  std::size_t count = 0;  // Konclude's conclusions, where it gave most
  bool is_consistent = true;
  double seconds = 0;  // of the first answer
};

Difference Differ(const Conclusions& ours, const std::function<Conclusions()>& ask) {
  Difference difference;
  for (int i = 0; i < 3; ++i) {
    Conclusions theirs;
    const double seconds = SecondsOf([&] { theirs = ask(); });
    DropTrivial(theirs.facts);
    auto missing = Less(theirs.facts, ours.facts);
    auto wrong = Less(ours.facts, theirs.facts);
    if (i == 0) {
      difference = {std::move(missing), std::move(wrong), theirs.facts.size(), theirs.is_consistent,
                    seconds};
    } else {
      difference.count = std::max(difference.count, theirs.facts.size());
      std::erase_if(difference.missing,
                    [&](const auto& fact) { return !theirs.facts.contains(fact); });
      std::erase_if(difference.wrong,
                    [&](const auto& fact) { return theirs.facts.contains(fact); });
    }
    if (difference.missing.empty() && difference.wrong.empty()) break;
  }
  return difference;
}

double Count(const std::vector<std::string>& list) { return static_cast<double>(list.size()); }

// The axioms in `file`, probed, without what contradicts itself.
Probed Prepare(const rdf::Document& document, const fs::path& file,
               std::vector<rdf::OwlNode>& axioms) {
  LeaveOutContradictions(document, file, axioms);
  Probed probed = WithProbes(document, axioms);
  WriteFileAtomically(file, probed.owl_xml);
  return probed;
}

void TellWrong(const Difference& difference, const Conclusions& ours, const char* unit) {
  Tell("wrong", difference.wrong);
  Row("  … of Lares that Konclude does not have", "<=", 0, unit, Count(difference.wrong));
  Row("  … both find it consistent", ">=", 1, "yes",
      ours.is_consistent && difference.is_consistent ? 1 : 0);
}

void CompareRl(const std::string& name, const rdf::Document& document, const fs::path& file,
               std::vector<rdf::OwlNode> axioms) {
  const Probed probed = Prepare(document, file, axioms);
  Conclusions ours;
  const double seconds = SecondsOf([&] { ours = ByLares(file, probed.properties); });
  DropTrivial(ours.facts);
  const Difference difference =
      Differ(ours, [&] { return IndividualsByKonclude(file, probed.properties); });
  Tell("missing", difference.missing);
  Note(name + ", OWL 2 RL part: Konclude concludes", "facts",
       static_cast<double>(difference.count));
  Row("  … missing in Lares", "<=", 0, "facts", Count(difference.missing));
  TellWrong(difference, ours, "facts");
  Note("  … Konclude's time for that of Lares, files read and written", "times",
       difference.seconds / seconds);
}

void CompareDl(const std::string& name, const rdf::Document& document, const fs::path& file,
               std::vector<rdf::OwlNode> axioms) {
  const Probed probed = Prepare(document, file, axioms);
  Conclusions ours = ByLares(file, {});
  Facts classes;
  for (const std::string& fact : ours.facts) {
    const auto found = probed.class_of_member.find(fact.substr(0, fact.find(' ')));
    const std::string object = fact.substr(fact.rfind(' ') + 1);
    if (found == probed.class_of_member.end() || found->second == object) continue;
    classes.insert(found->second + ' ' + kSubClassOf + ' ' + object);
  }
  ours.facts = std::move(classes);
  DropTrivial(ours.facts);
  WriteFileAtomically(file, ToOwlXml(document, std::move(axioms)));
  const Difference difference = Differ(ours, [&] { return ClassesByKonclude(file); });
  Note(name + ", OWL 2 DL part: subclasses by Konclude", "pairs",
       static_cast<double>(difference.count));
  Note("  … beyond OWL 2 RL, which Lares leaves", "pairs", Count(difference.missing));
  TellWrong(difference, ours, "pairs");
}

void Compare(const std::string& name, const fs::path& folder,
             const std::vector<std::string>& files) {
  const rdf::Document document = ReadAll(files);
  const rdf::AxiomsOfDocument read = rdf::AxiomsOf(document);
  const OwlParts parts = PartsOf(document, read.ontology.axioms);
  std::cerr << name << ": " << read.ontology.axioms.size() << " axioms, " << parts.dl.size()
            << " logical and valid OWL 2 DL, " << parts.rl.size() << " of them OWL 2 RL; "
            << read.left_out.size() << " triples are part of no axiom\n";
  Tell("punned: '!' is no OWL 2 DL, and its axioms are left out", parts.punned);
  Tell("left out, being no OWL 2 DL", parts.not_dl);
  CompareRl(name, document, folder / "rl.owx", parts.rl);
  CompareDl(name, document, folder / "dl.owx", parts.dl);
}

}  // namespace
}  // namespace lares::bench

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "konclude_bench NAME FILE...\n";
    return 2;
  }
  try {
    const lares::bench::TemporaryFolder folder;
    lares::bench::Compare(argv[1], folder.path(), {argv + 2, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "konclude_bench: " << error.what() << '\n';
    return 2;
  }
}
