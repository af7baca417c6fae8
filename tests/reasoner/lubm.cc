#include "tests/reasoner/lubm.h"

#include <zlib.h>

#include <array>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"

namespace lares::testing {
namespace {

std::string ReadGzip(const std::filesystem::path& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) throw Error(Code::kIo, "cannot open " + path.string());
  std::string bytes;
  std::array<char, 1 << 16> buffer{};
  for (int read = 0; (read = gzread(file, buffer.data(), buffer.size())) > 0;) {
    bytes.append(buffer.data(), static_cast<std::size_t>(read));
  }
  gzclose(file);
  return bytes;
}

}  // namespace

rdf::View ReadLubm(const std::filesystem::path& folder,
                   const std::shared_ptr<rdf::Dictionary>& dictionary) {
  const rdf::AliasTable aliases;
  const auto add = [&](const rdf::View& below, const std::string& bytes, rdf::Format format,
                       const std::string& name) {
    rdf::ReadOptions options;
    options.source = name;
    options.base_iri = "http://example.org/" + name;
    return below.With(owl::Materialise(
        below, {rdf::MakeGraph(rdf::ReadRdf(bytes, format, options), name, aliases, *dictionary)}));
  };
  const rdf::View ontology =
      add(rdf::View(dictionary), ReadFile(folder / "ontology/univ-bench.ttl"),
          rdf::Format::kTurtle, "univ-bench.ttl");
  return add(ontology, ReadGzip(folder / "lubm-1-0-0.nt.gz"), rdf::Format::kNTriples, "lubm");
}

}  // namespace lares::testing
