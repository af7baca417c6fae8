#include "ontology/triples/cursor.h"

#include <utility>

namespace lares::rdf {

Cursor::Cursor(std::shared_ptr<const View> view, const Pattern& pattern, Origin origin)
    : view_(std::move(view)), pattern_(pattern), origin_(origin) {
  if (view_->equality() == nullptr) return;
  collected_ = view_->Match(pattern_, origin_);
  rest_ = collected_;
  next_layer_ = view_->layers().size();
}

bool Cursor::IsAnswer(const Triple& triple) const {
  if (origin_ == Origin::kAsserted) return view_->IsAsserted(triple);
  return !view_->has_literal_subjects() ||
         view_->dictionary().Kind(triple.subject) != TermKind::kLiteral;
}

bool Cursor::Next(Triple* triple) {
  while (true) {
    while (!rest_.empty()) {
      const Triple& candidate = rest_.front();
      rest_ = rest_.subspan(1);
      if (view_->equality() == nullptr && !IsAnswer(candidate)) continue;
      *triple = candidate;
      return true;
    }
    if (next_layer_ == view_->layers().size()) return false;
    rest_ = view_->layers()[next_layer_++]->Range(pattern_);
  }
}

}  // namespace lares::rdf
