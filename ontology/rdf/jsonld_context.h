// Contexts of JSON-LD 1.1: what the names of a document mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ontology/rdf/jsonld_value.h"

namespace lares::rdf::jsonld {

// Of a term's @container; several may be set.
enum Container : std::uint8_t {
  kList = 1,
  kSet = 2,
  kLanguage = 4,
  kIndex = 8,
  kId = 16,
  kGraph = 32,
  kType = 64,
};

struct TermDefinition {
  std::optional<std::string> iri;  // a keyword for an alias; none: the term means nothing
  bool is_prefix = false;
  bool is_protected = false;
  bool is_reverse = false;
  std::uint8_t containers = 0;
  bool has_language = false;
  std::string type;      // "@id", "@vocab", "@json", "@none", an IRI; empty for none
  std::string language;  // "" for null
  std::string nest;
  std::string index;
  const Value* context = nullptr;  // the scoped context, inside the parsed text
};

// Immutable once made. A context holds what it adds to the one below it.
class Context {
 public:
  std::string base;  // empty: relative IRIs stay relative
  std::optional<std::string> vocab;
  std::string language;                     // "" for none
  std::shared_ptr<const Context> previous;  // to which nodes inside revert

  // Null when the term is not defined.
  const TermDefinition* Find(std::string_view term) const;

 private:
  friend class ContextReader;
  using Terms = std::map<std::string, std::shared_ptr<const TermDefinition>, std::less<>>;

  Terms terms_;  // null: not defined any more
  std::shared_ptr<const Context> below_;
  int depth_ = 0;
};
using ContextPtr = std::shared_ptr<const Context>;

bool IsKeyword(std::string_view text);
// "@" and letters: reserved, and ignored where it is no keyword.
bool HasKeywordForm(std::string_view text);
// "scheme:…", not looked at closely.
bool LooksLikeIri(std::string_view text);

// Throws `message` with the place of `offset` in the document.
using Fail = std::function<void(const std::string& message, std::size_t offset)>;

// The context processing, term definition and IRI expansion algorithms of the JSON-LD 1.1 API (W3C
// 2020, 4.1, 4.2, 5.2). A context by IRI, and @import, are refused: nothing is fetched.
class ContextReader {
 public:
  // `fail` throws.
  ContextReader(std::string base, Fail fail) : base_(std::move(base)), fail_(std::move(fail)) {}

  // Before any context.
  ContextPtr Initial() const;
  struct How {
    bool override_protected = false;
    bool propagate = true;
  };
  // `local` laid over `active`.
  ContextPtr Process(const ContextPtr& active, const Value& local, How how);
  // The same for the context of a term; the same answer is given again.
  ContextPtr ProcessScoped(const ContextPtr& active, const Value& local, How how);

  struct Against {
    bool document = false;  // relative to the document's base
    bool vocab = false;     // terms and @vocab count
  };
  // None for what has the form of a keyword and is none, and for a term that means nothing.
  std::optional<std::string> ExpandIri(const Context& active, std::string_view value,
                                       Against against);

 private:
  // One context that is being read.
  struct Work {
    Context& result;
    const Value& local;
    std::map<std::string, bool, std::less<>> defined;  // false: under way
    bool protects = false;
    bool override_protected = false;
    int under_way = 0;  // definitions that need each other nest
  };

  void ProcessOne(Context& result, const Value& local, How how);
  void ReadBase(Context& result, const Value& value);
  void ReadVocab(Context& result, const Value& value);
  void Define(Work& work, const std::string& term);
  void ReadDefinition(Work& work, const std::string& term, const Value& value, bool is_simple,
                      TermDefinition& definition, bool& is_ignored);
  void ReadReverse(Work& work, const Value& value, TermDefinition& definition, bool& is_ignored);
  void ReadId(Work& work, const std::string& term, const Value& id, bool is_simple,
              TermDefinition& definition, bool& is_ignored);
  void FindIri(Work& work, const std::string& term, const Value& value, TermDefinition& definition);
  void ReadType(Work& work, const Value& type, TermDefinition& definition);
  void ReadContainer(const Value& container, TermDefinition& definition);
  void ReadRest(Work& work, const std::string& term, const Value& value,
                TermDefinition& definition);
  void Keep(Work& work, const std::string& term, TermDefinition definition,
            const TermDefinition* before, std::size_t offset);
  std::optional<std::string> ExpandIn(Work& work, std::string_view value, Against against);
  std::optional<std::string> Expand(Work* work, const Context& active, std::string_view value,
                                    Against against);
  void SetTerm(Context& context, const std::string& term,
               std::shared_ptr<const TermDefinition> definition);
  std::shared_ptr<Context> Extend(const ContextPtr& active);

  std::string base_;
  Fail fail_;
  std::size_t copied_terms_ = 0;
  struct Key {
    const Context* active;
    const Value* local;
    int how;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  struct Scoped {
    ContextPtr active;  // keeps the key's address in use
    ContextPtr result;
  };
  std::map<Key, Scoped> scoped_;
};

}  // namespace lares::rdf::jsonld
