// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/group_names.hpp"

#include <string>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"

namespace tetproof::io {

std::optional<std::int64_t> group_number(std::string_view word) {
  std::int64_t number;
  if (!parse_integer(word, number) || number == 0 || std::to_string(number) != word) return {};
  return number;
}

}  // namespace tetproof::io
