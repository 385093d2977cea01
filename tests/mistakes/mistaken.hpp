// SPDX-License-Identifier: GPL-3.0-or-later
// Plants mistakes in the page, from the outside: errors that implementers of the paper make.
#pragma once

#include <vector>

#include "io/trace.hpp"
#include "io/triangle_surface.hpp"
#include "reference/options.hpp"

namespace tetproof::mistakes {

/// Each mistake replaces one function of reference/paper.
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
  row_4c_on_face,                  ///< Table 4: the centroid of a face, not the common edge's midpoint
  forgotten_surface_point,         ///< Table 4: the new point on an unshared face or edge is no surface point
  skewed_centroid,                 ///< the centroid of a face counts its first corner twice
  dilution_ignored,                ///< D17: the rule of dilution is missing
  worst_flip,                      ///< section 4: one flip, the one that lowers the smallest quality most
  flips_everywhere,                ///< section 4: O_i is the whole grid
  tetrahedron_without_neighbours,  ///< section 4: O_i has only the new tetrahedra
};

/// A mistake, and its name for `tetproof-mistaken --mistake`.
struct NamedMistake {
  Mistake mistake;
  const char* name;
};

/// Every mistake except `none`.
const std::vector<NamedMistake>& mistakes();

/// Steps (i) to (vi) by the page with a mistake: the records of the trace, with the settings first. Needs a
/// surface and options as `reference::generate` does, and throws as it does.
std::vector<trace::Record> run(const TriangleSurface& surface, reference::Options options, Mistake mistake);

}  // namespace tetproof::mistakes
