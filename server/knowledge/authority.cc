#include "server/knowledge/authority.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/text.h"
#include "ontology/rdf/vocabulary.h"
#include "server/knowledge/refusal.h"

namespace lares::server {
namespace {

constexpr std::size_t kNamed = 20;  // trespasses told one by one

// Text of a term of a document on its way in, which no view holds yet.
class TermText {
 public:
  TermText(const rdf::View& view, const rdf::Graph& graph) : view_(view), graph_(graph) {}

  std::string AsWritten(rdf::TermId term) const {
    const auto written = graph_.as_written.find(term);
    const rdf::TermId shown = written == graph_.as_written.end() ? term : written->second;
    return std::string(view_.dictionary().Get(shown).value);
  }
  std::string Name(rdf::TermId term, int depth = 0) const {
    const rdf::TermView view = view_.dictionary().Get(term);
    if (view.kind == rdf::TermKind::kLiteral) return rdf::ToNTriples(view);
    if (view.kind == rdf::TermKind::kIri) return std::string(LocalName(AsWritten(term)));
    if (depth > 2) return "[…]";
    std::string parts;
    const auto& triples = graph_.triples;
    for (auto at = std::lower_bound(triples.begin(), triples.end(),
                                    rdf::Triple{term, rdf::kAnyTerm, rdf::kAnyTerm});
         at != triples.end() && at->subject == term; ++at) {
      const std::string_view word = LocalName(view_.dictionary().Get(at->predicate).value);
      if (word == "type") continue;
      if (parts.size() > 120) return "[" + parts + " …]";
      parts += (parts.empty() ? "" : ", ") + std::string(word) + " " + Name(at->object, depth + 1);
    }
    return "[" + parts + "]";
  }
  std::string Axiom(const rdf::Triple& axiom) const {
    return Name(axiom.subject) + " " + std::string(LocalName(AsWritten(axiom.predicate))) + " " +
           Name(axiom.object);
  }

 private:
  const rdf::View& view_;
  const rdf::Graph& graph_;
};

bool IsNameByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

// The next place of `name` as a whole word.
std::size_t FindWord(std::string_view bytes, std::string_view name, std::size_t from) {
  for (std::size_t at = bytes.find(name, from); at != std::string_view::npos;
       at = bytes.find(name, at + 1)) {
    const bool begins = at == 0 || !IsNameByte(bytes[at - 1]);
    const std::size_t end = at + name.size();
    if (begins && (end == bytes.size() || !IsNameByte(bytes[end]))) return at;
  }
  return std::string_view::npos;
}

// Where the text says `first` and then, sooner than at any other of its places, `second`. Looks at
// so many places, and so far ahead, as an axiom may need.
Place PlaceOf(const Sent& sent, std::string_view first, std::string_view second) {
  std::size_t best = std::string_view::npos;
  std::size_t nearest = std::string_view::npos;
  int places = 0;
  for (std::size_t at = FindWord(sent.bytes, first, 0);
       at != std::string_view::npos && ++places <= 1000; at = FindWord(sent.bytes, first, at + 1)) {
    if (best == std::string_view::npos) best = at;
    const std::size_t gap = FindWord(sent.bytes.substr(at + first.size(), 4096), second, 0);
    if (gap < nearest) {
      nearest = gap;
      best = at;
    }
  }
  if (best == std::string_view::npos) return {sent.source, 0, 0};
  const std::string_view before = sent.bytes.substr(0, best);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {sent.source, static_cast<int>(line), static_cast<int>(best - line_start) + 1};
}

Place PlaceOf(const rdf::View& view, const TermText& text, const rdf::Triple& axiom,
              rdf::TermId term, const Sent& sent) {
  const auto local = [&](rdf::TermId named) {
    return std::string(LocalName(text.AsWritten(named)));
  };
  const bool has_name = view.dictionary().Kind(axiom.object) == rdf::TermKind::kIri;
  if (!has_name || term == axiom.object) return PlaceOf(sent, local(term), local(axiom.predicate));
  return PlaceOf(sent, local(term), local(axiom.object));
}

}  // namespace

void Authority::SetOwn(const rdf::View& own) {
  auto owners = std::make_shared<authority::Owners>();
  std::string space(rdf::kLares);
  space.pop_back();
  for (const auto& layer : own.layers()) {
    for (const rdf::Graph& graph : layer->graphs()) {
      owners->Add(authority::MakeSharedClaim(graph, space, own.dictionary()));
    }
  }
  const std::lock_guard lock(mutex_);
  own_ = owners;
  owners_ = std::make_shared<const authority::Owners>(Build(stored_));
}

void Authority::Put(const std::string& id, authority::Claim claim, Time first, bool by_editor) {
  const std::lock_guard lock(mutex_);
  Entry& entry = stored_.try_emplace(id, Entry{first, {}, false}).first->second;
  entry.claim = std::move(claim);
  entry.by_editor = by_editor;
  owners_ = std::make_shared<const authority::Owners>(Build(stored_));
}

void Authority::Remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  stored_.erase(id);
  owners_ = std::make_shared<const authority::Owners>(Build(stored_));
}

