// What the tests of reading and writing RDF share.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

#include "ontology/rdf/reader.h"
#include "ontology/rdf/writer.h"
#include "tests/ontology/isomorphism.h"

namespace lares::rdf::testing {

inline ReadOptions Named(const std::string& source) {
  ReadOptions options;
  options.source = source;
  return options;
}

// The fault of a document that has to have one.
inline Error FaultOf(std::string_view text, Format format, const ReadOptions& options) {
  try {
    const Document document = ReadRdf(text, format, options);
    ADD_FAILURE() << "accepted, " << document.statements.size() << " statements";
    return Error(Code::kInternal, "accepted");
  } catch (const Error& error) {
    return error;
  }
}

inline std::string MessageOf(std::string_view text, Format format,
                             const std::string& source = "x") {
  return FaultOf(text, format, Named(source)).FullMessage();
}

}  // namespace lares::rdf::testing
