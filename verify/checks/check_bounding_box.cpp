// SPDX-License-Identifier: GPL-3.0-or-later
// Checks whether mesh and surface are in the same units and in the same place, as far as their boxes tell.
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>

#include "verify/checks/surface_comparison.hpp"

namespace tetproof::verify {
namespace {

using Vector = Eigen::Vector3d;

struct Unit {
  const char* name;
  double millimetres;
};
constexpr std::array units{Unit{"metres", 1000},   Unit{"millimetres", 1}, Unit{"centimetres", 10},
                           Unit{"inches", 25.4},   Unit{"feet", 304.8},    Unit{"micrometres", 1e-3},
                           Unit{"kilometres", 1e6}};

// Two units between which a length's number changes by `factor` > 1.
struct Change {
  double factor;
  const char *large, *small;
};

// The change of units that takes the smaller box to the larger one: on each axis within 2 % and the allowed
// distance, which is in the surface's units. Of several changes with the same factor the first: those between
// common units come first.
std::optional<Change> change_of_units(const Vector& larger, const Vector& smaller, double allowed,
                                      bool surface_is_larger) {
  std::optional<Change> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Unit& large : units)
    for (const Unit& small : units) {
      if (large.millimetres <= small.millimetres) continue;
      const double factor = large.millimetres / small.millimetres;
      const Vector scaled = larger / factor, off = (scaled - smaller).cwiseAbs(),
                   most = 0.02 * scaled.cwiseMax(smaller) +
                          Vector::Constant(surface_is_larger ? allowed / factor : allowed);
      if ((off.array() <= most.array()).all() && off.maxCoeff() < least)
        least = off.maxCoeff(), best = {factor, large.name, small.name};
    }
  return best;
}

std::string text(const Vector& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

// What the boxes tell; empty if they tell nothing.
std::string fault(const Eigen::AlignedBox3d& mesh, const Eigen::AlignedBox3d& surface, double allowed) {
  // Where every point of the one is within the allowed distance of the other, so are the boxes' sides. Then
  // the mesh is as it should be, whatever factor may lie between the boxes.
  if ((mesh.min() - surface.min()).cwiseAbs().maxCoeff() <= allowed &&
      (mesh.max() - surface.max()).cwiseAbs().maxCoeff() <= allowed)
    return {};
  const Vector size = mesh.sizes(), wanted = surface.sizes();
  const bool larger = size.stableNorm() > wanted.stableNorm();
  const bool apart =
      (mesh.min() - surface.max()).maxCoeff() > allowed || (surface.min() - mesh.max()).maxCoeff() > allowed;
  const std::string no_meeting = apart ? "; the boxes do not meet" : "";
  if (const auto change = larger ? change_of_units(size, wanted, allowed, false)
                                 : change_of_units(wanted, size, allowed, true))
    return fmt::format("the {} is {:.6g} times as large as the {}: {} and {}?{}", larger ? "mesh" : "surface",
                       change->factor, larger ? "surface" : "mesh", change->small, change->large, no_meeting);
  // Moved: the sizes differ by far less than the places. Rounding moves no box by a millionth of its size.
  const Vector way = mesh.center() - surface.center();
  const double moved = way.stableNorm(), other = (size - wanted).cwiseAbs().maxCoeff();
  if (moved > std::max(2 * allowed, 1e-6 * wanted.stableNorm()) && other <= 0.05 * moved &&
      other <= 0.1 * wanted.stableNorm())
    return fmt::format("the mesh is as large as the surface and lies elsewhere: moved by {}{}", text(way),
                       no_meeting);
  if (!apart) return {};
  return fmt::format(
      "the boxes of mesh and surface do not meet: the mesh reaches from {} to {}, the surface "
      "from {} to {}",
      text(mesh.min()), text(mesh.max()), text(surface.min()), text(surface.max()));
}

}  // namespace

void check_bounding_box(const Comparison& c, Record& record) {
  if (!record.wants(Check::bounding_box) || c.faces.empty()) return;
  Eigen::AlignedBox3d mesh;
  for (const Triangle& face : c.faces)
    for (const Index v : face) mesh.extend(c.judged_mesh.mesh.points[static_cast<std::size_t>(v)]);
  const Eigen::AlignedBox3d surface(c.judged.report.box_min, c.judged.report.box_max);
  std::string what = fault(mesh, surface, c.allowed);
  if (!what.empty()) record[Check::bounding_box] = Suspects::complete({{.what = std::move(what)}});
}

void name_bounding_box(Record& record) {
  if (record[Check::bounding_box].count == 0) return;
  for (int i = 0; i < check_count; ++i)
    if (const auto check = static_cast<Check>(i); info(check).needs_surface && check != Check::bounding_box)
      record[check].cause = [](std::size_t) { return Cause{Check::bounding_box, 0}; };
}

}  // namespace tetproof::verify
