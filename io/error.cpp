// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/error.hpp"

#include "io/bytes/one_line.hpp"

namespace tetproof {

InputError::InputError(const std::string& message) : std::runtime_error(io::in_one_line(message)) {}

}  // namespace tetproof
