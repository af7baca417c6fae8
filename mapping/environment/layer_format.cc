#include "mapping/environment/layer_format.h"

#include <algorithm>

#include "base/error.h"
#include "mapping/environment/byte_reader.h"
#include "mapping/environment/grid_format.h"
#include "mapping/environment/magic.h"
#include "mapping/environment/octomap_format.h"
#include "mapping/environment/ply_format.h"
#include "mapping/environment/trajectory_format.h"
#include "ontology/rdf/document.h"

namespace lares::environment {
namespace {

LayerFacts CheckSemantic(ByteReader& reader) {
  const std::string front(reader.PeekFront(ByteReader::kMaxPeek));
  if (front.empty()) reader.Fail(NotA("RDF", front));
  const std::string_view looks = LooksLike(front);
  if (!looks.empty() && looks != "an XML document") reader.Fail(NotA("RDF", front));
  LayerFacts facts;
  try {
    facts.media_type = rdf::MediaType(rdf::GuessFormat("", reader.name(), front));
  } catch (const Error& error) {
    if (error.code() != Code::kUnsupported) throw;
    reader.Fail(NotA("RDF", front));
  }
  return facts;
}

LayerFacts CheckFeatures(ByteReader& reader) {
  reader.Peek();  // that it can be read
  LayerFacts facts;
  facts.media_type = "application/octet-stream";
  return facts;
}

LayerFacts CheckGridFile(const std::filesystem::path& file, const std::string& file_name) {
  ByteReader reader = ByteReader::OfFile(file, file_name);
  const std::string_view front = reader.PeekFront(512);
  const std::string_view looks = LooksLike(front);
  const bool may_be_tar = looks == "a tar archive" || (looks.empty() && !front.empty());
  if (!may_be_tar) reader.Fail(NotA("a tar of map YAML and PGM", front));
  return CheckGrid([&] { return TarReader::OfFile(file, file_name); }, file_name);
}

}  // namespace

const std::vector<std::string>& LayerNames() {
  static const std::vector<std::string> names = {"semantic", "features", "octomap",
                                                 "grid",     "cloud",    "trajectory"};
  return names;
}

bool IsLayerName(std::string_view name) {
  return std::find(LayerNames().begin(), LayerNames().end(), name) != LayerNames().end();
}

LayerFacts CheckLayer(std::string_view name, const std::filesystem::path& file,
                      std::string_view file_name) {
  const std::string source(file_name);
  if (name == "grid") return CheckGridFile(file, source);
  using Check = LayerFacts (*)(ByteReader&);
  const std::map<std::string_view, Check> checks = {{"semantic", CheckSemantic},
                                                    {"features", CheckFeatures},
                                                    {"octomap", CheckOctomap},
                                                    {"cloud", CheckCloud},
                                                    {"trajectory", CheckTrajectory}};
  const auto check = checks.find(name);
  if (check == checks.end()) {
    throw Error(Code::kUnsupported, "there is no layer '" + std::string(name.substr(0, 64)) +
                                        "'; layers are semantic, features, octomap, grid, cloud "
                                        "and trajectory");
  }
  ByteReader reader = ByteReader::OfFile(file, source);
  return check->second(reader);
}

}  // namespace lares::environment
