// How the commands speak to people.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace lares::cli {

using Json = nlohmann::ordered_json;

// Columns as wide as their widest cell; the last one is not padded. Widths count code points.
std::string FormatTable(const std::vector<std::string>& heads,
                        const std::vector<std::vector<std::string>>& rows);

std::string FormatPercent(double probability);                   // "72.8 %"
std::string FormatBytes(std::uint64_t bytes);                    // "12.3 MB"
std::string Plural(std::size_t count, const std::string& noun);  // "1 step", "2 steps"
// "2026-01-31T12:00:00.000Z" → "2026-01-31 12:00"
std::string FormatTime(const std::string& rfc3339);

// A text member, "" when it is absent or no text.
std::string TextOf(const Json& json, const std::string& name);

// A file that was named on the command line. Throws kIo when it cannot be read, kTooLarge.
std::string ReadLocalFile(const std::filesystem::path& file, std::uintmax_t max_bytes);

void Print(const std::string& text);  // to standard output; throws kIo when that fails
void PrintJson(const Json& json);

// Lists of {message, place?} under a heading, nothing when empty.
std::string FormatRemarks(const Json& remarks, const std::string& heading);

}  // namespace lares::cli
