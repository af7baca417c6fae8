// Content-Encoding: zstd (RFC 9110 §8.4, RFC 8878), both ways.
#pragma once

#include <string>
#include <string_view>

#include "server/http/message.h"

namespace lares::http {

// Whether the body may be sent as zstd: named in Accept-Encoding, with a quality above 0.
bool AcceptsZstd(std::string_view accept_encoding);

// Whether bodies of that type become much smaller.
bool IsCompressible(std::string_view media_type);

// Entity tags of the compressed form: "a" and "a-zstd". IdentityTag leaves other tags as they are.
std::string ZstdTag(const std::string& etag);
std::string IdentityTag(const std::string& etag);

// Whether this answer is to be sent as zstd: a whole one of a type that compresses, long enough,
// to a request that accepts it and asks for no range. Adds Vary where the request decides.
bool ChooseZstd(const Request& request, Response& response);
// The body compressed: at once when it is short, otherwise while it is sent.
void EncodeAsZstd(const Request& request, Response& response);

// Throws kUnsupported for another Content-Encoding than zstd.
void CheckContentEncoding(const Request& request);
// Whether the request's body is encoded.
bool IsZstd(const Request& request);
// Such a request with its body decoded while it is read, up to `max_bytes`.
Request Decoded(const Request& request, std::uint64_t max_bytes);

}  // namespace lares::http
