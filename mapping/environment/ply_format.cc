#include "mapping/environment/ply_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/number.h"
#include "base/text.h"
#include "mapping/environment/facts.h"
#include "mapping/environment/magic.h"

namespace lares::environment {
namespace {

constexpr std::size_t kMaxHeaderBytes = 64 << 10;
constexpr std::size_t kMaxNumberBytes = 64;

enum class Encoding { kAscii, kLittleEndian, kBigEndian };
enum class Scalar { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

struct ScalarName {
  std::string_view name;
  Scalar scalar;
};
constexpr ScalarName kScalarNames[] = {
    {"char", Scalar::kInt8},      {"int8", Scalar::kInt8},       {"uchar", Scalar::kUint8},
    {"uint8", Scalar::kUint8},    {"short", Scalar::kInt16},     {"int16", Scalar::kInt16},
    {"ushort", Scalar::kUint16},  {"uint16", Scalar::kUint16},   {"int", Scalar::kInt32},
    {"int32", Scalar::kInt32},    {"uint", Scalar::kUint32},     {"uint32", Scalar::kUint32},
    {"float", Scalar::kFloat32},  {"float32", Scalar::kFloat32}, {"double", Scalar::kFloat64},
    {"float64", Scalar::kFloat64}};
constexpr std::size_t kScalarBytes[] = {1, 1, 2, 2, 4, 4, 4, 8};

struct Property {
  std::string name;
  Scalar scalar = Scalar::kFloat32;
  std::optional<Scalar> list_count;  // type of the count, for lists
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Encoding encoding = Encoding::kAscii;
  std::vector<Element> elements;
};

std::vector<std::string> Words(std::string_view line) {
  std::vector<std::string> words;
  for (line = Trim(line); !line.empty(); line = Trim(line)) {
    words.emplace_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
  return words;
}

Scalar ParseScalar(const ByteReader& reader, std::string_view name) {
  for (const ScalarName& known : kScalarNames) {
    if (known.name == name) return known.scalar;
  }
  reader.Fail("'" + Excerpt(name) + "' is no type of a PLY property");
}

void ParseFormat(const ByteReader& reader, const std::vector<std::string>& words, Header& header) {
  if (words.size() != 3 || words[2] != "1.0") reader.Fail("the format line must end in 1.0");
  if (words[1] == "ascii") {
    header.encoding = Encoding::kAscii;
  } else if (words[1] == "binary_little_endian") {
    header.encoding = Encoding::kLittleEndian;
  } else if (words[1] == "binary_big_endian") {
    header.encoding = Encoding::kBigEndian;
  } else {
    reader.Fail("the format '" + Excerpt(words[1]) + "' is not known");
  }
}

void ParseElement(const ByteReader& reader, const std::vector<std::string>& words, Header& header) {
  Element element;
  if (words.size() != 3) reader.Fail("an element line is 'element NAME COUNT'");
  element.name = words[1];
  const char* end = words[2].data() + words[2].size();
  const auto parsed = std::from_chars(words[2].data(), end, element.count);
  if (parsed.ec != std::errc() || parsed.ptr != end) {
    reader.Fail("'" + Excerpt(words[2]) + "' is no count of elements");
  }
  header.elements.push_back(std::move(element));
}

void ParseProperty(const ByteReader& reader, const std::vector<std::string>& words,
                   Header& header) {
  if (header.elements.empty()) reader.Fail("a property comes before the first element");
  Property property;
  if (words.size() == 5 && words[1] == "list") {
    property.list_count = ParseScalar(reader, words[2]);
    if (*property.list_count >= Scalar::kFloat32) reader.Fail("a list is counted in whole numbers");
    property.scalar = ParseScalar(reader, words[3]);
    property.name = words[4];
  } else if (words.size() == 3) {
    property.scalar = ParseScalar(reader, words[1]);
    property.name = words[2];
  } else {
    reader.Fail("a property line is 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
  }
  header.elements.back().properties.push_back(std::move(property));
}

Header ReadHeader(ByteReader& reader) {
  const std::string_view front = reader.PeekFront(512);
  if (!front.starts_with("ply\n") && !front.starts_with("ply\r\n")) {
    reader.Fail(NotA("a PLY file", front));
  }
  reader.ReadLine(16);
  Header header;
  bool has_format = false;
  while (reader.offset() <= kMaxHeaderBytes) {
    const std::optional<std::string> line = reader.ReadLine(4096);
    if (!line) reader.Fail("the header has no 'end_header' line");
    const std::vector<std::string> words = Words(*line);
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") {
      if (!has_format) reader.Fail("the header has no format line");
      return header;
    }
    if (words[0] == "format") {
      ParseFormat(reader, words, header);
      has_format = true;
    } else if (words[0] == "element") {
      ParseElement(reader, words, header);
    } else if (words[0] == "property") {
      ParseProperty(reader, words, header);
    } else {
      reader.Fail("'" + Excerpt(words[0]) + "' is no word of a PLY header");
    }
  }
  reader.Fail("the header is longer than 64 KiB");
}

template <typename Number>
double FromBytes(const unsigned char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

double ToDouble(Scalar scalar, const unsigned char* bytes) {
  switch (scalar) {
    case Scalar::kInt8:
      return FromBytes<std::int8_t>(bytes);
    case Scalar::kUint8:
      return FromBytes<std::uint8_t>(bytes);
    case Scalar::kInt16:
      return FromBytes<std::int16_t>(bytes);
    case Scalar::kUint16:
      return FromBytes<std::uint16_t>(bytes);
    case Scalar::kInt32:
      return FromBytes<std::int32_t>(bytes);
    case Scalar::kUint32:
      return FromBytes<std::uint32_t>(bytes);
    case Scalar::kFloat32:
      return FromBytes<float>(bytes);
    case Scalar::kFloat64:
      return FromBytes<double>(bytes);
  }
  return 0;
}

class Body {
 public:
  Body(ByteReader& reader, const Header& header) : reader_(reader), header_(header) {}

  void ReadElement(const Element& element, BoundsBuilder* bounds) {
    element_ = &element;
    if (element.properties.empty()) return;
    const auto axes = bounds == nullptr ? Axes{} : FindAxes(element);
    for (index_ = 0; index_ < element.count; ++index_) {
      std::array<double, 3> point{};
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const double number = ReadProperty(element.properties[i]);
        for (std::size_t axis = 0; bounds != nullptr && axis < 3; ++axis) {
          if (axes[axis] == i) point[axis] = number;
        }
      }
      if (bounds == nullptr) continue;
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) {
        Fail("a coordinate is not a finite number");
      }
      bounds->Add(point[0], point[1], point[2]);
    }
  }

 private:
  using Axes = std::array<std::size_t, 3>;

  Axes FindAxes(const Element& element) const {
    Axes axes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string name(1, "xyz"[axis]);
      const auto property = std::find_if(element.properties.begin(), element.properties.end(),
                                         [&](const Property& p) { return p.name == name; });
      if (property == element.properties.end() || property->list_count) {
        reader_.Fail("the vertices have no property " + name);
      }
      axes[axis] = static_cast<std::size_t>(property - element.properties.begin());
    }
    return axes;
  }

