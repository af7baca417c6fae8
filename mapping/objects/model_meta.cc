#include "mapping/objects/model_meta.h"

#include <cmath>
#include <map>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "mapping/environment/facts.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/xml_tokens.h"

namespace lares::objects {
namespace {

using Kind = rdf::XmlToken::Kind;

constexpr double kMaxSide_m = 1000;
constexpr std::size_t kMaxDepth = 16;

struct Element {
  std::string name;
  std::size_t begin = 0;
};

struct Text {
  std::string value;
  std::size_t at = 0;
};

// The texts of the elements, by path: "model/dimensions/width".
class Reader {
 public:
  Reader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  void Run() {
    rdf::XmlTokens tokens(text_);
    for (rdf::XmlToken token = tokens.Next(); token.kind != Kind::kEnd; token = tokens.Next()) {
      Take(token);
    }
    if (!open_.empty()) Fail(open_.back().begin, "<" + open_.back().name + "> is never closed");
    if (!has_root_) Fail(0, "there is no <model>");
  }

  std::optional<Text> Find(const std::string& path) const {
    const auto found = texts_.find("model/" + path);
    return found == texts_.end() ? std::nullopt : std::optional<Text>(found->second);
  }
  Text Get(const std::string& path) const {
    auto text = Find(path);
    if (!text) Fail(text_.size(), "<" + path + "> is missing");
    return std::move(*text);
  }
  double Number(const std::string& path) const {
    const Text text = Get(path);
    const auto number = ToNumber(text.value);
    if (!number || !std::isfinite(*number)) {
      Fail(text.at, "<" + path + ">: '" + environment::Excerpt(text.value) + "' is not a number");
    }
    return *number;
  }
  // Above 0 and at most `most`.
  double Positive(const std::string& path, double most, const char* unit) const {
    const double number = Number(path);
    if (!(number > 0 && number <= most)) {
      Fail(Get(path).at, "<" + path + ">: " + environment::ToText(number) + unit +
                             " is not above 0 and at most " + environment::ToText(most) + unit);
    }
    return number;
  }
  [[noreturn]] void Fail(std::size_t at, const std::string& message) const {
    throw Error(Code::kInvalid, message, rdf::PlaceAt(text_, at, source_));
  }

 private:
  void Take(const rdf::XmlToken& token) {
    switch (token.kind) {
      case Kind::kStartTag:
        return Open(token);
      case Kind::kEmptyTag:
        Open(token);
        open_.pop_back();
        return;
      case Kind::kEndTag:
        return Close(token);
      case Kind::kText:
        return AddText(token);
      case Kind::kBroken:
      case Kind::kBadComment:
        Fail(token.begin, "is no XML from here on");
      case Kind::kEntity:
        Fail(token.begin, "declares an entity; such descriptions need none");
      default:
        return;
    }
  }

  void Open(const rdf::XmlToken& token) {
    if (open_.empty() && has_root_) Fail(token.begin, "there is a second root element");
    if (open_.empty() && token.name != "model") Fail(token.begin, "the root is not <model>");
    if (open_.size() >= kMaxDepth) Fail(token.begin, "elements are nested too deeply");
    has_root_ = true;
    open_.push_back({std::string(token.name), token.begin});
    // Faces come several times; nothing of them is needed.
    if (Path().find("/face") != std::string::npos && token.name != "faces") return;
    if (!texts_.emplace(Path(), Text{"", token.begin}).second) {
      Fail(token.begin, "<" + std::string(token.name) + "> is there twice");
    }
  }

  void Close(const rdf::XmlToken& token) {
    if (open_.empty() || open_.back().name != token.name) {
      Fail(token.begin, "</" + std::string(token.name) + "> closes nothing that is open");
    }
    open_.pop_back();
  }

  void AddText(const rdf::XmlToken& token) {
    const std::string_view text = Trim(text_.substr(token.begin, token.end - token.begin));
    if (text.empty()) return;
    if (open_.empty()) Fail(token.begin, "there is text outside the root element");
    const auto found = texts_.find(Path());
    if (found != texts_.end()) found->second.value += text;
  }

  std::string Path() const {
    std::string path;
    for (const Element& element : open_) path += (path.empty() ? "" : "/") + element.name;
    return path;
  }

  std::string_view text_;
  const std::string& source_;
  std::vector<Element> open_;
  bool has_root_ = false;
  std::map<std::string, Text> texts_;
};

}  // namespace

bool IsModelMeta(std::string_view text) {
  rdf::XmlTokens tokens(text.substr(0, 64 << 10));
  for (int i = 0; i < 100; ++i) {
    const rdf::XmlToken token = tokens.Next();
    if (token.kind == Kind::kStartTag || token.kind == Kind::kEmptyTag) {
      return token.name == "model";
    }
    if (token.kind == Kind::kEnd || token.kind == Kind::kBroken) return false;
  }
  return false;
}

ModelMeta ReadModelMeta(std::string_view text, const std::string& source) {
  Reader reader(text, source);
  if (text.size() > kMaxMetaBytes) reader.Fail(0, "is larger than 1 MiB");
  if (!IsUtf8(text)) reader.Fail(0, "is not UTF-8");
  reader.Run();
  ModelMeta meta;
  meta.name = reader.Get("name").value;
  const Text kind = reader.Get("type");
  meta.kind = kind.value;
  if (meta.kind != "planar" && meta.kind != "3D") {
    reader.Fail(kind.at, "<type>: '" + environment::Excerpt(meta.kind) +
                             "' is no kind of model: it is planar or 3D");
  }
  const double faces = reader.Number("faces");
  if (!(faces >= 0 && faces <= 1e6) || faces != std::floor(faces)) {
    reader.Fail(reader.Get("faces").at, "<faces> is no count of faces");
  }
  meta.faces = static_cast<std::uint32_t>(faces);
  if (meta.kind == "planar") {
    meta.size = {reader.Positive("dimensions/width", kMaxSide_m, " m"),
                 reader.Positive("dimensions/height", kMaxSide_m, " m"),
                 reader.Positive("dimensions/depth", kMaxSide_m, " m")};
  } else if (reader.Find("dimensions/scale")) {
    meta.scale = reader.Positive("dimensions/scale", 1e6, "");
  }
  return meta;
}

}  // namespace lares::objects
