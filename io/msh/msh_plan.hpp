// SPDX-License-Identifier: GPL-3.0-or-later
// What the versions of .msh hold where Gmsh looks for it. The plans themselves: `Msh22Limits` of 2.2, and
// `EntityPlan` of 4.0 and 4.1.
#pragma once

#include <string>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/msh/msh22_limits.hpp"
#include "io/msh/msh_entities.hpp"

namespace tetproof::io {

/// `document` must outlive what is returned.
/// `ghosts`: whether the elements' partitions tell all ghost elements.
Holds msh22_holds(const Document& document, const Msh22Limits& limits, bool ghosts, bool binary);
/// Likewise; `format`: "msh40" or "msh41".
Holds msh4_holds(const Document& document, const EntityPlan& plan, const std::string& format, bool binary);

}  // namespace tetproof::io
