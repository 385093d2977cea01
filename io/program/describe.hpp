// SPDX-License-Identifier: GPL-3.0-or-later
// Describes in numbers what a document holds. Not installed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/document.hpp"

namespace tetproof {

std::string describe_text(const Document& document);
/// The object under `input` in tetproof-convert's JSON.
nlohmann::ordered_json describe_json(const Document& document);

}  // namespace tetproof
