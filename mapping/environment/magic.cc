#include "mapping/environment/magic.h"

#include <cstddef>

#include "base/text.h"

namespace lares::environment {
namespace {

using namespace std::string_view_literals;

struct Magic {
  std::size_t offset;
  std::string_view bytes;
  std::string_view name;
};

constexpr Magic kMagics[] = {
    {0, "\x89PNG\r\n\x1A\n"sv, "a PNG image"},
    {0, "\xFF\xD8\xFF"sv, "a JPEG image"},
    {0, "GIF8"sv, "a GIF image"},
    {0, "\x1F\x8B"sv, "a gzip archive"},
    {0, "PK\x03\x04"sv, "a zip archive"},
    {0, "BZh"sv, "a bzip2 archive"},
    {0,
     "\xFD"
     "7zXZ\0"sv,
     "an xz archive"},
    {0, "\x28\xB5\x2F\xFD"sv, "a Zstandard archive"},
    {0, "%PDF"sv, "a PDF document"},
    {0,
     "\x7F"
     "ELF"sv,
     "an ELF program"},
    {0, "SQLite format 3\0"sv, "an SQLite database"},
    {0, "#ROSBAG V"sv, "a ROS bag"},
    {0, "# .PCD"sv, "a PCD point cloud"},
    {0, "VERSION .7\n"sv, "a PCD point cloud"},
    {0, "# Octomap OcTree"sv, "an OctoMap"},
    {0, "ply\n"sv, "a PLY point cloud"},
    {0, "ply\r"sv, "a PLY point cloud"},
    {0, "P5\n"sv, "a PGM image"},
    {0, "P5 "sv, "a PGM image"},
    {0, "P2\n"sv, "a PGM image"},
    {0, "P2 "sv, "a PGM image"},
    {257, "ustar"sv, "a tar archive"},
};

}  // namespace

std::string_view LooksLike(std::string_view first_bytes) {
  for (const Magic& magic : kMagics) {
    if (first_bytes.size() >= magic.offset + magic.bytes.size() &&
        first_bytes.substr(magic.offset, magic.bytes.size()) == magic.bytes) {
      return magic.name;
    }
  }
  std::string_view text = first_bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::string start = ToLower(Trim(text).substr(0, 16));
  if (start.starts_with("<!doctype html") || start.starts_with("<html")) return "an HTML page";
  if (start.starts_with("<?xml") || start.starts_with("<rdf:rdf")) return "an XML document";
  if (start.starts_with("{\"") || start.starts_with("[{")) return "a JSON document";
  return {};
}

std::string NotA(std::string_view expected, std::string_view first_bytes) {
  std::string sentence = "not " + std::string(expected);
  if (first_bytes.empty()) return sentence + ": it is empty";
  const std::string_view looks = LooksLike(first_bytes);
  if (!looks.empty()) sentence.append(": it looks like ").append(looks);
  return sentence;
}

}  // namespace lares::environment
