// Files that are whole or absent: read at once, or written, synced, renamed and synced.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace lares {

// The whole file. Throws kNotFound, kIo, or kTooLarge beyond `max_bytes`.
std::string ReadFile(const std::filesystem::path& path, std::uintmax_t max_bytes = UINTMAX_MAX);

// Writes beside `path`, fsyncs, renames over it and fsyncs the folder: after a return the content
// survives a power cut; before it the old content stands. Throws kIo (kUnavailable when full).
void WriteFileAtomically(const std::filesystem::path& path, std::string_view bytes);

// fsync of a folder, so that renames and creations in it are durable.
void SyncFolder(const std::filesystem::path& folder);

}  // namespace lares
