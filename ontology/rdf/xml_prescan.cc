#include "ontology/rdf/xml_prescan.h"

#include <libxml/SAX2.h>
#include <libxml/entities.h>
#include <libxml/parser.h>
#include <libxml/parserInternals.h>
#include <libxml/xmlerror.h>

#include <algorithm>
#include <climits>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "base/text.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::rdf {
namespace {

constexpr std::size_t kMostWarnings = 100;
constexpr std::string_view kXInclude = "http://www.w3.org/2001/XInclude";

std::string_view ViewOf(const xmlChar* text) {
  return text == nullptr ? std::string_view() : reinterpret_cast<const char*>(text);
}

// The text that an entity stands for, after those within it are expanded; saturates at `limit`.
class EntitySizes {
 public:
  explicit EntitySizes(std::size_t limit) : limit_(limit) {}

  void Declare(std::string_view name, std::string_view value) {
    values_.emplace(name, value);  // the first declaration binds
  }
  std::size_t SizeOf(const std::string& name, int depth = 0);
  // The entity's own text, without what its references expand to.
  std::size_t OwnSizeOf(const std::string& name) const {
    const auto value = values_.find(name);
    return value == values_.end() ? 0 : value->second.size();
  }

 private:
  static constexpr int kDeepest = 64;

  std::size_t limit_;
  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, std::size_t, std::less<>> sizes_;
};

std::size_t EntitySizes::SizeOf(const std::string& name, int depth) {
  if (const auto known = sizes_.find(name); known != sizes_.end()) return known->second;
  const auto value = values_.find(name);
  if (value == values_.end()) return 0;
  if (depth > kDeepest) return limit_;
  sizes_[name] = limit_;  // what a reference to itself expands to
  std::size_t size = value->second.size();
  std::string_view rest = value->second;
  for (std::size_t at; (at = rest.find('&')) != std::string_view::npos;) {
    rest.remove_prefix(at + 1);
    const std::size_t end = rest.find(';');
    if (end == std::string_view::npos) break;
    size = std::min(limit_, size + SizeOf(std::string(rest.substr(0, end)), depth + 1));
  }
  return sizes_[name] = size;
}

struct XmlPass {
  std::string_view bytes;
  const ReadOptions& options;
  xmlParserCtxtPtr context = nullptr;
  EntitySizes entities;
  std::vector<std::string> languages;  // xml:lang in scope, for each open element
  std::size_t expanded_bytes = 0;
  std::exception_ptr fault;
  XmlSummary summary;
  const XmlEvents* events = nullptr;

