#include "ontology/rdf/jsonld_context.h"

#include <algorithm>
#include <array>

#include "ontology/rdf/iri_resolve.h"
#include "ontology/rdf/term_checks.h"

namespace lares::rdf::jsonld {
namespace {

// Contexts stacked higher than this are laid flat, so that looking up a term stays cheap.
constexpr int kMostDepth = 8;
constexpr std::size_t kMostCopiedTerms = 1'000'000;
constexpr std::size_t kMostScoped = 10'000;
constexpr int kMostUnderWay = 100;

constexpr std::array<std::string_view, 22> kKeywords = {
    "@base",   "@container", "@context", "@direction", "@graph",     "@id",
    "@import", "@included",  "@index",   "@json",      "@language",  "@list",
    "@nest",   "@none",      "@prefix",  "@propagate", "@protected", "@reverse",
    "@set",    "@type",      "@value",   "@vocab"};

bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool IsIriOrBlank(std::string_view text) { return LooksLikeIri(text) || text.starts_with("_:"); }

bool IsContextEntry(std::string_view key) {
  return key == "@base" || key == "@direction" || key == "@import" || key == "@language" ||
         key == "@propagate" || key == "@protected" || key == "@version" || key == "@vocab";
}

bool HasSameMeaning(const TermDefinition& a, const TermDefinition& b) {
  const bool same_context =
      a.context == b.context ||
      (a.context != nullptr && b.context != nullptr && AreEqual(*a.context, *b.context));
  return same_context && a.iri == b.iri && a.is_prefix == b.is_prefix &&
         a.is_reverse == b.is_reverse && a.containers == b.containers &&
         a.has_language == b.has_language && a.type == b.type && a.language == b.language &&
         a.nest == b.nest && a.index == b.index;
}

std::uint8_t ContainerOf(std::string_view name) {
  if (name == "@list") return kList;
  if (name == "@set") return kSet;
  if (name == "@language") return kLanguage;
  if (name == "@index") return kIndex;
  if (name == "@id") return kId;
  if (name == "@graph") return kGraph;
  if (name == "@type") return kType;
  return 0;
}

bool MayStandTogether(std::uint8_t containers) {
  if ((containers & kList) != 0) return containers == kList;
  if ((containers & kGraph) != 0) {
    const int rest = containers & ~(kGraph | kSet);
    return rest == 0 || rest == kId || rest == kIndex;
  }
  const int rest = containers & ~kSet;
  return (rest & (rest - 1)) == 0;
}

}  // namespace

bool IsKeyword(std::string_view text) {
  return std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end();
}

bool HasKeywordForm(std::string_view text) {
  return text.size() > 1 && text[0] == '@' && std::all_of(text.begin() + 1, text.end(), IsLetter);
}

bool LooksLikeIri(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0 || !IsLetter(text[0])) return false;
  return std::all_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
    return IsLetter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  });
}

const TermDefinition* Context::Find(std::string_view term) const {
  for (const Context* context = this; context != nullptr; context = context->below_.get()) {
    const auto found = context->terms_.find(term);
    if (found != context->terms_.end()) return found->second.get();
  }
  return nullptr;
}

ContextPtr ContextReader::Initial() const {
  auto context = std::make_shared<Context>();
  context->base = base_;
  return context;
}

std::shared_ptr<Context> ContextReader::Extend(const ContextPtr& active) {
  auto context = std::make_shared<Context>();
  context->base = active->base;
  context->vocab = active->vocab;
  context->language = active->language;
  context->previous = active->previous;
  if (active->depth_ < kMostDepth) {
    context->below_ = active;
    context->depth_ = active->depth_ + 1;
    return context;
  }
  for (const Context* layer = active.get(); layer != nullptr; layer = layer->below_.get()) {
    copied_terms_ += layer->terms_.size();
    if (copied_terms_ > kMostCopiedTerms) {
      throw Error(Code::kTooLarge, "the contexts define too many terms inside each other");
    }
    context->terms_.insert(layer->terms_.begin(), layer->terms_.end());
  }
  return context;
}

ContextPtr ContextReader::ProcessScoped(const ContextPtr& active, const Value& local, How how) {
  const Key key{active.get(), &local, (how.override_protected ? 2 : 0) + (how.propagate ? 1 : 0)};
  if (const auto known = scoped_.find(key); known != scoped_.end()) return known->second.result;
  ContextPtr result = Process(active, local, how);
  if (scoped_.size() < kMostScoped) scoped_[key] = {active, result};
  return result;
}

