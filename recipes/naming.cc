#include "recipes/naming.h"

#include <cctype>

#include "base/text.h"

namespace lares::recipes {

namespace {

std::string Label(const rdf::View& view, const std::string& iri) {
  const auto id = view.dictionary().FindIri(iri);
  return id ? view.Label(*id) : std::string(LocalName(iri));
}

std::string AsWritten(const rdf::View& view, const std::string& iri) {
  const auto id = view.dictionary().FindIri(iri);
  return id ? view.AsWritten(*id) : iri;
}

std::string Part(const rdf::View& view, const prolog::Value& part) {
  const auto* compound = std::get_if<prolog::Compound>(&part.data);
  if (compound == nullptr) return part.text();
  const std::string& iri = compound->arguments.at(0).text();
  if (compound->name == "label") return Label(view, iri);
  if (compound->name == "phrase") return Phrase(iri);
  return "'" + Label(view, iri) + "' <" + AsWritten(view, iri) + ">";
}

}  // namespace

Resource MakeResource(const rdf::View& view, const std::string& iri) {
  if (iri.empty()) return {};
  return {iri, Label(view, iri), AsWritten(view, iri)};
}

std::vector<Resource> MakeResources(const rdf::View& view, const prolog::Value& iris) {
  std::vector<Resource> resources;
  for (const prolog::Value& iri : iris.list()) resources.push_back(MakeResource(view, iri.text()));
  return resources;
}

std::string MakeSentence(const rdf::View& view, const prolog::Value& sentence) {
  const auto* parts = std::get_if<prolog::List>(&sentence.data);
  if (parts == nullptr) return Part(view, sentence);
  std::string text;
  for (const prolog::Value& part : *parts) text += Part(view, part);
  return text;
}

std::vector<std::string> MakeSentences(const rdf::View& view, const prolog::Value& sentences) {
  std::vector<std::string> texts;
  for (const prolog::Value& sentence : sentences.list()) {
    texts.push_back(MakeSentence(view, sentence));
  }
  return texts;
}

std::string Phrase(std::string_view iri) {
  std::string_view name = LocalName(iri);
  if (const auto dash = name.find('-'); dash != std::string_view::npos && dash > 0) {
    name = name.substr(0, dash);
  }
  std::string words;
  for (const char c : name) {
    const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (upper && !words.empty() && words.back() != ' ') words += ' ';
    words += c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return words;
}

}  // namespace lares::recipes
