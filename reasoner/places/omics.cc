#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "ontology/rdf/vocabulary.h"
#include "reasoner/places/read_prior.h"

namespace lares::places {
namespace {

constexpr std::string_view kClass = "OmicsLocations";

using TermIndex = std::uint32_t;

// One statement of the database: terms of the document, kNone where none was found yet.
struct Location {
  static constexpr TermIndex kNone = UINT32_MAX;
  TermIndex subject = kNone, object = kNone;
};

// A document's individuals as terms; `subject` and `object` are of the namespace that the class is.
class Locations {
 public:
  Locations(const rdf::Document& document, std::string_view bytes, const std::string& source)
      : document_(document), bytes_(bytes), source_(source) {
    FindIndividuals();
    for (const rdf::Statement& statement : document.statements) Read(statement);
  }

  const std::map<TermIndex, Location>& all() const { return locations_; }

  // The IRI that `individual` has for `role`; throws when there is none.
  const std::string& Iri(TermIndex individual, TermIndex value, const char* role) const {
    if (value == Location::kNone) Fail(individual, std::string("has no ") + role);
    const rdf::Term& term = document_.terms[value];
    if (term.kind != rdf::TermKind::kIri) Fail(individual, std::string(role) + " is no IRI");
    return term.value;
  }

 private:
  void FindIndividuals() {
    for (const rdf::Statement& statement : document_.statements) {
      const rdf::Term& predicate = document_.terms[statement.predicate];
      const rdf::Term& type = document_.terms[statement.object];
      if (predicate.value != std::string(rdf::kRdf) + "type") continue;
      if (type.kind != rdf::TermKind::kIri || !type.value.ends_with(kClass)) continue;
      const std::string space = type.value.substr(0, type.value.size() - kClass.size());
      if (!space.ends_with('#') && !space.ends_with('/')) continue;
      locations_[statement.subject];
      roles_[space + "subject"] = &Location::subject;
      roles_[space + "object"] = &Location::object;
    }
  }

  void Read(const rdf::Statement& statement) {
    const auto role = roles_.find(document_.terms[statement.predicate].value);
    const auto location = locations_.find(statement.subject);
    if (role == roles_.end() || location == locations_.end()) return;
    TermIndex& value = location->second.*(role->second);
    if (value != Location::kNone && value != statement.object) {
      Fail(statement.subject, "has two values for <" + role->first + ">");
    }
    value = statement.object;
  }

  [[noreturn]] void Fail(TermIndex individual, const std::string& message) const {
    const std::string& iri = document_.terms[individual].value;
    throw Error(Code::kInvalid, "<" + iri + "> " + message, {source_, LineOf(iri)});
  }

  // Where the text first names the individual, by its whole local name; 0 when it does not.
  int LineOf(const std::string& iri) const {
    const std::string_view local = LocalName(iri);
    for (std::size_t at = bytes_.find(local); at != std::string_view::npos;
         at = bytes_.find(local, at + 1)) {
      const std::string_view after = bytes_.substr(at + local.size(), 1);
      if (after.find_first_of("\"'> \t\r\n") == std::string_view::npos) continue;
      const std::string_view before = bytes_.substr(0, at);
      return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
    }
    return 0;
  }

  const rdf::Document& document_;
  std::string_view bytes_;
  const std::string& source_;
  std::map<TermIndex, Location> locations_;
  std::map<std::string, TermIndex Location::*> roles_;
};

}  // namespace

PriorTable ReadOmics(std::string_view bytes, const std::string& name,
                     const rdf::AliasTable& aliases) {
  rdf::ReadOptions options;
  options.source = name;
  const rdf::Document document = rdf::ReadRdf(bytes, rdf::GuessFormat("", "", bytes), options);
  const Locations locations(document, bytes, name);
  TableBuilder table(name);
  for (const auto& [individual, location] : locations.all()) {
    const std::string& object = locations.Iri(individual, location.subject, "subject");
    const std::string& place = locations.Iri(individual, location.object, "object");
    table.Add(aliases.Canonical(object), aliases.Canonical(place), 1, "");
  }
  return table.Finish(name, "OMICS locations", 0);
}

}  // namespace lares::places
