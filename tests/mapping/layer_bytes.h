// Small layers made by hand, and what a check says about bytes.
#pragma once

#include <archive.h>
#include <archive_entry.h>

#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mapping/environment/byte_reader.h"
#include "mapping/environment/layer_format.h"

namespace lares::environment::testing {

// Runs `check` on bytes; the message of its Error, or "" when there is none.
inline std::string Refusal(LayerFacts (*check)(ByteReader&), const std::string& bytes) {
  ByteReader reader = ByteReader::OfBytes(bytes, "file");
  try {
    check(reader);
  } catch (const Error& error) {
    if (error.code() != Code::kInvalid) return "not kInvalid: " + error.FullMessage();
    return error.FullMessage();
  }
  return "";
}

inline LayerFacts Check(LayerFacts (*check)(ByteReader&), const std::string& bytes) {
  ByteReader reader = ByteReader::OfBytes(bytes, "file");
  return check(reader);
}

// An OctoMap with one occupied voxel, the one whose lowest corner is the origin: a chain of inner
// nodes, first upward in x, y and z, then always down.
inline std::string OneVoxelBt(const std::string& resolution = "0.5",
                              const std::string& size = "17") {
  std::string bytes = "# Octomap OcTree binary file\n# made for a test\nid OcTree\nsize " + size +
                      "\nres " + resolution + "\ndata\n";
  bytes += std::string("\x00\xC0", 2);  // child 7 is an inner node
  for (int depth = 1; depth < 15; ++depth) bytes += std::string("\x03\x00", 2);
  return bytes + std::string("\x02\x00", 2);  // child 0 is occupied
}

inline std::string FloatBytes(float number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

// A root with one free and one occupied child, full format.
inline std::string TwoLeavesOt(const std::string& id = "OcTree", float log_odds = 0.85F,
                               const std::string& payload = "") {
  std::string bytes = "# Octomap OcTree file\nid " + id + "\nsize 3\nres 0.1\ndata\n";
  bytes += FloatBytes(log_odds) + payload + '\x81';  // children 0 and 7
  bytes += FloatBytes(-0.4F) + payload + std::string(1, '\0');
  return bytes + FloatBytes(log_odds) + payload + std::string(1, '\0');
}

struct TarFile {
  std::string path;
  std::string bytes;
  unsigned type = AE_IFREG;
};

inline std::string MakeTar(const std::vector<TarFile>& files) {
  std::size_t room = 1 << 20;
  for (const TarFile& file : files) room += file.bytes.size();
  std::string tar(room, '\0');
  std::size_t used = 0;
  struct archive* writer = archive_write_new();
  archive_write_set_format_ustar(writer);
  archive_write_open_memory(writer, tar.data(), tar.size(), &used);
  for (const TarFile& file : files) {
    struct archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, file.path.c_str());
    archive_entry_set_filetype(entry, file.type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, static_cast<la_int64_t>(file.bytes.size()));
    if (file.type == AE_IFLNK) archive_entry_set_symlink(entry, "/etc/passwd");
    archive_write_header(writer, entry);
    archive_write_data(writer, file.bytes.data(), file.bytes.size());
    archive_entry_free(entry);
  }
  archive_write_close(writer);
  archive_write_free(writer);
  tar.resize(used);
  return tar;
}

}  // namespace lares::environment::testing