ContextPtr ContextReader::Process(const ContextPtr& active, const Value& local, How how) {
  if (local.is_object()) {
    if (const Value* propagate = local.Find("@propagate")) {
      if (propagate->kind != Value::Kind::kBoolean) {
        fail_("@propagate is true or false (invalid @propagate value)", propagate->offset);
      }
      how.propagate = propagate->boolean;
    }
  }
  std::shared_ptr<Context> result = Extend(active);
  if (!how.propagate && !result->previous) result->previous = active;
  ForEachItem(local, [&](const Value& one) {
    if (one.is_null()) {
      std::map<std::string_view, bool> is_protected;  // by the topmost definition
      for (const Context* c = result.get(); c != nullptr; c = c->below_.get()) {
        for (const auto& [term, definition] : c->terms_) {
          is_protected.emplace(term, definition && definition->is_protected);
        }
      }
      const bool has_protected = std::any_of(is_protected.begin(), is_protected.end(),
                                             [](const auto& entry) { return entry.second; });
      if (has_protected && !how.override_protected) {
        fail_("null would take away protected terms (invalid context nullification)", one.offset);
      }
      auto fresh = std::make_shared<Context>();
      fresh->base = base_;
      if (!how.propagate) fresh->previous = result->previous;
      result = std::move(fresh);
      return;
    }
    if (one.is_string()) {
      fail_("the context " + Quoted(one.text) +
                " would have to be fetched, and nothing ever is: write it into the document",
            one.offset);
    }
    if (!one.is_object()) {
      fail_("a context is an object or null (invalid local context)", one.offset);
    }
    // Each context of an array is laid over the one before.
    if (!result->terms_.empty()) result = Extend(result);
    ProcessOne(*result, one, how);
  });
  return result;
}

void ContextReader::ProcessOne(Context& result, const Value& local, How how) {
  if (const Value* version = local.Find("@version"); version != nullptr && version->text != "1.1") {
    fail_("@version is the number 1.1 (invalid @version value)", version->offset);
  }
  if (const Value* import = local.Find("@import")) {
    if (!import->is_string()) fail_("@import is a text (invalid @import value)", import->offset);
    fail_("@import " + Quoted(import->text) +
              " would have to be fetched, and nothing ever is: write it into the document",
          import->offset);
  }
  if (const Value* base = local.Find("@base")) ReadBase(result, *base);
  if (const Value* vocab = local.Find("@vocab")) ReadVocab(result, *vocab);
  if (const Value* language = local.Find("@language")) {
    if (!language->is_null() && !language->is_string()) {
      fail_("@language is a text or null (invalid default language)", language->offset);
    }
    result.language = language->text;
  }
  if (const Value* direction = local.Find("@direction")) {
    if (!direction->is_null() && direction->text != "ltr" && direction->text != "rtl") {
      fail_("@direction is ltr, rtl or null (invalid base direction)", direction->offset);
    }
  }
  if (const Value* propagate = local.Find("@propagate");
      propagate != nullptr && propagate->kind != Value::Kind::kBoolean) {
    fail_("@propagate is true or false (invalid @propagate value)", propagate->offset);
  }
  Work work{result, local, {}, false, how.override_protected, 0};
  if (const Value* protects = local.Find("@protected")) {
    if (protects->kind != Value::Kind::kBoolean) {
      fail_("@protected is true or false (invalid @protected value)", protects->offset);
    }
    work.protects = protects->boolean;
  }
  for (const Member& member : local.members) {
    if (!IsContextEntry(member.key)) Define(work, member.key);
  }
}

void ContextReader::ReadBase(Context& result, const Value& value) {
  if (value.is_null()) {
    result.base.clear();
  } else if (value.is_string() && LooksLikeIri(value.text)) {
    result.base = value.text;
  } else if (value.is_string() && !result.base.empty()) {
    std::string resolved;
    ResolveIri(value.text, result.base, resolved);
    result.base = std::move(resolved);
  } else {
    fail_("@base is an IRI or null (invalid base IRI)", value.offset);
  }
  if (!result.base.empty() && !IsAbsoluteIri(result.base)) {
    fail_("@base is no IRI (invalid base IRI)", value.offset);
  }
}

void ContextReader::ReadVocab(Context& result, const Value& value) {
  if (value.is_null()) {
    result.vocab.reset();
    return;
  }
  if (!value.is_string()) fail_("@vocab is a text or null (invalid vocab mapping)", value.offset);
  const auto expanded = Expand(nullptr, result, value.text, {true, true});
  if (!expanded || IsKeyword(*expanded)) {
    fail_("@vocab is an IRI (invalid vocab mapping)", value.offset);
  }
  result.vocab = *expanded;
}

