#include "reasoner/owl/rule.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/text.h"
#include "ontology/rdf/literal_value.h"
#include "ontology/rdf/vocabulary.h"

namespace lares::owl {
namespace {

rdf::TermId InternName(std::string_view name, rdf::Dictionary& dictionary) {
  return dictionary.InternIri(Expand(name));
}

// Turns one row into a rule.
class Compiler {
 public:
  Compiler(const RuleRow& row, rdf::Dictionary& dictionary) : row_(row), dictionary_(dictionary) {}

  Rule Compile() {
    rule_.name = row_.name;
    rule_.table = row_.table;
    rule_.schema = ReadAtoms(row_.schema);
    if (row_.data[0] == '@') {
      rule_.list_use = ListUse::kWhole;
      rule_.list_procedure = row_.data + 1;
      rule_.list = Variable("?l");
      rule_.is_bound_by_schema.assign(names_.size(), true);
    } else {
      rule_.is_bound_by_schema.assign(names_.size(), true);
      rule_.data = ReadAtoms(row_.data);
      rule_.heads = ReadAtoms(row_.head);
    }
    rule_.variables = static_cast<std::uint32_t>(names_.size());
    rule_.is_bound_by_schema.resize(names_.size(), false);
    rule_.is_transitive = IsTransitive();
    return std::move(rule_);
  }

 private:
  std::uint32_t Variable(std::string_view name) {
    for (std::uint32_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) return i;
    }
    names_.emplace_back(name);
    return static_cast<std::uint32_t>(names_.size() - 1);
  }

  Slot ReadSlot(std::string_view word) {
    if (word.starts_with('?')) return {true, Variable(word)};
    return {false, static_cast<std::uint32_t>(InternName(word, dictionary_))};
  }

  Atom ReadAtom(const std::vector<std::string>& words) {
    Atom atom{ReadSlot(words[0]), ReadSlot(words[1]), {}, -1};
    const std::string& object = words[2];
    if (object[0] >= '0' && object[0] <= '9') {
      atom.number = object[0] - '0';
      atom.object = {true, Variable("?number" + std::to_string(names_.size()))};
    } else {
      atom.object = ReadSlot(object);
    }
    return atom;
  }

  void ReadList(const std::vector<std::string>& words) {
    rule_.list_use = words.size() == 3 ? ListUse::kEach : ListUse::kPairs;
    rule_.list = Variable(words[0]);
    rule_.first_member = Variable(words[2]);
    if (words.size() == 4) rule_.second_member = Variable(words[3]);
  }

  std::vector<Atom> ReadAtoms(std::string_view text) {
    std::vector<Atom> atoms;
    std::vector<std::string> words = Split(text, ' ');
    words.emplace_back(".");
    std::vector<std::string> atom;
    for (std::string& word : words) {
      if (word.empty()) continue;
      if (word != ".") {
        atom.push_back(std::move(word));
        continue;
      }
      if (atom.size() >= 3 && atom[1] == "LIST") {
        ReadList(atom);
      } else if (atom.size() == 3) {
        atoms.push_back(ReadAtom(atom));
      } else if (!atom.empty()) {
        throw Error(Code::kInternal, std::string("not a pattern in rule ") + row_.name);
      }
      atom.clear();
    }
    return atoms;
  }

  bool IsTransitive() const {
    if (rule_.data.size() != 2 || rule_.heads.size() != 1) return false;
    const auto same = [](const Slot& a, const Slot& b) {
      return a.is_variable == b.is_variable && a.value == b.value;
    };
    const Atom& left = rule_.data[0];
    const Atom& right = rule_.data[1];
    const Atom& head = rule_.heads[0];
    return same(left.predicate, right.predicate) && same(left.predicate, head.predicate) &&
           same(left.object, right.subject) && same(left.subject, head.subject) &&
           same(right.object, head.object) && left.subject.is_variable && left.object.is_variable &&
           right.object.is_variable;
  }

  const RuleRow& row_;
  rdf::Dictionary& dictionary_;
  Rule rule_;
  std::vector<std::string> names_;
};

}  // namespace

std::string Expand(std::string_view name) {
  if (name == "a") return std::string(rdf::kRdf) + "type";
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kPrefixes = {
      {{"rdf:", rdf::kRdf}, {"rdfs:", rdf::kRdfs}, {"owl:", rdf::kOwl}}};
  for (const auto& [prefix, iri] : kPrefixes) {
    if (name.starts_with(prefix)) return std::string(iri).append(name.substr(prefix.size()));
  }
  return std::string(name);
}

Vocabulary::Vocabulary(rdf::Dictionary& dictionary)
    : type(InternName("rdf:type", dictionary)),
      first(InternName("rdf:first", dictionary)),
      rest(InternName("rdf:rest", dictionary)),
      nil(InternName("rdf:nil", dictionary)),
      same_as(InternName("owl:sameAs", dictionary)),
      sub_class_of(InternName("rdfs:subClassOf", dictionary)),
      sub_property_of(InternName("rdfs:subPropertyOf", dictionary)),
      equivalent_class(InternName("owl:equivalentClass", dictionary)),
      equivalent_property(InternName("owl:equivalentProperty", dictionary)),
      thing(InternName("owl:Thing", dictionary)),
      nothing(InternName("owl:Nothing", dictionary)) {}

std::vector<Rule> CompileRules(std::span<const RuleRow> rows, rdf::Dictionary& dictionary) {
  std::vector<Rule> rules;
  rules.reserve(rows.size());
  for (const RuleRow& row : rows) {
    rules.push_back(Compiler(row, dictionary).Compile());
    Rule& rule = rules.back();
    rule.number = static_cast<std::uint32_t>(rules.size());
    // scm-sco and scm-spo see to what these would find in a second step.
    rule.is_equality =
        rule.name == "eq-sym" || rule.name == "eq-trans" || rule.name.starts_with("eq-rep-");
    rule.is_self_closed = rule.name == "cax-sco" || rule.name == "prp-spo1";
  }
  return rules;
}

bool HasValue(const rdf::TermView& literal, int value) {
  using Space = rdf::DataValue::Space;
  if (literal.kind != rdf::TermKind::kLiteral) return false;
  rdf::TermView trimmed = literal;
  trimmed.value = Trim(literal.value);
  const auto known = rdf::ValueOf(trimmed);
  const bool is_number = known && (known->space == Space::kDecimal ||
                                   known->space == Space::kDouble || known->space == Space::kFloat);
  return is_number && known->canonical == std::to_string(value);
}

}  // namespace lares::owl
