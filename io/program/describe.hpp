// SPDX-License-Identifier: GPL-3.0-or-later
// What a document holds, in figures. No part of the libraries.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/document.hpp"

namespace tetproof {

std::string describe_text(const Document& document);
nlohmann::ordered_json describe_json(const Document& document);

}  // namespace tetproof