void ContextReader::SetTerm(Context& context, const std::string& term,
                            std::shared_ptr<const TermDefinition> definition) {
  context.terms_[term] = std::move(definition);
}

void ContextReader::Define(Work& work, const std::string& term) {
  const Value& value = *work.local.Find(term);
  if (const auto known = work.defined.find(term); known != work.defined.end()) {
    if (known->second) return;
    fail_("the term " + Quoted(term) + " is defined by itself (cyclic IRI mapping)", value.offset);
  }
  if (work.under_way >= kMostUnderWay) {
    fail_("terms are defined by terms more than 100 deep", value.offset);
  }
  if (term.empty()) fail_("a term may not be empty (invalid term definition)", value.offset);
  work.defined[term] = false;
  if (term == "@type") {
    const bool fits =
        value.is_object() && !value.members.empty() &&
        std::all_of(value.members.begin(), value.members.end(), [](const Member& member) {
          return (member.key == "@container" && member.value.text == "@set") ||
                 member.key == "@protected";
        });
    if (!fits)
      fail_("@type can only be given \"@container\": \"@set\" (keyword redefinition)",
            value.offset);
  } else if (IsKeyword(term)) {
    fail_("the keyword " + term + " cannot be given a meaning (keyword redefinition)",
          value.offset);
  } else if (HasKeywordForm(term)) {
    work.defined[term] = true;
    return;
  }
  if (!value.is_null() && !value.is_string() && !value.is_object()) {
    fail_("a term is defined by a text, an object or null (invalid term definition)", value.offset);
  }
  // What was before stays alive below while the new definition is made.
  std::shared_ptr<const TermDefinition> own_before;
  if (const auto own = work.result.terms_.find(term); own != work.result.terms_.end()) {
    own_before = own->second;
  }
  const TermDefinition* before = work.result.Find(term);
  SetTerm(work.result, term, nullptr);
  TermDefinition definition;
  definition.is_protected = work.protects;
  bool is_ignored = false;
  ++work.under_way;
  ReadDefinition(work, term, value, value.is_string(), definition, is_ignored);
  --work.under_way;
  if (is_ignored) {
    work.defined[term] = true;
    return;
  }
  Keep(work, term, std::move(definition), before, value.offset);
  work.defined[term] = true;
}

void ContextReader::ReadDefinition(Work& work, const std::string& term, const Value& value,
                                   bool is_simple, TermDefinition& definition, bool& is_ignored) {
  if (const Value* protects = value.Find("@protected")) {
    if (protects->kind != Value::Kind::kBoolean) {
      fail_("@protected is true or false (invalid @protected value)", protects->offset);
    }
    definition.is_protected = protects->boolean;
  }
  if (const Value* type = value.Find("@type")) ReadType(work, *type, definition);
  if (value.Find("@reverse") != nullptr) {
    ReadReverse(work, value, definition, is_ignored);
    return;
  }
  const Value* id = value.is_object() ? value.Find("@id") : &value;
  if (id != nullptr && !(id->is_string() && id->text == term)) {
    ReadId(work, term, *id, is_simple, definition, is_ignored);
    if (is_ignored) return;
  } else {
    FindIri(work, term, value, definition);
  }
  ReadRest(work, term, value, definition);
}

void ContextReader::ReadReverse(Work& work, const Value& value, TermDefinition& definition,
                                bool& is_ignored) {
  const Value& reverse = *value.Find("@reverse");
  if (value.Find("@id") != nullptr || value.Find("@nest") != nullptr) {
    fail_("@reverse has no @id or @nest beside it (invalid reverse property)", reverse.offset);
  }
  if (!reverse.is_string()) fail_("@reverse is a text (invalid IRI mapping)", reverse.offset);
  if (HasKeywordForm(reverse.text)) {
    is_ignored = true;
    return;
  }
  definition.iri = ExpandIn(work, reverse.text, {false, true});
  if (!definition.iri || !IsIriOrBlank(*definition.iri)) {
    fail_("@reverse " + Quoted(reverse.text) + " is no IRI (invalid IRI mapping)", reverse.offset);
  }
  definition.is_reverse = true;
  if (const Value* container = value.Find("@container"); container && !container->is_null()) {
    if (container->text != "@set" && container->text != "@index") {
      fail_("the container of a reverse property is @set or @index (invalid reverse property)",
            container->offset);
    }
    definition.containers = ContainerOf(container->text);
  }
}

