#include "tests/reasoner/lubm.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "ontology/rdf/reader.h"
#include "reasoner/owl/materialise.h"

namespace lares::testing {
std::string LubmData(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "lubm-1-0-0.nt.gz";
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
      add(rdf::View(dictionary), ReadFile(folder / "ontology/univ-bench.ttl"), rdf::Format::kTurtle,
          "univ-bench.ttl");
  return add(ontology, LubmData(folder), rdf::Format::kNTriples, "lubm");
}

std::string LubmQuery(const std::filesystem::path& folder, int number) {
  return ReadFile(folder / "queries" / ("q" + std::to_string(number) + ".rq"));
}

std::vector<std::string> LubmAnswers(const std::filesystem::path& folder, int number) {
  std::vector<std::string> lines;
  std::istringstream text(
      ReadFile(folder / "answers" / ("answers_query" + std::to_string(number) + ".csv")));
  std::string line;
  std::getline(text, line);  // the head; a query without answers has nothing else
  while (std::getline(text, line)) {
    if (!Trim(line).empty()) lines.emplace_back(Trim(line));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace lares::testing
