#include <array>
#include <optional>

#include "base/text.h"
#include "ontology/rdf/document.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

struct Row {
  std::string_view key;
  Format format;
};

constexpr std::array<Row, 13> kMediaTypes = {
    {{"application/rdf+xml", Format::kRdfXml},
     {"application/xml", Format::kRdfXml},
     {"text/xml", Format::kRdfXml},
     {"text/turtle", Format::kTurtle},
     {"application/x-turtle", Format::kTurtle},
     {"application/trig", Format::kTriG},
     {"application/x-trig", Format::kTriG},
     {"application/n-triples", Format::kNTriples},
     {"application/n-quads", Format::kNQuads},
     {"application/ld+json", Format::kJsonLd},
     {"text/owl-functional", Format::kOwlFunctional},
     {"application/owl-functional", Format::kOwlFunctional},
     {"application/owl+xml", Format::kOwlXml}}};

constexpr std::array<Row, 12> kExtensions = {{{".rdf", Format::kRdfXml},
                                              {".xml", Format::kRdfXml},
                                              {".rdfs", Format::kRdfXml},
                                              {".ttl", Format::kTurtle},
                                              {".trig", Format::kTriG},
                                              {".nt", Format::kNTriples},
                                              {".nq", Format::kNQuads},
                                              {".jsonld", Format::kJsonLd},
                                              {".json", Format::kJsonLd},
                                              {".ofn", Format::kOwlFunctional},
                                              {".owx", Format::kOwlXml},
                                              {".owlxml", Format::kOwlXml}}};

// Types that clients send when they do not know.
constexpr std::array<std::string_view, 3> kVagueTypes = {"application/octet-stream", "text/plain",
                                                         "application/x-www-form-urlencoded"};

bool StartsWithWord(std::string_view text, std::string_view word) {
  return ToLower(text.substr(0, word.size())) == word &&
         (text.size() == word.size() || text[word.size()] <= ' ' || text[word.size()] == '<' ||
          text[word.size()] == '{');
}

std::string_view SkipBlank(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  for (;;) {
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos) return {};
    text.remove_prefix(start);
    if (text[0] != '#') return text;
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end);
  }
}

// "<name ", "<p:name>", "<?xml", "<!--": markup and not an IRI.
bool IsMarkup(std::string_view text) {
  if (text.size() < 2 || text[0] != '<') return false;
  if (text[1] == '?' || text[1] == '!') return true;
  const std::size_t end = text.find_first_of("> \t\r\n");
  if (end == std::string_view::npos || end < 2) return false;
  const std::string_view name = text.substr(1, end - 1);
  if (text[end] != '>') return name.find('/') == std::string_view::npos;
  return name == "rdf:RDF" || name == "RDF";
}

// What comes after the declaration, comments and document type of an XML text.
std::string_view RootOf(std::string_view text) {
  while (text.size() > 1 && text[0] == '<' && (text[1] == '?' || text[1] == '!')) {
    const bool is_comment = text.starts_with("<!--");
    std::size_t end = text.find(is_comment ? "-->" : ">");
    if (!is_comment && text.substr(0, end).find('[') != std::string_view::npos) {
      end = text.find("]>");  // a document type with declarations of its own
    }
    if (end == std::string_view::npos) return {};
    text.remove_prefix(text.find('>', end) + 1);
    text.remove_prefix(std::min(text.find('<'), text.size()));
  }
  return text;
}

// "Ontology" of OWL's namespace, whatever its prefix.
bool IsOwlXml(std::string_view text) {
  const std::string_view root = RootOf(text);
  const std::string_view tag = root.substr(0, root.find('>'));
  const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n"));
  return (name == "<Ontology" || name.ends_with(":Ontology")) &&
         tag.find(kOwl) != std::string_view::npos;
}

// "Prefix(", "Ontology (".
bool IsOwlFunctional(std::string_view text) {
  for (const std::string_view word : {"Prefix", "Ontology"}) {
    if (!text.starts_with(word)) continue;
    const std::size_t next = text.find_first_not_of(" \t\r\n", word.size());
    if (next != std::string_view::npos && text[next] == '(') return true;
  }
  return false;
}

