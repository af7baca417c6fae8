#include "reasoner/owl/proof.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "reasoner/owl/phrases.h"

namespace lares::owl {
namespace {

constexpr std::size_t kMaxIndent = 40;

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

class TextWriter {
 public:
  TextWriter(const Proof& proof, const rdf::View& view)
      : proof_(proof), view_(view), number_(proof.nodes.size()) {}

  std::string Write() {
    for (std::size_t i = proof_.nodes.size(); i-- > 0;) Number(i);
    Line(proof_.nodes.size() - 1, 0);
    return std::move(text_);
  }

 private:
  // The conclusion is 1, what it rests on follows.
  void Number(std::size_t index) {
    const ProofNode& node = proof_.nodes[index];
    if (!node.is_asserted() || !IsListCell(node.triple, view_)) number_[index] = ++count_;
  }

  void Line(std::size_t index, std::size_t depth) {
    const ProofNode& node = proof_.nodes[index];
    if (number_[index] == 0) return;
    text_.append(std::min(2 * depth, kMaxIndent), ' ');
    text_ += std::to_string(number_[index]) + ". " + PhraseOf(node.triple, view_);
    if (!shown_.insert(index).second) {
      text_ += node.is_asserted() ? "\n" : " (as above)\n";
      return;
    }
    if (node.is_asserted()) {
      text_ += " — stated in " + Joined(node.graphs) + "\n";
      return;
    }
    text_ += " — by " + node.rule + " (table " + std::to_string(node.table) + ")";
    std::string numbers;
    for (const std::size_t premise : node.premises) {
      if (number_[premise] == 0) continue;
      numbers += (numbers.empty() ? " from " : ", ") + std::to_string(number_[premise]);
    }
    text_ += numbers + "\n";
    for (const std::size_t premise : node.premises) Line(premise, depth + 1);
  }

  const Proof& proof_;
  const rdf::View& view_;
  std::vector<std::size_t> number_;  // 0: not shown
  std::size_t count_ = 0;
  std::set<std::size_t> shown_;
  std::string text_;
};

}  // namespace

std::size_t Proof::steps() const {
  return static_cast<std::size_t>(std::count_if(
      nodes.begin(), nodes.end(), [](const ProofNode& node) { return !node.is_asserted(); }));
}

std::string ToText(const Proof& proof, const rdf::View& view) {
  return TextWriter(proof, view).Write();
}

std::string ToJson(const Proof& proof, const rdf::View& view) {
  using Json = nlohmann::ordered_json;
  Json nodes = Json::array();
  for (std::size_t i = 0; i < proof.nodes.size(); ++i) {
    const ProofNode& node = proof.nodes[i];
    Json json{{"id", i}, {"text", PhraseOf(node.triple, view)}};
    if (!node.is_contradiction()) {
      const auto [s, p, o] = node.triple;
      json["triple"] = {ToNTriples(s, view), ToNTriples(p, view), ToNTriples(o, view)};
    }
    if (node.is_asserted()) {
      json["graphs"] = node.graphs;
    } else {
      json["rule"] = node.rule;
      json["table"] = node.table;
      json["premises"] = node.premises;
    }
    nodes.push_back(std::move(json));
  }
  const Json json{{"conclusion", PhraseOf(proof.conclusion().triple, view)},
                  {"steps", proof.steps()},
                  {"nodes", std::move(nodes)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace lares::owl
