// What a request's bytes must look like before anything is made of them: two readers must not
// disagree on where a request ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace lares::http {

// For the request line, all fields and the empty line. Throws a ProblemError ("bad-request") for
// anything that is no field of RFC 9112, and for a body whose length is stated twice or unreadably.
void CheckRawHeader(std::string_view header);

// How long the body is whose client sends it without waiting to be asked, as a header with its
// empty line announces it. 0 for none, for one of unknown length, and for what cannot be read: the
// header is not checked here.
std::size_t AwaitedLength(std::string_view header);

// Follows a chunked body (without trailers) byte by byte.
class ChunkedBodyCheck {
 public:
  // False from the first byte on that does not belong there.
  bool Accept(std::string_view bytes);

 private:
  enum class Stage { kSize, kExtension, kSizeEnd, kData, kDataCr, kDataLf, kLastCr, kLastLf, kEnd };
  bool AcceptByte(char byte);
  bool AcceptSize(char byte);

  Stage stage_ = Stage::kSize;
  std::uint64_t size_ = 0;  // of the chunk; of what is left of it in kData
  int digits_ = 0;
  int extension_bytes_ = 0;
  bool refused_ = false;
};

}  // namespace lares::http
