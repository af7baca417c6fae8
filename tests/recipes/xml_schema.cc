#include "tests/recipes/xml_schema.h"

#include <libxml/parser.h>
#include <libxml/xmlschemas.h>

#include <stdexcept>

namespace lares::testing {
namespace {

void Collect(void* to, xmlErrorPtr error) {
  static_cast<std::vector<std::string>*>(to)->push_back(std::to_string(error->line) + ": " +
                                                        error->message);
}

}  // namespace

struct XmlSchema::State {
  xmlSchemaPtr schema = nullptr;
};

XmlSchema::XmlSchema(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
  std::vector<std::string> faults;
  xmlSchemaParserCtxtPtr parser = xmlSchemaNewParserCtxt(file.c_str());
  xmlSchemaSetParserStructuredErrors(parser, Collect, &faults);
  state_->schema = xmlSchemaParse(parser);
  xmlSchemaFreeParserCtxt(parser);
  if (state_->schema == nullptr || !faults.empty()) {
    throw std::runtime_error(faults.empty() ? "no schema" : faults.front());
  }
}

XmlSchema::~XmlSchema() { xmlSchemaFree(state_->schema); }

std::vector<std::string> XmlSchema::Violations(const std::string& xml) const {
  xmlDocPtr document = xmlReadMemory(xml.data(), static_cast<int>(xml.size()), "plan.xml", nullptr,
                                     XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  if (document == nullptr) return {"it is not well-formed"};
  std::vector<std::string> violations;
  xmlSchemaValidCtxtPtr validator = xmlSchemaNewValidCtxt(state_->schema);
  xmlSchemaSetValidStructuredErrors(validator, Collect, &violations);
  const int result = xmlSchemaValidateDoc(validator, document);
  if (result != 0 && violations.empty()) violations.emplace_back("not valid");
  xmlSchemaFreeValidCtxt(validator);
  xmlFreeDoc(document);
  return violations;
}

}  // namespace lares::testing
