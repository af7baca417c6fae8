#include "reasoner/prolog/foreign.h"

#include <SWI-Prolog.h>

namespace lares::prolog {

void ThrowTypeError(const char* type, std::uintptr_t culprit) {
  PL_type_error(type, culprit);
  throw PendingException();
}

void ThrowInstantiationError() {
  PL_instantiation_error(0);
  throw PendingException();
}

void ThrowExistenceError(const char* type, const char* name) {
  const term_t culprit = PL_new_term_ref();
  if (PL_put_atom_chars(culprit, name)) PL_existence_error(type, culprit);
  throw PendingException();
}

std::uintptr_t RaiseLaresError(Code code, std::string_view message) {
  const std::string_view name = ToString(code);
  const term_t arguments = PL_new_term_refs(2), exception = PL_new_term_ref();
  const functor_t functor = PL_new_functor(PL_new_atom("lares_error"), 2);
  return PL_put_atom_nchars(arguments, name.size(), name.data()) &&
         PL_put_chars(arguments + 1, PL_STRING | REP_UTF8, message.size(), message.data()) &&
         PL_cons_functor_v(exception, functor, arguments) && PL_raise_exception(exception);
}

}  // namespace lares::prolog
