#include "robots/urdf/xml_tree.h"

#include <algorithm>
#include <optional>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/xml_prescan.h"

namespace lares::urdf {
namespace {

constexpr const char* kExpand =
    "expand it first: `xacro FILE > robot.urdf`, with ROS 2 `ros2 run xacro xacro FILE > "
    "robot.urdf`";

bool IsNameByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

// Where the first element's '<' stands; nothing when there is none. `doctype` tells that a document
// type comes before it.
struct Prolog {
  std::size_t root = std::string_view::npos;
  std::optional<std::size_t> doctype;
};

Prolog ReadProlog(std::string_view bytes) {
  Prolog prolog;
  std::size_t at = bytes.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while ((at = bytes.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = bytes.substr(at);
    std::string_view end = ">";
    if (rest.starts_with("<!--")) {
      end = "-->";
    } else if (rest.starts_with("<?")) {
      end = "?>";
    } else if (rest.starts_with("<!")) {
      prolog.doctype = at;
      return prolog;
    } else {
      prolog.root = at;
      return prolog;
    }
    at = bytes.find(end, at);
    if (at == std::string_view::npos) break;
  }
  return prolog;
}

int LineOf(std::string_view bytes, std::size_t offset) {
  return 1 + static_cast<int>(std::count(bytes.begin(), bytes.begin() + offset, '\n'));
}

// Simulators' files use prefixes that nobody declared; libxml2 does not take that.
std::string DeclarePrefixes(std::string_view bytes, std::size_t root) {
  std::set<std::string, std::less<>> used;
  for (std::size_t at = 0; (at = bytes.find('<', at)) != std::string_view::npos; ++at) {
    std::size_t end = at + 1;
    while (end < bytes.size() && IsNameByte(bytes[end])) ++end;
    if (end > at + 1 && end < bytes.size() && bytes[end] == ':') {
      const std::string_view prefix = bytes.substr(at + 1, end - at - 1);
      if (prefix.size() <= 64) used.emplace(prefix);
    }
    if (used.size() > 64) break;
  }
  std::string declarations;
  for (const std::string& prefix : used) {
    if (prefix == "xml" || prefix == "xmlns") continue;
    if (bytes.find("xmlns:" + prefix) != std::string_view::npos) continue;
    declarations += " xmlns:" + prefix + "=\"urn:undeclared#" + prefix + "\"";
  }
  std::size_t name_end = root + 1;
  while (name_end < bytes.size() && (IsNameByte(bytes[name_end]) || bytes[name_end] == ':')) {
    ++name_end;
  }
  std::string text(bytes);
  return text.insert(name_end, declarations);
}

class TreeBuilder {
 public:
  TreeBuilder(std::string_view bytes, const std::string& source, const Limits& limits)
      : bytes_(bytes), source_(source), limits_(limits) {}

  rdf::XmlEvents events() {
    return {[this](const rdf::XmlElement& element) { Start(element); }, [this] { End(); },
            [this](std::string_view text) { Text(text); }};
  }
  Element TakeRoot() { return std::move(root_); }

 private:
  [[noreturn]] void Refuse(Code code, const std::string& message, const std::string& hint = "") {
    Error error(code, message, {source_, line_, 0});
    if (!hint.empty()) error.WithHint(hint);
    throw error;
  }

  void Count(const Element& element) {
    if (++elements_ > limits_.max_elements) {
      Refuse(Code::kTooLarge, "there are more than " + std::to_string(limits_.max_elements) +
                                  " elements (the limit max_elements)");
    }
    if (open_.size() != 1) return;
    if (element.name == "joint" && ++joints_ > limits_.max_joints) {
      Refuse(Code::kTooLarge, "there are more than " + std::to_string(limits_.max_joints) +
                                  " joints (the limit max_joints)");
    }
    if (element.name == "link" && ++links_ > limits_.max_links) {
      Refuse(Code::kTooLarge, "there are more than " + std::to_string(limits_.max_links) +
                                  " links (the limit max_links)");
    }
  }

  void CheckExpanded(std::string_view where, std::string_view value) {
    if (value.find("${") == std::string_view::npos && value.find("$(") == std::string_view::npos) {
      return;
    }
    Refuse(Code::kInvalid,
           std::string(where) + " still holds '" + std::string(value.substr(0, 60)) +
               "', which xacro should have replaced",
           kExpand);
  }

  void Start(const rdf::XmlElement& seen) {
    line_ = LineAt(seen);
    Element element;
    element.name = seen.name;
    element.line = line_;
    if (!seen.space.empty()) {
      element.prefix = seen.space.substr(seen.space.find_last_of("#/") + 1);
    }
    if (element.prefix == "xacro" || seen.space.find("/xacro") != std::string_view::npos) {
      Refuse(Code::kInvalid, "<xacro:" + element.name + "> is an element of xacro, not of URDF",
             kExpand);
    }
    if (open_.empty() && (element.name != "robot" || !element.prefix.empty())) {
      Refuse(Code::kInvalid, "the root element is <" + element.name + ">, not <robot>");
    }
    Count(element);
    for (const auto& attribute : seen.attributes) {
      if (attribute.value.size() > limits_.max_value_bytes) {
        Refuse(Code::kTooLarge, "the attribute '" + std::string(attribute.name) +
                                    "' is longer than " + std::to_string(limits_.max_value_bytes) +
                                    " bytes (the limit max_value_bytes)");
      }
      CheckExpanded("attribute '" + std::string(attribute.name) + "' of <" + element.name + ">",
                    attribute.value);
      element.attributes.push_back({std::string(attribute.name), std::string(attribute.value)});
    }
    open_.push_back(std::move(element));
  }

  void End() {
    Element done = std::move(open_.back());
    open_.pop_back();
    done.text = Trim(done.text);
    if (done.text.find('$') != std::string::npos) {
      line_ = done.line;
      CheckExpanded("the text of <" + done.name + ">", done.text);
    }
    (open_.empty() ? root_ : open_.back().children.emplace_back()) = std::move(done);
  }

  void Text(std::string_view text) {
    if (open_.empty()) return;
    std::string& own = open_.back().text;
    if (own.empty()) text = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (own.size() + text.size() > limits_.max_value_bytes) {
      Refuse(Code::kTooLarge, "the text of <" + open_.back().name + "> is longer than " +
                                  std::to_string(limits_.max_value_bytes) +
                                  " bytes (the limit max_value_bytes)");
    }
    own.append(text);
  }

  int LineAt(const rdf::XmlElement& seen) {
    if (seen.offset == rdf::XmlElement::kNoOffset || seen.offset < counted_) {
      return seen.place.line;
    }
    lines_ +=
        static_cast<int>(std::count(bytes_.begin() + counted_, bytes_.begin() + seen.offset, '\n'));
    counted_ = seen.offset;
    return lines_;
  }

  std::string_view bytes_;
  const std::string& source_;
  const Limits& limits_;
  std::vector<Element> open_;
  Element root_;
  std::size_t elements_ = 0, joints_ = 0, links_ = 0;
  std::size_t counted_ = 0;  // bytes whose lines are in lines_
  int lines_ = 1;
  int line_ = 1;  // of the last start tag
};

}  // namespace

const std::string* Element::Find(std::string_view attribute) const {
  for (const Attribute& own : attributes) {
    if (own.name == attribute) return &own.value;
  }
  return nullptr;
}

const Element* Element::Child(std::string_view child) const {
  for (const Element& own : children) {
    if (own.name == child) return &own;
  }
  return nullptr;
}

std::vector<const Element*> Element::Children(std::string_view child) const {
  std::vector<const Element*> found;
  for (const Element& own : children) {
    if (own.name == child) found.push_back(&own);
  }
  return found;
}

bool IsUrdf(std::string_view bytes) {
  const Prolog prolog = ReadProlog(bytes);
  // A document type before <robot> is refused later, by name.
  const std::size_t at = prolog.doctype ? bytes.find("<robot", *prolog.doctype) : prolog.root;
  if (at == std::string_view::npos) return false;
  const std::string_view rest = bytes.substr(at);
  if (!rest.starts_with("<robot")) return false;
  const std::string_view after = rest.substr(6);
  // Turtle may begin with the IRI <robot#1>.
  return after.starts_with('>') || after.starts_with("/>") ||
         (!after.empty() && std::string_view(" \t\r\n").find(after[0]) != std::string_view::npos);
}

Element ReadXmlTree(std::string_view bytes, const std::string& source, const Limits& limits) {
  if (bytes.size() > limits.max_bytes) {
    throw Error(Code::kTooLarge,
                "the URDF has more than " + std::to_string(limits.max_bytes) +
                    " bytes (the limit max_bytes)",
                {source, 0, 0});
  }
  const Prolog prolog = ReadProlog(bytes);
  if (prolog.doctype) {
    throw Error(Code::kUnsupported, "a URDF with a document type or entities is not read",
                {source, LineOf(bytes, *prolog.doctype), 0});
  }
  if (prolog.root == std::string_view::npos) {
    throw Error(Code::kInvalid, "there is no element <robot>", {source, 1, 0});
  }
  const std::string declared = DeclarePrefixes(bytes, prolog.root);
  rdf::ReadOptions options;
  options.source = source;
  options.max_depth = limits.max_depth;
  options.max_entity_bytes = 0;
  TreeBuilder builder(declared, source, limits);
  const rdf::XmlEvents events = builder.events();
  rdf::CheckXml(declared, options, &events);
  return builder.TakeRoot();
}

}  // namespace lares::urdf
