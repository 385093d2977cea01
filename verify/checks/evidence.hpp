// SPDX-License-Identifier: GPL-3.0-or-later
// The stages in which a mesh is judged by itself. Each `examine_...` returns evidence, and each `check_...`
// records what the evidence says. Suspects refer to the evidence, which must outlive `Record::settle`.
// Internal.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "verify/checks/conformity.hpp"
#include "verify/checks/record.hpp"
#include "verify/checks/touching_parts.hpp"
#include "verify/mesh/boundary.hpp"
#include "verify/mesh/cracks.hpp"
#include "verify/mesh/mesh_volumes.hpp"
#include "verify/mesh/orientation.hpp"
#include "verify/mesh/unjudged_places.hpp"
#include "verify/triangles/intersections.hpp"

namespace tetproof::verify {

/// Numbers and coordinates.
struct PointEvidence {
  std::vector<Index> out_of_range, repeating;       ///< tetrahedra, ascending
  std::vector<std::pair<Index, Index>> not_finite;  ///< vertex and tetrahedron, ascending
  std::vector<std::uint8_t> excluded;          ///< 1: a tetrahedron without geometry; empty: there are none
  std::vector<std::vector<Index>> same_place;  ///< points with equal coordinates, each set ascending
};
PointEvidence examine_points(const TetMesh& mesh, const Record& record);
/// index-range, finite-coordinates, repeated-vertex, duplicate-point, unused-point.
void check_points(const TetMesh& mesh, const PointEvidence& points, const Unjudged& unjudged, Record& record);

/// Single tetrahedra, and how they meet.
struct TetrahedraEvidence {
  Orientations signs;
  FaceMatching faces;
  std::vector<std::vector<Index>> duplicates;  ///< tetrahedra with the same four vertices
};
TetrahedraEvidence examine_tetrahedra(const TetMesh& mesh, const PointEvidence& points, const Record& record);
/// duplicate-tet, inverted, flat, face-shared-thrice, face-orientation.
void check_tetrahedra(const TetMesh& mesh, const TetrahedraEvidence& tetrahedra, Record& record);

/// Empty if the check is not wanted.
Cracks examine_cracks(const TetMesh& mesh, const PointEvidence& points, const TetrahedraEvidence& tetrahedra,
                      const Record& record);
/// crack; the cause of each duplicate point at a crack.
void check_cracks(const TetMesh& mesh, const PointEvidence& points, const Cracks& cracks, Record& record);

/// The boundary of the mesh with its cracks closed.
struct BoundaryEvidence {
  Boundary boundary;
  /// Faces that met only when the cracks were closed: of each place two whose tetrahedra lie on one side.
  std::vector<std::array<FaceId, 2>> folded;
};
BoundaryEvidence examine_boundary(const TetMesh& mesh, const PointEvidence& points,
                                  const TetrahedraEvidence& tetrahedra, const Cracks& cracks);

/// A boundary face with the mesh on its outer side.
struct CoveredFace {
  Index face;   ///< position in `Boundary::faces`
  int winding;  ///< winding number of the other faces on its outer side
};

/// Places where the boundary meets itself, or nearly does.
struct ContactEvidence {
  Near near;
  Intersections meetings;
  std::vector<CoveredFace> covered;  ///< at most one for each group of faces
  Conformity conformity;
  std::vector<std::array<Index, 2>> near_pairs;  ///< faces that are near each other without being one place
  Interfaces interfaces;                         ///< filled by `examine_interfaces`
};
/// So many pairs of triangles that meet or are near each other are kept; the others are counted. All that are
/// counted are kept: one interface between two parts can have hundreds of thousands of pairs.
inline constexpr std::size_t most_pairs = most_counted_pairs;
ContactEvidence examine_contacts(const TetMesh& mesh, const Boundary& boundary, Record& record);
/// hanging-node, crossed-diagonal, near-contact.
void check_conformity(const TetMesh& mesh, const Boundary& boundary, const ContactEvidence& contacts,
                      Record& record);
/// Finds parts that touch, and drops covered faces that only such parts cover.
void examine_interfaces(const TetMesh& mesh, const PointEvidence& points,
                        const TetrahedraEvidence& tetrahedra, const Cracks& cracks, const Boundary& boundary,
                        ContactEvidence& contacts, Record& record);
/// So many faces of an interface are listed; the others are counted.
inline constexpr std::size_t most_faces_of_an_interface = 100;
/// non-conforming-interface; the cause of what the checks before found at an interface.
void check_interfaces(const TetMesh& mesh, const PointEvidence& points, const Boundary& boundary,
                      const ContactEvidence& contacts, Record& record);
/// boundary-self-intersection.
void check_self_intersection(const TetMesh& mesh, const Boundary& boundary, const ContactEvidence& contacts,
                             Record& record);
/// overlap.
void check_overlap(const TetMesh& mesh, const PointEvidence& points, const BoundaryEvidence& boundary,
                   const ContactEvidence& contacts, Record& record);
/// cavity. The largest `right_cavities` cavities are as they should be. Those at unjudged elements are not
/// judged: these may fill them.
void check_cavities(const TetMesh& mesh, const Boundary& boundary, const Conformity& conformity,
                    const MeshVolumes& volumes, std::size_t right_cavities, const UnjudgedPlaces& unjudged,
                    Record& record);
/// boundary-nonmanifold-edge, boundary-nonmanifold-vertex. Those at unjudged elements are not judged: they
/// may be inside the mesh.
void check_manifold(const TetMesh& mesh, const Boundary& boundary, const Conformity& conformity,
                    const UnjudgedPlaces& unjudged, Record& record);

}  // namespace tetproof::verify
