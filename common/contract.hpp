#pragma once

#include <cstdio>
#include <cstdlib>

namespace evbal {

/// Ends the process, naming the contract that a caller broke and where it stands.
[[noreturn]] inline void contract_broken(const char* expected, const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: contract broken: expected %s (%s)\n", file, line, expected, condition);
  std::abort();
}

}  // namespace evbal

/// A precondition of a public function: aborts if `condition` does not hold, in Release builds (-DNDEBUG) too, since
/// whoever calls an installed library has no other. `expected` says in words what must hold. For what a caller may get
/// wrong and a comparison or two can tell; `assert` is for what only this project's own code could break.
#define EVBAL_EXPECT(condition, expected) \
  ((condition) ? static_cast<void>(0) : ::evbal::contract_broken(expected, #condition, __FILE__, __LINE__))