std::shared_ptr<const authority::Owners> Authority::owners() const {
  const std::lock_guard lock(mutex_);
  return owners_;
}

bool Authority::IsByEditor(const std::string& graph) const {
  const std::lock_guard lock(mutex_);
  return std::any_of(stored_.begin(), stored_.end(), [&](const auto& stored) {
    return stored.second.by_editor && stored.second.claim.graph == graph;
  });
}

authority::Owners Authority::OwnersWith(const std::string& id,
                                        const authority::Claim& claim) const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, Entry> stored = stored_;
  stored.try_emplace(id, Entry{Time::max(), {}, false}).first->second.claim = claim;
  return Build(stored);
}

authority::Owners Authority::Build(const std::map<std::string, Entry>& stored) const {
  std::vector<const Entry*> entries;
  for (const auto& [id, entry] : stored) entries.push_back(&entry);
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry* a, const Entry* b) { return a->first < b->first; });
  authority::Owners owners = *own_;
  for (const Entry* entry : entries) owners.Add(entry->claim);
  return owners;
}

void RefuseTrespasses(const rdf::View& known, const rdf::Graph& graph,
                      const std::vector<authority::Trespass>& trespasses, const Sent& sent) {
  if (trespasses.empty()) return;
  const TermText text(known, graph);
  std::string message = "adds to what others say about their terms:";
  nlohmann::json axioms = nlohmann::json::array();
  std::optional<Place> first;
  for (const authority::Trespass& trespass : trespasses) {
    if (axioms.size() == kNamed) {
      message += "\n  and " + std::to_string(trespasses.size() - kNamed) + " more";
      break;
    }
    const Place place = PlaceOf(known, text, trespass.axiom, trespass.term, sent);
    const std::string name(LocalName(text.AsWritten(trespass.term)));
    const std::string owners = Join(trespass.owners, ", ");
    message += "\n  " + text.Axiom(trespass.axiom) + " (" + ToString(place) + "): " + name +
               " belongs to " + owners;
    axioms.push_back({{"axiom", text.Axiom(trespass.axiom)},
                      {"term", std::string(known.dictionary().Get(trespass.term).value)},
                      {"as_written", text.AsWritten(trespass.term)},
                      {"owners", trespass.owners},
                      {"line", place.line},
                      {"column", place.column}});
    if (!first) first = place;
  }
  Refusal refusal(Refusal::Kind::kForeignTerm, message, *first);
  refusal.WithMembers(nlohmann::json{{"axioms", axioms}}.dump());
  refusal.WithHint(
      "say it of a class or property of the document's own, or send it with editor "
      "rights (--editor)");
  throw refusal;
}

}  // namespace lares::server
