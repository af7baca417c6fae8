#include <openssl/evp.h>

#include "reasoner/sparql/expression.h"

namespace lares::sparql {

using syntax::Op;

namespace {

const EVP_MD* Algorithm(Op op) {
  switch (op) {
    case Op::kMd5:
      return EVP_md5();
    case Op::kSha1:
      return EVP_sha1();
    case Op::kSha256:
      return EVP_sha256();
    case Op::kSha384:
      return EVP_sha384();
    default:
      return EVP_sha512();
  }
}

}  // namespace

Value CallHashFunction(Op op, Arguments arguments) {
  const Value& value = arguments[0];
  if (value.kind != Value::Kind::kString) return {};
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned size = 0;
  const std::string_view text = value.text();
  if (EVP_Digest(text.data(), text.size(), digest, &size, Algorithm(op), nullptr) != 1) return {};
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string hex;
  for (unsigned i = 0; i < size; ++i) {
    hex += kHex[digest[i] >> 4];
    hex += kHex[digest[i] & 15];
  }
  return MakeString(std::move(hex));
}

}  // namespace lares::sparql
