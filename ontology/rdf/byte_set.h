// Sets of bytes, and fast search for one of them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace lares::rdf {

class ByteSet {
 public:
  explicit constexpr ByteSet(std::string_view bytes) {
    for (const char byte : bytes) has_[static_cast<unsigned char>(byte)] = true;
  }
  constexpr bool Has(char byte) const { return has_[static_cast<unsigned char>(byte)]; }
  // Where the first member at or after `from` is; the size of `text` when there is none.
  std::size_t Find(std::string_view text, std::size_t from) const {
    while (from < text.size() && !Has(text[from])) ++from;
    return from < text.size() ? from : text.size();
  }

 private:
  std::array<bool, 256> has_{};
};

}  // namespace lares::rdf
