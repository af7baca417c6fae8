#include "server/cli/print.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"

namespace lares::cli {
namespace {

std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

}  // namespace

std::string FormatTable(const std::vector<std::string>& heads,
                        const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::string& head : heads) widths.push_back(Width(head));
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], Width(row[i]));
  }
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - Width(row[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add(heads);
  for (const auto& row : rows) add(row);
  return text;
}

std::string FormatPercent(double probability) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", probability * 100);
  return text;
}

std::string FormatBytes(std::uint64_t bytes) {
  static constexpr const char* kUnits[] = {"B", "kB", "MB", "GB", "TB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= 999.5 && unit + 1 < std::size(kUnits); ++unit) value /= 1000;
  char text[32];
  std::snprintf(text, sizeof text, unit == 0 || value >= 100 ? "%.0f %s" : "%.1f %s", value,
                kUnits[unit]);
  return text;
}

std::string Plural(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string FormatTime(const std::string& rfc3339) {
  if (rfc3339.size() < 16) return rfc3339;
  return rfc3339.substr(0, 10) + " " + rfc3339.substr(11, 5);
}

std::string TextOf(const Json& json, const std::string& name) {
  if (!json.is_object()) return "";
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

std::string ReadLocalFile(const std::filesystem::path& file, std::uintmax_t max_bytes) {
  try {
    return ReadFile(file, max_bytes);
  } catch (const Error& error) {
    if (error.code() == Code::kTooLarge) throw;
    throw Error(Code::kIo, error.what());
  }
}

void Print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw Error(Code::kIo, "cannot write to standard output");
  }
}

void PrintJson(const Json& json) {
  Print(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string FormatRemarks(const Json& remarks, const std::string& heading) {
  if (!remarks.is_array() || remarks.empty()) return "";
  std::string text = heading + "\n";
  for (const Json& remark : remarks) {
    std::string where;
    if (remark.contains("place")) {
      const Json& place = remark["place"];
      where = ToString(
          Place{TextOf(place, "source"), place.value("line", 0), place.value("column", 0)});
    }
    text += "  " + (where.empty() ? "" : where + ": ") + TextOf(remark, "message") + "\n";
  }
  return text;
}

}  // namespace lares::cli