void ContextReader::ReadId(Work& work, const std::string& term, const Value& id, bool is_simple,
                           TermDefinition& definition, bool& is_ignored) {
  if (id.is_null()) return;
  if (!id.is_string()) fail_("@id of a term is a text or null (invalid IRI mapping)", id.offset);
  if (!IsKeyword(id.text) && HasKeywordForm(id.text)) {
    is_ignored = true;
    return;
  }
  definition.iri = ExpandIn(work, id.text, {false, true});
  if (!definition.iri || !(IsKeyword(*definition.iri) || IsIriOrBlank(*definition.iri))) {
    fail_(Quoted(id.text) + " is neither an IRI nor a keyword (invalid IRI mapping)", id.offset);
  }
  if (*definition.iri == "@context") {
    fail_("@context has no other name (invalid keyword alias)", id.offset);
  }
  const bool is_compound = term.find('/') != std::string::npos ||
                           (term.size() > 2 && term.find(':', 1) < term.size() - 1);
  if (is_compound) {
    work.defined[term] = true;
    const auto expanded = ExpandIn(work, term, {false, true});
    if (expanded != definition.iri) {
      fail_("the term " + Quoted(term) + " is an IRI of its own, and not " +
                Quoted(*definition.iri) + " (invalid IRI mapping)",
            id.offset);
    }
  } else if (is_simple) {
    static constexpr std::string_view kGenDelims = ":/?#[]@";
    const std::string& iri = *definition.iri;
    definition.is_prefix =
        term.find(':') == std::string::npos && !iri.empty() &&
        (kGenDelims.find(iri.back()) != std::string_view::npos || iri.starts_with("_:"));
  }
}

void ContextReader::FindIri(Work& work, const std::string& term, const Value& value,
                            TermDefinition& definition) {
  if (const std::size_t colon = term.find(':', 1); colon != std::string::npos) {
    const std::string prefix = term.substr(0, colon);
    if (work.local.Find(prefix) != nullptr && !IsContextEntry(prefix)) Define(work, prefix);
    const TermDefinition* found = work.result.Find(prefix);
    definition.iri = found != nullptr && found->iri ? *found->iri + term.substr(colon + 1) : term;
  } else if (term.find('/') != std::string::npos) {
    definition.iri = ExpandIn(work, term, {false, true});
    if (!definition.iri || !LooksLikeIri(*definition.iri)) {
      fail_("the term " + Quoted(term) + " becomes no IRI (invalid IRI mapping)", value.offset);
    }
  } else if (term == "@type") {
    definition.iri = "@type";
  } else if (work.result.vocab) {
    definition.iri = *work.result.vocab + term;
  } else {
    fail_("the term " + Quoted(term) +
              " is given no IRI, and there is no @vocab (invalid IRI "
              "mapping)",
          value.offset);
  }
}

void ContextReader::ReadType(Work& work, const Value& type, TermDefinition& definition) {
  if (!type.is_string()) fail_("@type of a term is a text (invalid type mapping)", type.offset);
  const auto expanded = ExpandIn(work, type.text, {false, true});
  const bool fits =
      expanded && (*expanded == "@id" || *expanded == "@vocab" || *expanded == "@json" ||
                   *expanded == "@none" || LooksLikeIri(*expanded));
  if (!fits) {
    fail_("@type " + Quoted(type.text) + " is no IRI (invalid type mapping)", type.offset);
  }
  definition.type = *expanded;
}

void ContextReader::ReadContainer(const Value& container, TermDefinition& definition) {
  bool fits = true;
  ForEachItem(container, [&](const Value& item) {
    const std::uint8_t bit = item.is_string() ? ContainerOf(item.text) : 0;
    if (bit == 0) fits = false;
    definition.containers |= bit;
  });
  if (!fits || !MayStandTogether(definition.containers) ||
      (container.is_array() && container.items.size() > 1 && definition.containers == kList)) {
    fail_("such a @container is not known (invalid container mapping)", container.offset);
  }
  if ((definition.containers & kType) == 0) return;
  if (definition.type.empty()) definition.type = "@id";
  if (definition.type != "@id" && definition.type != "@vocab") {
    fail_("a @type container needs @type @id or @vocab (invalid type mapping)", container.offset);
  }
}

