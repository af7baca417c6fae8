#include "robots/urdf/tree_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/text.h"
#include "base/xml_text.h"
#include "robots/urdf/infer.h"

namespace lares::urdf {
namespace {

constexpr double kRowHeight = 30, kBoxHeight = 22, kIndent = 92, kMargin = 20, kHead = 74;
constexpr double kCharWidth = 6.7;       // of the 12 px text
constexpr double kSmallCharWidth = 5.7;  // of the 10 px text
constexpr std::size_t kMaxChars = 48;

struct Mark {
  std::string text;
  const char* fill;
};

struct Row {
  int link = -1;
  std::size_t depth = 0;
  std::size_t index = 0;
  std::vector<Mark> marks;

  double x() const { return kMargin + static_cast<double>(depth) * kIndent; }
  double middle() const { return kHead + (static_cast<double>(index) + 0.5) * kRowHeight; }
};

std::string Number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f", value);
  return text.data();
}

const char* ColourOf(Joint::Kind kind) {
  switch (kind) {
    case Joint::Kind::kRevolute:
      return "#1f6fb2";
    case Joint::Kind::kContinuous:
      return "#0f8a5f";
    case Joint::Kind::kPrismatic:
      return "#b3541e";
    case Joint::Kind::kFloating:
    case Joint::Kind::kPlanar:
      return "#7b3fa0";
    case Joint::Kind::kFixed:
      break;
  }
  return "#9aa0a6";
}

std::string SensorText(const Sensor& sensor) {
  constexpr const char* kNames[] = {"camera", "depth camera", "RGB-D camera", "stereo camera",
                                    "laser",  "3-D laser",    "sonar",        "bumper",
                                    "IMU",    "force/torque", "sensor"};
  return kNames[static_cast<std::size_t>(sensor.kind)];
}

std::vector<Mark> MarksOf(const Body& body, int link) {
  std::vector<Mark> marks;
  const auto side = [](const std::string& text) { return text.empty() ? "" : text + " "; };
  if (link == body.base.link && body.base.kind != BaseKind::kUnknown) {
    marks.push_back({std::string(ToString(body.base.kind)) + " base", "#fde9b8"});
  }
  for (const Torso& torso : body.torsos) {
    if (torso.link == link) marks.push_back({"torso", "#e6dcf5"});
  }
  for (const Head& head : body.heads) {
    if (head.link == link) marks.push_back({"pan-tilt", "#e6dcf5"});
  }
  for (const Arm& arm : body.arms) {
    if (arm.base_link == link) marks.push_back({side(arm.side) + "arm begins", "#d9ead3"});
  }
  for (const Gripper& gripper : body.grippers) {
    if (gripper.palm == link) marks.push_back({side(gripper.side) + "gripper", "#d9ead3"});
  }
  for (const BodySensor& sensor : body.sensors) {
    if (sensor.sensor.link == link) marks.push_back({SensorText(sensor.sensor), "#cfe2f3"});
  }
  return marks;
}

// Depth first, so that what hangs together stands together.
std::vector<Row> MakeRows(const Model& model, const Body& body) {
  std::vector<Row> rows;
  std::vector<Row> open{{model.root, 0, 0, {}}};
  while (!open.empty()) {
    Row row = open.back();
    open.pop_back();
    row.index = rows.size();
    row.marks = MarksOf(body, row.link);
    const auto& joints = model.links[At(row.link)].child_joints;
    for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint) {
      open.push_back({model.joints[At(*joint)].child, row.depth + 1, 0, {}});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string Text(double x, double y, const char* style, const std::string& text) {
  return "<text x=\"" + Number(x) + "\" y=\"" + Number(y) + "\" " + style + ">" +
         EscapedXml(text, XmlUse::kText) + "</text>\n";
}

std::string EdgeSvg(const Row& row, const Row& parent, const Joint& joint) {
  const double from_x = parent.x() + 14;
  const std::string colour = ColourOf(joint.kind);
  std::string svg = "<path d=\"M" + Number(from_x) + " " +
                    Number(parent.middle() + kBoxHeight / 2) + "V" + Number(row.middle()) + "H" +
                    Number(row.x()) + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
                    (Moves(joint) ? "1.8" : "1") + "\"/>\n";
  const std::string style = "class=\"s\" fill=\"" + colour + "\"";
  return svg + Text(from_x + 5, row.middle() - 3, style.c_str(), std::string(ToString(joint.kind)));
}

struct RowSvg {
  std::string svg;
  double right = 0;
};

RowSvg BoxSvg(const Row& row, const Model& model) {
  const Link& link = model.links[At(row.link)];
  const std::string name = Shortened(link.name, kMaxChars);
  const double width = static_cast<double>(CodePoints(name)) * kCharWidth + 16;
  const std::string fill = row.marks.empty() ? "#ffffff" : row.marks.front().fill;
  RowSvg out;
  out.svg = "<rect x=\"" + Number(row.x()) + "\" y=\"" + Number(row.middle() - kBoxHeight / 2) +
            "\" width=\"" + Number(width) + "\" height=\"" + Number(kBoxHeight) +
            "\" rx=\"4\" fill=\"" + fill + "\" stroke=\"#3c4043\"/>\n" +
            Text(row.x() + 8, row.middle() + 4, "class=\"l\"", name);
  double x = row.x() + width + 8;
  for (const Mark& mark : row.marks) {
    const double mark_width = static_cast<double>(CodePoints(mark.text)) * kSmallCharWidth + 12;
    out.svg += "<rect x=\"" + Number(x) + "\" y=\"" + Number(row.middle() - 8) + "\" width=\"" +
               Number(mark_width) + "\" height=\"16\" rx=\"8\" fill=\"" + mark.fill +
               "\" stroke=\"#5f6368\" stroke-width=\"0.6\"/>\n" +
               Text(x + 6, row.middle() + 3.5, "class=\"s\" fill=\"#202124\"", mark.text);
    x += mark_width + 6;
  }
  if (link.parent_joint >= 0) {
    const std::string joint = Shortened(model.joints[At(link.parent_joint)].name, kMaxChars);
    out.svg += Text(x, row.middle() + 3.5, "class=\"s\" fill=\"#5f6368\"", joint);
    x += static_cast<double>(CodePoints(joint)) * kSmallCharWidth;
  }
  out.right = x;
  return out;
}

std::string Legend() {
  std::string svg;
  double x = kMargin;
  for (const Joint::Kind kind :
       {Joint::Kind::kFixed, Joint::Kind::kRevolute, Joint::Kind::kContinuous,
        Joint::Kind::kPrismatic, Joint::Kind::kPlanar}) {
    std::string text(ToString(kind));
    if (kind == Joint::Kind::kPlanar) text = "planar, floating";
    svg += "<path d=\"M" + Number(x) + " 56h22\" stroke=\"" + ColourOf(kind) +
           "\" stroke-width=\"2\"/>\n" + Text(x + 27, 60, "class=\"s\" fill=\"#202124\"", text);
    x += 44 + static_cast<double>(text.size()) * kSmallCharWidth;
  }
  return svg;
}

std::string DotQuoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return quoted + "\"";
}

}  // namespace

std::string ToSvg(const Model& model, const Body& body) {
  const std::vector<Row> rows = MakeRows(model, body);
  std::vector<std::size_t> row_of(model.links.size());
  for (const Row& row : rows) row_of[At(row.link)] = row.index;
  std::string edges, boxes;
  double right = 560;
  for (const Row& row : rows) {
    const int above = model.links[At(row.link)].parent_joint;
    if (above >= 0) {
      const Joint& joint = model.joints[At(above)];
      edges += EdgeSvg(row, rows[row_of[At(joint.parent)]], joint);
    }
    RowSvg box = BoxSvg(row, model);
    boxes += box.svg;
    right = std::max(right, box.right);
  }
  const std::string width = Number(right + kMargin);
  const std::string height =
      Number(kHead + static_cast<double>(rows.size()) * kRowHeight + kMargin);
  const std::string title = Shortened(model.name, kMaxChars) + ": " +
                            std::to_string(model.links.size()) + " links, " +
                            std::to_string(model.joints.size()) + " joints, " +
                            std::to_string(body.sensors.size()) + " sensors";
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
         "\" viewBox=\"0 0 " + width + " " + height +
         "\">\n<style>text{font-family:Helvetica,Arial,sans-serif}.t{font-size:18px;"
         "font-weight:bold}.l{font-size:12px}.s{font-size:10px}</style>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
         Text(kMargin, 32, "class=\"t\"", title) + Legend() + edges + boxes + "</svg>\n";
}

std::string ToDot(const Model& model, const Body& body) {
  std::string dot = "digraph " + DotQuoted(model.name) +
                    " {\n  rankdir=LR;\n  node [shape=box, style=filled, fillcolor=white];\n";
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    std::string label = model.links[i].name;
    const std::vector<Mark> marks = MarksOf(body, static_cast<int>(i));
    for (const Mark& mark : marks) label += " · " + mark.text;
    dot += "  l" + std::to_string(i) + " [label=" + DotQuoted(label);
    if (!marks.empty()) dot += std::string(", fillcolor=\"") + marks.front().fill + "\"";
    dot += "];\n";
  }
  for (const Joint& joint : model.joints) {
    dot += "  l" + std::to_string(joint.parent) + " -> l" + std::to_string(joint.child) +
           " [label=" + DotQuoted(joint.name + " (" + std::string(ToString(joint.kind)) + ")") +
           ", color=\"" + ColourOf(joint.kind) + "\"];\n";
  }
  return dot + "}\n";
}

}  // namespace lares::urdf
