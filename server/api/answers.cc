#include "server/api/answers.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/http/url.h"

namespace lares::api {

http::Response JsonAnswer(const Json& json, int status) {
  http::Response response;
  response.status = status;
  response.headers.Set("Content-Type", "application/json");
  response.body = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  return response;
}

bool QueryFlag(const http::Request& request, const std::string& name) {
  const auto value = request.Query(name);
  if (!value || *value == "false" || *value == "0") return false;
  if (*value == "true" || *value == "1" || value->empty()) return true;
  throw Error(Code::kInvalid, "?" + name + "= is true or false, not '" + *value + "'");
}

int QueryNumber(const http::Request& request, const std::string& name, int otherwise, int least,
                int most) {
  const auto value = request.Query(name);
  if (!value) return otherwise;
  int number = 0;
  const auto [end, error] = std::from_chars(value->data(), value->data() + value->size(), number);
  if (error != std::errc() || end != value->data() + value->size() || number < least ||
      number > most) {
    throw Error(Code::kInvalid, "?" + name + "= is a whole number from " + std::to_string(least) +
                                    " to " + std::to_string(most) + ", not '" + *value + "'");
  }
  return number;
}

std::string Compact(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

http::Response PageOfTexts(const http::Request& request, std::size_t count,
                           const std::function<std::string(std::size_t)>& key,
                           const std::function<std::string(std::size_t)>& item) {
  const auto limit = static_cast<std::size_t>(QueryNumber(request, "limit", 100, 1, 1000));
  std::size_t first = 0;
  if (const auto after = request.Query("after")) {
    while (first < count && key(first) != *after) ++first;
    if (first == count) {
      throw Error(Code::kNotFound, "there is no '" + *after + "' to begin after");
    }
    ++first;
  }
  const std::size_t end = std::min(count, first + limit);
  std::string text = "{\"items\":[";
  for (std::size_t i = first; i < end; ++i) text += (i > first ? ",\n" : "\n") + item(i);
  const bool more = end < count && end > first;
  text += "\n],\"count\":" + std::to_string(count) +
          ",\"next\":" + (more ? Compact(Json(key(end - 1))) : "null") + "}\n";
  http::Response response;
  response.headers.Set("Content-Type", "application/json");
  response.body = std::move(text);
  return response;
}

http::Response Page(const http::Request& request, std::size_t count,
                    const std::function<std::string(std::size_t)>& key,
                    const std::function<Json(std::size_t)>& item) {
  return PageOfTexts(request, count, key, [&](std::size_t i) { return Compact(item(i)); });
}

std::string ContentDisposition(const std::string& file_name) {
  std::string plain;
  for (const char c : file_name) {
    const auto byte = static_cast<unsigned char>(c);
    plain += byte < 0x20 || byte > 0x7e || c == '"' || c == '\\' ? '_' : c;
  }
  return "attachment; filename=\"" + plain + "\"; filename*=UTF-8''" +
         http::PercentEncode(file_name);
}

http::Response BlobAnswer(const store::Store& store, const store::Blob& blob,
                          const std::string& media_type, const std::string& file_name,
                          const std::string& etag) {
  http::Response response;
  response.headers.Set("Content-Type",
                       media_type.empty() ? "application/octet-stream" : media_type);
  response.headers.Set("ETag", etag);
  response.headers.Set("Accept-Ranges", "bytes");
  if (!file_name.empty())
    response.headers.Set("Content-Disposition", ContentDisposition(file_name));
  response.body = http::FileBody{store.BlobPath(blob.sha256), 0, blob.size};
  return response;
}

}  // namespace lares::api
