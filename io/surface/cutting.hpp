// SPDX-License-Identifier: GPL-3.0-or-later
// The rules by which polygons and facets are cut into triangles, the same for every format.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// What became of one polygon or facet.
struct Cut {
  std::vector<std::array<Index, 3>> triangles;  ///< positions of points, wound as the polygon
  /// Of one that is not planar: the largest angle between two triangles at an edge [degrees]; 0: planar.
  double bend = 0;
  std::string fault;  ///< why it cannot be cut: "crosses itself"; empty: it was
};

/// Cuts a polygon of three corners or more, of which neighbours differ. `Fan` (io/surface/polygons.hpp) tells
/// which kind it is:
///  - planar and convex: it is cut into a fan;
///  - planar and not convex: into the constrained Delaunay triangulation, see io/surface/planar_cut.hpp;
///  - a quadrangle that is not planar: along its shorter diagonal, or along the one with the smallest
///    position if both have the same length; never along one that would fold it over;
///  - larger and not planar: into the constrained Delaunay triangulation of what is seen along the axis next
///    to its normal.
/// `cut` is overwritten; its memory is used again.
void cut_polygon(std::span<const Index> corners, const std::vector<Eigen::Vector3d>& points, Cut& cut);

/// Cuts a facet of several polygons, of which some may be edges and points, or with holes: the constrained
/// Delaunay triangulation of all, wound as the polygon with the largest area. A facet without area has no
/// triangles.
void cut_facet(std::span<const std::span<const Index>> polygons, std::span<const Eigen::Vector3d> holes,
               const std::vector<Eigen::Vector3d>& points, Cut& cut);

/// Counts what was not planar, for one warning.
struct Bends {
  std::size_t quadrangles = 0, polygons = 0;
  double largest = 0;  ///< [degrees]

  void add(const Cut& cut, std::size_t corners) {
    if (cut.bend == 0) return;
    ++(corners == 4 ? quadrangles : polygons);
    largest = cut.bend > largest ? cut.bend : largest;
  }
  /// "2 quadrangles are not planar: cut along the shorter diagonal; the largest bend is 5.7 degrees"; empty:
  /// none.
  std::string text() const;
};

/// The facets of a document by their elements, for code that goes from element to element.
class Facets {
 public:
  explicit Facets(const Document& document);

  /// The facet of several polygons or with holes that has the element; null: none.
  const Facet* of(std::size_t element) const;
  /// Whether any of `count` elements from `first` on belongs to a facet.
  bool any_in(std::size_t first, std::size_t count) const;
  /// Cuts a facet. `moved`: the position of each node in `points`; empty: its own. A facet that names a node
  /// which does not exist has a fault.
  void cut(const Facet& facet, const std::vector<Index>& moved, const std::vector<Eigen::Vector3d>& points,
           Cut& cut) const;

 private:
  const Document& document_;
  std::vector<const Facet*> sorted_;
};

}  // namespace tetproof::io
