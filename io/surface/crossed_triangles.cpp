// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/crossed_triangles.hpp"

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version_macros.h>
#if CGAL_VERSION_MAJOR < 6
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#else
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#endif

#include <iterator>

namespace tetproof::io {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_MAJOR < 6
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#else  // CGAL 6 renamed both
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#endif

Kernel::Point_3 point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

}  // namespace

struct CrossedTriangles::Tree {
  Triangles triangles;
  Boxes boxes;
};

CrossedTriangles::CrossedTriangles(const std::vector<Eigen::Vector3d>& points,
                                   const std::vector<std::array<Index, 3>>& triangles)
    : tree_(std::make_unique<Tree>()) {
  const auto p = [&](Index i) { return point(points[static_cast<std::size_t>(i)]); };
  for (const auto& [a, b, c] : triangles) tree_->triangles.emplace_back(p(a), p(b), p(c));
  tree_->boxes.insert(tree_->triangles.cbegin(), tree_->triangles.cend());
  tree_->boxes.build();
}

CrossedTriangles::~CrossedTriangles() = default;

std::vector<std::size_t> CrossedTriangles::of(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  std::vector<Boxes::Primitive_id> crossed;
  tree_->boxes.all_intersected_primitives(Kernel::Segment_3(point(from), point(to)),
                                          std::back_inserter(crossed));
  std::vector<std::size_t> numbers;
  for (const auto& triangle : crossed)
    numbers.push_back(static_cast<std::size_t>(triangle - tree_->triangles.cbegin()));
  return numbers;
}

}  // namespace tetproof::io