// "{" and a key, or "[" and an object: no Turtle, and no graph of TriG.
bool IsJson(std::string_view text) {
  if (text[0] != '{' && text[0] != '[') return false;
  const std::size_t next = text.find_first_not_of(" \t\r\n", 1);
  return next != std::string_view::npos && text[next] == (text[0] == '{' ? '"' : '{');
}

std::optional<Format> FromBytes(std::string_view bytes) {
  const std::string_view text = SkipBlank(bytes.substr(0, 1 << 16));
  if (text.empty()) return std::nullopt;
  if (IsOwlFunctional(text)) return Format::kOwlFunctional;
  if (IsMarkup(text)) return IsOwlXml(text) ? Format::kOwlXml : Format::kRdfXml;
  if (IsJson(text)) return Format::kJsonLd;
  if (text[0] == '{' || StartsWithWord(text, "graph")) return Format::kTriG;
  if (StartsWithWord(text, "@prefix") || StartsWithWord(text, "@base") ||
      StartsWithWord(text, "prefix") || StartsWithWord(text, "base") || text[0] == '<' ||
      text[0] == '[' || text.starts_with("_:")) {
    return Format::kTurtle;
  }
  return std::nullopt;
}

[[noreturn]] void Refuse(const std::string& why) {
  throw Error(Code::kUnsupported, why)
      .WithHint(
          "RDF/XML (.owl, .rdf), Turtle (.ttl), TriG (.trig), N-Triples (.nt), N-Quads (.nq), "
          "JSON-LD "
          "(.jsonld), OWL functional syntax (.ofn) and OWL/XML (.owx) are read");
}

// A syntax of OWL that is not read, whatever it was sent as.
void RefuseManchesterSyntax(std::string_view bytes) {
  const std::string_view text = SkipBlank(bytes.substr(0, 1 << 16));
  if (text.starts_with("Prefix:") || text.starts_with("Ontology:")) {
    Refuse("this is OWL Manchester syntax, which is not read: convert it to RDF/XML or Turtle");
  }
}

// What is said to be RDF/XML, or just XML, may be one of OWL's own syntaxes.
Format OfXml(Format named, std::string_view bytes) {
  const auto seen = FromBytes(bytes);
  return seen == Format::kOwlXml || seen == Format::kOwlFunctional ? *seen : named;
}

}  // namespace

std::string_view MediaType(Format format) {
  switch (format) {
    case Format::kRdfXml:
      return "application/rdf+xml";
    case Format::kTurtle:
      return "text/turtle";
    case Format::kTriG:
      return "application/trig";
    case Format::kNTriples:
      return "application/n-triples";
    case Format::kNQuads:
      return "application/n-quads";
    case Format::kOwlFunctional:
      return "text/owl-functional";
    case Format::kOwlXml:
      return "application/owl+xml";
    case Format::kJsonLd:
      return "application/ld+json";
  }
  return "application/octet-stream";
}

Format GuessFormat(std::string_view media_type, std::string_view file_name,
                   std::string_view bytes) {
  RefuseManchesterSyntax(bytes);
  const std::string type =
      ToLower(Trim(media_type.substr(0, std::min(media_type.find(';'), media_type.size()))));
  for (const Row& row : kMediaTypes) {
    if (type != row.key) continue;
    return row.format == Format::kRdfXml ? OfXml(row.format, bytes) : row.format;
  }
  bool is_vague = type.empty() || type == "*/*";
  for (const std::string_view vague : kVagueTypes) is_vague = is_vague || type == vague;
  if (!is_vague) Refuse("the media type '" + type + "' is not one of RDF");
  const std::string name = ToLower(file_name);
  // ".owl" says ontology, not syntax.
  if (name.ends_with(".owl")) return FromBytes(bytes).value_or(Format::kRdfXml);
  for (const Row& row : kExtensions) {
    if (!name.ends_with(row.key)) continue;
    return row.format == Format::kRdfXml ? OfXml(row.format, bytes) : row.format;
  }
  if (const auto format = FromBytes(bytes)) return *format;
  Refuse("the format of the document is not told by its name or its first bytes");
}

}  // namespace lares::rdf
