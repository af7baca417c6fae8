// What is asked of one robot alone.
#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "server/knowledge/knowledge.h"
#include "server/knowledge/state.h"

namespace lares::server {
namespace {

// Local names of the classes of components.
std::vector<std::string> ComponentNames(const rdf::View& view, rdf::TermId sub_class,
                                        rdf::TermId component) {
  std::vector<std::string> names;
  for (const rdf::TermId term : view.Subjects(sub_class, component)) {
    const rdf::TermView found = view.dictionary().Get(term);
    if (found.kind == rdf::TermKind::kIri) names.emplace_back(LocalName(found.value));
  }
  return names;
}

}  // namespace

recipes::Resource Knowledge::ResolveComponent(const std::string& name) {
  const rdf::View view = Catalogue();
  const rdf::TermId sub_class =
      view.dictionary().InternIri("http://www.w3.org/2000/01/rdf-schema#subClassOf");
  const rdf::TermId component = view.dictionary().InternIri(std::string(rdf::kLares) + "Component");
  const auto similar = [&] {
    return SimilarNames(name, ComponentNames(view, sub_class, component));
  };
  recipes::Resource found;
  try {
    found = ResolveClass(name);
  } catch (const Error& error) {
    if (error.code() != Code::kNotFound) throw;
    throw Error(Code::kNotFound, "no component is called '" + name + "'").WithCandidates(similar());
  }
  const auto term = view.dictionary().FindIri(found.iri);
  if (term && view.Contains({*term, sub_class, component})) return found;
  throw Error(Code::kInvalid, "'" + name + "' is a class, but no component of robots")
      .WithCandidates(similar());
}

recipes::CapabilityReport Knowledge::Capabilities(const std::string& robot, bool strict) {
  const Resolved resolved = Resolve(store::DocumentKind::kRobot, robot);
  if (resolved.target_iri.empty()) {
    throw Error(Code::kNotFound, "'" + resolved.document.id + "' describes no robot to use");
  }
  recipes::MatchOptions options;
  options.strict = strict;
  return recipes::Capabilities(state_->engines,
                               state_->ViewOf({&resolved.document, nullptr, nullptr}),
                               resolved.target_iri, options);
}

}  // namespace lares::server