  // The property's value; of a list, nothing useful.
  double ReadProperty(const Property& property) {
    if (!property.list_count) return ReadNumber(property.scalar);
    const double count = ReadNumber(*property.list_count);
    if (!(count >= 0 && count <= UINT32_MAX && count == std::floor(count))) {
      Fail("a list cannot have " + ToText(count) + " entries");
    }
    for (double i = 0; i < count; ++i) ReadNumber(property.scalar);
    return 0;
  }

  double ReadNumber(Scalar scalar) {
    return header_.encoding == Encoding::kAscii ? ReadAscii() : ReadBinary(scalar);
  }

  double ReadAscii() {
    const std::string word = reader_.ReadToken(kMaxNumberBytes);
    if (word.empty()) Fail("the file ends");
    const std::optional<double> number = ToNumber(word);
    if (!number) Fail("'" + Excerpt(word) + "' is not a number");
    return *number;
  }

  double ReadBinary(Scalar scalar) {
    unsigned char bytes[8];
    const std::size_t count = kScalarBytes[static_cast<std::size_t>(scalar)];
    if (!reader_.Read(reinterpret_cast<char*>(bytes), count)) Fail("the file ends");
    if (header_.encoding == Encoding::kBigEndian) std::reverse(bytes, bytes + count);
    return ToDouble(scalar, bytes);
  }

  [[noreturn]] void Fail(const std::string& message) const {
    reader_.Fail(Excerpt(element_->name) + " " + std::to_string(index_ + 1) + " of " +
                 std::to_string(element_->count) + ": " + message);
  }

  ByteReader& reader_;
  const Header& header_;
  const Element* element_ = nullptr;
  std::uint64_t index_ = 0;
};

void CheckEnd(ByteReader& reader, const Header& header) {
  if (header.encoding == Encoding::kAscii && reader.ReadToken(kMaxNumberBytes).empty()) return;
  if (header.encoding == Encoding::kAscii || reader.Peek() >= 0) {
    reader.Fail("data follow the last element");
  }
}

}  // namespace

LayerFacts CheckCloud(ByteReader& reader) {
  const Header header = ReadHeader(reader);
  Body body(reader, header);
  BoundsBuilder bounds;
  LayerFacts facts;
  facts.media_type = "application/ply";
  bool has_vertices = false;
  for (const Element& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    if (is_vertex && has_vertices) reader.Fail("the header has two vertex elements");
    if (is_vertex && element.properties.empty()) reader.Fail("the vertices have no property x");
    body.ReadElement(element, is_vertex ? &bounds : nullptr);
    if (is_vertex) facts.facts["points"] = std::to_string(element.count);
    if (element.name == "face") facts.facts["faces"] = std::to_string(element.count);
    has_vertices = has_vertices || is_vertex;
  }
  if (!has_vertices) reader.Fail("the header has no vertex element");
  CheckEnd(reader, header);
  constexpr const char* kEncodings[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  facts.facts["format"] = kEncodings[static_cast<std::size_t>(header.encoding)];
  facts.bounds_m = bounds.bounds_m();
  return facts;
}

}  // namespace lares::environment
