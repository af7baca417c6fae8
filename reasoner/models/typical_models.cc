#include "reasoner/models/typical_models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/text.h"

namespace lares::models {
namespace {

using prolog::Atom;
using prolog::Compound;
using prolog::List;
using prolog::Value;

Value A(const std::string& text) { return {Atom{text}}; }

Value Atoms(const std::vector<std::string>& texts) {
  List list;
  for (const std::string& text : texts) list.push_back(A(text));
  return {list};
}

std::vector<std::string> Texts(const Value& list) {
  std::vector<std::string> texts;
  for (const Value& item : list.list()) texts.push_back(item.text());
  return texts;
}

std::string LabelOf(const rdf::View& view, const std::string& iri) {
  const auto term = view.dictionary().FindIri(iri);
  return term ? view.Label(*term) : std::string(LocalName(iri));
}

std::string Percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

// What the rules found out, by what was asked.
struct Findings {
  std::vector<std::string> places;
  bool places_above = false;
  std::map<std::string, Value> evidence;           // by class
  std::map<std::vector<std::string>, Value> uses;  // by algorithm: IRI, then classes
};

std::vector<std::string> KeyOf(const Candidate::Algorithm& algorithm) {
  std::vector<std::string> key{algorithm.iri};
  key.insert(key.end(), algorithm.classes.begin(), algorithm.classes.end());
  return key;
}

std::vector<Candidate::Algorithm> AlgorithmsOf(const Candidate& candidate) {
  return candidate.algorithms.empty() ? std::vector<Candidate::Algorithm>{{}}
                                      : candidate.algorithms;
}

Value RowsOf(const places::PriorTable& rooms) {
  List rows;
  for (const places::PriorRow& row : rooms.rows) {
    if (row.count > 0) rows.push_back({Compound{"row", {A(row.object), A(row.place)}}});
  }
  return {rows};
}

Findings Ask(prolog::EnginePool& engines, const rdf::View& view, const places::PriorTable& rooms,
             const std::vector<Candidate>& candidates, const TypicalOptions& options) {
  // Two descriptions may put one class under different ones: what either says counts.
  std::map<std::string, std::set<std::string>> kinds;
  std::set<std::vector<std::string>> algorithms;
  for (const Candidate& candidate : candidates) {
    for (const auto& kind : candidate.kinds) {
      kinds[kind.class_iri].insert(kind.above.begin(), kind.above.end());
    }
    for (const auto& algorithm : AlgorithmsOf(candidate)) algorithms.insert(KeyOf(algorithm));
  }
  List asked_kinds, asked_algorithms;
  for (const auto& [iri, above] : kinds) {
    asked_kinds.push_back({Compound{"kind", {A(iri), Atoms({above.begin(), above.end()})}}});
  }
  for (const auto& key : algorithms) {
    asked_algorithms.push_back(
        {Compound{"algorithm", {A(key.front()), Atoms({key.begin() + 1, key.end()})}}});
  }
  const auto choice = engines.Once(view, "typical_models", "choose",
                                   {A(options.room_iri),
                                    RowsOf(rooms),
                                    {asked_kinds},
                                    {asked_algorithms},
                                    A(options.robot_iri)});
  if (!choice) throw Error(Code::kInternal, "typical_models:choose gave no answer");
  const List& parts = choice->compound().arguments;
  Findings findings;
  if (const auto* places = std::get_if<Compound>(&parts.at(0).data)) {
    findings.places_above = places->name == "as";
    findings.places = findings.places_above
                          ? std::vector<std::string>{places->arguments.at(0).text()}
                          : Texts(places->arguments.at(0));
  }
  std::size_t i = 0;
  for (const auto& [iri, above] : kinds) findings.evidence[iri] = parts.at(1).list().at(i++);
  i = 0;
  for (const auto& key : algorithms) findings.uses[key] = parts.at(2).list().at(i++);
  return findings;
}

// The counts of a table, looked at from the rooms that were asked for.
class Counts {
 public:
  Counts(const places::PriorTable& rooms, const std::vector<std::string>& places, double lambda)
      : lambda_(lambda) {
    const std::set<std::string> here(places.begin(), places.end());
    std::set<std::string_view> classes;
    for (const places::PriorRow& row : rooms.rows) {
      classes.insert(row.object);
      Count& count = by_object_[row.object];
      count.all += row.count;
      if (!here.contains(row.place)) continue;
      count.here += row.count;
      all_here_ += row.count;
    }
    smoothing_ = lambda * static_cast<double>(classes.size());
  }

