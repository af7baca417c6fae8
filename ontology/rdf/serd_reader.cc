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
#include "ontology/rdf/text_lines.h"
#include "ontology/rdf/turtle_prescan.h"

namespace lares::rdf {
namespace {

constexpr std::size_t kPageBytes = 1 << 16;
constexpr std::size_t kExact = 1;

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
    case Format::kNTriples:  // Serd takes some of Turtle for N-Triples, but not for N-Quads
    case Format::kNQuads:
      return SERD_NQUADS;
    default:
      return SERD_TURTLE;
  }
}

std::string ReadableMessage(std::string_view from_serd) {
  // Serd prints the end of the file as the character −1.
  if (from_serd.find("not `\xFF") != std::string_view::npos) return "unexpected end of file";
  std::string text(Trim(from_serd));
  while (!IsUtf8(text)) text.pop_back();
  if (text.find("%FFFFFFFF") != std::string::npos) return "end of file in an IRI";
  std::replace(text.begin(), text.end(), '`', '\'');
  return text;
}

// One pass of Serd over a text. Serd calls back from C, so nothing may be thrown through it: the
// callbacks keep what went wrong and stop the parser.
class SerdPass {
 public:
  SerdPass(std::string_view bytes, Format format, const ReadOptions& options)
      : bytes_(bytes), format_(format), options_(options), builder_(format, options) {
    base_ = options.base_iri;
  }

  // `page_bytes` kExact makes FaultOffset() exact for faults that Serd does not see.
  void Run(std::size_t page_bytes);

  bool failed() const { return syntax_error_ || failure_; }
  bool failed_in_syntax() const { return syntax_error_.has_value(); }
  // Serd ended without a complaint, perhaps before the end: at what FaultOffset() says.
  bool has_stopped() const { return has_stopped_; }
  bool has_label_clash() const { return has_label_clash_; }
  // The fault, and where it is in the text. Only after failed().
  Error Fault() const;
  std::size_t FaultOffset() const;
  Document Finish() { return builder_.Finish(); }

 private:
  struct SyntaxError {
    std::string message;
    int line = 0;
    int column = 0;
  };

  // A term as the text has it: "<" "http://…" ">".
  struct Writing {
    const char* front = "";
    std::string_view text;
    const char* back = "";
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

  std::string_view bytes_;
  Format format_;
  const ReadOptions& options_;
  DocumentBuilder builder_;
  std::unordered_map<std::string, std::string> prefixes_;
  std::string base_;
  std::size_t consumed_ = 0;
  std::uint32_t line_ = 1;        // of what was consumed, when that is byte by byte
  std::string value_, datatype_;  // scratch
  Writing at_work_;               // the term at work …
  std::string culprit_text_;      // … when something was wrong with it
  std::optional<SyntaxError> syntax_error_;
  bool has_label_clash_ = false;
  bool has_stopped_ = false;
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
  if (failed() || status == SERD_SUCCESS) return;
  if (status > SERD_FAILURE) {
    syntax_error_ = SyntaxError{reinterpret_cast<const char*>(serd_strerror(status)), 0, 0};
  } else {
    has_stopped_ = true;
  }
}

std::size_t SerdPass::Read(void* buffer, std::size_t size, std::size_t count, void* self) {
  auto& pass = *static_cast<SerdPass*>(self);
  const std::size_t wanted = std::min(size * count, pass.bytes_.size() - pass.consumed_);
  std::memcpy(buffer, pass.bytes_.data() + pass.consumed_, wanted);
  pass.consumed_ += wanted;
  if (wanted == 1 && *static_cast<const char*>(buffer) == '\n') ++pass.line_;
  return wanted;
}

SerdStatus SerdPass::OnError(void* self, const SerdError* error) {
  auto& pass = *static_cast<SerdPass*>(self);
  if (pass.failed()) return SERD_SUCCESS;
  char message[256];
  std::vsnprintf(message, sizeof message, error->fmt, *error->args);
  pass.syntax_error_ = SyntaxError{ReadableMessage(message), static_cast<int>(error->line),
                                   static_cast<int>(error->col)};
  pass.has_label_clash_ = error->status == SERD_ERR_ID_CLASH;
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
    culprit_text_ = at_work_.front + std::string(at_work_.text) + at_work_.back;
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
      pass.at_work_ = {"", TextOf(*predicate), ""};
      throw Error(Code::kInvalid, "the predicate is not an IRI");
    }
    statement.predicate = pass.TermOf(*predicate);
    statement.object = object->type == SERD_LITERAL ? pass.LiteralOf(*object, datatype, language)
                                                    : pass.TermOf(*object);
    if (graph != nullptr && graph->type != SERD_NOTHING) {
      statement.graph = pass.TermOf(*graph);
      if (pass.format_ == Format::kNTriples) {
        throw Error(Code::kInvalid, "a fourth term: N-Triples has no graphs, N-Quads has");
      }
    }
    pass.builder_.Add(statement);
    if (pass.options_.record_lines) pass.builder_.document().lines.push_back(pass.line_);
  });
}

