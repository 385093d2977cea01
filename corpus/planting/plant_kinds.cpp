// SPDX-License-Identifier: GPL-3.0-or-later
// The table of all kinds, and the kinds that plant two defects at once.
#include <fmt/core.h>

#include <algorithm>

#include "corpus/planting/plant_site.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

std::vector<PlantKind> two_at_once() {
  const auto both = [](const char* id, const char* first, const char* second, const char* comment) {
    return PlantKind{.id = id,
                     .expected = Expected::defective,
                     .flags = {"two"},
                     .comment = comment,
                     .first = first,
                     .second = second};
  };
  return {
      both("inverted-and-hanging", "inverted-inside", "hanging-on-edge",
           "two independent defects: an inverted tetrahedron and a hanging node"),
      both("inverted-and-inside", "inverted-inside", "inside-another",
           "two independent defects: an inverted tetrahedron, and a tetrahedron inside another"),
      both("nan-and-crack", "nan-inside", "crack-around-tet",
           "two independent defects: a NaN coordinate and a crack"),
      both("duplicate-and-thrice", "duplicate-tet", "face-shared-thrice",
           "two independent defects: a duplicate tetrahedron, and a face shared by three"),
      both("crossed-and-overlap", "crossed-diagonals", "overlap-1e-12",
           "two independent defects: crossed diagonals, and an overlap by 1e-12 of a face's size"),
      both("missing-and-touching", "missing-inside", "touching-edge",
           "a missing tetrahedron, and far from it a boundary that touches itself"),
      both("index-and-flat", "index-too-high", "flat",
           "two independent defects: a vertex number that no point has, and a flat tetrahedron"),
      both("crack-and-inside-at-vertex", "crack-around-tet", "inside-another-at-vertex",
           "two independent defects: a crack, and a tetrahedron inside another that shares a vertex with it"),
      both("hanging-and-hanging", "hanging-off-edge", "hanging-off-face",
           "two hanging nodes far from each other, both off their edge or face by rounding"),
      {.id = "any-two-apart",
       .flags = {"two", "campaign"},
       .comment = "two random kinds, planted far from each other"},
      {.id = "any-two-together",
       .flags = {"two", "campaign"},
       .comment = "two random kinds, planted in the same place or near each other"}};
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
