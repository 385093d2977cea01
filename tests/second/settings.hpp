// SPDX-License-Identifier: GPL-3.0-or-later
// What the second implementation is asked for, and the mistakes that can be planted in it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tetproof::second {

/// Errors that implementers of the paper make. Each is one line or two, at the place its comment names.
enum class Mistake {
  none,
  table2_row,                      ///< Table 2, row 12f: the second tetrahedron is (v1,v3,p24,p34)
  higher_diagonal,                 ///< D9: the diagonal starts at the higher-numbered interior vertex
  table3_interior_end,             ///< Table 3, row 3b: the intersection closest to the interior end
  asked_for_both,                  ///< D6: a 0 asked for both signs becomes interior
  case5_kept,                      ///< D10: four surface points are kept wherever the centroid is
  distance_to_triangles,           ///< eq. (3.2): to the triangles, not to their vertices
  volumes_exchanged,               ///< eq. (3.1): V1 at the surface and V0 at d1
  signed_error,                    ///< eq. (3.3) without the absolute value
  signed_curvature,                ///< D15: |k1 + k2|, so that saddles count as flat
  inverted_curvature_weight,       ///< eq. (3.6): 1 at the largest curvature
  four_pieces,                     ///< eq. (3.5): L+3 for every split
  row_3b_as_3a,                    ///< Table 4: the unshared face is not looked for
  row_4c_on_face,                  ///< Table 4: the centroid of a face instead of the common edge's midpoint
  forgotten_surface_point,         ///< Table 4: the new point on an unshared simplex is not a surface point
  skewed_centroid,                 ///< the centroid of a face counts its first corner twice
  dilution_ignored,                ///< D17's second rule is missing
  worst_flip,                      ///< section 4: the triangulation that minimises the smallest quality
  flips_everywhere,                ///< section 4: O_i is the whole grid
  tetrahedron_without_neighbours,  ///< section 4: O_i is the new tetrahedra only
};

/// Every mistake but none, with the name that `tetproof-second --mistake` knows.
struct NamedMistake {
  Mistake mistake;
  const char* name;
};
const std::vector<NamedMistake>& mistakes();

enum class Quality { none, solid_angle, aspect_ratio };

struct Settings {
  bool outside = false;
  std::array<int, 3> cells{6, 0, 0};  ///< one along the longest side and zeros, or all three
  double box_scale = 1.2;
  double on_surface = 1e-6;  ///< of the shortest cell edge
  bool shortest_diagonals = false;
  bool literal = false;

  int insertions = -1;      ///< how many points at most; -1: until it ends by itself; 0: no step (v)
  double v0 = 0.2, v1 = 2;  ///< in mean volumes of the first grid
  std::optional<double> v0_absolute, v1_absolute;  ///< [length^3]; in place of the above
  std::optional<double> d1;  ///< [length]; the largest d_i of the first grid if not given
  double p = 1;
  bool curvature = false;
  bool past_dilution = false;
  Quality improve = Quality::solid_angle;
  double improve_below = 0.002;  ///< of a full solid angle

  bool remember_splits =
      true;  ///< keep the split of each tetrahedron from step to step; false: evaluate all anew
  Mistake mistake = Mistake::none;
};

}  // namespace tetproof::second
