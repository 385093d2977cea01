// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary between C and C++: no exception passes it, and the caller's floating-point environment does
// not either.
#pragma once

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <cfenv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "verify/c/tetproof.h"

namespace tetproof::c {

/// A call that is refused, with the status that tells why.
struct Refused : std::runtime_error {
  Refused(tetproof_status why, const std::string& message) : std::runtime_error(message), status(why) {}
  tetproof_status status;
};

[[noreturn]] inline void refuse_argument(const std::string& message) {
  throw Refused(TETPROOF_BAD_ARGUMENT, message);
}

/// Refuses a null pointer; `name` is the argument's.
template <class T>
T& needed(T* pointer, const char* name) {
  if (!pointer) refuse_argument(fmt::format("{} is null", name));
  return *pointer;
}

/// Fills `error`, if there is one, and returns `status`.
tetproof_status report_error(tetproof_error* error, tetproof_status status, const char* message) noexcept;
/// The same for the exception that is being handled.
tetproof_status report_exception(tetproof_error* error) noexcept;

/// The environment that the exact predicates need, as long as it lives: rounding to nearest, nothing flushed
/// to zero, no traps. Then the caller's comes back.
class DefaultEnvironment {
 public:
  DefaultEnvironment() {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultEnvironment() { std::fesetenv(&callers_); }
  DefaultEnvironment(const DefaultEnvironment&) = delete;
  DefaultEnvironment& operator=(const DefaultEnvironment&) = delete;

 private:
  std::fenv_t callers_;
};

/// Does the work of a function of the interface, and turns what it throws into a status.
template <class Work>
tetproof_status guarded(tetproof_error* error, const Work& work) noexcept {
  const DefaultEnvironment environment;
  try {
    work();
  } catch (...) {
    return report_exception(error);
  }
  return report_error(error, TETPROOF_OK, "");
}

/// The number of threads for work; `threads` 0: all. oneTBB has no more than it has anyway, and prints a
/// warning if it is asked for more.
int concurrency(std::int32_t threads);

/// Does work that may run on so many threads; 0: on all processors. Its arena takes its threads' environment
/// from this thread, and keeps the work apart from what else the caller does with oneTBB.
template <class Work>
void on_threads(std::int32_t threads, const Work& work) {
  tbb::task_arena arena(concurrency(threads));
  arena.execute(work);
}

/// A copy that tetproof_text_free frees. Throws std::bad_alloc.
char* text_for_caller(const std::string& text);

/// Sets `*result` to null, so that it is so if the call fails. Refuses a null pointer; `name` is the
/// argument's.
template <class T>
T*& result_of(T** result, const char* name) {
  needed(result, name) = nullptr;
  return *result;
}

}  // namespace tetproof::c
