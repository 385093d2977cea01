// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes and distances as exact rational numbers, and their text. Internal.
#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <span>
#include <string>

#include "io/tet_mesh.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;
using RationalTriangle = std::array<RationalPoint, 3>;

/// The coordinates, which must be finite.
RationalPoint exact_point(const Eigen::Vector3d& p);
RationalTriangle exact_triangle(std::span<const Eigen::Vector3d> points,
                                const std::array<Index, 3>& triangle);
/// The point at these weights, whose sum is 1.
RationalPoint weighted(const RationalTriangle& triangle, const std::array<Rational, 3>& weights);

/// (b-a) x (c-a) . (d-a) / 6 [length^3].
Rational exact_volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                      const Eigen::Vector3d& d);
/// The sum over all tetrahedra; numbers must be in range, coordinates finite.
Rational exact_volume(const TetMesh& mesh);
/// What closed triangles enclose that point outwards.
Rational exact_volume(const TriangleSurface& surface);

/// [length^2]
Rational squared_distance(const RationalPoint& p, const RationalTriangle& t);
/// Of two triangles that do not meet.
Rational squared_distance(const RationalTriangle& s, const RationalTriangle& t);
/// To the nearest of the triangles, of which there must be one. Doubles choose those that are compared
/// exactly: all within a thousandth of the nearest's distance and 1e-12 of the size of the coordinates.
Rational squared_distance(const RationalPoint& p, std::span<const Eigen::Vector3d> points,
                          std::span<const std::array<Index, 3>> triangles);

/// The nearest point of a triangle, as weights of its corners; in doubles, which are only a proposal.
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& t);

/// A double near x, at most a unit in its last place off.
double rounded(const Rational& x);
/// "n/d" or "n".
std::string text_of(const Rational& x);
/// For people: "-3/7", or with the power of two of a long denominator apart: "-3/(7*2^120)".
std::string short_text(const Rational& x);
/// Six digits of x and its exact value: "-1.2e-19, exactly -3/2^64"; a short fraction stands alone: "0.5".
std::string value_text(const Rational& x);

}  // namespace tetproof::corpus