// The absolute IRI of a node; points into the node or into `scratch`.
std::string_view SerdPass::IriOf(const SerdNode& node, std::string& scratch) {
  if (node.type == SERD_CURIE) {
    at_work_ = {"", TextOf(node), ""};
    return Expand(TextOf(node), scratch);
  }
  at_work_ = {"<", TextOf(node), ">"};
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
  at_work_ = {"_:", TextOf(node), ""};
  if (TextOf(node).starts_with('-')) {
    throw Error(Code::kInvalid, "the label of a blank node begins with '-'");
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
  at_work_ = {"", term.language.empty() ? term.value : term.language, ""};
  return builder_.Intern(term);
}

// Serd counts columns in bytes. It reports statements once they are whole, so a term at fault is a
// little before what was consumed.
std::size_t SerdPass::FaultOffset() const {
  if (syntax_error_ && syntax_error_->line > 0) {
    const auto column = static_cast<std::size_t>(std::max(1, syntax_error_->column));
    return std::min(LineStart(bytes_, syntax_error_->line) + column - 1, bytes_.size());
  }
  if (has_stopped_) return consumed_ - std::min<std::size_t>(consumed_, 1);  // it had looked at one
  const std::size_t found = culprit_text_.empty()
                                ? std::string_view::npos
                                : bytes_.substr(0, consumed_).rfind(culprit_text_);
  return found == std::string_view::npos ? consumed_ : found;
}

Error SerdPass::Fault() const {
  if (syntax_error_) return Error(Code::kInvalid, syntax_error_->message);
  try {
    std::rethrow_exception(failure_);
  } catch (const Error& error) {
    return error;
  }
}

[[noreturn]] void Throw(const SerdPass& pass, std::string_view bytes, const ReadOptions& options) {
  throw WithPlace(pass.Fault(), PlaceAt(bytes, pass.FaultOffset(), options.source));
}

Document ReadRelabelled(std::string_view bytes, Format format, const ReadOptions& options) {
  const RelabelledText relabelled = RelabelBlanks(bytes);
  SerdPass pass(relabelled.text, format, options);
  pass.Run(kExact);
  if (!pass.failed()) return pass.Finish();
  const std::size_t offset = relabelled.OriginalOffset(pass.FaultOffset());
  throw WithPlace(pass.Fault(), PlaceAt(bytes, offset, options.source));
}

bool HasStatements(std::string_view text, std::size_t count, Format format,
                   const ReadOptions& options) {
  SerdPass pass(text, format, options);
  pass.Run(kPageBytes);
  return !pass.failed() && !pass.has_stopped() && pass.Finish().statements.size() == count;
}

// The first line that is not one whole statement. Large blocks first: a reader for each line of a
// large text takes long.
std::optional<std::size_t> FindBadLine(std::string_view text, Format format,
                                       const ReadOptions& options) {
  constexpr std::size_t kBlockBytes = 1 << 18;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t newline = text.find('\n', begin + kBlockBytes);
    const std::size_t end = newline == std::string_view::npos ? text.size() : newline + 1;
    const std::string_view block = text.substr(begin, end - begin);
    if (!HasStatements(block, CountLines(block), format, options)) {
      std::optional<std::size_t> found;
      ForEachLine(block, [&](std::size_t at, std::string_view line) {
        if (!found && !HasStatements(line, 1, format, options)) found = begin + at;
      });
      if (found) return found;
    }
    begin = end;
  }
  return std::nullopt;
}

// N-Triples and N-Quads have one statement to a line; Serd does not mind, and stops in silence
// where a statement does not begin as it should.
void CheckLines(std::string_view bytes, std::size_t statements, Format format,
                const ReadOptions& options) {
  if (CountLines(bytes) == statements) return;
  const auto line = FindBadLine(bytes, format, options);
  if (!line) return;
  throw Error(Code::kInvalid, "this line does not hold one whole statement",
              PlaceAt(bytes, *line, options.source));
}

}  // namespace

Document ReadWithSerd(std::string_view bytes, Format format, const ReadOptions& options) {
  const bool is_nested = format == Format::kTurtle || format == Format::kTriG;
  if (is_nested || bytes.find('\0') != std::string_view::npos) {
    CheckTurtleText(bytes, format, options);
  }
  SerdPass pass(bytes, format, options);
  pass.Run(options.record_lines ? kExact : kPageBytes);
  if (pass.has_label_clash()) return ReadRelabelled(bytes, format, options);
  if (pass.failed_in_syntax()) Throw(pass, bytes, options);
  if (pass.failed() || pass.has_stopped()) {
    // The fault is one that Serd does not see: read again, byte by byte, to know where.
    SerdPass exact(bytes, format, options);
    exact.Run(kExact);
    if (exact.failed()) Throw(exact, bytes, options);
    if (!is_nested) CheckLines(bytes, 0, format, options);
    const std::size_t stop = exact.FaultOffset();
    const std::size_t left = stop + SkipBlank(bytes.substr(stop));
    if (left < bytes.size()) {
      throw Error(Code::kInvalid, "expected a statement", PlaceAt(bytes, left, options.source));
    }
  }
  Document document = pass.Finish();
  if (!is_nested) CheckLines(bytes, document.statements.size(), format, options);
  return document;
}

}  // namespace lares::rdf