  Place Here() const {
    // Inside an entity: the place of the reference.
    const xmlParserInputPtr input = context->inputNr > 0 ? context->inputTab[0] : context->input;
    if (input == nullptr) return {options.source, 0, 0};
    return {options.source, input->line, input->col};
  }
  void Stop(const Error& error) { StopWith(std::make_exception_ptr(error)); }
  void StopWith(std::exception_ptr exception) {
    if (fault) return;
    fault = std::move(exception);
    xmlStopParser(context);
  }
  // Nothing may be thrown through libxml2.
  template <typename Call>
  void Tell(Call&& call) {
    if (events == nullptr || fault) return;
    try {
      call(*events);
    } catch (...) {
      StopWith(std::current_exception());
    }
  }
  void Refuse(Code code, const std::string& message) { Stop(Error(code, message, Here())); }
};

XmlPass& PassOf(void* data) {
  return *static_cast<XmlPass*>(static_cast<xmlParserCtxtPtr>(data)->_private);
}

Code CodeOf(const xmlError& error) {
  const std::string_view message = error.message == nullptr ? "" : error.message;
  const bool is_limit = error.code == XML_ERR_ENTITY_LOOP || error.code == XML_ERR_NAME_TOO_LONG ||
                        message.find("XML_PARSE_HUGE") != std::string_view::npos ||
                        message.find("too long") != std::string_view::npos;
  return is_limit ? Code::kTooLarge : Code::kInvalid;
}

// libxml2 calls a namespace that is no URI an error; RDF takes any string.
bool IsOnlyOdd(const xmlError& error) {
  return error.domain == XML_FROM_NAMESPACE &&
         (error.code == XML_WAR_NS_URI || error.code == XML_WAR_NS_URI_RELATIVE);
}

// libxml2 names the end of the document; the comment's beginning says more.
Place PlaceOfOpenComment(const XmlPass& pass) {
  const std::size_t last_end = pass.bytes.rfind("-->");
  const std::size_t from = last_end == std::string_view::npos ? 0 : last_end + 3;
  return PlaceAt(pass.bytes, std::min(pass.bytes.find("<!--", from), pass.bytes.size()),
                 pass.options.source);
}

void OnError(void* data, xmlErrorPtr error) {
  XmlPass& pass = PassOf(data);
  if (error == nullptr || pass.fault) return;
  std::string message(Trim(error->message == nullptr ? "not well-formed" : error->message));
  while (!IsUtf8(message)) message.pop_back();
  const Place place = error->code == XML_ERR_COMMENT_NOT_FINISHED
                          ? PlaceOfOpenComment(pass)
                          : Place{pass.options.source, error->line, error->int2};
  if (error->level >= XML_ERR_ERROR && !IsOnlyOdd(*error)) {
    pass.Stop(Error(CodeOf(*error), message, place));
  } else if (pass.summary.warnings.size() < kMostWarnings) {
    pass.summary.warnings.push_back({Remark::Kind::kWarning, place, message});
  }
}

void OnInternalSubset(void* data, const xmlChar* name, const xmlChar* public_id,
                      const xmlChar* system_id) {
  XmlPass& pass = PassOf(data);
  if (public_id != nullptr || system_id != nullptr) {
    pass.Refuse(Code::kUnsupported,
                "a document type from outside, " +
                    Quoted(ViewOf(system_id != nullptr ? system_id : public_id)) +
                    ", is never read");
    return;
  }
  xmlSAX2InternalSubset(data, name, public_id, system_id);
}

void OnEntity(void* data, const xmlChar* name, int type, const xmlChar* public_id,
              const xmlChar* system_id, xmlChar* content) {
  XmlPass& pass = PassOf(data);
  if (public_id != nullptr || system_id != nullptr) {
    pass.Refuse(Code::kUnsupported,
                "the external entity " + Quoted(ViewOf(name)) + " is never read");
    return;
  }
  if (type == XML_INTERNAL_GENERAL_ENTITY) pass.entities.Declare(ViewOf(name), ViewOf(content));
  xmlSAX2EntityDecl(data, name, type, public_id, system_id, content);
}

void OnUnparsedEntity(void* data, const xmlChar* name, const xmlChar*, const xmlChar*,
                      const xmlChar*) {
  PassOf(data).Refuse(Code::kUnsupported,
                      "the external entity " + Quoted(ViewOf(name)) + " is never read");
}

xmlEntityPtr OnReference(void* data, const xmlChar* name) {
  XmlPass& pass = PassOf(data);
  const std::string entity(ViewOf(name));
  const std::size_t limit = pass.options.max_entity_bytes;
  pass.expanded_bytes += pass.entities.OwnSizeOf(entity);
  if (pass.entities.SizeOf(entity) > limit || pass.expanded_bytes > limit) {
    pass.Refuse(Code::kTooLarge, "with the entity " + Quoted(entity) +
                                     " the document expands to more than " + std::to_string(limit) +
                                     " bytes of entity text");
    return nullptr;
  }
  return xmlSAX2GetEntity(data, name);
}

// As libxml2 gives it: five pointers for each attribute.
struct AttributeView {
  std::string_view local, prefix, space, value;
};

AttributeView AttributeAt(const xmlChar** attributes, int index) {
  const xmlChar** a = attributes + index * 5;
  return {ViewOf(a[0]),
          ViewOf(a[1]),
          ViewOf(a[2]),
          {reinterpret_cast<const char*>(a[3]), static_cast<std::size_t>(a[4] - a[3])}};
}

// RDF/XML of 1999; Raptor passes over them in silence.
bool IsWithdrawn(const AttributeView& attribute) {
  return attribute.space == kRdf &&
         (attribute.local == "aboutEach" || attribute.local == "aboutEachPrefix" ||
          attribute.local == "bagID");
}

// Where the tag begins that libxml2 has just read up to its '>'. Not known inside an entity and
// where the text is transcoded.
std::size_t OffsetOfTag(const XmlPass& pass) {
  const xmlParserInputPtr input = pass.context->input;
  if (input == nullptr || pass.context->inputNr != 1) return XmlElement::kNoOffset;
  if (input->buf != nullptr && input->buf->encoder != nullptr) return XmlElement::kNoOffset;
  const std::size_t at = static_cast<std::size_t>(input->consumed) +
                         static_cast<std::size_t>(input->cur - input->base);
  return at > pass.bytes.size() ? XmlElement::kNoOffset : pass.bytes.rfind('<', at);
}

void TellStart(XmlPass& pass, std::string_view name, std::string_view space,
               const xmlChar** attributes, int count) {
  pass.Tell([&](const XmlEvents& events) {
    XmlElement element{space, name, {}, pass.languages.back(), pass.Here(), OffsetOfTag(pass)};
    for (int i = 0; i < count; ++i) {
      const AttributeView attribute = AttributeAt(attributes, i);
      element.attributes.push_back({attribute.prefix, attribute.local, attribute.value});
    }
    events.start(element);
  });
}

void OnText(void* data, const xmlChar* text, int length) {
  PassOf(data).Tell([&](const XmlEvents& events) {
    events.text({reinterpret_cast<const char*>(text), static_cast<std::size_t>(length)});
  });
}

void EnterLanguage(XmlPass& pass, const xmlChar** attributes, int count) {
  pass.languages.push_back(pass.languages.empty() ? std::string() : pass.languages.back());
  for (int i = 0; i < count; ++i) {
    const AttributeView attribute = AttributeAt(attributes, i);
    if (attribute.prefix == "xml" && attribute.local == "lang") {
      pass.languages.back() = attribute.value;
    }
  }
}

void OnStart(void* data, const xmlChar* name, const xmlChar*, const xmlChar* space, int,
             const xmlChar**, int count, int, const xmlChar** attributes) {
  XmlPass& pass = PassOf(data);
  EnterLanguage(pass, attributes, count);
  const std::string& language = pass.languages.back();
  for (int i = 0; i < count; ++i) {
    const AttributeView attribute = AttributeAt(attributes, i);
    if (attribute.prefix == "xml") {
      if (attribute.local == "base" && pass.languages.size() == 1) {
        pass.summary.base_iri = attribute.value.substr(0, attribute.value.find('#'));
      }
    } else if (IsWithdrawn(attribute)) {
      pass.Refuse(Code::kInvalid,
                  "rdf:" + std::string(attribute.local) + " is no longer part of RDF/XML");
    } else if (!language.empty() && !attribute.space.empty()) {
      std::string predicate = std::string(attribute.space) + std::string(attribute.local);
      pass.summary.tagged_attributes.push_back(
          {pass.Here().line, std::move(predicate), std::string(attribute.value), language});
    }
  }
  if (pass.languages.size() > static_cast<std::size_t>(pass.options.max_depth)) {
    pass.Refuse(Code::kTooLarge,
                "elements nest deeper than " + std::to_string(pass.options.max_depth));
  } else if (ViewOf(space) == kXInclude) {
    pass.Refuse(Code::kUnsupported, "XInclude is not followed");
  }
  TellStart(pass, ViewOf(name), ViewOf(space), attributes, count);
}

void OnEnd(void* data, const xmlChar*, const xmlChar*, const xmlChar*) {
  XmlPass& pass = PassOf(data);
  pass.languages.pop_back();
  pass.Tell([](const XmlEvents& events) { events.end(); });
}

xmlSAXHandler Handlers() {
  xmlSAXHandler handlers{};
  handlers.initialized = XML_SAX2_MAGIC;
  handlers.startDocument = &xmlSAX2StartDocument;
  handlers.internalSubset = &OnInternalSubset;
  handlers.entityDecl = &OnEntity;
  handlers.unparsedEntityDecl = &OnUnparsedEntity;
  handlers.getEntity = &OnReference;
  handlers.getParameterEntity = &xmlSAX2GetParameterEntity;
  handlers.startElementNs = &OnStart;
  handlers.endElementNs = &OnEnd;
  handlers.characters = &OnText;
  handlers.ignorableWhitespace = &OnText;
  handlers.cdataBlock = &OnText;
  handlers.serror = &OnError;
  return handlers;
}

struct ContextDeleter {
  void operator()(xmlParserCtxtPtr context) const {
    if (context->myDoc != nullptr) xmlFreeDoc(context->myDoc);
    xmlFreeParserCtxt(context);
  }
};

}  // namespace

