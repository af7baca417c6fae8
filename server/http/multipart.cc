#include "server/http/multipart.h"

#include <map>
#include <optional>

#include "base/error.h"
#include "base/text.h"
#include "server/http/media_type.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

[[noreturn]] void Malformed(const std::string& what) {
  throw ProblemError("bad-request", "malformed multipart/form-data: " + what);
}

// `form-data; name="a"; filename="b\"c"` → its parameters. Nothing when malformed.
std::optional<std::map<std::string, std::string>> ParseDisposition(std::string_view text) {
  // The grammar is that of a media type once the leading word is one.
  const std::size_t end = std::min(text.find(';'), text.size());
  if (ToLower(Trim(text.substr(0, end))) != "form-data") return std::nullopt;
  auto parsed = ParseMediaType("form/data" + std::string(text.substr(end)));
  if (!parsed) return std::nullopt;
  return parsed->parameters;
}

PartHeader ParsePartHeader(std::string_view block) {
  PartHeader header;
  bool named = false;
  for (const std::string& line : Split(block, '\n')) {
    const std::string_view field = Trim(line);
    if (field.empty()) continue;
    const std::size_t colon = field.find(':');
    if (colon == std::string_view::npos) Malformed("a part's header line has no ':'");
    const std::string name = ToLower(Trim(field.substr(0, colon)));
    const std::string_view value = Trim(field.substr(colon + 1));
    if (name == "content-type") header.content_type = std::string(value);
    if (name != "content-disposition") continue;
    const auto parameters = ParseDisposition(value);
    if (!parameters) Malformed("a part's Content-Disposition cannot be read");
    if (const auto found = parameters->find("name"); found != parameters->end()) {
      header.name = found->second;
      named = true;
    }
    if (const auto found = parameters->find("filename"); found != parameters->end()) {
      header.file_name = SafeFileName(found->second);
    }
  }
  if (!named || header.name.empty()) Malformed("a part has no name");
  return header;
}

}  // namespace

std::string MultipartBoundary(std::string_view content_type) {
  const auto media = ParseMediaType(content_type);
  if (!media || media->type != "multipart/form-data") {
    throw Error(Code::kUnsupported, "the body must be multipart/form-data");
  }
  const auto boundary = media->parameters.find("boundary");
  if (boundary == media->parameters.end() || boundary->second.empty() ||
      boundary->second.size() > 70) {
    throw ProblemError("bad-request", "the Content-Type states no boundary of 1 to 70 characters");
  }
  return boundary->second;
}

std::string SafeFileName(std::string_view sent) {
  const std::size_t slash = sent.find_last_of("/\\");
  std::string name(slash == std::string_view::npos ? sent : sent.substr(slash + 1));
  std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (name == "." || name == "..") return "";
  while (name.size() > 255 || !IsUtf8(name)) {
    if (name.empty()) break;
    name.pop_back();
  }
  return name;
}

MultipartParser::MultipartParser(std::string boundary, MultipartHandler handler,
                                 MultipartLimits limits)
    : delimiter_("\r\n--" + std::move(boundary)),
      handler_(std::move(handler)),
      limits_(limits),
      buffer_("\r\n") {}  // so that a boundary at the very start is found like any other

void MultipartParser::Feed(std::string_view bytes) {
  buffer_ += bytes;
  while (Step()) {
  }
}

void MultipartParser::Finish() {
  if (stage_ != Stage::kEpilogue) Malformed("it ends before its closing boundary");
}

bool MultipartParser::Step() {
  switch (stage_) {
    case Stage::kPreamble:
      return StepPreamble();
    case Stage::kAfterBoundary:
      return StepAfterBoundary();
    case Stage::kHeader:
      return StepHeader();
    case Stage::kData:
      return StepData();
    case Stage::kEpilogue:
      buffer_.clear();
      return false;
  }
  return false;
}

bool MultipartParser::StepPreamble() {
  const std::size_t found = buffer_.find(delimiter_);
  if (found == std::string::npos) {
    if (buffer_.size() > limits_.max_header_bytes) Malformed("its boundary never appears");
    return false;
  }
  buffer_.erase(0, found + delimiter_.size());
  stage_ = Stage::kAfterBoundary;
  return true;
}

bool MultipartParser::StepAfterBoundary() {
  // "--" closes; else optional blanks and a line end open the next part.
  if (buffer_.size() >= 2 && buffer_.compare(0, 2, "--") == 0) {
    stage_ = Stage::kEpilogue;
    return true;
  }
  const std::size_t end = buffer_.find("\r\n");
  if (end == std::string::npos) {
    if (buffer_.size() > 256) Malformed("text follows a boundary");
    return false;
  }
  if (!Trim(std::string_view(buffer_).substr(0, end)).empty()) Malformed("text follows a boundary");
  if (++parts_ > limits_.max_parts) {
    throw Error(Code::kTooLarge,
                "the form has more than " + std::to_string(limits_.max_parts) + " parts");
  }
  buffer_.erase(0, end);  // keeps "\r\n", so that a part without headers has its empty line too
  stage_ = Stage::kHeader;
  return true;
}

bool MultipartParser::StepHeader() {
  const std::size_t end = buffer_.find("\r\n\r\n");
  if (std::min(end, buffer_.size()) > limits_.max_header_bytes) {
    throw Error(Code::kTooLarge, "the header of a part is longer than " +
                                     std::to_string(limits_.max_header_bytes) + " bytes");
  }
  if (end == std::string::npos) return false;
  const PartHeader header = ParsePartHeader(std::string_view(buffer_).substr(0, end));
  buffer_.erase(0, end + 4);
  stage_ = Stage::kData;
  handler_.begin(header);
  return true;
}

bool MultipartParser::StepData() {
  const std::size_t found = buffer_.find(delimiter_);
  if (found == std::string::npos) {
    // The last bytes may be the beginning of a boundary.
    if (buffer_.size() < delimiter_.size()) return false;
    const std::size_t safe = buffer_.size() - (delimiter_.size() - 1);
    handler_.data(std::string_view(buffer_).substr(0, safe));
    buffer_.erase(0, safe);
    return false;
  }
  if (found > 0) handler_.data(std::string_view(buffer_).substr(0, found));
  handler_.end();
  buffer_.erase(0, found + delimiter_.size());
  stage_ = Stage::kAfterBoundary;
  return true;
}

void ReadMultipart(const Request& request, const MultipartHandler& handler,
                   const MultipartLimits& limits) {
  MultipartParser parser(MultipartBoundary(request.headers.Get("Content-Type")), handler, limits);
  request.read_body([&](std::string_view piece) { parser.Feed(piece); });
  parser.Finish();
}

}  // namespace lares::http
