// A proof as a picture: layers of boxes, each below what it serves.
#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "base/xml_text.h"
#include "reasoner/owl/phrases.h"
#include "reasoner/owl/proof.h"

namespace lares::owl {
namespace {

constexpr double kCharWidth = 7.2, kBoxHeight = 44, kLayerHeight = 92, kGap = 22, kMargin = 20;
constexpr std::size_t kMaxChars = 56;

struct Box {
  std::size_t layer = 0;
  double x = 0, width = 0;
  double wanted_x = 0;  // centre of what it serves
  bool is_shown = false;
  std::string title, line1, line2;

  double centre() const { return x + width / 2; }
  double top() const { return kMargin + static_cast<double>(layer) * kLayerHeight; }
};

std::string SecondLine(const ProofNode& node) {
  if (!node.is_asserted()) return node.rule + " · table " + std::to_string(node.table);
  std::string text = "stated in ";
  for (std::size_t i = 0; i < node.graphs.size(); ++i) text += (i > 0 ? ", " : "") + node.graphs[i];
  return text;
}

std::vector<Box> MakeBoxes(const Proof& proof, const rdf::View& view) {
  std::vector<Box> boxes(proof.nodes.size());
  for (std::size_t i = proof.nodes.size(); i-- > 0;) {
    const ProofNode& node = proof.nodes[i];
    Box& box = boxes[i];
    box.is_shown = !node.is_asserted() || !IsListCell(node.triple, view);
    box.title = PhraseOf(node.triple, view);
    box.line1 = Shortened(box.title, kMaxChars);
    box.line2 = Shortened(SecondLine(node), kMaxChars);
    box.width =
        kCharWidth * static_cast<double>(std::max(CodePoints(box.line1), CodePoints(box.line2))) +
        24;
    for (const std::size_t premise : node.premises) {
      boxes[premise].layer = std::max(boxes[premise].layer, box.layer + 1);
    }
  }
  return boxes;
}

// Layer by layer from above: boxes stand under the middle of what they serve, in that order, pushed
// apart where they would overlap.
double Place(const Proof& proof, std::vector<Box>& boxes) {
  std::vector<std::vector<std::size_t>> layers;
  for (std::size_t i = boxes.size(); i-- > 0;) {
    if (!boxes[i].is_shown) continue;
    layers.resize(std::max(layers.size(), boxes[i].layer + 1));
    layers[boxes[i].layer].push_back(i);
  }
  std::vector<double> sum(boxes.size(), 0), count(boxes.size(), 0);
  double left = 0;
  for (std::vector<std::size_t>& layer : layers) {
    for (const std::size_t i : layer) boxes[i].wanted_x = count[i] > 0 ? sum[i] / count[i] : 0;
    // Premises of one step come in the order of the rule: earlier nodes first.
    std::stable_sort(layer.begin(), layer.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(boxes[a].wanted_x, a) < std::pair(boxes[b].wanted_x, b);
    });
    double total = 0, middle = 0;
    for (const std::size_t i : layer) {
      total += boxes[i].width + kGap;
      middle += boxes[i].wanted_x / static_cast<double>(layer.size());
    }
    double x = middle - (total - kGap) / 2;
    for (const std::size_t i : layer) {
      boxes[i].x = x;
      x += boxes[i].width + kGap;
      left = std::min(left, boxes[i].x);
      for (const std::size_t premise : proof.nodes[i].premises) {
        sum[premise] += boxes[i].centre();
        ++count[premise];
      }
    }
  }
  double right = 0;
  for (Box& box : boxes) {
    box.x += kMargin - left;
    if (box.is_shown) right = std::max(right, box.x + box.width);
  }
  return right + kMargin;
}

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string Drawn(const Box& box, const ProofNode& node) {
  const char* fill = node.is_contradiction() ? "#fdd" : node.is_asserted() ? "#e3f4e3" : "#eef2fb";
  const char* stroke = node.is_contradiction() ? "#b33" : node.is_asserted() ? "#4a4" : "#57a";
  const std::string x = Number(box.centre());
  return "<g><title>" + EscapedXml(box.title, XmlUse::kText) + "</title><rect x=\"" +
         Number(box.x) + "\" y=\"" + Number(box.top()) + "\" width=\"" + Number(box.width) +
         "\" height=\"" + Number(kBoxHeight) + "\" rx=\"6\" fill=\"" + fill + "\" stroke=\"" +
         stroke + "\"/><text x=\"" + x + "\" y=\"" + Number(box.top() + 18) + "\">" +
         EscapedXml(box.line1, XmlUse::kText) + "</text><text x=\"" + x + "\" y=\"" +
         Number(box.top() + 35) + "\" class=\"by\">" + EscapedXml(box.line2, XmlUse::kText) +
         "</text></g>\n";
}

// A curve, so that lines that pass a layer can be told apart.
std::string Line(const Box& from, const Box& to) {
  const double y1 = from.top() + kBoxHeight, y2 = to.top();
  return "<path d=\"M" + Number(from.centre()) + " " + Number(y1) + " C" + Number(from.centre()) +
         " " + Number(y1 + 24) + " " + Number(to.centre()) + " " + Number(y2 - 24) + " " +
         Number(to.centre()) + " " + Number(y2) + "\"/>\n";
}

std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' || c == '\r' ? ' ' : c;
  }
  return quoted + "\"";
}

}  // namespace

std::string ToSvg(const Proof& proof, const rdf::View& view) {
  std::vector<Box> boxes = MakeBoxes(proof, view);
  const double width = Place(proof, boxes);
  std::string lines, drawn;
  std::size_t layers = 0;
  for (std::size_t i = boxes.size(); i-- > 0;) {
    if (!boxes[i].is_shown) continue;
    layers = std::max(layers, boxes[i].layer);
    drawn += Drawn(boxes[i], proof.nodes[i]);
    for (const std::size_t premise : proof.nodes[i].premises) {
      if (boxes[premise].is_shown) lines += Line(boxes[i], boxes[premise]);
    }
  }
  const std::string w = Number(width);
  const std::string h =
      Number(2 * kMargin + static_cast<double>(layers) * kLayerHeight + kBoxHeight);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
         "\" viewBox=\"0 0 " + w + " " + h +
         "\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\" "
         "text-anchor=\"middle\">\n<style>.by{font-size:10.5px;fill:#555}"
         "path{fill:none;stroke:#999}</style>\n<rect width=\"100%\" height=\"100%\" "
         "fill=\"#fff\"/>\n" +
         lines + drawn + "</svg>\n";
}

std::string ToDot(const Proof& proof, const rdf::View& view) {
  std::string text = "digraph proof {\n  node [shape=box, fontname=\"sans\"];\n";
  for (std::size_t i = 0; i < proof.nodes.size(); ++i) {
    const ProofNode& node = proof.nodes[i];
    const std::string name = "  n" + std::to_string(i);
    std::string label = Quoted(PhraseOf(node.triple, view) + "\x01" + SecondLine(node));
    label.replace(label.find('\x01'), 1, "\\n");
    text += name + " [label=" + label + (node.is_asserted() ? ", color=green" : "") + "];\n";
    for (const std::size_t premise : node.premises) {
      text += name + " -> n" + std::to_string(premise) + ";\n";
    }
  }
  return text + "}\n";
}

}  // namespace lares::owl