XmlSummary CheckXml(std::string_view bytes, const ReadOptions& options, const XmlEvents* events) {
  if (Trim(bytes).empty()) {
    throw Error(Code::kInvalid, "the document is empty", {options.source, 1, 1});
  }
  if (bytes.size() > INT_MAX) {
    throw Error(Code::kTooLarge, "XML documents are read up to 2 GB", {options.source, 0, 0});
  }
  xmlInitParser();
  const std::unique_ptr<xmlParserCtxt, ContextDeleter> context(
      xmlCreateMemoryParserCtxt(bytes.data(), static_cast<int>(bytes.size())));
  if (!context) throw Error(Code::kUnavailable, "no memory for an XML parser");
  XmlPass pass{bytes, options, context.get(), EntitySizes(options.max_entity_bytes + 1), {}, 0,
               {},    {},      events};
  context->_private = &pass;
  *context->sax = Handlers();
  xmlCtxtUseOptions(context.get(), XML_PARSE_NONET | XML_PARSE_NOENT);
  xmlParseDocument(context.get());
  if (pass.fault) std::rethrow_exception(pass.fault);
  if (context->wellFormed == 0) {
    throw Error(Code::kInvalid, "the XML is not well-formed", pass.Here());
  }
  auto& tagged = pass.summary.tagged_attributes;
  std::stable_sort(tagged.begin(), tagged.end(), [](const auto& a, const auto& b) {
    return std::tie(a.line, a.predicate, a.value) < std::tie(b.line, b.predicate, b.value);
  });
  return std::move(pass.summary);
}

}  // namespace lares::rdf
