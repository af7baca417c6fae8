// What the headers of resumable uploads say (tus 1.0, https://tus.io/protocols/resumable-upload).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/time.h"
#include "server/http/message.h"

namespace lares::http {

inline constexpr std::string_view kTusVersion = "1.0.0";
inline constexpr std::string_view kTusExtensions =
    "creation,creation-with-upload,expiration,checksum,termination";
inline constexpr std::size_t kMaxUploadMetadataBytes = 4096;

// Strict (RFC 4648 §4, with padding). Nothing when malformed.
std::optional<std::string> DecodeBase64(std::string_view text);

// A whole number of decimal digits. Throws "bad-request" when absent, malformed or beyond 2^63 - 1.
std::uint64_t ReadUploadNumber(const Request& request, std::string_view header);

// Pairs of a key and, in Base64, a value that may be empty. Throws "bad-request" for what is
// malformed, has a key twice or is longer than kMaxUploadMetadataBytes.
std::map<std::string, std::string> ParseUploadMetadata(std::string_view header);

// The SHA-256 of a piece, in hexadecimal; nothing when the header is empty. Throws "bad-request"
// for another algorithm and for what is no such hash.
std::optional<std::string> ParseUploadChecksum(std::string_view header);

// "Sat, 28 Nov 2026 12:15:00 GMT" (RFC 9110 §5.6.7).
std::string FormatHttpDate(Time time);

}  // namespace lares::http
