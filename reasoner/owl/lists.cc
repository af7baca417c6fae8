#include "reasoner/owl/lists.h"

#include <bit>

#include "base/error.h"

namespace lares::owl {
namespace {

constexpr std::size_t kMaxReadings = 64;
constexpr std::size_t kMaxMembers = 1'000'000;
constexpr std::size_t kMaxSteps = 4'000'000;

struct Partial {
  rdf::TermId cell;
  ListReading reading;
  rdf::TermId mark{};  // a cell met since the last fork; met again, there is no way out
};

Slot Constant(rdf::TermId id) { return {false, static_cast<std::uint32_t>(id)}; }
Slot Variable(std::size_t number) { return {true, static_cast<std::uint32_t>(number)}; }

void WriteIntersection(rdf::TermId subject, const std::vector<rdf::TermId>& members,
                       const Vocabulary& words, Rule& rule) {
  for (const rdf::TermId member : members) {
    rule.data.push_back({Variable(0), Constant(words.type), Constant(member)});
  }
  rule.heads.push_back({Variable(0), Constant(words.type), Constant(subject)});
  rule.variables = 1;
}

void WriteChain(rdf::TermId subject, const std::vector<rdf::TermId>& members, Rule& rule) {
  const std::size_t n = members.size();
  for (std::size_t i = 0; i < n; ++i) {
    rule.data.push_back({Variable(i), Constant(members[i]), Variable(i + 1)});
  }
  rule.heads.push_back({Variable(0), Constant(subject), Variable(n)});
  rule.variables = static_cast<std::uint32_t>(n + 1);
}

void WriteKey(rdf::TermId subject, const std::vector<rdf::TermId>& members, const Vocabulary& words,
              Rule& rule) {
  for (const std::size_t each : {0, 1}) {
    rule.data.push_back({Variable(each), Constant(words.type), Constant(subject)});
    for (std::size_t i = 0; i < members.size(); ++i) {
      rule.data.push_back({Variable(each), Constant(members[i]), Variable(2 + i)});
    }
  }
  rule.heads.push_back({Variable(0), Constant(words.same_as), Variable(1)});
  rule.variables = static_cast<std::uint32_t>(2 + members.size());
}

}  // namespace

std::vector<ListReading> ReadLists(rdf::TermId head, const Vocabulary& words,
                                   const ObjectsOf& objects_of) {
  std::vector<ListReading> readings;
  std::vector<Partial> open;
  open.push_back({head, {}});
  for (std::size_t step = 0; !open.empty() && step < kMaxSteps; ++step) {
    Partial partial = std::move(open.back());
    open.pop_back();
    if (partial.cell == words.nil) {
      readings.push_back(std::move(partial.reading));
      if (readings.size() == kMaxReadings) break;
      continue;
    }
    const std::size_t length = partial.reading.members.size();
    if (length == kMaxMembers || partial.cell == partial.mark) continue;  // a circle
    if (std::has_single_bit(length)) partial.mark = partial.cell;
    const auto members = objects_of(partial.cell, words.first);
    const auto rests = objects_of(partial.cell, words.rest);
    const std::size_t ways = members.size() * rests.size();
    for (std::size_t way = 0; way < ways && open.size() < kMaxReadings; ++way) {
      const rdf::TermId member = members[way / rests.size()];
      const rdf::TermId rest = rests[way % rests.size()];
      Partial longer{rest, way + 1 == ways ? std::move(partial.reading) : partial.reading,
                     ways == 1 ? partial.mark : rdf::kAnyTerm};
      longer.reading.members.push_back(member);
      longer.reading.cells.push_back({partial.cell, words.first, member});
      longer.reading.cells.push_back({partial.cell, words.rest, rest});
      open.push_back(std::move(longer));
    }
  }
  return readings;
}

Rule WriteRule(const Rule& rule, rdf::TermId subject, const std::vector<rdf::TermId>& members,
               const Vocabulary& words) {
  Rule written;
  written.name = rule.name;
  written.table = rule.table;
  written.number = rule.number;
  if (rule.list_procedure == "intersection") {
    WriteIntersection(subject, members, words, written);
  } else if (rule.list_procedure == "chain") {
    WriteChain(subject, members, written);
  } else if (rule.list_procedure == "key") {
    WriteKey(subject, members, words, written);
  } else {
    throw Error(Code::kInternal, "no procedure " + rule.list_procedure);
  }
  if (members.empty()) written.data.clear();
  written.is_bound_by_schema.assign(written.variables, false);
  return written;
}

}  // namespace lares::owl
