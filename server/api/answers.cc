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

Json Page(const http::Request& request, std::size_t count,
          const std::function<std::string(std::size_t)>& key,
          const std::function<Json(std::size_t)>& item) {
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
  Json page{{"items", Json::array()}, {"count", count}, {"next", nullptr}};
  for (std::size_t i = first; i < end; ++i) page["items"].push_back(item(i));
  if (end < count && end > first) page["next"] = key(end - 1);
  return page;
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
