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

#include "base/text.h"
#include "ontology/rdf/term_checks.h"

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
  const ReadOptions& options;
  xmlParserCtxtPtr context = nullptr;
  EntitySizes entities;
  int depth = 0;
  std::size_t expanded_bytes = 0;
  std::optional<Error> fault;
  XmlSummary summary;

  Place Here() const {
    // Inside an entity: the place of the reference.
    const xmlParserInputPtr input = context->inputNr > 0 ? context->inputTab[0] : context->input;
    if (input == nullptr) return {options.source, 0, 0};
    return {options.source, input->line, input->col};
  }
  void Stop(const Error& error) {
    if (fault) return;
    fault = error;
    xmlStopParser(context);
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

void OnError(void* data, xmlErrorPtr error) {
  XmlPass& pass = PassOf(data);
  if (error == nullptr || pass.fault) return;
  std::string message(Trim(error->message == nullptr ? "not well-formed" : error->message));
  while (!IsUtf8(message)) message.pop_back();
  const Place place{pass.options.source, error->line, error->int2};
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

// Five pointers for each attribute: local name, prefix, namespace, begin and end of its value.
std::string BaseAmong(const xmlChar** attributes, int count) {
  for (int i = 0; i < count; ++i, attributes += 5) {
    if (ViewOf(attributes[0]) != "base" || ViewOf(attributes[1]) != "xml") continue;
    const std::string_view value(reinterpret_cast<const char*>(attributes[3]),
                                 static_cast<std::size_t>(attributes[4] - attributes[3]));
    return std::string(value.substr(0, value.find('#')));
  }
  return {};
}

void OnStart(void* data, const xmlChar*, const xmlChar*, const xmlChar* space, int, const xmlChar**,
             int attribute_count, int, const xmlChar** attributes) {
  XmlPass& pass = PassOf(data);
  if (pass.depth == 0) pass.summary.base_iri = BaseAmong(attributes, attribute_count);
  if (++pass.depth > pass.options.max_depth) {
    pass.Refuse(Code::kTooLarge,
                "elements nest deeper than " + std::to_string(pass.options.max_depth));
  } else if (ViewOf(space) == kXInclude) {
    pass.Refuse(Code::kUnsupported, "XInclude is not followed");
  }
}

void OnEnd(void* data, const xmlChar*, const xmlChar*, const xmlChar*) { --PassOf(data).depth; }

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

XmlSummary CheckXml(std::string_view bytes, const ReadOptions& options) {
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
  XmlPass pass{options, context.get(), EntitySizes(options.max_entity_bytes + 1), 0, 0, {}, {}};
  context->_private = &pass;
  *context->sax = Handlers();
  xmlCtxtUseOptions(context.get(), XML_PARSE_NONET | XML_PARSE_NOENT);
  xmlParseDocument(context.get());
  if (pass.fault) throw *pass.fault;
  if (context->wellFormed == 0) {
    throw Error(Code::kInvalid, "the XML is not well-formed", pass.Here());
  }
  return std::move(pass.summary);
}

}  // namespace lares::rdf
