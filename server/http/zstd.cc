#include "server/http/zstd.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <new>

#include "base/error.h"
#include "server/http/problem.h"

namespace lares::http {
namespace {

constexpr int kLevel = 3;

[[noreturn]] void ThrowDecoding(std::size_t code) {
  if (ZSTD_getErrorCode(code) == ZSTD_error_frameParameter_windowTooLarge) {
    throw Error(Code::kTooLarge, "the body was compressed with a window larger than 8 MiB");
  }
  if (ZSTD_getErrorCode(code) == ZSTD_error_memory_allocation) throw std::bad_alloc();
  throw ProblemError("bad-request",
                     std::string("the body is no Zstandard: ") + ZSTD_getErrorName(code));
}

void CheckEncoding(std::size_t code) {
  if (ZSTD_isError(code) != 0) {
    throw Error(Code::kInternal, std::string("Zstandard: ") + ZSTD_getErrorName(code));
  }
}

}  // namespace

struct ZstdDecoder::State {
  DecodeLimits limits;
  std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)> stream{ZSTD_createDStream(),
                                                                       &ZSTD_freeDStream};
  std::string piece = std::string(ZSTD_DStreamOutSize(), '\0');
  std::uint64_t taken = 0;
  std::uint64_t given = 0;
  bool in_frame = false;
};

ZstdDecoder::ZstdDecoder(const DecodeLimits& limits) : state_(std::make_unique<State>()) {
  if (state_->stream == nullptr) throw std::bad_alloc();
  state_->limits = limits;
  ZSTD_DCtx_setParameter(state_->stream.get(), ZSTD_d_windowLogMax, limits.max_window_log);
}

ZstdDecoder::~ZstdDecoder() = default;

void ZstdDecoder::Feed(std::string_view bytes, const Sink& sink) {
  State& state = *state_;
  state.taken += bytes.size();
  ZSTD_inBuffer input{bytes.data(), bytes.size(), 0};
  bool more = !bytes.empty();
  while (more) {
    ZSTD_outBuffer output{state.piece.data(), state.piece.size(), 0};
    const std::size_t left = ZSTD_decompressStream(state.stream.get(), &output, &input);
    if (ZSTD_isError(left) != 0) ThrowDecoding(left);
    state.in_frame = left != 0;
    state.given += output.pos;
    if (state.given > state.limits.max_bytes) {
      throw Error(Code::kTooLarge, "the body has more than the " +
                                       std::to_string(state.limits.max_bytes) +
                                       " bytes allowed here, once decoded");
    }
    if (state.given > state.limits.ratio_free_bytes &&
        state.given / state.limits.max_ratio > state.taken) {
      throw Error(Code::kTooLarge, "the body is compressed more than " +
                                       std::to_string(state.limits.max_ratio) + " times")
          .WithHint("send it without Content-Encoding");
    }
    if (output.pos > 0) sink(std::string_view(state.piece.data(), output.pos));
    // A full piece may be followed by more of what was taken in already.
    more = input.pos < input.size || (state.in_frame && output.pos == output.size);
  }
}

void ZstdDecoder::Finish() const {
  if (state_->in_frame || state_->taken == 0) {
    throw ProblemError("bad-request", "the compressed body ends before it is complete");
  }
}

struct ZstdEncoder::State {
  std::unique_ptr<ZSTD_CStream, std::size_t (*)(ZSTD_CStream*)> stream{ZSTD_createCStream(),
                                                                       &ZSTD_freeCStream};
  std::string piece = std::string(ZSTD_CStreamOutSize(), '\0');

  void Run(std::string_view bytes, ZSTD_EndDirective directive, const Sink& sink) {
    ZSTD_inBuffer input{bytes.data(), bytes.size(), 0};
    while (true) {
      ZSTD_outBuffer output{piece.data(), piece.size(), 0};
      const std::size_t left = ZSTD_compressStream2(stream.get(), &output, &input, directive);
      CheckEncoding(left);
      if (output.pos > 0) sink(std::string_view(piece.data(), output.pos));
      if (directive == ZSTD_e_continue ? input.pos == input.size : left == 0) return;
    }
  }
};

ZstdEncoder::ZstdEncoder() : state_(std::make_unique<State>()) {
  if (state_->stream == nullptr) throw std::bad_alloc();
  CheckEncoding(ZSTD_CCtx_setParameter(state_->stream.get(), ZSTD_c_compressionLevel, kLevel));
  CheckEncoding(ZSTD_CCtx_setParameter(state_->stream.get(), ZSTD_c_checksumFlag, 1));
}

ZstdEncoder::~ZstdEncoder() = default;

void ZstdEncoder::Feed(std::string_view bytes, const Sink& sink) {
  state_->Run(bytes, ZSTD_e_continue, sink);
}
void ZstdEncoder::Flush(const Sink& sink) { state_->Run({}, ZSTD_e_flush, sink); }
void ZstdEncoder::End(const Sink& sink) { state_->Run({}, ZSTD_e_end, sink); }

}  // namespace lares::http
