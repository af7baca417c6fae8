// The files of an archive, in memory.
#pragma once

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace lares::testing {

// Path → content of every file whose path begins with `prefix`; zip, tar, gzip and what else
// libarchive knows. Fails the test when the archive cannot be read.
inline std::map<std::string, std::string> ReadArchive(const std::filesystem::path& file,
                                                      const std::string& prefix = "") {
  std::map<std::string, std::string> files;
  const std::unique_ptr<archive, decltype(&archive_read_free)> reader(archive_read_new(),
                                                                      &archive_read_free);
  archive_read_support_filter_all(reader.get());
  archive_read_support_format_all(reader.get());
  EXPECT_EQ(archive_read_open_filename(reader.get(), file.c_str(), 1U << 16), ARCHIVE_OK)
      << archive_error_string(reader.get());
  archive_entry* entry = nullptr;
  int result = ARCHIVE_OK;
  while ((result = archive_read_next_header(reader.get(), &entry)) == ARCHIVE_OK) {
    const std::string path = archive_entry_pathname(entry);
    if (!path.starts_with(prefix) || archive_entry_filetype(entry) != AE_IFREG) continue;
    std::string& content = files[path];
    char buffer[1U << 16];
    la_ssize_t got = 0;
    while ((got = archive_read_data(reader.get(), buffer, sizeof buffer)) > 0) {
      content.append(buffer, static_cast<std::size_t>(got));
    }
    EXPECT_EQ(got, 0) << path << ": " << archive_error_string(reader.get());
  }
  EXPECT_EQ(result, ARCHIVE_EOF) << archive_error_string(reader.get());
  return files;
}

}  // namespace lares::testing
