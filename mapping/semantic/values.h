// Single values in a view: numbers, times, names for messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/time.h"
#include "ontology/triples/view.h"

namespace lares::semantic {

// The IRI (or blank node) in angle brackets, as its document wrote it.
std::string Quoted(const rdf::View& view, rdf::TermId term);

// The one number that any of `subjects` has for `property`; nothing when there is none. Throws
// kInvalid, naming the subject and `name`, for what is no finite number and for two different ones.
std::optional<double> FindNumber(const rdf::View& view, const std::vector<rdf::TermId>& subjects,
                                 rdf::TermId property, const std::string& name);

// A dateTime literal (with any zone; without one, UTC), a literal of Unix seconds, or an IRI or
// blank node whose name ends in "_<Unix seconds>". Nothing for anything else.
std::optional<Time> ToTime(const rdf::TermView& term);

}  // namespace lares::semantic
