// What handlers have in common: JSON answers, query parameters, pages, files.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "server/api/json.h"
#include "server/http/message.h"
#include "server/store/store.h"

namespace lares::api {

http::Response JsonAnswer(const Json& json, int status = 200);

// "true"/"1"/"" are true, "false"/"0" false. Throws kInvalid for anything else.
bool QueryFlag(const http::Request& request, const std::string& name);
// Throws kInvalid for what is no whole number within the bounds.
int QueryNumber(const http::Request& request, const std::string& name, int otherwise, int least,
                int most);

// {"items": […], "count": all, "next": key of the next page} of `count` things that are in order:
// `key(i)` names them, `item(i)` shows them as JSON text. ?limit= (100, at most 1000) and ?after=
// (a key) choose the page.
http::Response PageOfTexts(const http::Request& request, std::size_t count,
                           const std::function<std::string(std::size_t)>& key,
                           const std::function<std::string(std::size_t)>& item);
http::Response Page(const http::Request& request, std::size_t count,
                    const std::function<std::string(std::size_t)>& key,
                    const std::function<Json(std::size_t)>& item);

// JSON without line breaks; bytes that are no UTF-8 are replaced.
std::string Compact(const Json& json);

// A stored blob with ETag, ranges and the name to save it under.
http::Response BlobAnswer(const store::Store& store, const store::Blob& blob,
                          const std::string& media_type, const std::string& file_name,
                          const std::string& etag);

// `attachment; filename="…"; filename*=UTF-8''…`
std::string ContentDisposition(const std::string& file_name);

}  // namespace lares::api
