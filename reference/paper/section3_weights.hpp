// SPDX-License-Identifier: GPL-3.0-or-later
// Section 3, step (v): eqs (3.1) to (3.6), curvature, and the present grid. README.md has the page's sentence
// for each function.
#pragma once

#include <Eigen/Dense>

#include "io/error.hpp"
#include "reference/paper/section2.hpp"

namespace tetproof::reference::paper {

using Corners = std::array<Point, 4>;
using Numbers = std::set<std::int64_t>;  ///< of tetrahedra

using trace::Weight;  ///< a tetrahedron's values in eqs (3.1) to (3.3) and (3.6)

/// The split that Table 4 prescribes.
struct Split {
  int row = 0;                  ///< in `tables::table4`
  std::vector<int> replaced{};  ///< positions in the tetrahedron: the corners of what holds the new point
  Point point{};
  bool on_surface = false, moved = false;  ///< a surface point; moved to the parametric surface
  double change = 0;                       ///< of the sum of errors
};

struct Tetrahedron {
  Tet v{};
  Weight weight;
  std::optional<Split> split{};        ///< as evaluated before: it changes only with the tetrahedron (D19)
  bool refused = false, left = false;  ///< the split degenerates (D18); its point must not be moved (D12)
};

class Weights : public Section2 {
 public:
  using Section2::Section2;

  // --- the present grid

  Corners corners(const Tet& v) const { return {points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]}; }
  static bool positive(const Corners& t) { return orientation(t[0], t[1], t[2], t[3]) > 0; }

