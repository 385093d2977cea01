// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/solid_faces.hpp"

#include <algorithm>
#include <map>

namespace tetproof::io {
namespace {

using List = std::vector<std::int32_t>;

// The nodes of a shape in Gmsh's order, https://gmsh.info/doc/texinfo/gmsh.html#Node-ordering.
struct SolidShape {
  Shape shape;
  std::vector<List> faces;  // corners, anticlockwise from outside
  std::vector<List> edges;  // in the order of their middle nodes, which follow the corners
  std::vector<List> mids;   // quadrangles in the order of their middle nodes, which follow those of edges
};

// clang-format off
const SolidShape shapes[] = {
    {Shape::tetrahedron,
     {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}},
     {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {2, 3}, {1, 3}},
     {}},
    {Shape::hexahedron,
     {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}},
     {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 5}, {2, 3}, {2, 6}, {3, 7}, {4, 5}, {4, 7}, {5, 6}, {6, 7}},
     {{0, 3, 2, 1}, {0, 1, 5, 4}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}}},
    {Shape::prism,
     {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}},
     {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {3, 5}, {4, 5}},
     {{0, 1, 4, 3}, {0, 3, 5, 2}, {1, 2, 5, 4}}},
    {Shape::pyramid,
     {{0, 1, 4}, {3, 0, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 2, 1}},
     {{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}},
     {{0, 3, 2, 1}}},
};
// clang-format on

std::int32_t node_of_edge(const SolidShape& shape, std::int32_t a, std::int32_t b, int corners) {
  const auto edge = std::find_if(shape.edges.begin(), shape.edges.end(), [&](const List& ends) {
    return (ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a);
  });
  return static_cast<std::int32_t>(corners + (edge - shape.edges.begin()));
}

std::vector<SolidFace> faces_of(const ElementType& type, const SolidShape& shape) {
  const int edges = static_cast<int>(shape.edges.size()), mids = static_cast<int>(shape.mids.size());
  const bool on_edges = type.nodes == type.corners + edges || type.nodes == type.corners + edges + mids ||
                        (type.shape == Shape::hexahedron && type.nodes == 27);
  const bool in_faces = on_edges && type.nodes > type.corners + edges && mids > 0;
  std::vector<SolidFace> faces;
  for (const List& corners : shape.faces) {
    SolidFace& face = faces.emplace_back();
    const bool is_triangle = corners.size() == 3;
    face.corners = static_cast<int>(corners.size());
    face.nodes = corners;
    face.type = is_triangle ? triangle3 : quadrangle4;
    if (!on_edges) continue;
    for (std::size_t k = 0; k < corners.size(); ++k)
      face.nodes.push_back(node_of_edge(shape, corners[k], corners[(k + 1) % corners.size()], type.corners));
    const auto mid = std::find(shape.mids.begin(), shape.mids.end(), corners);
    const bool has_mid = in_faces && mid != shape.mids.end();
    if (has_mid)
      face.nodes.push_back(static_cast<std::int32_t>(type.corners + edges + (mid - shape.mids.begin())));
    constexpr int quadrangle9 = 10, quadrangle8 = 16;
    face.type = is_triangle ? triangle6 : has_mid ? quadrangle9 : quadrangle8;
  }
  return faces;
}

}  // namespace

std::span<const SolidFace> solid_faces(int type) {
  static const std::map<int, std::vector<SolidFace>> all = [] {
    std::map<int, std::vector<SolidFace>> made;
    for (int t = 1; t <= 140; ++t)
      if (const ElementType* known = element_type(t))
        for (const SolidShape& shape : shapes)
          if (shape.shape == known->shape) made[t] = faces_of(*known, shape);
    return made;
  }();
  const auto found = all.find(type);
  return found == all.end() ? std::span<const SolidFace>() : found->second;
}

}  // namespace tetproof::io