void ContextReader::ReadRest(Work& work, const std::string& term, const Value& value,
                             TermDefinition& definition) {
  if (!value.is_object()) return;
  if (const Value* container = value.Find("@container")) ReadContainer(*container, definition);
  if (const Value* index = value.Find("@index")) {
    const auto expanded =
        index->is_string() ? ExpandIn(work, index->text, {false, true}) : std::nullopt;
    if ((definition.containers & kIndex) == 0 || !expanded || !LooksLikeIri(*expanded)) {
      fail_("@index of a term is an IRI beside an @index container (invalid term definition)",
            index->offset);
    }
    definition.index = index->text;
  }
  if (const Value* context = value.Find("@context")) {
    // That it can be read is checked now, against what is known now; nothing of it is kept.
    Process(ContextPtr(ContextPtr(), &work.result), *context, {true, true});
    definition.context = context;
  }
  if (const Value* language = value.Find("@language"); language && !value.Find("@type")) {
    if (!language->is_null() && !language->is_string()) {
      fail_("@language is a text or null (invalid language mapping)", language->offset);
    }
    definition.has_language = true;
    definition.language = language->text;
  }
  if (const Value* direction = value.Find("@direction"); direction && !value.Find("@type")) {
    if (!direction->is_null() && direction->text != "ltr" && direction->text != "rtl") {
      fail_("@direction is ltr, rtl or null (invalid base direction)", direction->offset);
    }
  }
  if (const Value* nest = value.Find("@nest")) {
    if (!nest->is_string() || (IsKeyword(nest->text) && nest->text != "@nest")) {
      fail_("@nest is a term or @nest (invalid @nest value)", nest->offset);
    }
    definition.nest = nest->text;
  }
  if (const Value* prefix = value.Find("@prefix")) {
    if (term.find_first_of(":/") != std::string::npos) {
      fail_("a prefix has no ':' or '/' in it (invalid term definition)", prefix->offset);
    }
    if (prefix->kind != Value::Kind::kBoolean) {
      fail_("@prefix is true or false (invalid @prefix value)", prefix->offset);
    }
    definition.is_prefix = prefix->boolean;
    if (definition.is_prefix && definition.iri && IsKeyword(*definition.iri)) {
      fail_("a keyword is no prefix (invalid term definition)", prefix->offset);
    }
  }
  static constexpr std::array<std::string_view, 11> kKnown = {
      "@id",       "@reverse", "@container", "@context",   "@direction", "@index",
      "@language", "@nest",    "@prefix",    "@protected", "@type"};
  for (const Member& member : value.members) {
    if (std::find(kKnown.begin(), kKnown.end(), member.key) != kKnown.end()) continue;
    fail_(Quoted(member.key) +
              " does not belong into a term's definition (invalid term "
              "definition)",
          member.offset);
  }
}

void ContextReader::Keep(Work& work, const std::string& term, TermDefinition definition,
                         const TermDefinition* before, std::size_t offset) {
  if (!work.override_protected && before != nullptr && before->is_protected) {
    if (!HasSameMeaning(definition, *before)) {
      fail_("the term " + Quoted(term) + " is protected (protected term redefinition)", offset);
    }
    definition.is_protected = true;
  }
  SetTerm(work.result, term, std::make_shared<const TermDefinition>(std::move(definition)));
}

std::optional<std::string> ContextReader::ExpandIn(Work& work, std::string_view value,
                                                   Against against) {
  return Expand(&work, work.result, value, against);
}

std::optional<std::string> ContextReader::ExpandIri(const Context& active, std::string_view value,
                                                    Against against) {
  return Expand(nullptr, active, value, against);
}

std::optional<std::string> ContextReader::Expand(Work* work, const Context& active,
                                                 std::string_view value, Against against) {
  if (IsKeyword(value)) return std::string(value);
  if (HasKeywordForm(value)) return std::nullopt;
  const auto define_first = [&](std::string_view term) {
    if (work == nullptr || work->local.Find(term) == nullptr || IsContextEntry(term)) return;
    const auto known = work->defined.find(term);
    if (known == work->defined.end() || !known->second) Define(*work, std::string(term));
  };
  define_first(value);
  const TermDefinition* definition = active.Find(value);
  if (definition != nullptr && definition->iri && IsKeyword(*definition->iri)) {
    return definition->iri;
  }
  if (against.vocab && definition != nullptr) return definition->iri;
  if (const std::size_t colon = value.find(':', 1);
      value.size() > 1 && colon != std::string_view::npos) {
    const std::string_view prefix = value.substr(0, colon);
    const std::string_view suffix = value.substr(colon + 1);
    if (prefix == "_" || suffix.starts_with("//")) return std::string(value);
    define_first(prefix);
    const TermDefinition* space = active.Find(prefix);
    if (space != nullptr && space->iri && space->is_prefix) {
      return *space->iri + std::string(suffix);
    }
    if (LooksLikeIri(value)) return std::string(value);
  }
  if (against.vocab && active.vocab) return *active.vocab + std::string(value);
  if (against.document && !active.base.empty()) {
    std::string resolved;
    ResolveIri(value, active.base, resolved);
    return resolved;
  }
  return std::string(value);
}

}  // namespace lares::rdf::jsonld