  /// Counts the tetrahedra at each edge and each face of v up or down.
  void count(Tet v, int change) {
    std::sort(v.begin(), v.end());
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) {
        shares_[{v[a], v[b]}] += change;
        for (int c = b + 1; c < 4; ++c) shares_[{v[a], v[b], v[c]}] += change;
      }
  }
  void add(const Tet& v) {
    tets_[next_++] = {.v = v, .weight = weigh(corners(v))};
    count(v, 1);
  }
  void remove(std::int64_t number) {
    count(tets_.at(number).v, -1);
    tets_.erase(number);
  }
  /// Whether two tetrahedra have an edge or a face of v, given by positions.
  bool is_shared(const Tet& v, const std::vector<int>& positions) const {
    return shares_.at(names(v, positions)) > 1;
  }
  static std::vector<int> names(const Tet& v, const std::vector<int>& positions) {
    std::vector<int> named;
    for (const int i : positions) named.push_back(v[i]);
    std::sort(named.begin(), named.end());
    return named;
  }

  // --- equations

  /// Eq. (3.2), reading D14.
  virtual double distance(const Point& centroid) const {
    double least = HUGE_VAL;
    for (const Point& x : surface_.vertices) least = std::min(least, squared_distance(centroid, x));
    return std::sqrt(least);
  }
  static double squared_distance(const Point& a, const Point& b) {
    const Point d = a - b;
    return d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
  }
  /// Eq. (3.1).
  virtual double desired(double d) const { return desired_volume(d, law_); }
  /// Eqs (3.3) and (3.6).
  virtual double error(double volume, double desired) const { return volume_error(volume, desired); }
  virtual double omega(double kappa) const { return curvature_weight(kappa, kappa_min_, kappa_max_); }

  Weight weigh(const Corners& t) const {
    const Point centre = centroid(t[0], t[1], t[2], t[3]);
    Weight w{.tet = t, .d = distance(centre), .volume = volume(t[0], t[1], t[2], t[3])};
    if (!kappas_.empty()) w.kappa = curvature_near(centre, w.d);
    if (w.kappa) w.omega = omega(*w.kappa);
    w.desired = desired(w.omega * w.d);
    w.error = error(w.volume, w.desired);
    return w;
  }
  double sum_of_errors() const {
    CompensatedSum sum;
    for (const auto& [number, tet] : tets_) sum.add(tet.weight.error);
    return sum.value();
  }
  std::int64_t size() const { return static_cast<std::int64_t>(tets_.size()); }
  double e_avg() const { return average_error(sum_of_errors(), size()); }  ///< eq. (3.4)
  /// Eq. (3.5), reading D16.
  virtual double e_avg_after(double sum, double change, int pieces) const {
    return average_error_after_split(sum, change, size(), options_.literal ? 4 : pieces);
  }

  // --- curvature, reading D15

  /// kappa_i: of several closest vertices the lexicographically smallest.
  virtual double curvature_near(const Point& centroid, double d) const {
    std::size_t closest = kappas_.size();
    const auto& x = surface_.vertices;
    for (std::size_t k = 0; k < x.size(); ++k)
      if (squared_distance(centroid, x[k]) <= d * d * (1 + 2e-12) &&
          (closest == kappas_.size() || lexicographically_less(x[k], x[closest])))
        closest = k;
    return kappas_.at(closest);
  }

  /// The absolute curvature at a vertex: the first ring of neighbours determines the fit, or two rings do.
  double absolute_curvature(int v) const {
    std::vector<Point> normals;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      const auto& names = surface_.triangles[t];
      if (std::count(names.begin(), names.end(), v)) normals.push_back((b - a).cross(c - a).normalized());
    }
    std::sort(normals.begin(), normals.end(), by_coordinates);
    Point sum(0, 0, 0);
    for (const Point& n : normals) sum += n;
    if (!sum.normalized().allFinite() || sum.normalized().isZero()) return 0;
    std::set<int> ring{v};
    for (int rings = 1; rings <= 2; ++rings) {
      const std::set<int> inner = ring;
      for (const auto& t : surface_.triangles)
        if (inner.contains(t[0]) || inner.contains(t[1]) || inner.contains(t[2]))
          ring.insert(t.begin(), t.end());
      std::vector<Point> offsets;
      for (const int w : ring)
        if (w != v) offsets.push_back(surface_.vertices[w] - surface_.vertices[v]);
      if (const auto k = fitted_curvatures(offsets, sum.normalized())) return absolute((*k)[0], (*k)[1]);
    }
    return 0;
  }
  virtual double absolute(double k1, double k2) const { return std::abs(k1) + std::abs(k2); }

  /// The curvatures k1 and k2 of the form (c20 u^2 + 2 c11 u w + c02 w^2) / 2 that fits the heights of some
  /// points over the plane normal to n best (reference [3]). Nothing if the points do not determine it.
  static std::optional<Eigen::Vector2d> fitted_curvatures(std::vector<Point> offsets, const Point& n) {
    std::sort(offsets.begin(), offsets.end(), by_coordinates);
    const Point x = n.unitOrthogonal(), y = n.cross(x);
    double scale = 0;  // makes the entries numbers around 1
    for (const Point& o : offsets) scale = std::max(scale, o.norm());
    Eigen::MatrixX3d forms(offsets.size(), 3);
    Eigen::VectorXd heights(offsets.size());
    for (Eigen::Index i = 0; i < forms.rows(); ++i) {
      const Point o = offsets[i] / scale;
      const double u = o.dot(x), w = o.dot(y);
      forms.row(i) << u * u / 2, u * w, w * w / 2;
      heights[i] = o.dot(n);
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixX3d> qr(std::as_const(forms));
    qr.setThreshold(1e-9);
    if (qr.rank() < 3) return std::nullopt;
    const Eigen::Vector3d c = qr.solve(heights) / scale;
    const Eigen::Matrix2d form = (Eigen::Matrix2d() << c[0], c[1], c[1], c[2]).finished();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(form, Eigen::EigenvaluesOnly).eigenvalues();
  }

  /// Step (v), reading D13.
  void weigh_grid() {
    const AdaptOptions& adapt = *options_.adapt;
    CompensatedSum volumes;
    double farthest = 0;
    for (auto& [number, tet] : tets_) {
      tet.weight = weigh(corners(tet.v));
      volumes.add(tet.weight.volume);
      farthest = std::max(farthest, tet.weight.d);
    }
    mean_volume_ = volumes.value() / static_cast<double>(size());
    law_ = {.v0 = adapt.v0.value * (adapt.v0.absolute ? 1 : mean_volume_),
            .v1 = adapt.v1.value * (adapt.v1.absolute ? 1 : mean_volume_),
            .d1 = adapt.d1 != 0 ? adapt.d1 : farthest,
            .p = adapt.p};
    e_avg_goal_ = adapt.e_avg.value * (adapt.e_avg.absolute ? 1 : mean_volume_);
    if (law_.d1 == 0) throw InputError("every tetrahedron of the first grid is at distance 0: give d1");
    for (std::size_t v = 0; v < surface_.vertices.size() && adapt.curvature; ++v)
      kappas_.push_back(absolute_curvature(static_cast<int>(v)));
    if (adapt.curvature) {
      kappa_min_ = *std::min_element(kappas_.begin(), kappas_.end());
      kappa_max_ = *std::max_element(kappas_.begin(), kappas_.end());
    }
    for (auto& [number, tet] : tets_) tet.weight = weigh(corners(tet.v));
    e_avg_first_ = e_avg();
    trace::FirstGrid first{
        std::ssize(points_), size(), mean_volume_, law_.v0, law_.v1, law_.d1, {}, {}, e_avg()};
    if (adapt.curvature) first.kappa_min = kappa_min_, first.kappa_max = kappa_max_;
    if (e_avg_goal_ > 0) first.e_avg_goal = e_avg_goal_;
    record(first);
    for (const auto& [number, tet] : tets_) record(tet.weight);
  }

  void record(const trace::Record& record) const {
    if (options_.listener.record) options_.listener.record(record);
  }

  std::vector<Point> points_;
  std::set<int> surface_points_;
  std::map<std::int64_t, Tetrahedron> tets_;  ///< by number; a number is never used again
  std::int64_t next_ = 0;
  std::map<std::vector<int>, int> shares_;  ///< how many tetrahedra have an edge, a face, by ascending points
  double mean_volume_ = 0, e_avg_goal_ = 0, e_avg_first_ = 0, kappa_min_ = 0, kappa_max_ = 0;
  VolumeLaw law_{.v0 = 1, .v1 = 1, .d1 = 1};  ///< before step (v): of no consequence
  std::vector<double> kappas_;                ///< of the surface's vertices; empty without curvature
};

}  // namespace tetproof::reference::paper
