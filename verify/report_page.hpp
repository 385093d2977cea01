// SPDX-License-Identifier: GPL-3.0-or-later
// The report as a page of HTML with a view of the mesh and its defects in three dimensions.
#pragma once

#include <string>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// What was judged, for `report_page`.
struct PageSubject {
  const TetMesh& mesh;
  const Numbering& numbering;
  std::string mesh_name;                     ///< shown as it is; it may hold any characters
  const TriangleSurface* surface = nullptr;  ///< what the mesh was compared with, if anything
  std::string surface_name{};
  /// As in `Options`: the region of each tetrahedron as a position in `region_tags`; empty: one region.
  const std::vector<std::int64_t>& regions;
  const std::vector<RegionTag>& region_tags;
  /// Tetrahedra to show in a layer of their own, and what they are called; none if the name is empty.
  std::vector<Index> chosen{};
  std::string chosen_name{};
};

/// One file that opens from disk in any browser, without a network: the verdict, every finding with a place
/// to fly to, the table of checks, volumes, distances, regions, histograms of quality, and the view:
/// boundary, surface, defects with one ring around them, witness points, and the places of the largest
/// distances.
///
/// At most 20 MB, unless findings name very many tetrahedra: these are always there. The view holds all
/// tetrahedra, so that the mesh can be cut anywhere, where they fit (about 650,000); of larger meshes those
/// that planes through the middle meet, and a boundary drawn by at most 150,000 triangles. The page says what
/// it leaves out. The same input gives the same bytes.
std::string report_page(const Report& report, const PageSubject& subject);

}  // namespace tetproof::verify
