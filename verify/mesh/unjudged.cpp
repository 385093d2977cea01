// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of a document that are not judged.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/document.hpp"
#include "io/model/element_types.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {
namespace {

std::string name_of(const ElementBlock& block) {
  const std::string name = io::name_of_elements(block.type);
  return name == "elements" ? fmt::format("elements of type {}", block.type) : name;
}

// `what` is not read, with the place where the first one is.
NotJudged not_read(const std::string& what, const Loss& loss) {
  return {what, loss.count, "not read" + (loss.example.empty() ? "" : ": " + loss.example)};
}

// Adds the boxes of the elements of a block, if their nodes tell where they are.
void add_boxes(const Document& document, const ElementBlock& block, Unjudged& result) {
  const io::ElementType* type = io::element_type(block.type);
  if (block.nodes_each < 1 || (type && (type->shape == io::Shape::other || type->nodes > type->corners))) {
    result.places_known = false;
    return;
  }
  const Index* node = document.connectivity.data() + block.nodes;
  for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each) {
    if (!std::all_of(node, node + block.nodes_each, [&](Index i) {
          return i >= 0 && document.points[static_cast<std::size_t>(i)].allFinite();
        })) {
      result.places_known = false;
      continue;
    }
    Eigen::Vector3d low = document.points[static_cast<std::size_t>(node[0])], high = low;
    for (int k = 1; k < block.nodes_each; ++k) {
      low = low.cwiseMin(document.points[static_cast<std::size_t>(node[k])]);
      high = high.cwiseMax(document.points[static_cast<std::size_t>(node[k])]);
    }
    result.boxes.push_back({low, high});
  }
}

// Whether m is the middle of a and b: 2 m = a + b, exactly. `error` is what the rounding of a + b lost
// (Knuth's sum of two doubles). If anything overflows, it is NaN or not 0, and the answer is no.
bool is_middle(double m, double a, double b) {
  const double sum = a + b, of_b = sum - a, error = (a - (sum - of_b)) + (b - of_b);
  return std::isfinite(sum) && std::isfinite(2 * m) && error == 0 && 2 * m == sum;
}

// Whether the shape of a tetrahedron of higher order is that of its corners.
bool is_straight(const Document& document, const ElementBlock& block, const Index* node) {
  if (block.type != io::tetrahedron10) return false;
  constexpr int edges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}};  // Gmsh's order
  if (std::any_of(node, node + 10, [](Index i) { return i < 0; })) return false;
  const auto at = [&](int k) { return document.points[static_cast<std::size_t>(node[k])]; };
  for (int e = 0; e < 6; ++e)
    for (int axis = 0; axis < 3; ++axis)
      if (!is_middle(at(4 + e)[axis], at(edges[e][0])[axis], at(edges[e][1])[axis])) return false;
  return true;
}

std::int64_t curved_in(const Document& document, const ElementBlock& block) {
  const io::ElementType* type = io::element_type(block.type);
  if (!type || type->shape != io::Shape::tetrahedron || type->nodes == type->corners) return 0;
  std::int64_t curved = 0;
  const Index* node = document.connectivity.data() + block.nodes;
  for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
    curved += !is_straight(document, block, node);
  return curved;
}

}  // namespace

Unjudged unjudged(const Document& document) {
  Unjudged result{.points = points_of_other_cells(document)};
  for (const ElementBlock& block : document.blocks) {
    result.curved += curved_in(document, block);
    if (!has_other_cells(block) || block.count == 0) continue;
    add_boxes(document, block, result);
    const std::string what = name_of(block);
    const auto known = std::find_if(result.elements.begin(), result.elements.end(),
                                    [&](const NotJudged& entry) { return entry.what == what; });
    if (known != result.elements.end())
      known->count += static_cast<std::int64_t>(block.count);
    else
      result.elements.push_back({what, static_cast<std::int64_t>(block.count),
                                 fmt::format("only tetrahedra are judged; the first is element {}",
                                             document.element_tag(block.first))});
  }
  for (const Loss& loss : document.dropped) {
    if (!loss.elements) continue;
    result.points_known = result.places_known = false;
    result.unread.push_back(not_read(loss.item, loss));
  }
  return result;
}

void add_unread_surface(Unjudged& unjudged, const std::vector<Loss>& dropped) {
  for (const Loss& loss : dropped)
    if (loss.elements) unjudged.unread.push_back(not_read(loss.item + " of the surface", loss));
}

}  // namespace tetproof::verify
