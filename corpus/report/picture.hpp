// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a surface and of a defect in its mesh, as SVG. Internal.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "corpus/report/statements.hpp"
#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

struct PictureText {
  std::string title;  ///< one line; cut where it is too long
  std::string below;  ///< a line of small print; what the picture leaves out is added
};

/// Draws the surface in a parallel projection, and beside it the marked parts of the mesh, enlarged and from
/// a direction of their own, with the file's numbers. Without marks the surface alone, with the numbers of
/// its vertices if they are few. The directions are those that show most. At most 400 triangles are drawn,
/// the nearest to the defect; the picture says so. The same bytes on every machine; below 100 kB.
std::string picture(const TriangleSurface& surface, const TetMesh& mesh, const Numbering& numbering,
                    const Marks& marks, const PictureText& text);

}  // namespace tetproof::corpus
