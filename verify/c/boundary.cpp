// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/c/boundary.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

#include "io/bytes/one_line.hpp"
#include "io/error.hpp"
#include "verify/deadline.hpp"

namespace tetproof::c {
namespace {

constexpr std::size_t room = sizeof(tetproof_error::message);

// Copies as much as there is room for. Allocates nothing.
void put_message(char* to, const char* message) {
  const std::size_t length = std::strlen(message);
  if (length < room) {
    std::memcpy(to, message, length + 1);
    return;
  }
  std::size_t cut = room - sizeof "...";
  while (cut > 0 && (static_cast<unsigned char>(message[cut]) & 0xC0) == 0x80)
    --cut;  // inside of a character
  std::memcpy(to, message, cut);
  std::memcpy(to + cut, "...", sizeof "...");
}

tetproof_status report_internal(tetproof_error* error, const std::exception& fault) noexcept {
  try {
    const std::string message =
        "internal error, please report it with the input: " + io::in_one_line(fault.what());
    return report_error(error, TETPROOF_INTERNAL, message.c_str());
  } catch (...) {
    return report_error(error, TETPROOF_OUT_OF_MEMORY, "out of memory");
  }
}

}  // namespace

tetproof_status report_error(tetproof_error* error, tetproof_status status, const char* message) noexcept {
  if (!error) return status;
  error->status = status;
  put_message(error->message, message);
  return status;
}

tetproof_status report_exception(tetproof_error* error) noexcept {
  try {
    throw;
  } catch (const Refused& refused) {
    return report_error(error, refused.status, refused.what());
  } catch (const InputError& input) {
    return report_error(error, TETPROOF_BAD_INPUT, input.what());
  } catch (const verify::OutOfTime& late) {
    return report_error(error, TETPROOF_OUT_OF_TIME, late.what());
  } catch (const std::bad_alloc&) {
    return report_error(error, TETPROOF_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& fault) {
    return report_internal(error, fault);
  } catch (...) {
    return report_error(error, TETPROOF_INTERNAL, "internal error, please report it with the input");
  }
}

int concurrency(std::int32_t threads) {
  const std::size_t all = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return static_cast<int>(threads > 0 ? std::min(all, static_cast<std::size_t>(threads)) : all);
}

char* text_for_caller(const std::string& text) {
  char* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (!copy) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace tetproof::c

const char* tetproof_version(void) {
  return TETPROOF_VERSION_STRING;
}

const char* tetproof_status_name(tetproof_status status) {
  switch (status) {
    case TETPROOF_OK:
      return "TETPROOF_OK";
    case TETPROOF_BAD_ARGUMENT:
      return "TETPROOF_BAD_ARGUMENT";
    case TETPROOF_BAD_INPUT:
      return "TETPROOF_BAD_INPUT";
    case TETPROOF_TOO_LARGE:
      return "TETPROOF_TOO_LARGE";
    case TETPROOF_LOSSY:
      return "TETPROOF_LOSSY";
    case TETPROOF_OUT_OF_TIME:
      return "TETPROOF_OUT_OF_TIME";
    case TETPROOF_OUT_OF_MEMORY:
      return "TETPROOF_OUT_OF_MEMORY";
    case TETPROOF_INTERNAL:
      return "TETPROOF_INTERNAL";
    default:
      return "unknown status";
  }
}

void tetproof_text_free(char* text) {
  std::free(text);
}
