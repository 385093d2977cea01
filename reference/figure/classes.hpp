// SPDX-License-Identifier: GPL-3.0-or-later
// The classes into which a figure sorts tetrahedra by size or quality, their colours and their legend. Not
// installed.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/tet_mesh.hpp"
#include "reference/figure/figure.hpp"

namespace tetproof::reference {

using Colour = std::array<int, 3>;              ///< red, green and blue, 0 to 255
std::string hexadecimal(const Colour& colour);  ///< "#rrggbb"

/// Classes of a measured value. Class i holds the values below bounds[i] that are in no lower class; the last
/// class holds the rest.
struct Classes {
  std::string heading;
  std::vector<double> bounds;
  std::vector<std::string> labels;  ///< one for each bound

  std::size_t count() const { return bounds.size() + 1; }
  std::size_t of(double value) const;
  /// All colours are light, so that dark edges can be seen on them; small values have the stronger ones.
  Colour colour(std::size_t i) const;
  /// A field for each class, the largest on top, as lines of SVG.
  std::string legend() const;
  int legend_height() const;  ///< in pixels
};

/// What the figure shows of each of `tets`: its volume over the mean volume of all tetrahedra of the mesh, or
/// its smallest solid angle as a fraction of 4 pi.
std::vector<double> shown_values(const TetMesh& mesh, const std::vector<Index>& tets, FigureColour what);

/// Classes for these values. Bounds of volumes are powers of two: about one hundredth of the picture's area
/// is below the lowest of them, and one hundredth above the highest. `areas`: what each value takes of the
/// picture.
Classes classes_for(const std::vector<double>& values, const std::vector<double>& areas, FigureColour what);

}  // namespace tetproof::reference
