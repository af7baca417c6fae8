#include "reasoner/prolog/bundled_rules.h"

// The saved state that bundle.pl makes from reasoner/rules/*.pl. CMake says where it is and
// compiles this file anew whenever a rule changes.
asm(R"(
  .section .rodata
  .balign 16
  .global lares_bundled_rules
  .global lares_bundled_rules_end
lares_bundled_rules:
  .incbin ")" LARES_RULES_STATE R"("
lares_bundled_rules_end:
  .byte 0
  .previous
)");

extern "C" {
extern const unsigned char lares_bundled_rules[];
extern const unsigned char lares_bundled_rules_end[];
}

namespace lares::prolog {

std::span<const unsigned char> BundledRules() {
  return {lares_bundled_rules, lares_bundled_rules_end};
}

}  // namespace lares::prolog
