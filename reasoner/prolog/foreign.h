// C++ exceptions end at the edge. Inside this folder's .cc files only (needs SWI-Prolog.h).
#pragma once

#include <cstdint>
#include <exception>
#include <string_view>

#include "base/error.h"

namespace lares::prolog {

// A Prolog exception is pending in this engine: leave the foreign predicate at once.
struct PendingException {};

// Raise error(Formal, _) and throw PendingException.
[[noreturn]] void ThrowTypeError(const char* type, std::uintptr_t culprit);
[[noreturn]] void ThrowInstantiationError();
[[noreturn]] void ThrowExistenceError(const char* type, const char* name);
// Raises lares_error(Code, Message); always false, to be returned to Prolog.
std::uintptr_t RaiseLaresError(Code code, std::string_view message);

// Runs the body of a foreign predicate; what it throws becomes a Prolog exception.
template <typename Body>
std::uintptr_t Guard(Body&& body) {
  try {
    return body();
  } catch (const PendingException&) {
    return 0;
  } catch (const Error& error) {
    return RaiseLaresError(error.code(), error.FullMessage());
  } catch (const std::exception& error) {
    return RaiseLaresError(Code::kInternal, error.what());
  }
}

}  // namespace lares::prolog