  void Fill(const std::vector<std::string>& objects, Choice& choice) const {
    Count sum;
    for (const std::string& object : objects) {
      const auto found = by_object_.find(object);
      if (found == by_object_.end()) continue;
      sum.here += found->second.here;
      sum.all += found->second.all;
    }
    if (!(sum.here > 0)) return;
    choice.probability = (sum.here + lambda_) / (all_here_ + smoothing_);
    choice.probability_of_room = sum.here / sum.all;
  }

 private:
  struct Count {
    double here = 0, all = 0;
  };
  double lambda_;
  double smoothing_ = 0;
  double all_here_ = 0;
  std::map<std::string, Count> by_object_;
};

class Chooser {
 public:
  Chooser(const rdf::View& view, const TypicalOptions& options, const Findings& findings,
          const Counts& counts)
      : view_(view), options_(options), findings_(findings), counts_(counts) {}

  Choice Judge(const Candidate& candidate) const {
    Choice choice;
    choice.id = candidate.id;
    choice.size_bytes = candidate.size_bytes;
    for (const auto& kind : candidate.kinds) {
      Choice one = choice;
      one.class_iri = kind.class_iri;
      const Value& evidence = findings_.evidence.at(kind.class_iri);
      if (const auto* found = std::get_if<Compound>(&evidence.data)) {
        one.counted_above = found->name == "as";
        one.counted = one.counted_above ? std::vector<std::string>{found->arguments.at(0).text()}
                                        : Texts(found->arguments.at(0));
        counts_.Fill(one.counted, one);
      }
      if (choice.class_iri.empty() || one.probability > choice.probability) choice = one;
    }
    choice.why = Evidence(choice);
    if (!(choice.probability > 0)) {
      choice.verdict = Verdict::kNotTypical;
    } else if (choice.probability < options_.min_probability) {
      choice.verdict = Verdict::kTooRare;
      choice.why += "; rarer than the " + Percent(options_.min_probability) + " asked for";
    } else {
      JudgeRobot(candidate, choice);
    }
    return choice;
  }

 private:
  std::string Room() const { return LabelOf(view_, options_.room_iri); }
  std::string Robot() const { return LabelOf(view_, options_.robot_iri); }

  std::string Labels(const std::vector<std::string>& iris) const {
    std::vector<std::string> labels;
    for (const std::string& iri : iris) labels.push_back(LabelOf(view_, iri));
    return Join(labels, ", ");
  }

  std::string Evidence(const Choice& choice) const {
    const std::string of = "a model of " + LabelOf(view_, choice.class_iri);
    if (!(choice.probability > 0)) {
      return of + ", of which nothing says that it is typical of " + Room();
    }
    std::string why = of;
    if (choice.counted_above) {
      why += ", a kind of " + Labels(choice.counted);
    } else if (choice.counted != std::vector<std::string>{choice.class_iri}) {
      why += ", counted as " + Labels(choice.counted);
    }
    return why + ": " + Percent(choice.probability) + " of the things in " + Room() + ", where " +
           Percent(choice.probability_of_room) + " of them are";
  }

  void JudgeRobot(const Candidate& candidate, Choice& choice) const {
    choice.verdict = Verdict::kLoaded;
    if (options_.robot_iri.empty()) return;
    std::string without, perhaps;
    for (const auto& algorithm : AlgorithmsOf(candidate)) {
      const Compound& use = findings_.uses.at(KeyOf(algorithm)).compound();
      if (use.name == "has") {
        choice.robot_has = use.arguments.at(0).text();
        choice.why += "; " + Robot() + " has " + LabelOf(view_, *choice.robot_has);
        return;
      }
      if (use.name == "perhaps") {
        const std::string general = use.arguments.at(1).text();
        perhaps = Robot() + " has " + LabelOf(view_, general) +
                  ", of which it is not said whether it is " +
                  LabelOf(view_, use.arguments.at(0).text());
        if (!options_.strict) choice.robot_has = general;
      } else {
        without += (without.empty() ? "" : " or ") + Labels(Texts(use.arguments.at(0)));
      }
    }
    if (choice.robot_has) {
      choice.why += "; " + perhaps;
      return;
    }
    choice.verdict = Verdict::kRobotLacks;
    choice.why += "; " + (perhaps.empty() ? Robot() + " has no " + without : perhaps);
  }

