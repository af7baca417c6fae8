// Paths by walking (SPARQL 1.1, 18.4): closures are sets, found breadth first.
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "reasoner/sparql/steps.h"

namespace lares::sparql {

using rdf::kAnyTerm;
using rdf::Triple;
using syntax::Path;

namespace {

using Reach = FunctionRef<bool(TermId)>;

// Distinct terms in the order in which they came.
class TermSet {
 public:
  explicit TermSet(Context& context) : charge_(context.account) {}
  bool Insert(TermId id) {
    if (!known_.insert(id).second) return false;
    if (list_.size() % 64 == 0) charge_.Add(64 * kBytesEach);
    list_.push_back(id);
    return true;
  }
  std::size_t size() const { return list_.size(); }
  TermId At(std::size_t i) const { return list_[i]; }

 private:
  static constexpr std::size_t kBytesEach = 40;
  std::unordered_set<TermId> known_;
  std::vector<TermId> list_;
  Charge charge_;
};

class Walker {
 public:
  Walker(Context& context, Source& source) : context_(context), source_(source) {}

  // Calls `reach` for the ends of `path` from `from` (to it, when backward), an end perhaps more
  // than once. False when `reach` said so.
  bool Walk(const Path& path, TermId from, bool is_backward, Reach reach) {
    switch (path.kind) {
      case Path::Kind::kIri:
        return Edges(context_.constants[path.iri.index], from, is_backward, reach);
      case Path::Kind::kInverse:
        return Walk(path.parts[0], from, !is_backward, reach);
      case Path::Kind::kSequence:
        return WalkSequence(path, 0, from, is_backward, reach);
      case Path::Kind::kAlternative:
        return std::ranges::all_of(
            path.parts, [&](const Path& part) { return Walk(part, from, is_backward, reach); });
      case Path::Kind::kNegated:
        return WalkOthers(path, from, is_backward, reach);
      default:
        return WalkClosure(path, from, is_backward, reach);
    }
  }

  bool IsNode(TermId id) {
    return source_.Estimate({id, {}, {}}) > 0 || source_.Estimate({{}, {}, id}) > 0;
  }

  // Every term that is a subject or object.
  void CollectNodes(TermSet& nodes) {
    source_.ForEach({}, [&](const Triple& triple) {
      context_.guard.Tick();
      nodes.Insert(triple.subject);
      nodes.Insert(triple.object);
      return true;
    });
  }

 private:
  bool Edges(TermId property, TermId from, bool is_backward, Reach reach) {
    const rdf::Pattern pattern =
        is_backward ? rdf::Pattern{{}, property, from} : rdf::Pattern{from, property, {}};
    return source_.ForEach(pattern, [&](const Triple& triple) {
      context_.guard.Tick();
      return reach(is_backward ? triple.subject : triple.object);
    });
  }

  bool WalkSequence(const Path& path, std::size_t done, TermId from, bool is_backward,
                    Reach reach) {
    if (done == path.parts.size()) return reach(from);
    const std::size_t next = is_backward ? path.parts.size() - 1 - done : done;
    return Walk(path.parts[next], from, is_backward, [&, done](TermId middle) {
      return WalkSequence(path, done + 1, middle, is_backward, reach);
    });
  }

  // !(p|^q): any property but p forward, any but q backward.
  bool WalkOthers(const Path& path, TermId from, bool is_backward, Reach reach) {
    const auto walk = [&](const std::vector<syntax::Node>& excluded, bool backward) {
      const rdf::Pattern pattern =
          backward ? rdf::Pattern{{}, {}, from} : rdf::Pattern{from, {}, {}};
      return source_.ForEach(pattern, [&](const Triple& triple) {
        context_.guard.Tick();
        for (const syntax::Node& node : excluded) {
          if (context_.constants[node.index] == triple.predicate) return true;
        }
        return reach(backward ? triple.subject : triple.object);
      });
    };
    const bool only_backward = path.not_forward.empty() && !path.not_backward.empty();
    if (!only_backward && !walk(path.not_forward, is_backward)) return false;
    return path.not_backward.empty() || walk(path.not_backward, !is_backward);
  }

  bool WalkClosure(const Path& path, TermId from, bool is_backward, Reach reach) {
    TermSet reached(context_);
    if (path.kind != Path::Kind::kOneOrMore) {
      reached.Insert(from);
      if (!reach(from)) return false;
    }
    const auto expand = [&](TermId node) {
      return Walk(path.parts[0], node, is_backward,
                  [&](TermId end) { return !reached.Insert(end) || reach(end); });
    };
    if (!expand(from)) return false;
    if (path.kind == Path::Kind::kZeroOrOne) return true;
    const std::size_t begin = path.kind == Path::Kind::kZeroOrMore ? 1 : 0;
    for (std::size_t i = begin; i < reached.size(); ++i) {
      if (!expand(reached.At(i))) return false;
    }
    return true;
  }

  Context& context_;
  Source& source_;
};

}  // namespace

bool PathStep::Step(Context& context, Row& row, Next next) {
  const Path& path = pattern_.path;
  const syntax::Node& subject = pattern_.ends.subject;
  const syntax::Node& object = pattern_.ends.object;
  Walker walker(context, *scope_.source);
  const TermId from = context.At(subject, row);
  const TermId to = context.At(object, row);

  // From a known end; `other` is the variable at the far one, or its term is `wanted`.
  const auto walk_from = [&](TermId start, bool is_backward, const syntax::Node& other,
                             TermId wanted) {
    bool goes_on = true;
    const bool is_bag = path.kind == Path::Kind::kNegated;
    walker.Walk(path, start, is_backward, [&](TermId end) {
      if (wanted != kAnyTerm) {
        if (end != wanted) return true;
        goes_on = next(row);
        return goes_on && is_bag;  // a set has each end once
      }
      row[other.index] = end;
      goes_on = next(row);
      row[other.index] = kAnyTerm;
      return goes_on;
    });
    return goes_on;
  };
  // Between two variables a path of length zero joins the graph's own nodes only (18.4).
  const bool has_zero = path.kind == Path::Kind::kZeroOrMore || path.kind == Path::Kind::kZeroOrOne;
  const TermId known = from != kAnyTerm ? from : to;
  if (has_zero && subject.is_variable() && object.is_variable() && known != kAnyTerm &&
      !walker.IsNode(known)) {
    return true;
  }
  if (from != kAnyTerm) return walk_from(from, false, object, to);
  if (to != kAnyTerm) return walk_from(to, true, subject, kAnyTerm);

  TermSet nodes(context);
  walker.CollectNodes(nodes);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const TermId start = nodes.At(i);
    row[subject.index] = start;
    const bool is_loop = subject == object;
    const bool goes_on = walk_from(start, false, object, is_loop ? start : kAnyTerm);
    row[subject.index] = kAnyTerm;
    if (!goes_on) return false;
  }
  return true;
}

}  // namespace lares::sparql
