#include <serd/serd.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

#include "base/text.h"
#include "ontology/rdf/document_builder.h"
#include "ontology/rdf/iri_resolve.h"
#include "ontology/rdf/parsers.h"
#include "ontology/rdf/position.h"
#include "ontology/rdf/term_checks.h"
#include "ontology/rdf/turtle_prescan.h"

namespace lares::rdf {
namespace {

constexpr std::size_t kPageBytes = 1 << 16;

struct SerdReaderDeleter {
  void operator()(SerdReader* reader) const { serd_reader_free(reader); }
};

std::string_view TextOf(const SerdNode& node) {
  return {reinterpret_cast<const char*>(node.buf), node.n_bytes};
}

SerdSyntax SyntaxOf(Format format) {
  switch (format) {
    case Format::kTriG:
      return SERD_TRIG;
    case Format::kNTriples:
      return SERD_NTRIPLES;
    case Format::kNQuads:
      return SERD_NQUADS;
    default:
      return SERD_TURTLE;
  }
}

// One pass of Serd over a text. Serd calls back from C, so nothing may be thrown through it: the
// callbacks keep what went wrong and stop the parser.
class SerdPass {
 public:
  SerdPass(std::string_view bytes, Format format, const ReadOptions& options)
      : bytes_(bytes), format_(format), options_(options), builder_(format, options) {
    base_ = options.base_iri;
  }

  // `page_bytes` 1 makes consumed() exact after a failure.
  void Run(std::size_t page_bytes);

  bool failed() const { return syntax_error_ || failure_; }
  bool failed_in_syntax() const { return syntax_error_.has_value(); }
  std::size_t consumed() const { return consumed_; }
  // The fault, where it is. Only after failed().
  Error Fault() const;
  Document Finish() { return builder_.Finish(); }

 private:
  struct SyntaxError {
    std::string message;
    int line = 0;
    int column = 0;
  };

  static std::size_t Read(void* buffer, std::size_t size, std::size_t count, void* self);
  static int HasReadError(void*) { return 0; }
  static SerdStatus OnError(void* self, const SerdError* error);
  static SerdStatus OnBase(void* self, const SerdNode* iri);
  static SerdStatus OnPrefix(void* self, const SerdNode* name, const SerdNode* iri);
  static SerdStatus OnStatement(void* self, SerdStatementFlags flags, const SerdNode* graph,
                                const SerdNode* subject, const SerdNode* predicate,
                                const SerdNode* object, const SerdNode* datatype,
                                const SerdNode* language);
  template <typename Work>
  SerdStatus Guard(Work&& work);

  std::string_view IriOf(const SerdNode& node, std::string& scratch);
  std::string_view Expand(std::string_view name, std::string& scratch);
  std::string_view Resolve(const SerdNode& node, std::string& scratch);
  std::uint32_t TermOf(const SerdNode& node);
  std::uint32_t LiteralOf(const SerdNode& node, const SerdNode* datatype, const SerdNode* language);
  Place PlaceOfCulprit() const;

