#include "ontology/triples/sorting.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace lares::rdf {
namespace {

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr std::size_t kShort = 4096;  // below it comparisons win

std::uint32_t Number(const Triple& triple, Component component) {
  return static_cast<std::uint32_t>(Get(triple, component));
}

// One pass of a radix sort, from `in` to `out`.
void CountingPass(Component component, int shift, const std::vector<Triple>& in,
                  std::vector<Triple>& out) {
  std::array<std::size_t, kDigits> begin{};
  for (const Triple& triple : in) ++begin[(Number(triple, component) >> shift) & (kDigits - 1)];
  std::size_t sum = 0;
  for (std::size_t& count : begin) {
    const std::size_t here = count;
    count = sum;
    sum += here;
  }
  for (const Triple& triple : in) {
    out[begin[(Number(triple, component) >> shift) & (kDigits - 1)]++] = triple;
  }
}

// As StableSortBy. `other` is scratch, which sorts of one array share.
void SortBy(Component component, std::vector<Triple>& triples, std::vector<Triple>& other) {
  if (triples.size() < kShort) {
    std::stable_sort(triples.begin(), triples.end(), [component](const Triple& a, const Triple& b) {
      return Number(a, component) < Number(b, component);
    });
    return;
  }
  std::uint32_t largest = 0;
  for (const Triple& triple : triples) largest = std::max(largest, Number(triple, component));
  other.resize(triples.size());
  for (int shift = 0; shift < 32 && largest >> shift != 0; shift += kDigitBits) {
    CountingPass(component, shift, triples, other);
    triples.swap(other);
  }
}

}  // namespace

void StableSortBy(Component component, std::vector<Triple>& triples) {
  std::vector<Triple> other;
  SortBy(component, triples, other);
}

void SortAndDeduplicate(std::vector<Triple>& triples) {
  if (!std::is_sorted(triples.begin(), triples.end())) {
    if (triples.size() < kShort) {
      std::sort(triples.begin(), triples.end());
    } else {
      std::vector<Triple> other;
      SortBy(Component::kObject, triples, other);
      SortBy(Component::kPredicate, triples, other);
      SortBy(Component::kSubject, triples, other);
    }
  }
  triples.erase(std::unique(triples.begin(), triples.end()), triples.end());
}

}  // namespace lares::rdf
