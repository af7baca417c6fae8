#include "ontology/rdf/xml_fragment.h"

#include <libxml/xmlreader.h>

#include <limits>
#include <memory>
#include <string>

namespace lares::rdf {

bool IsXmlFragment(std::string_view text) {
  const std::string document = "<x>" + std::string(text) + "</x>";
  if (document.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return false;
  const std::unique_ptr<xmlTextReader, decltype(&xmlFreeTextReader)> reader(
      xmlReaderForMemory(document.data(), static_cast<int>(document.size()), nullptr, "UTF-8",
                         XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING),
      &xmlFreeTextReader);
  if (!reader) return false;
  int result = 1;
  int roots = 0;
  while ((result = xmlTextReaderRead(reader.get())) == 1) {
    if (xmlTextReaderDepth(reader.get()) == 0 &&
        xmlTextReaderNodeType(reader.get()) == XML_READER_TYPE_ELEMENT) {
      ++roots;
    }
  }
  return result == 0 && roots == 1;
}

}  // namespace lares::rdf
