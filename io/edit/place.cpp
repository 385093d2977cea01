// SPDX-License-Identifier: GPL-3.0-or-later
// Scales and moves documents.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/origin.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"

namespace tetproof::io {
namespace {

using Limits = std::numeric_limits<double>;

bool overflew(double old, double now) {
  return std::isfinite(old) && !std::isfinite(now);
}

// Whether a product is so small that digits of it are gone. A sum may be 0.
bool underflew(double old, double now) {
  const double least = std::abs(old) < Limits::min() ? Limits::denorm_min() : Limits::min();
  return old != 0 && std::abs(now) < least;
}

// Applies maps to what has a place or a size. InputError if anything would leave the range of numbers.
class Placing {
 public:
  using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;
  enum class Kind { sum, product };
  Placing(Document& document, Kind kind, const Map& map) : document_(document), kind_(kind), map_(map) {}

  void move_points() {
    move(document_.points, [&](std::size_t i) { return fmt::format("node {}", document_.node_tag(i)); });
    const auto position = [](const char* word) {
      return [word](std::size_t i) { return fmt::format("{} {}", word, i + 1); };
    };
    move(document_.holes, position("hole"));
    for (Facet& facet : document_.facets) move(facet.holes, position("a facet's hole"));
    for (std::size_t i = 0; i < document_.regions.size(); ++i)
      move(document_.regions[i].point, position("region"), i);
    move(document_.voronoi.points, position("point of the Voronoi diagram"));
    for (Entity& entity : document_.entities) move_box(entity.box);
  }

  // Multiplies a length, an area or a volume.
  void grow(double& value, double factor, int power, const char* what) const {
    const double old = value;
    for (int k = 0; k < power; ++k) value *= factor;
    for (int k = power; k < 0; ++k) value /= factor;
    if (overflew(old, value) || underflew(old, value)) refuse(what);
  }

  // Of a periodic link's matrix.
  void set_shift(double& shift, double to) const {
    if (overflew(shift, to)) refuse("a periodic link");
    shift = to;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: {} would leave the range of numbers", document_.path, what));
  }

  template <class Name>
  void move(Eigen::Vector3d& point, const Name& name, std::size_t i) const {
    const Eigen::Vector3d old = point;
    point = map_(old);
    if (!old.allFinite()) return;
    for (int k = 0; k < 3; ++k)
      if (overflew(old[k], point[k]) || (kind_ == Kind::product && underflew(old[k], point[k])))
        refuse(name(i));
  }
  template <class Name>
  void move(std::vector<Eigen::Vector3d>& points, const Name& name) const {
    for (std::size_t i = 0; i < points.size(); ++i) move(points[i], name, i);
  }

  // The box of an entity without points reaches from the largest number to the least: there it stays.
  void move_box(std::array<double, 6>& box) const {
    for (std::size_t corner : {0, 3}) {
      const Eigen::Vector3d to = map_(Eigen::Vector3d(box[corner], box[corner + 1], box[corner + 2]));
      for (std::size_t k = 0; k < 3; ++k) {
        double& side = box[corner + k];
        const double there = to[static_cast<Eigen::Index>(k)];
        side = std::isfinite(side) ? std::clamp(there, Limits::lowest(), Limits::max()) : there;
      }
    }
  }

  Document& document_;
  const Kind kind_;
  const Map& map_;
};

// Points that rounding puts beside their place by more than a millionth of the mesh: far from the origin few
// places are left, and points of a small mesh fall on each other.
std::vector<Loss> rounded_places(const Document& document, const Eigen::Vector3d& by) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(Limits::max()), high = -low;
  for (const Eigen::Vector3d& point : document.points)
    if (point.allFinite()) low = low.cwiseMin(point), high = high.cwiseMax(point);
  const double most = 1e-6 * (high - low).stableNorm();
  std::size_t count = 0;
  std::string first;
  for (std::size_t i = 0; i < document.points.size(); ++i) {
    const Eigen::Vector3d& point = document.points[i];
    const double off = (((point + by) - by) - point).stableNorm();
    if (!point.allFinite() || most == 0 || !(off > most)) continue;  // one place has no shape to lose
    if (count++ == 0) first = fmt::format("node {} by {:.3g}", document.node_tag(i), off);
  }
  std::vector<Loss> lost;
  add_loss(lost, "points that rounding puts beside their place", count, first);
  return lost;
}

bool is_affine_map(const PeriodicLink& link) {
  return link.affine.size() == 16;
}

// Other numbers than those of a map stay as they are: nobody knows what they say.
void list_other_numbers(const Document& document, std::vector<Loss>& lost) {
  for (const PeriodicLink& link : document.periodic)
    if (!link.affine.empty() && !is_affine_map(link))
      add_loss(lost, "affine transformations without 16 numbers, left as they were", 1,
               fmt::format("entity {} of dimension {}: {}", link.entity, link.dim,
                           counted(link.affine.size(), "numbers")));
}

}  // namespace

Edit scale(Document& document, double factor) {
  if (!(factor > 0) || !std::isfinite(factor))
    throw InputError(fmt::format("expected a factor above 0, found {}", factor));
  const Placing::Map map = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d { return point * factor; };
  Placing place(document, Placing::Kind::product, map);
  place.move_points();
  for (Region& region : document.regions)
    if (region.max_volume > 0) place.grow(region.max_volume, factor, 3, "the bound of a region's volume");
  for (AreaBound& bound : document.area_bounds) place.grow(bound.area, factor, 2, "the bound of an area");
  for (LengthBound& bound : document.length_bounds)
    place.grow(bound.length, factor, 1, "the bound of a length");
  for (PeriodicLink& link : document.periodic)
    for (std::size_t row = 0; row < 3 && is_affine_map(link); ++row)
      place.set_shift(link.affine[4 * row + 3], link.affine[4 * row + 3] * factor);
  mark_lengths(document);
  for (auto* all : {&document.node_values, &document.element_values})
    for (Values& values : *all)
      if (values.length_power != 0)
        for (double& value : values.reals)
          if (values.length_power < 3 || value > 0)  // a bound that is not positive is none
            place.grow(value, factor, values.length_power, values.name.c_str());
  std::vector<Loss> lost;
  list_other_numbers(document, lost);
  return {fmt::format("{} scaled by {}", counted(document.points.size(), "points"), factor), std::move(lost)};
}

Edit translate(Document& document, const Eigen::Vector3d& by) {
  if (!by.allFinite()) throw InputError("expected three finite numbers X,Y,Z");
  std::vector<Loss> lost = rounded_places(document, by);
  const Placing::Map map = [&](const Eigen::Vector3d& point) -> Eigen::Vector3d { return point + by; };
  Placing place(document, Placing::Kind::sum, map);
  place.move_points();
  for (PeriodicLink& link : document.periodic) {  // x = A m + t becomes x + d = A (m + d) + t + d - A d
    if (!is_affine_map(link)) continue;
    for (std::size_t row = 0; row < 3; ++row) {
      const double* a = link.affine.data() + 4 * row;
      place.set_shift(link.affine[4 * row + 3], a[3] + (by[static_cast<Eigen::Index>(row)] -
                                                        (a[0] * by[0] + a[1] * by[1] + a[2] * by[2])));
    }
  }
  list_other_numbers(document, lost);
  return {
      fmt::format("{} moved by ({}, {}, {})", counted(document.points.size(), "points"), by[0], by[1], by[2]),
      std::move(lost)};
}

}  // namespace tetproof::io
