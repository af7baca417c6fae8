#include <libxml/xmlerror.h>
#include <raptor2.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "base/text.h"
#include "ontology/rdf/document_builder.h"
#include "ontology/rdf/parsers.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/xml_prescan.h"
#include "ontology/rdf/xml_recover.h"

namespace lares::rdf {
namespace {

constexpr std::size_t kMostWarnings = 100;

// A world serves one thread at a time. Freeing one would clean up libxml2 for the whole process, so
// they are kept for the next reader and never freed.
class Worlds {
 public:
  static Worlds& Get() {
    static auto* worlds = new Worlds;
    return *worlds;
  }
  raptor_world* Take() {
    const std::scoped_lock lock(mutex_);
    if (idle_.empty()) return Open();
    raptor_world* world = idle_.back();
    idle_.pop_back();
    return world;
  }
  void GiveBack(raptor_world* world) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(world);
  }

 private:
  static raptor_world* Open() {
    raptor_world* world = raptor_new_world();
    if (world == nullptr) throw Error(Code::kInternal, "Raptor cannot be started");
    raptor_world_set_flag(world, RAPTOR_WORLD_FLAG_WWW_SKIP_INIT_FINISH, 1);
    raptor_world_set_flag(world, RAPTOR_WORLD_FLAG_LIBXML_GENERIC_ERROR_SAVE, 0);
    raptor_world_set_flag(world, RAPTOR_WORLD_FLAG_LIBXML_STRUCTURED_ERROR_SAVE, 0);
    if (raptor_world_open(world) != 0) throw Error(Code::kInternal, "Raptor cannot be started");
    return world;
  }

  std::mutex mutex_;
  std::vector<raptor_world*> idle_;
};

class WorldLease {
 public:
  WorldLease() : world_(Worlds::Get().Take()) {}
  ~WorldLease() {
    raptor_world_set_log_handler(world_, nullptr, nullptr);
    raptor_world_set_generate_bnodeid_handler(world_, nullptr, nullptr);
    // Raptor leaves its own handlers behind in libxml2's state of this thread.
    xmlSetStructuredErrorFunc(nullptr, nullptr);
    xmlSetGenericErrorFunc(nullptr, nullptr);
    Worlds::Get().GiveBack(world_);
  }
  WorldLease(const WorldLease&) = delete;
  WorldLease& operator=(const WorldLease&) = delete;
  raptor_world* get() const { return world_; }

 private:
  raptor_world* world_;
};

struct ParserDeleter {
  void operator()(raptor_parser* parser) const { raptor_free_parser(parser); }
};
struct UriDeleter {
  void operator()(raptor_uri* uri) const { raptor_free_uri(uri); }
};

// What relative IRIs are resolved against when nobody stated a base; an IRI that still begins with
// it is refused.
constexpr std::string_view kNoBase = "x-lares-no-base://none/";

std::string_view TextOf(raptor_uri* uri) {
  std::size_t length = 0;
  const unsigned char* text = raptor_uri_as_counted_string(uri, &length);
  return {reinterpret_cast<const char*>(text), length};
}

std::string_view TextOf(const unsigned char* text, std::size_t length) {
  if (text == nullptr) return {};
  return {reinterpret_cast<const char*>(text), length};
}

class RaptorPass {
 public:
  RaptorPass(std::string_view bytes, const XmlSummary& summary, const ReadOptions& options)
      : bytes_(bytes), summary_(summary), options_(options), builder_(Format::kRdfXml, options) {}

  Document Run();

 private:
  static void OnLog(void* self, raptor_log_message* message);
  static void OnStatement(void* self, raptor_statement* statement);
  static void OnNamespace(void* self, raptor_namespace* space);
  static unsigned char* OnBlank(void* self, unsigned char* label);

