#include "recipes/match/words.h"

#include <cstdio>

namespace lares::recipes {

namespace {

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

std::string Listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

std::string WithArticle(const std::string& name) {
  const bool vowel = !name.empty() && std::string("aeiouAEIOU").find(name[0]) != std::string::npos;
  return (vowel ? "an " : "a ") + name;
}

namespace {

std::string BoundText(const Measure& measure) {
  std::string text = WithArticle(measure.quantity.label);
  if (measure.at_least && measure.at_most) {
    return text + " between " + Number(*measure.at_least) + " and " + Number(*measure.at_most) +
           " " + measure.unit;
  }
  if (measure.at_least)
    return text + " of at least " + Number(*measure.at_least) + " " + measure.unit;
  return text + " of at most " + Number(measure.at_most.value_or(0)) + " " + measure.unit;
}

}  // namespace

std::string ShortText(const Measure& measure) {
  const bool too_little = measure.at_least && *measure.actual < *measure.at_least;
  std::string text = Number(*measure.actual) + " " + measure.unit + ", " +
                     Number(measure.short_by) + " " + measure.unit;
  if (measure.short_by_percent) {
    char percent[32];
    std::snprintf(percent, sizeof percent, " (%.0f %%)", *measure.short_by_percent);
    text += percent;
  }
  return text + (too_little ? " too little" : " too much");
}

std::string TextOf(const std::vector<Measure>& measures) {
  std::vector<std::string> texts;
  for (const Measure& measure : measures) texts.push_back(BoundText(measure));
  return Listed(texts);
}

}  // namespace lares::recipes
