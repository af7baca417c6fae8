// multipart/form-data (RFC 7578), read while it arrives and written while it is sent.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"

namespace lares::http {

struct PartHeader {
  std::string name;
  std::string file_name;     // last component only, whatever path the client sent; "" for fields
  std::string content_type;  // "" when not stated
};

struct MultipartHandler {
  std::function<void(const PartHeader&)> begin;
  std::function<void(std::string_view)> data;  // any number of pieces
  std::function<void()> end;
};

struct MultipartLimits {
  std::size_t max_parts = 64;
  std::size_t max_header_bytes = 8192;  // of one part
};

// The boundary of a Content-Type header. Throws kUnsupported when it is not multipart/form-data,
// "bad-request" when the boundary is absent or not of 1–70 characters.
std::string MultipartBoundary(std::string_view content_type);

// A file name as a client sent it, made safe: no folders, no control characters, at most 255 bytes.
std::string SafeFileName(std::string_view sent);

// Feed() the body in pieces of any size, then Finish(). Holds at most a boundary's length and one
// part's header. Throws "bad-request" for a malformed body and kTooLarge for a limit; what the
// handler throws passes through. Not usable after a throw.
class MultipartParser {
 public:
  MultipartParser(std::string boundary, MultipartHandler handler, MultipartLimits limits = {});
  void Feed(std::string_view bytes);
  // Throws unless the closing boundary was seen.
  void Finish();

 private:
  enum class Stage { kPreamble, kAfterBoundary, kHeader, kData, kEpilogue };
  bool Step();
  bool StepPreamble();
  bool StepAfterBoundary();
  bool StepHeader();
  bool StepData();

  std::string delimiter_;  // "\r\n--boundary"
  MultipartHandler handler_;
  MultipartLimits limits_;
  Stage stage_ = Stage::kPreamble;
  std::string buffer_;
  std::size_t parts_ = 0;
};

// Reads a request's body as a form. Throws as MultipartParser and Request::read_body do.
void ReadMultipart(const Request& request, const MultipartHandler& handler,
                   const MultipartLimits& limits = {});

// One part to send: text, or a file that is read while it is sent.
struct FormPart {
  std::string name;
  std::string text;  // used when `file` is empty
  std::filesystem::path file;
  std::string file_name;     // "" for plain fields
  std::string content_type;  // "" leaves the header out
};

// The pieces of a form in order; the sum of their lengths is the body's.
struct FormPiece {
  std::string text;
  std::filesystem::path file;  // when not empty, this file's bytes instead of `text`
  std::uint64_t length = 0;
  std::uint64_t offset = 0;  // in the file
};
struct EncodedForm {
  std::string content_type;
  std::vector<FormPiece> pieces;
  std::uint64_t length = 0;
};
// Throws kIo for a file that cannot be read.
EncodedForm EncodeForm(const std::vector<FormPart>& parts);

}  // namespace lares::http