  void Parse(raptor_world* world);
  void Fail();
  void CheckBase(std::string_view iri) const;
  std::uint32_t TermOf(const raptor_term& term);
  std::uint32_t ObjectOf(const raptor_term& term, std::uint32_t predicate);
  std::string_view LanguageOfAttribute(std::string_view predicate, std::string_view value);
  int Line() const;
  // The first tag on `line` or the last before it: Raptor knows lines only.
  Place PlaceOfTag(int line) const;
  Place Here() const;

  std::string_view bytes_;
  const XmlSummary& summary_;
  const ReadOptions& options_;
  DocumentBuilder builder_;
  raptor_parser* parser_ = nullptr;
  std::uint64_t blanks_ = 0;
  std::vector<bool> is_used_;  // of summary_.tagged_attributes
  std::exception_ptr failure_;
};

Document RaptorPass::Run() {
  {
    const WorldLease world;
    raptor_world_set_log_handler(world.get(), this, &OnLog);
    raptor_world_set_generate_bnodeid_handler(world.get(), this, &OnBlank);
    Parse(world.get());
  }
  if (failure_) std::rethrow_exception(failure_);
  return builder_.Finish();
}

void RaptorPass::Parse(raptor_world* world) {
  const std::unique_ptr<raptor_parser, ParserDeleter> parser(raptor_new_parser(world, "rdfxml"));
  const std::string base(options_.base_iri.empty() ? kNoBase : options_.base_iri);
  const std::unique_ptr<raptor_uri, UriDeleter> uri(
      raptor_new_uri(world, reinterpret_cast<const unsigned char*>(base.c_str())));
  if (!parser || !uri) throw Error(Code::kInternal, "Raptor cannot be started");
  parser_ = parser.get();
  raptor_parser_set_option(parser_, RAPTOR_OPTION_NO_NET, nullptr, 1);
  raptor_parser_set_option(parser_, RAPTOR_OPTION_NO_FILE, nullptr, 1);
  raptor_parser_set_option(parser_, RAPTOR_OPTION_LOAD_EXTERNAL_ENTITIES, nullptr, 0);
  raptor_parser_set_statement_handler(parser_, this, &OnStatement);
  raptor_parser_set_namespace_handler(parser_, this, &OnNamespace);
  const auto* text = reinterpret_cast<const unsigned char*>(bytes_.data());
  const bool is_done = raptor_parser_parse_start(parser_, uri.get()) == 0 &&
                       raptor_parser_parse_chunk(parser_, text, bytes_.size(), 1) == 0;
  if (!is_done && !failure_) {
    failure_ =
        std::make_exception_ptr(Error(Code::kInvalid, "the document is not RDF/XML", Here()));
  }
  parser_ = nullptr;
}

// Keeps the exception at hand and makes Raptor stop.
void RaptorPass::Fail() {
  if (!failure_) {
    try {
      throw;
    } catch (const Error& error) {
      failure_ = std::make_exception_ptr(WithPlace(error, Here()));
    } catch (...) {
      failure_ = std::current_exception();
    }
  }
  if (parser_ != nullptr) raptor_parser_parse_abort(parser_);
}

void RaptorPass::OnLog(void* self, raptor_log_message* message) {
  auto& pass = *static_cast<RaptorPass*>(self);
  if (message->level < RAPTOR_LOG_LEVEL_WARN || pass.failure_) return;
  try {
    const int line = message->locator == nullptr ? 0 : std::max(0, message->locator->line);
    std::string text(Trim(message->text == nullptr ? "" : message->text));
    while (!IsUtf8(text)) text.pop_back();
    if (message->level > RAPTOR_LOG_LEVEL_WARN) {
      throw Error(Code::kInvalid, text, pass.PlaceOfTag(line));
    }
    auto& remarks = pass.builder_.document().remarks;
    if (remarks.size() >= kMostWarnings) return;
    remarks.push_back({Remark::Kind::kWarning, pass.PlaceOfTag(line), text});
  } catch (...) {
    pass.Fail();
  }
}

void RaptorPass::OnStatement(void* self, raptor_statement* statement) {
  auto& pass = *static_cast<RaptorPass*>(self);
  if (pass.failure_) return;
  try {
    const std::uint32_t subject = pass.TermOf(*statement->subject);
    const std::uint32_t predicate = pass.TermOf(*statement->predicate);
    pass.builder_.Add({subject, predicate, pass.ObjectOf(*statement->object, predicate)});
    if (pass.options_.record_lines) {
      pass.builder_.document().lines.push_back(static_cast<std::uint32_t>(pass.Line()));
    }
  } catch (...) {
    pass.Fail();
  }
}

void RaptorPass::OnNamespace(void* self, raptor_namespace* space) {
  auto& pass = *static_cast<RaptorPass*>(self);
  if (pass.failure_) return;
  try {
    const auto* prefix = raptor_namespace_get_prefix(space);
    raptor_uri* uri = raptor_namespace_get_uri(space);
    if (uri == nullptr) return;  // xmlns="" takes a default away
    pass.builder_.document().prefixes.emplace(
        prefix == nullptr ? "" : reinterpret_cast<const char*>(prefix), TextOf(uri));
  } catch (...) {
    pass.Fail();
  }
}

// Labels of the document are kept; generated ones are "gen1", "gen2", …, and a label that looks
// like one is moved out of their way.
unsigned char* RaptorPass::OnBlank(void* self, unsigned char* label) {
  auto& pass = *static_cast<RaptorPass*>(self);
  std::string text;
  if (label == nullptr) {
    text = "gen" + std::to_string(++pass.blanks_);
  } else {
    text = reinterpret_cast<const char*>(label);
    if (!text.starts_with("gen")) return label;
    text = "gen_" + text;
    raptor_free_memory(label);
  }
  auto* copy = static_cast<unsigned char*>(raptor_alloc_memory(text.size() + 1));
  if (copy != nullptr) std::copy_n(text.c_str(), text.size() + 1, copy);
  return copy;
}

void RaptorPass::CheckBase(std::string_view iri) const {
  if (!iri.starts_with(kNoBase)) return;
  throw Error(Code::kInvalid, "the IRI " + Quoted(iri.substr(kNoBase.size())) +
                                  " is relative, and no base IRI is known");
}

std::uint32_t RaptorPass::TermOf(const raptor_term& term) {
  switch (term.type) {
    case RAPTOR_TERM_TYPE_URI: {
      const std::string_view iri = TextOf(term.value.uri);
      CheckBase(iri);
      return builder_.Intern({TermKind::kIri, iri, {}, {}});
    }
    case RAPTOR_TERM_TYPE_BLANK:
      return builder_.Intern(
          {TermKind::kBlank, TextOf(term.value.blank.string, term.value.blank.string_len), {}, {}});
    case RAPTOR_TERM_TYPE_LITERAL: {
      const raptor_term_literal_value& literal = term.value.literal;
      TermView view{TermKind::kLiteral, TextOf(literal.string, literal.string_len), {}, {}};
      if (literal.datatype != nullptr) view.datatype = TextOf(literal.datatype);
      CheckBase(view.datatype);
      view.language = TextOf(literal.language, literal.language_len);
      return builder_.Intern(view);
    }
    default:
      throw Error(Code::kInternal, "a term of no kind");
  }
}

// The same attribute may be there twice on one line, in two languages: first come, first served.
std::string_view RaptorPass::LanguageOfAttribute(std::string_view predicate,
                                                 std::string_view value) {
  const auto& tagged = summary_.tagged_attributes;
  if (tagged.empty()) return {};
  const auto key = [](const TaggedAttribute& a) { return std::tie(a.line, a.predicate, a.value); };
  const TaggedAttribute wanted{Line(), std::string(predicate), std::string(value), {}};
  const auto [first, last] =
      std::equal_range(tagged.begin(), tagged.end(), wanted,
                       [&](const auto& a, const auto& b) { return key(a) < key(b); });
  is_used_.resize(tagged.size());
  for (auto it = first; it != last; ++it) {
    auto is_used = is_used_[static_cast<std::size_t>(it - tagged.begin())];
    if (is_used) continue;
    is_used = true;
    return it->language;
  }
  return {};
}

std::uint32_t RaptorPass::ObjectOf(const raptor_term& term, std::uint32_t predicate) {
  const raptor_term_literal_value& literal = term.value.literal;
  if (term.type != RAPTOR_TERM_TYPE_LITERAL || literal.datatype != nullptr ||
      literal.language != nullptr) {
    return TermOf(term);
  }
  const std::string_view value = TextOf(literal.string, literal.string_len);
  const std::string& name = builder_.document().terms[predicate].value;
  return builder_.Intern({TermKind::kLiteral, value, {}, LanguageOfAttribute(name, value)});
}

Place RaptorPass::PlaceOfTag(int line) const {
  if (line <= 0) return {options_.source, 0, 0};
  const std::size_t start = LineStart(bytes_, line);
  const std::size_t end = std::min(bytes_.find('\n', start), bytes_.size());
  std::size_t tag = bytes_.substr(0, end).find('<', start);
  if (tag == std::string_view::npos) tag = bytes_.substr(0, start).rfind('<');
  return PlaceAt(bytes_, tag == std::string_view::npos ? start : tag, options_.source);
}

int RaptorPass::Line() const {
  raptor_locator* locator = parser_ == nullptr ? nullptr : raptor_parser_get_locator(parser_);
  return locator == nullptr ? 0 : std::max(0, locator->line);
}

Place RaptorPass::Here() const { return PlaceOfTag(Line()); }

void SortByPlace(std::vector<Remark>& remarks) {
  const auto key = [](const Remark& remark) {
    return std::pair(remark.place.line, remark.place.column);
  };
  std::stable_sort(remarks.begin(), remarks.end(),
                   [&](const Remark& a, const Remark& b) { return key(a) < key(b); });
}

Document ReadWellFormed(std::string_view bytes, const ReadOptions& options) {
  const XmlSummary summary = CheckXml(bytes, options);
  Document document = RaptorPass(bytes, summary, options).Run();
  if (IsAbsoluteIri(summary.base_iri)) document.base_iri = summary.base_iri;
  document.remarks.insert(document.remarks.end(), summary.warnings.begin(), summary.warnings.end());
  SortByPlace(document.remarks);
  return document;
}

// Raptor reads past misplaced rdf:resource and drops what stands beside it; a document is loaded
// whole or not at all.
void RefuseWhatRaptorDrops(std::string_view bytes, const ReadOptions& options) {
  RepairedXml repaired;
  try {
    repaired = RepairXml(bytes, options);
  } catch (const Error& error) {
    if (error.code() == Code::kUnsupported) return;  // an encoding that is not looked into
    throw;
  }
  if (repaired.repairs.empty()) return;
  const RepairedXml::Repair& first = repaired.repairs.front();
  throw Error(Code::kInvalid, first.fault, first.place).WithHint("it can be repaired: --recover");
}

}  // namespace

Document ReadRdfXml(std::string_view bytes, const ReadOptions& options) {
  if (!options.recover) {
    Document document;
    try {
      document = ReadWellFormed(bytes, options);
    } catch (const Error& error) {
      throw ExplainXmlError(error, bytes, options);
    }
    RefuseWhatRaptorDrops(bytes, options);
    return document;
  }
  const RepairedXml repaired = RepairXml(bytes, options);
  try {
    Document document = ReadWellFormed(repaired.text, options);
    for (Remark& remark : document.remarks) {
      remark.place = OriginalPlace(repaired, bytes, remark.place);
    }
    for (const RepairedXml::Repair& repair : repaired.repairs) {
      document.remarks.push_back(
          {Remark::Kind::kRepair, repair.place, repair.fault + "; " + repair.remedy});
    }
    SortByPlace(document.remarks);
    return document;
  } catch (const Error& error) {
    if (!error.place()) throw;
    throw Error(error.code(), error.what(), OriginalPlace(repaired, bytes, *error.place()))
        .WithHint(error.hint());
  }
}

}  // namespace lares::rdf
