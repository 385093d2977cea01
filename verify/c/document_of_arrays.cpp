// SPDX-License-Identifier: GPL-3.0-or-later
// Makes documents from the arrays of a caller.
#include <algorithm>
#include <limits>
#include <utility>

#include "io/model/element_types.hpp"
#include "io/model/groups_of_values.hpp"
#include "verify/c/arrays.hpp"
#include "verify/c/boundary.hpp"
#include "verify/c/documents.hpp"

namespace tetproof::c {
namespace {

// Adds elements, and their tags as values that become groups. Elements of different groups are in no
// common entity.
template <std::size_t Corners>
void add_elements(Document& document, const tetproof_integers& array, const tetproof_integers* groups,
                  const char* name, const char* groups_name, UnknownNumbers& unknown) {
  const auto elements = elements_of<Corners>(array, document.points.size(), unknown, name);
  const std::size_t first = document.elements();
  if (!elements.empty())
    document.blocks.push_back({.type = Corners == 4 ? io::tetrahedron4 : io::triangle3,
                               .dim = Corners == 4 ? 3 : 2,
                               .entity = groups ? 0 : 1,
                               .nodes_each = Corners,
                               .count = elements.size(),
                               .first = first,
                               .nodes = document.connectivity.size()});
  for (const auto& corners : elements)
    document.connectivity.insert(document.connectivity.end(), corners.begin(), corners.end());
  if (!groups) return;
  std::vector<std::int64_t> tags = tags_of(*groups, groups_name);
  if (tags.size() != elements.size())
    refuse_argument(fmt::format("{}: count is {}, expected {}, that of {}", groups_name, tags.size(),
                                elements.size(), name));
  for (const std::int64_t tag : tags)
    if (tag < 0 || tag > std::numeric_limits<std::int32_t>::max())
      refuse_argument(fmt::format("{}: a tag is {}, expected 0 to 2147483647", groups_name, tag));
  if (std::all_of(tags.begin(), tags.end(), [](std::int64_t tag) { return tag == 0; })) return;
  Values& values = document.element_values.emplace_back();
  values.name = "groups";
  values.first = first;
  values.integers = std::move(tags);
}

}  // namespace

Document document_of_arrays(const DocumentArrays& arrays) {
  Document document;
  document.points = points_of(needed(arrays.points, "points"), "points");
  const bool both = arrays.tets && arrays.triangles;
  if (both && arrays.tets->base != arrays.triangles->base)
    refuse_argument(fmt::format("the base of tets is {}, and that of triangles {}: expected the same",
                                arrays.tets->base, arrays.triangles->base));
  if (arrays.tet_groups && !arrays.tets) refuse_argument("tet_groups are given without tets");
  if (arrays.triangle_groups && !arrays.triangles)
    refuse_argument("triangle_groups are given without triangles");
  if (both && arrays.tets->count > 0 && arrays.triangles->count > 0 &&
      arrays.tets->count > std::numeric_limits<Index>::max() - arrays.triangles->count)
    throw Refused(TETPROOF_TOO_LARGE,
                  fmt::format("{} tetrahedra and {} triangles, at most 2147483647 elements can be numbered",
                              arrays.tets->count, arrays.triangles->count));
  UnknownNumbers unknown;
  if (arrays.tets) add_elements<4>(document, *arrays.tets, arrays.tet_groups, "tets", "tet_groups", unknown);
  if (arrays.triangles)
    add_elements<3>(document, *arrays.triangles, arrays.triangle_groups, "triangles", "triangle_groups",
                    unknown);
  document.unknown = unknown.numbers();
  if (arrays.tets || arrays.triangles)
    document.first_node = document.first_element = arrays.tets ? arrays.tets->base : arrays.triangles->base;
  if (!document.points.empty() && !arrays.tet_groups && !arrays.triangle_groups)
    document.node_blocks.push_back(
        {.dim = arrays.tets ? 3 : 2, .entity = 1, .count = document.points.size()});
  io::make_groups_of_values(document, "groups");
  return document;
}

}  // namespace tetproof::c
