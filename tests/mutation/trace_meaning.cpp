// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mutation/trace_meaning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace tetproof::mutation {
namespace {

using namespace trace;

constexpr double tolerance = 1e-9;

bool before(const Point& a, const Point& b) {
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

void canonical(Settings& s) {
  const Settings defaults;
  s.program = s.surface = "";
  if (s.points == "0") {  // there are no steps (v) and (vi)
    s.p = defaults.p, s.curvature = defaults.curvature, s.past_dilution = defaults.past_dilution;
    s.improve = "none";
  }
  if (s.improve == "none") s.improve_below = defaults.improve_below;
}
void canonical(Cut& cut) {
  std::sort(cut.edge.begin(), cut.edge.end());
}
void canonical(Weight& weight) {
  std::sort(weight.tet.begin(), weight.tet.end(), before);
}
void canonical(Insertion& insertion) {
  const Tet given = insertion.tet;
  std::sort(insertion.tet.begin(), insertion.tet.end(), before);
  for (int& at : insertion.replaced)
    at = static_cast<int>(std::find(insertion.tet.begin(), insertion.tet.end(), given.at(at)) -
                          insertion.tet.begin());
  std::sort(insertion.replaced.begin(), insertion.replaced.end());
}
void canonical(Flip& flip) {
  std::sort(flip.face.begin(), flip.face.end(), before);
  std::sort(flip.edge.begin(), flip.edge.end(), before);
}
template <class R>
void canonical(R&) {}

// Compares records with the original's sizes.
class Same {
 public:
  explicit Same(const std::vector<Record>& original) {
    for (const Record& record : original) {
      if (const auto* settings = std::get_if<Settings>(&record)) p_ = settings->p;
      if (const auto* lattice = std::get_if<Lattice>(&record))
        diagonal_ = (lattice->box[1] - lattice->box[0]).norm();
      if (const auto* first = std::get_if<FirstGrid>(&record)) first_ = *first;
    }
  }

  bool operator()(const Record& a, const Record& b) const {
    return a.index() == b.index() && std::visit(
                                         [&](const auto& one) {
                                           using R = std::decay_t<decltype(one)>;
                                           return same(one, std::get<R>(b));
                                         },
                                         a);
  }

 private:
  static bool number(double a, double b, double scale = 0) {
    return a == b || std::abs(a - b) <= tolerance * std::max({std::abs(a), std::abs(b), std::abs(scale)});
  }
  bool length(double a, double b) const { return std::abs(a - b) <= tolerance * diagonal_; }
  bool point(const Point& a, const Point& b) const { return (a - b).norm() <= tolerance * diagonal_; }
  template <std::size_t n>
  bool points(const std::array<Point, n>& a, const std::array<Point, n>& b) const {
    const auto close = [&](const Point& p, const Point& q) { return point(p, q); };
    return std::is_permutation(a.begin(), a.end(), b.begin(), close);
  }
  bool volume(double a, double b) const { return number(a, b, first_.mean_volume); }
  bool curvature(const std::optional<double>& a, const std::optional<double>& b) const {
    if (!a || !b) return a.has_value() == b.has_value();
    return number(*a, *b, std::max(first_.kappa_max.value_or(0), 1 / diagonal_));
  }
  double desired(double d) const {
    const double t = std::pow(std::max(0.0, d) / first_.d1, p_);
    return std::max((1 - t) * first_.v0 + t * first_.v1, std::min(first_.v0, first_.v1));
  }

  bool same(const Settings& a, const Settings& b) const {
    return number(a.box_scale, b.box_scale) && number(a.on_surface, b.on_surface) && number(a.p, b.p) &&
           number(a.improve_below, b.improve_below) &&
           std::tie(a.region, a.diagonals, a.literal, a.curvature, a.parametric, a.improve, a.points,
                    a.past_dilution) == std::tie(b.region, b.diagonals, b.literal, b.curvature, b.parametric,
                                                 b.improve, b.points, b.past_dilution);
  }
  bool same(const Lattice& a, const Lattice& b) const {
    return a.cells == b.cells && point(a.box[0], b.box[0]) && point(a.box[1], b.box[1]);
  }
  bool same(const Indicators& a, const Indicators& b) const {
    return std::tie(a.j, a.k, a.initial, a.after) == std::tie(b.j, b.k, b.initial, b.after);
  }
  bool same(const Moved& a, const Moved& b) const {
    return a.vertex == b.vertex && a.mended == b.mended && point(a.point, b.point);
  }
  bool same(const Cut& a, const Cut& b) const { return a.edge == b.edge && point(a.point, b.point); }
  bool same(const Rows& a, const Rows& b) const { return a.cell == b.cell && a.rows == b.rows; }
  bool same(const Mapped& a, const Mapped& b) const { return point(a.from, b.from) && point(a.to, b.to); }
  bool same(const FirstGrid& a, const FirstGrid& b) const {
    return a.points == b.points && a.tets == b.tets && number(a.mean_volume, b.mean_volume) &&
           number(a.v0, b.v0) && number(a.v1, b.v1) && length(a.d1, b.d1) &&
           curvature(a.kappa_min, b.kappa_min) && curvature(a.kappa_max, b.kappa_max) &&
           volume(a.e_avg, b.e_avg) && number(a.e_avg_goal.value_or(0), b.e_avg_goal.value_or(0));
  }
  bool same(const Weight& a, const Weight& b) const {
    const double d = a.omega * a.d, by = tolerance * diagonal_;
    const double steep =
        std::max(std::abs(desired(d + by) - desired(d)), std::abs(desired(d - by) - desired(d)));
    const double size = std::max({first_.mean_volume, std::abs(a.volume), std::abs(a.desired)});
    return points(a.tet, b.tet) && length(a.d, b.d) && curvature(a.kappa, b.kappa) &&
           number(a.omega, b.omega, 1) && volume(a.volume, b.volume) &&
           (volume(a.desired, b.desired) || std::abs(a.desired - b.desired) <= steep) &&
           (number(a.error, b.error, size) || std::abs(a.error - b.error) <= steep);
  }
  bool same(const Insertion& a, const Insertion& b) const {
    return a.n == b.n && a.row == b.row && a.replaced == b.replaced && points(a.tet, b.tet) &&
           point(a.point, b.point) && volume(a.e_avg, b.e_avg);
  }
  bool same(const Flip& a, const Flip& b) const {
    return a.two_to_three == b.two_to_three && points(a.face, b.face) && points(a.edge, b.edge) &&
           number(a.quality_before, b.quality_before) && number(a.quality_after, b.quality_after) &&
           volume(a.e_avg, b.e_avg);
  }
  bool same(const End& a, const End& b) const {
    return std::tie(a.stopped, a.insertions, a.flips, a.refused, a.points, a.tets) ==
               std::tie(b.stopped, b.insertions, b.flips, b.refused, b.points, b.tets) &&
           volume(a.e_avg, b.e_avg);
  }

  double p_ = 1, diagonal_ = 1;
  FirstGrid first_;
};

// 0: settings and the lattice, 1: steps (ii) to (iv), 2: step (v), 3: step (vi).
int group_of(const Record& record) {
  if (std::holds_alternative<Settings>(record) || std::holds_alternative<Lattice>(record)) return 0;
  if (std::holds_alternative<FirstGrid>(record) || std::holds_alternative<Weight>(record)) return 2;
  return std::holds_alternative<Insertion>(record) || std::holds_alternative<Flip>(record) ||
                 std::holds_alternative<End>(record)
             ? 3
             : 1;
}

}  // namespace

std::vector<Record> canonical_records(const std::string& path) {
  std::vector<Record> records;
  Reader reader(path);
  while (std::optional<Record> record = reader.next()) {
    std::visit([](auto& r) { canonical(r); }, *record);
    records.push_back(*record);
  }
  return records;
}

bool same_meaning(const std::vector<Record>& original, const std::vector<Record>& changed) {
  if (original.size() != changed.size()) return false;
  for (std::size_t i = 0; i < original.size(); ++i)
    if (group_of(original[i]) != group_of(changed[i])) return false;
  const Same same(original);
  // What is different at its place: where the order is free, it may be found at another one.
  std::vector<const Record*> missing, strange;
  for (std::size_t i = 0; i < original.size(); ++i) {
    if (same(original[i], changed[i])) continue;
    if (group_of(original[i]) == 3) return false;
    missing.push_back(&original[i]);
    strange.push_back(&changed[i]);
  }
  return std::is_permutation(missing.begin(), missing.end(), strange.begin(),
                             [&](const Record* a, const Record* b) { return same(*a, *b); });
}

}  // namespace tetproof::mutation
