#include "ontology/triples/cursor.h"

#include <utility>

namespace lares::rdf {

Cursor::Cursor(View view, const Pattern& pattern, Origin origin)
    : view_(std::move(view)), pattern_(pattern), origin_(origin) {}

bool Cursor::Next(Triple* triple) {
  while (true) {
    while (!rest_.empty()) {
      const Triple& candidate = rest_.front();
      rest_ = rest_.subspan(1);
      if (origin_ == Origin::kAsserted && !view_.IsAsserted(candidate)) continue;
      *triple = candidate;
      return true;
    }
    if (next_layer_ == view_.layers().size()) return false;
    rest_ = view_.layers()[next_layer_++]->Range(pattern_);
  }
}

}  // namespace lares::rdf
