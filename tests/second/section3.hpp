// SPDX-License-Identifier: GPL-3.0-or-later
// Sections 3 and 4 of the paper, steps (v) and (vi): every choice by going through everything.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/trace.hpp"
#include "tests/second/section2.hpp"

namespace tetproof::second {

/// |k1| + |k2| at each vertex (reading D15).
std::vector<double> absolute_curvatures(const TriangleSurface& surface, Mistake mistake);

/// Eqs (3.1) to (3.3) and (3.6) for a tetrahedron.
struct Weight {
  double d = 0, kappa = 0, omega = 1, volume = 0, desired = 0, error = 0;
};

/// What is the same for all tetrahedra.
struct Law {
  double v0 = 0, v1 = 0, d1 = 0, p = 1;
  std::vector<double> kappas;  ///< by surface vertex; empty without curvature
  double kappa_min = 0, kappa_max = 0;
};

using Corners = std::array<Point, 4>;

double signed_volume(const Corners& corners);
/// Eq. (3.2), and the surface vertex that attains it.
std::pair<double, std::size_t> distance(const TriangleSurface& surface, const Corners& corners,
                                        Mistake mistake);
double desired_volume(double d, const Law& law, Mistake mistake);        ///< eq. (3.1), reading D13
double curvature_weight(double kappa, const Law& law, Mistake mistake);  ///< eq. (3.6)
Weight weigh(const TriangleSurface& surface, const Corners& corners, const Law& law, Mistake mistake);

/// How good a tetrahedron is (section 4): tan(Omega/2) of its smallest solid angle, or D/A as errata entry E5
/// reads it.
double quality(const Corners& corners, Quality kind);
/// Its smallest solid angle as a part of 1, the whole sphere.
double smallest_solid_angle(const Corners& corners);

/// A split as Table 4 asks for it.
struct Split {
  std::string row;
  std::vector<int> replaced;  ///< positions in the tetrahedron
  Point point;
  bool on_surface = false;  ///< is the new point a surface point
  double change = 0;        ///< of the sum of E_i
};

struct Tetrahedron {
  std::array<int, 4> v{};
  Weight weight;
  std::optional<Split> split;  ///< remembered
  bool refused = false;        ///< its split degenerates (D18)
};

/// The grid while it adapts.
class Adaptation {
 public:
  Adaptation(const TriangleSurface& surface, const Grid& grid, const Settings& settings);
  void run(std::vector<trace::Record>& records);
  /// Section 4 on a set of tetrahedra, by number.
  void improve(std::set<std::int64_t> set, std::vector<trace::Record>& records);
  TetMesh mesh() const;

 private:
  Corners corners(const std::array<int, 4>& v) const;
  void add(const std::array<int, 4>& v);
  void remove(std::int64_t number);
  void count(const std::array<int, 4>& v, int change);
  double sum() const;
  double average() const { return sum() / static_cast<double>(tets_.size()); }
  void weigh_first_grid(std::vector<trace::Record>& records);

  Split split_of(const std::array<int, 4>& v, double error) const;
  std::optional<std::int64_t> choose();
  bool degenerates(const std::array<int, 4>& v, const Split& split) const;
  std::set<std::int64_t> insert(std::int64_t number);

  std::set<std::int64_t> surroundings(const std::array<int, 4>& replaced,
                                      const std::set<std::int64_t>& pieces) const;
  struct FlipPlan;
  std::optional<FlipPlan> best_flip(const std::set<std::int64_t>& set) const;
  std::optional<FlipPlan> plan(const std::set<std::int64_t>& old) const;

  const TriangleSurface& surface_;
  Settings settings_;
  Law law_;
  std::vector<Point> points_;
  std::set<int> surface_points_;
  std::map<std::int64_t, Tetrahedron> tets_;  ///< by number; a number is never used twice
  std::int64_t next_ = 0;
  std::map<std::array<int, 3>, int> faces_;  ///< how many tetrahedra have a face, an edge
  std::map<std::array<int, 2>, int> edges_;
  std::int64_t insertions_ = 0, flips_ = 0, refused_ = 0;
};

}  // namespace tetproof::second
