// SPDX-License-Identifier: GPL-3.0-or-later
// What a page's view in three dimensions shows: tetrahedra, layers of triangles, marks, and places to fly to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::io {

/// Triangles that are shown and hidden together: `triangles`, or `faces`.
struct SceneLayer {
  std::string id;                                 ///< of the switch on the page: letters and "-"
  std::string name;                               ///< what the switch is called
  std::vector<std::array<Index, 3>> triangles{};  ///< positions in `Scene::points`
  /// For each of `triangles` a tetrahedron that it is a face of, as a position in `Scene::tets`. Empty: they
  /// belong to no tetrahedra.
  std::vector<Index> tets{};
  /// Faces of tetrahedra: 4 * (position in `Scene::tets`) + position in `tet_faces`.
  std::vector<std::uint32_t> faces{};
  /// A value of each triangle or face that can colour it, such as a distance; NaN: none. Empty: no values.
  std::vector<float> values{};
  std::string colour = "#8fb4d8";  ///< "#rrggbb", where nothing else colours it
  double opacity = 1;
  bool shown = true;
  bool boundary = false;  ///< the boundary of the tetrahedra: the cut takes its place
};

/// Edges that are shown and hidden together.
struct SceneEdges {
  std::string id, name;
  std::vector<std::array<Index, 2>> edges;  ///< positions in `Scene::points`
  std::string colour = "#333333";
  bool shown = true;
};

/// A point with a word beside it.
struct SceneMark {
  Eigen::Vector3d point;  ///< [length]
  std::string text;
  std::string colour = "#c8102e";
};

/// A place to fly to.
struct SceneTarget {
  Eigen::Vector3d middle;                     ///< [length]
  double radius = 0;                          ///< of a ball around all that belongs to it [length]
  std::string text;                           ///< what it is, with the file's own numbers
  std::vector<Index> tets;                    ///< positions in `Scene::tets`, to be outlined
  std::vector<Index> nodes;                   ///< positions in `Scene::points`, to be marked
  std::vector<std::array<Index, 3>> faces{};  ///< of such positions, to be outlined
};

struct Scene {
  std::vector<Eigen::Vector3d> points;  ///< [length]
  std::vector<std::array<Index, 4>> tets;
  /// The first `cut_tets` tetrahedra are shown by the cut; the others only tell about themselves when they
  /// are clicked.
  std::size_t cut_tets = 0;
  std::string cut_axes = "xyz";  ///< the axes across which the mesh can be cut
  /// False: the mesh can be cut in its middle only, and the first `cut_tets` are those that such planes meet.
  bool cut_anywhere = true;
  Eigen::Vector3d cut_middle = Eigen::Vector3d::Zero();
  std::vector<std::int64_t> tet_numbers, point_numbers;  ///< the file's; of points without one: -1
  std::vector<std::int32_t> tet_regions;                 ///< positions in `regions`; empty: one region
  std::vector<std::string> regions;                      ///< the names of the regions
  std::string value_name;                                ///< what `SceneLayer::values` measures
  std::vector<SceneLayer> layers;
  std::vector<SceneEdges> edges;
  std::vector<SceneMark> marks;
  std::vector<SceneTarget> targets;
};

/// The triangles of a layer, whether it has them as triangles or as faces.
std::vector<std::array<Index, 3>> triangles_of(const Scene& scene, const SceneLayer& layer);

/// The scene as JSON for the page's scripts (scene.js). Arrays of numbers are base64 of little-endian values;
/// the corners of tetrahedra have three bytes each, so there may be 2^24 points. No character of the text can
/// end the element of the page that holds it. Throws std::logic_error if there are more points.
std::string scene_json(const Scene& scene);
}  // namespace tetproof::io
