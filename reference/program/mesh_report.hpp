// SPDX-License-Identifier: GPL-3.0-or-later
// Reports how a grid was made, as text and as JSON. Not installed.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

#include "reference/generate.hpp"
#include "verify/surface.hpp"

namespace tetproof::reference {

/// For people: a line for the grid, and a line for each remarkable fact.
std::string generation_text(const Generation& made);

/// Adds the keys `generation` and, if there was one, `adaptation` and `follow`.
void add_generation(nlohmann::ordered_json& json, const std::string& surface_name,
                    const verify::SurfaceReport& surface, const Generation& made);

}  // namespace tetproof::reference
