// SPDX-License-Identifier: GPL-3.0-or-later
// How a grid came about, as tetproof-mesh tells it. Not installed.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

#include "reference/generate.hpp"
#include "verify/surface.hpp"

namespace tetproof::reference {

/// For people: a line for the grid and one for each thing worth knowing.
std::string generation_text(const Generation& made);

/// The keys `generation`, and `adaptation` and `follow` if there was one.
void add_generation(nlohmann::ordered_json& json, const std::string& surface_name,
                    const verify::SurfaceReport& surface, const Generation& made);

}  // namespace tetproof::reference
