#include "mapping/objects/model_file.h"

#include <charconv>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "mapping/environment/ply_format.h"

namespace lares::objects {
namespace {

ModelFileFacts ReadCloud(const std::filesystem::path& file, const std::string& file_name) {
  auto reader = environment::ByteReader::OfFile(file, file_name);
  const environment::LayerFacts cloud = environment::CheckCloud(reader);
  ModelFileFacts facts;
  const std::string& points = cloud.facts.at("points");
  std::uint64_t count = 0;
  std::from_chars(points.data(), points.data() + points.size(), count);
  facts.points = count;
  facts.bounds = cloud.bounds_m;
  return facts;
}

ModelFileFacts ReadXml(const std::filesystem::path& file, const std::string& file_name) {
  auto reader = environment::ByteReader::OfFile(file, file_name);
  if (!IsModelMeta(reader.PeekFront(environment::ByteReader::kMaxPeek))) return {};
  if (std::filesystem::file_size(file) > kMaxMetaBytes) {
    throw Error(Code::kInvalid, "is larger than 1 MiB", {file_name, 0, 0});
  }
  ModelFileFacts facts;
  facts.meta = ReadModelMeta(ReadFile(file), file_name);
  return facts;
}

}  // namespace

ModelFileFacts ReadModelFile(const std::filesystem::path& file, const std::string& file_name) {
  const std::string extension = ToLower(std::filesystem::path(file_name).extension().string());
  if (extension == ".ply") return ReadCloud(file, file_name);
  if (extension == ".xml") return ReadXml(file, file_name);
  return {};
}

}  // namespace lares::objects
