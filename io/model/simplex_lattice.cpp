// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: what Gmsh 4.8 writes for orders 1 to 10, and vtkLagrangeTetra::GetParametricCoords of VTK 9.1. Both
// list the corners, the nodes on the edges, those inside of the faces and those inside of the tetrahedron,
// which are a smaller triangle or tetrahedron again. They differ in the edges' directions and in where a face
// starts.
#include "io/model/simplex_lattice.hpp"

#include <array>
#include <cstddef>
#include <map>

namespace tetproof::io {
namespace {

using Place = std::array<int, 4>;  // barycentric coordinates, in steps

// The corners between which edges and faces lie, in the order in which their nodes are listed.
struct Sides {
  std::array<std::array<std::size_t, 2>, 6> edges;
  std::array<std::array<std::size_t, 3>, 4> faces;
};
constexpr Sides gmsh{{{{0, 1}, {1, 2}, {2, 0}, {3, 0}, {3, 2}, {3, 1}}},
                     {{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {3, 1, 2}}}};
constexpr Sides vtk{{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}},
                    {{{0, 1, 3}, {2, 3, 1}, {0, 3, 2}, {0, 2, 1}}}};

// `steps` steps from a towards b, which is `order` steps away.
Place towards(Place from, const Place& a, const Place& b, int order, int steps) {
  for (std::size_t k = 0; k < from.size(); ++k) from[k] += (b[k] - a[k]) / order * steps;
  return from;
}

void add_edge(const Place& a, const Place& b, int order, std::vector<Place>& places) {
  for (int k = 1; k < order; ++k) places.push_back(towards(a, a, b, order, k));
}

void add_inside_of_triangle(const std::array<Place, 3>& corners, int order, std::vector<Place>& places) {
  if (order < 3) return;
  std::array<Place, 3> inner;
  for (std::size_t k = 0; k < 3; ++k) {
    inner[k] = corners[k];
    for (std::size_t other = 0; other < 3; ++other)
      inner[k] = towards(inner[k], corners[k], corners[other], order, 1);
  }
  if (order == 3) {
    places.push_back(inner[0]);
    return;
  }
  places.insert(places.end(), inner.begin(), inner.end());
  for (std::size_t k = 0; k < 3; ++k) add_edge(inner[k], inner[(k + 1) % 3], order - 3, places);
  add_inside_of_triangle(inner, order - 3, places);
}

void add_tetrahedron(const std::array<Place, 4>& corners, int order, const Sides& sides,
                     std::vector<Place>& places) {
  if (order == 0) {
    places.push_back(corners[0]);
    return;
  }
  places.insert(places.end(), corners.begin(), corners.end());
  for (const auto& [a, b] : sides.edges) add_edge(corners[a], corners[b], order, places);
  for (const auto& [a, b, c] : sides.faces)
    add_inside_of_triangle({corners[a], corners[b], corners[c]}, order, places);
  if (order < 4) return;
  std::array<Place, 4> inner;
  for (std::size_t k = 0; k < 4; ++k) {
    inner[k] = corners[k];
    for (std::size_t other = 0; other < 4; ++other)
      inner[k] = towards(inner[k], corners[k], corners[other], order, 1);
  }
  add_tetrahedron(inner, order - 4, sides, places);
}

std::vector<Place> places_in(const Sides& sides, int order) {
  std::array<Place, 4> corners{};
  for (std::size_t k = 0; k < 4; ++k) corners[k][k] = order;
  std::vector<Place> places;
  add_tetrahedron(corners, order, sides, places);
  return places;
}

}  // namespace

std::vector<int> vtk_tetrahedron(int order) {
  std::map<Place, int> number;
  for (const Place& place : places_in(gmsh, order)) number.emplace(place, static_cast<int>(number.size()));
  std::vector<int> found;
  for (const Place& place : places_in(vtk, order)) found.push_back(number.at(place));
  return found;
}

}  // namespace tetproof::io
