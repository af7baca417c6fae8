// The first byte chooses the size of the pieces, the rest is the body of a form with boundary "B".
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "server/http/multipart.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view body(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::size_t step = 1 + data[0] % 61;
  bool open = false;
  std::size_t given = 0;
  lares::http::MultipartParser parser("B", {[&](const lares::http::PartHeader& header) {
                                              if (open || header.name.empty()) std::abort();
                                              if (header.file_name.find('/') != std::string::npos)
                                                std::abort();
                                              open = true;
                                            },
                                            [&](std::string_view piece) {
                                              if (!open) std::abort();
                                              given += piece.size();
                                            },
                                            [&] {
                                              if (!open) std::abort();
                                              open = false;
                                            }});
  try {
    for (std::size_t at = 0; at < body.size(); at += step) parser.Feed(body.substr(at, step));
    parser.Finish();
    if (open) std::abort();
  } catch (const lares::Error&) {
  }
  if (given > body.size()) std::abort();
  return 0;
}
