// SPDX-License-Identifier: GPL-3.0-or-later
// The table of kinds.
#include <fmt/core.h>

#include <algorithm>

#include "corpus/planting/plant_site.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

std::vector<PlantKind> two_at_once() {
  constexpr auto defective = Expected::defective;
  const auto both = [](const char* id, const char* first, const char* second, const char* comment) {
    return PlantKind{id, defective, {"two"}, {}, {}, comment, nullptr, first, second};
  };
  return {both("inverted-and-hanging", "inverted-inside", "hanging-on-edge",
               "two independent defects: an inverted tetrahedron, a hanging node"),
          both("inverted-and-inside", "inverted-inside", "inside-another",
               "two independent defects: an inverted tetrahedron, one inside another"),
          both("nan-and-crack", "nan-inside", "crack-around-tet",
               "two independent defects: a coordinate that is not a number, a crack"),
          both("duplicate-and-thrice", "duplicate-tet", "face-shared-thrice",
               "two independent defects: a duplicate, a face of three tetrahedra"),
          both("crossed-and-overlap", "crossed-diagonals", "overlap-1e-12",
               "two independent defects: crossed diagonals, an overlap by 1e-12"),
          both("missing-and-touching", "missing-inside", "touching-edge",
               "a missing tetrahedron, and far from it a boundary that touches itself"),
          both("index-and-flat", "index-too-high", "flat",
               "two independent defects: a number that no point has, a flat tetrahedron"),
          both("crack-and-inside-at-vertex", "crack-around-tet", "inside-another-at-vertex",
               "two independent defects: a crack, a tetrahedron inside another at a vertex of it"),
          both("hanging-and-hanging", "hanging-off-edge", "hanging-off-face",
               "two nodes that hang far from each other, both rounded off"),
          {"any-two-apart", {}, {"two", "campaign"}, {}, {}, "any two kinds far from each other", nullptr},
          {"any-two-together",
           {},
           {"two", "campaign"},
           {},
           {},
           "any two kinds in one place or near it",
           nullptr}};
}

}  // namespace

const char* name_of(Expected expected) {
  return expected == Expected::sound ? "sound" : expected == Expected::debatable ? "debatable" : "defective";
}

bool PlantKind::has(std::string_view flag) const {
  return std::any_of(flags.begin(), flags.end(), [&](const char* own) { return flag == own; });
}

const std::vector<PlantKind>& plant_kinds() {
  static const std::vector<PlantKind> all = [] {
    std::vector<PlantKind> kinds;
    for (const auto& theme :
         {number_kinds(), orientation_kinds(), push_kinds(), thin_kinds(), overlap_kinds(), copy_kinds(),
          contact_kinds(), conformity_kinds(), crack_kinds(), missing_kinds(), two_at_once()})
      kinds.insert(kinds.end(), theme.begin(), theme.end());
    return kinds;
  }();
  return all;
}

const PlantKind& plant_kind(std::string_view id) {
  for (const PlantKind& kind : plant_kinds())
    if (id == kind.id) return kind;
  throw InputError(fmt::format("unknown kind of defect '{}'", id));
}

}  // namespace tetproof::corpus
