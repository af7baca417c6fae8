#include "server/cli/grid_files.h"

#include "server/cli/print.h"

#include <array>
#include <fstream>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "mapping/environment/map_yaml.h"
#include "mapping/environment/tar_reader.h"
#include "server/api/tar.h"

namespace lares::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMaxImageBytes = std::uintmax_t{4} << 30;

// The YAML with its image named by file name alone; every other line stays as it is.
std::string WithImage(const std::string& yaml, const std::string& image) {
  std::vector<std::string> lines = Split(yaml, '\n');
  for (std::string& line : lines) {
    if (line.starts_with("image:")) line = "image: \"" + image + "\"";
  }
  return Join(lines, "\n");
}

void Add(std::ofstream& archive, const std::string& name, const std::string& bytes) {
  archive << api::TarHeader(name, bytes.size(), Now()) << bytes << api::TarPadding(bytes.size());
}

}  // namespace

void PackGrid(const fs::path& yaml, const fs::path& archive) {
  const std::string text = ReadLocalFile(yaml, environment::kMaxMapYamlBytes);
  const environment::MapYaml map = environment::ReadMapYaml(text, yaml.filename().string());
  const fs::path image = yaml.parent_path() / map.image;  // an absolute image stands for itself
  const std::string bytes = ReadLocalFile(image, kMaxImageBytes);
  std::ofstream out(archive, std::ios::binary | std::ios::trunc);
  const std::string image_name = image.filename().string();
  Add(out, yaml.filename().string(), map.image == image_name ? text : WithImage(text, image_name));
  Add(out, image_name, bytes);
  out << api::TarEnd();
  out.close();
  if (!out) throw Error(Code::kIo, "cannot write '" + archive.string() + "'");
}

void UnpackGrid(const fs::path& archive, const fs::path& folder) {
  fs::create_directories(folder);
  auto reader = environment::TarReader::OfFile(archive, archive.filename().string());
  while (const auto entry = reader.Next()) {
    const fs::path file = folder / entry->path;  // relative and without "..": the reader sees to it
    fs::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    std::array<char, 64 * 1024> piece;
    while (const std::size_t got = reader.Read(piece.data(), piece.size())) {
      out.write(piece.data(), static_cast<std::streamsize>(got));
    }
    out.close();
    if (!out) throw Error(Code::kIo, "cannot write '" + file.string() + "'");
  }
}

}  // namespace lares::cli
