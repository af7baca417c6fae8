#include "server/http/message.h"

#include <strings.h>

#include <algorithm>

#include "base/error.h"

namespace lares::http {
namespace {

bool SameName(std::string_view a, std::string_view b) {
  return a.size() == b.size() && ::strncasecmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace

const std::string* Headers::Find(std::string_view name) const {
  for (const auto& field : fields_) {
    if (SameName(field.first, name)) return &field.second;
  }
  return nullptr;
}

std::string_view Headers::Get(std::string_view name) const {
  const std::string* value = Find(name);
  return value == nullptr ? std::string_view() : std::string_view(*value);
}

std::string Headers::GetList(std::string_view name) const {
  std::string list;
  for (const auto& field : fields_) {
    if (!SameName(field.first, name)) continue;
    if (!list.empty()) list += ", ";
    list += field.second;
  }
  return list;
}

void Headers::Set(std::string_view name, std::string value) {
  Remove(name);
  Add(name, std::move(value));
}

void Headers::Remove(std::string_view name) {
  std::erase_if(fields_, [&](const auto& field) { return SameName(field.first, name); });
}

void Headers::Add(std::string_view name, std::string value) {
  fields_.emplace_back(std::string(name), std::move(value));
}

std::optional<std::string> Request::Query(const std::string& name) const {
  const auto found = query.find(name);
  return found == query.end() ? std::nullopt : std::optional(found->second);
}

const std::string& Request::Param(const std::string& name) const {
  const auto found = params.find(name);
  if (found == params.end()) throw Error(Code::kInternal, "the route has no {" + name + "}");
  return found->second;
}

std::string ReadWholeBody(const Request& request, std::uint64_t max_bytes) {
  const auto refuse = [max_bytes] {
    throw Error(Code::kTooLarge, "the request's body is longer than the " +
                                     std::to_string(max_bytes) + " bytes allowed here");
  };
  std::string body;
  if (!request.has_body) return body;
  if (request.content_length && *request.content_length > max_bytes) refuse();
  if (request.content_length) body.reserve(*request.content_length);
  request.read_body([&](std::string_view piece) {
    if (body.size() + piece.size() > max_bytes) refuse();
    body += piece;
  });
  return body;
}

std::uint64_t BodyLength(const Response& response) {
  if (const auto* text = std::get_if<std::string>(&response.body)) return text->size();
  if (const auto* file = std::get_if<FileBody>(&response.body)) return file->length;
  if (const auto* stream = std::get_if<StreamBody>(&response.body)) return stream->length;
  return 0;
}

std::string ProduceWhole(const Response& response) {
  class TextSink : public OpenSink {
   public:
    void Write(std::string_view bytes) override { text += bytes; }
    void Flush() override {}
    std::stop_token gone() override { return {}; }
    std::string text;
  };
  if (const auto* text = std::get_if<std::string>(&response.body)) return *text;
  const auto* open = std::get_if<OpenBody>(&response.body);
  if (open == nullptr) throw Error(Code::kInternal, "the body is no text");
  TextSink sink;
  open->produce(sink);
  return sink.text;
}

}  // namespace lares::http