  std::string_view bytes_;
  Format format_;
  const ReadOptions& options_;
  DocumentBuilder builder_;
  std::unordered_map<std::string, std::string> prefixes_;
  std::string base_;
  std::size_t consumed_ = 0;
  std::string value_, datatype_, culprit_;  // scratch; the term at work, as written
  std::optional<SyntaxError> syntax_error_;
  std::exception_ptr failure_;
};

void SerdPass::Run(std::size_t page_bytes) {
  const std::unique_ptr<SerdReader, SerdReaderDeleter> reader(
      serd_reader_new(SyntaxOf(format_), this, nullptr, &OnBase, &OnPrefix, &OnStatement, nullptr));
  serd_reader_set_strict(reader.get(), true);
  serd_reader_set_error_sink(reader.get(), &OnError, this);
  const SerdStatus status =
      serd_reader_read_source(reader.get(), &Read, &HasReadError, this,
                              reinterpret_cast<const uint8_t*>("document"), page_bytes);
  if (status > SERD_FAILURE && !failed()) {
    syntax_error_ = SyntaxError{reinterpret_cast<const char*>(serd_strerror(status)), 0, 0};
  }
}

std::size_t SerdPass::Read(void* buffer, std::size_t size, std::size_t count, void* self) {
  auto& pass = *static_cast<SerdPass*>(self);
  const std::size_t wanted = std::min(size * count, pass.bytes_.size() - pass.consumed_);
  std::memcpy(buffer, pass.bytes_.data() + pass.consumed_, wanted);
  pass.consumed_ += wanted;
  return wanted;
}

SerdStatus SerdPass::OnError(void* self, const SerdError* error) {
  auto& pass = *static_cast<SerdPass*>(self);
  if (pass.failed()) return SERD_SUCCESS;
  char message[256];
  std::vsnprintf(message, sizeof message, error->fmt, *error->args);
  std::string text(Trim(message));
  while (!IsUtf8(text)) text.pop_back();
  pass.syntax_error_ =
      SyntaxError{text, static_cast<int>(error->line), static_cast<int>(error->col)};
  return SERD_SUCCESS;
}

template <typename Work>
SerdStatus SerdPass::Guard(Work&& work) {
  if (failed()) return SERD_ERR_INTERNAL;
  try {
    work();
    return SERD_SUCCESS;
  } catch (...) {
    failure_ = std::current_exception();
    return SERD_ERR_INTERNAL;
  }
}

SerdStatus SerdPass::OnBase(void* self, const SerdNode* iri) {
  auto& pass = *static_cast<SerdPass*>(self);
  return pass.Guard([&] {
    const std::string base(pass.IriOf(*iri, pass.value_));
    if (const auto fault = FaultOf({TermKind::kIri, base, {}, {}})) {
      throw Error(Code::kInvalid, *fault);
    }
    pass.base_ = base;
    if (pass.options_.base_iri.empty() && pass.builder_.document().base_iri.empty()) {
      pass.builder_.document().base_iri = base;
    }
  });
}

SerdStatus SerdPass::OnPrefix(void* self, const SerdNode* name, const SerdNode* iri) {
  auto& pass = *static_cast<SerdPass*>(self);
  return pass.Guard([&] {
    const std::string prefix(TextOf(*name));
    const std::string space(pass.IriOf(*iri, pass.value_));
    if (const auto fault = FaultOf({TermKind::kIri, space, {}, {}})) {
      throw Error(Code::kInvalid, *fault);
    }
    pass.prefixes_[prefix] = space;
    pass.builder_.document().prefixes[prefix] = space;
  });
}

SerdStatus SerdPass::OnStatement(void* self, SerdStatementFlags, const SerdNode* graph,
                                 const SerdNode* subject, const SerdNode* predicate,
                                 const SerdNode* object, const SerdNode* datatype,
                                 const SerdNode* language) {
  auto& pass = *static_cast<SerdPass*>(self);
  return pass.Guard([&] {
    Statement statement;
    statement.subject = pass.TermOf(*subject);
    if (predicate->type == SERD_BLANK || predicate->type == SERD_LITERAL) {
      pass.culprit_ = TextOf(*predicate);
      throw Error(Code::kInvalid, "the predicate is not an IRI");
    }
    statement.predicate = pass.TermOf(*predicate);
    statement.object = object->type == SERD_LITERAL ? pass.LiteralOf(*object, datatype, language)
                                                    : pass.TermOf(*object);
    if (graph != nullptr && graph->type != SERD_NOTHING) statement.graph = pass.TermOf(*graph);
    pass.builder_.Add(statement);
  });
}

// The absolute IRI of a node; points into the node or into `scratch`.
std::string_view SerdPass::IriOf(const SerdNode& node, std::string& scratch) {
  if (node.type == SERD_CURIE) {
    culprit_ = TextOf(node);
    return Expand(culprit_, scratch);
  }
  culprit_.assign("<").append(TextOf(node)).append(">");
  if (format_ == Format::kNTriples || format_ == Format::kNQuads) return TextOf(node);
  return Resolve(node, scratch);
}

std::string_view SerdPass::Expand(std::string_view name, std::string& scratch) {
  const std::size_t colon = name.find(':');
  scratch.assign(name.substr(0, colon));
  const auto row = prefixes_.find(scratch);
  if (row == prefixes_.end()) {
    throw Error(Code::kInvalid, "the prefix '" + scratch + ":' is not declared");
  }
  scratch.assign(row->second).append(name.substr(colon + 1));
  return scratch;
}

std::string_view SerdPass::Resolve(const SerdNode& node, std::string& scratch) {
  if (base_.empty() || serd_uri_string_has_scheme(node.buf)) return TextOf(node);
  ResolveIri(TextOf(node), base_, scratch);
  return scratch;
}

std::uint32_t SerdPass::TermOf(const SerdNode& node) {
  if (node.type != SERD_BLANK) {
    return builder_.Intern({TermKind::kIri, IriOf(node, value_), {}, {}});
  }
  return builder_.Intern({TermKind::kBlank, TextOf(node), {}, {}});
}

std::uint32_t SerdPass::LiteralOf(const SerdNode& node, const SerdNode* datatype,
                                  const SerdNode* language) {
  TermView term{TermKind::kLiteral, TextOf(node), {}, {}};
  if (datatype != nullptr && datatype->type != SERD_NOTHING) {
    term.datatype = IriOf(*datatype, datatype_);
  }
  if (language != nullptr && language->type != SERD_NOTHING) term.language = TextOf(*language);
  culprit_ = term.language.empty() ? term.value : term.language;
  return builder_.Intern(term);
}

// Statements are reported once they are whole, so the term is a little before what was consumed.
Place SerdPass::PlaceOfCulprit() const {
  const std::string_view before = bytes_.substr(0, consumed_);
  const std::size_t found = culprit_.empty() ? std::string_view::npos : before.rfind(culprit_);
  const std::size_t offset = found == std::string_view::npos ? consumed_ : found;
  return PlaceAt(bytes_, offset, options_.source);
}

Error SerdPass::Fault() const {
  if (syntax_error_) {
    const SyntaxError& error = *syntax_error_;
    const Place place =
        error.line == 0
            ? PlaceAt(bytes_, consumed_, options_.source)
            : PlaceAt(bytes_,
                      std::min(LineStart(bytes_, error.line) +
                                   static_cast<std::size_t>(std::max(0, error.column - 1)),
                               bytes_.size()),
                      options_.source);
    return Error(Code::kInvalid, error.message, place);
  }
  try {
    std::rethrow_exception(failure_);
  } catch (const Error& error) {
    return WithPlace(error, PlaceOfCulprit());
  }
}

}  // namespace

Document ReadWithSerd(std::string_view bytes, Format format, const ReadOptions& options) {
  const bool is_nested = format == Format::kTurtle || format == Format::kTriG;
  if (is_nested || bytes.find('\0') != std::string_view::npos) CheckTurtleText(bytes, options);
  SerdPass pass(bytes, format, options);
  pass.Run(kPageBytes);
  if (!pass.failed()) return pass.Finish();
  if (pass.failed_in_syntax()) throw pass.Fault();
  // The fault is one of ours: read again, byte by byte, to know where.
  SerdPass exact(bytes, format, options);
  exact.Run(1);
  throw exact.failed() ? exact.Fault() : pass.Fault();
}

}  // namespace lares::rdf