  const rdf::View& view_;
  const TypicalOptions& options_;
  const Findings& findings_;
  const Counts& counts_;
};

void NumberWithinClasses(std::vector<Choice>& choices) {
  std::map<std::string, std::size_t> seen;
  for (Choice& choice : choices) choice.nth_of_its_class = ++seen[choice.class_iri];
}

// `choices` in the order in which they are wanted.
void Spend(const TypicalOptions& options, std::vector<Choice>& choices) {
  std::size_t models = 0;
  std::uint64_t bytes = 0;
  for (Choice& choice : choices) {
    if (options.max_models && models >= *options.max_models) {
      choice.verdict = Verdict::kTooMany;
      choice.why += "; left out, as " + std::to_string(models) + " are loaded already";
    } else if (options.max_bytes && choice.size_bytes > *options.max_bytes - bytes) {
      choice.verdict = Verdict::kTooLarge;
      choice.why += "; its " + std::to_string(choice.size_bytes) + " bytes do not fit into the " +
                    std::to_string(*options.max_bytes - bytes) + " that are left";
    } else {
      ++models;
      bytes += choice.size_bytes;
    }
  }
}

}  // namespace

void TypicalOptions::Check() const {
  const auto fail = [](const char* what) { throw Error(Code::kInvalid, what); };
  if (room_iri.empty()) fail("room: which kind of room is not said");
  if (!(min_probability >= 0 && min_probability <= 1)) {
    fail("min_probability is between 0 and 1");
  }
  if (!(lambda > 0) || !std::isfinite(lambda)) fail("lambda is a finite number above 0");
}

TypicalChoice ChooseTypical(prolog::EnginePool& engines, const rdf::View& view,
                            const places::PriorTable& rooms,
                            const std::vector<Candidate>& candidates,
                            const TypicalOptions& options) {
  options.Check();
  const Findings findings = Ask(engines, view, rooms, candidates, options);
  const Counts counts(rooms, findings.places, options.lambda);
  const Chooser chooser(view, options, findings, counts);
  std::vector<Choice> wanted;
  TypicalChoice answer{findings.places, findings.places_above, {}, {}, 0};
  for (const Candidate& candidate : candidates) {
    Choice choice = chooser.Judge(candidate);
    auto& list = choice.verdict == Verdict::kLoaded ? wanted : answer.left_out;
    list.push_back(std::move(choice));
  }
  const auto by_worth = [](const Choice& a, const Choice& b) {
    return std::tuple(-a.probability, a.class_iri, a.size_bytes, a.id) <
           std::tuple(-b.probability, b.class_iri, b.size_bytes, b.id);
  };
  std::sort(wanted.begin(), wanted.end(), by_worth);
  NumberWithinClasses(wanted);
  std::stable_sort(wanted.begin(), wanted.end(), [](const Choice& a, const Choice& b) {
    return a.nth_of_its_class < b.nth_of_its_class;
  });
  Spend(options, wanted);
  for (Choice& choice : wanted) {
    if (choice.verdict != Verdict::kLoaded) {
      answer.left_out.push_back(std::move(choice));
      continue;
    }
    answer.size_bytes += choice.size_bytes;
    answer.loaded.push_back(std::move(choice));
  }
  std::stable_sort(answer.left_out.begin(), answer.left_out.end(),
                   [&](const Choice& a, const Choice& b) {
                     return a.verdict != b.verdict ? a.verdict > b.verdict : by_worth(a, b);
                   });
  return answer;
}

}  // namespace lares::models
