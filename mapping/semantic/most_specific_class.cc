#include "mapping/semantic/most_specific_class.h"

#include <algorithm>
#include <vector>

namespace lares::semantic {
namespace {

std::vector<rdf::TermId> NamedClasses(const rdf::View& view, const Names& names, rdf::TermId thing,
                                      rdf::Origin origin) {
  std::vector<rdf::TermId> classes;
  for (const rdf::Triple& triple : view.Match({thing, names.type, rdf::kAnyTerm}, origin)) {
    const rdf::TermId type = triple.object;
    const bool says_something =
        type != names.named_individual && type != names.thing && type != names.map_object;
    if (says_something && view.dictionary().Get(type).kind == rdf::TermKind::kIri) {
      classes.push_back(type);
    }
  }
  std::sort(classes.begin(), classes.end(), [&](rdf::TermId a, rdf::TermId b) {
    return view.dictionary().Get(a).value < view.dictionary().Get(b).value;
  });
  return classes;
}

}  // namespace

std::optional<rdf::TermId> MostSpecificClass(const rdf::View& view, const Names& names,
                                             rdf::TermId thing) {
  const auto all = NamedClasses(view, names, thing, rdf::Origin::kAll);
  const auto is_below = [&](rdf::TermId a, rdf::TermId b) {
    return a != b && view.Contains({a, names.sub_class_of, b}) &&
           !view.Contains({b, names.sub_class_of, a});
  };
  for (const rdf::Origin origin : {rdf::Origin::kAsserted, rdf::Origin::kAll}) {
    for (const rdf::TermId candidate : NamedClasses(view, names, thing, origin)) {
      const bool is_most_specific = std::none_of(
          all.begin(), all.end(), [&](rdf::TermId other) { return is_below(other, candidate); });
      if (is_most_specific) return candidate;
    }
  }
  return std::nullopt;
}

}  // namespace lares::semantic
