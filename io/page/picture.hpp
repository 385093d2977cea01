// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a scene as SVG, for where its view cannot be shown.
#pragma once

#include <string>

#include "io/page/scene.hpp"

namespace tetproof::io {

/// Draws the layers that are shown, the farthest triangles first, and the marks over them, in a parallel
/// projection. Layers of more than 3000 triangles are drawn by fewer. Of translucent layers only the outlines
/// of the triangles are drawn. The same scene gives the same bytes.
std::string picture_svg(const Scene& scene);

}  // namespace tetproof::io
