// SPDX-License-Identifier: GPL-3.0-or-later
// Sources: Gmsh's reference manual, "Node ordering"; VTK's class documentation (vtkQuadraticTetra and its
// like); TetGen's manual, section 5.2.4, figure 35; Medit: what Gmsh writes.
#include "io/model/node_order.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/model/element_types.hpp"
#include "io/model/simplex_lattice.hpp"

namespace tetproof::io {
namespace {

// The nodes of an element in the format's order. Each node is named by the corners, in Gmsh's numbers, that
// it lies between.
struct Nodes {
  int type;
  std::string_view nodes;
};

// clang-format off
constexpr Nodes gmsh[] = {
    { 8, "0 1 01"},
    { 9, "0 1 2 01 12 02"},
    {10, "0 1 2 3 01 12 23 03 0123"},
    { 6, "0 1 2 3 4 5"},
    {11, "0 1 2 3 01 12 02 03 23 13"},
    {12, "0 1 2 3 4 5 6 7 01 03 04 12 15 23 26 37 45 47 56 67 0123 0145 0347 1256 2367 4567 01234567"},
    {13, "0 1 2 3 4 5 01 02 03 12 14 25 34 35 45 0134 0235 1245"},
    {17, "0 1 2 3 4 5 6 7 01 03 04 12 15 23 26 37 45 47 56 67"},
    {18, "0 1 2 3 4 5 01 02 03 12 14 25 34 35 45"},
    {19, "0 1 2 3 4 01 03 04 12 14 23 24 34"}};

constexpr Nodes vtk[] = {
    { 6, "0 2 1 3 5 4"},
    {11, "0 1 2 3 01 12 02 03 13 23"},
    {12, "0 1 2 3 4 5 6 7 01 12 23 03 45 56 67 47 04 15 26 37 0347 1256 0145 2367 0123 4567 01234567"},
    {13, "0 1 2 3 4 5 01 12 02 34 45 35 03 14 25 0134 1245 0235"},
    {17, "0 1 2 3 4 5 6 7 01 12 23 03 45 56 67 47 04 15 26 37"},
    {18, "0 1 2 3 4 5 01 12 02 34 45 35 03 14 25"},
    {19, "0 1 2 3 4 01 12 23 03 04 14 24 34"}};

constexpr Nodes medit[] = {
    {11, "0 1 2 3 01 12 02 03 13 23"}};

constexpr Nodes tetgen[] = {
    {11, "0 1 2 3 23 03 01 12 13 02"}};
// clang-format on

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; at < text.size(); at = text.find_first_not_of(' ', at + found.back().size()))
    found.push_back(text.substr(at, text.find(' ', at) - at));
  return found;
}

using Orders = std::map<std::pair<int, NodeOrder>, std::vector<int>>;

Orders all_orders() {
  Orders orders;
  const auto add = [&](std::span<const Nodes> table, NodeOrder format) {
    for (const Nodes& row : table)
      for (const Nodes& gmshs : gmsh) {
        if (gmshs.type != row.type) continue;
        std::vector<int>& order = orders[{row.type, format}];
        const std::vector<std::string_view> names = words(gmshs.nodes);
        for (const std::string_view node : words(row.nodes))
          for (std::size_t k = 0; k < names.size(); ++k)
            if (names[k] == node) order.push_back(static_cast<int>(k));
        if (order.size() != names.size()) throw std::logic_error("a node order that lacks a node");
      }
  };
  add(vtk, NodeOrder::vtk);
  add(medit, NodeOrder::medit);
  add(tetgen, NodeOrder::tetgen);
  for (int order = 2; const int type = complete_type(Shape::tetrahedron, order); ++order) {
    const std::vector<int> of_vtk = vtk_tetrahedron(order);
    if (order > 2) orders[{type, NodeOrder::vtk}] = of_vtk;
    orders[{bezier(type), NodeOrder::vtk}] = of_vtk;
  }
  return orders;
}

}  // namespace

std::span<const int> node_order(int type, NodeOrder format) {
  static const Orders orders = all_orders();
  const auto found = orders.find({type, format});
  return found == orders.end() ? std::span<const int>{} : std::span<const int>(found->second);
}

std::vector<int> order_of_lattice(int type, const std::vector<std::int64_t>& places) {
  struct Corners {
    int type;
    std::vector<std::vector<std::int64_t>> at;
  };
  // clang-format off
  static const Corners all[] = {
      { 8, {{0}, {2}}},
      { 9, {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
      {10, {{0, 0}, {2, 0}, {2, 2}, {0, 2}}},
      {11, {{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 2}}},
      {12, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}},
      {13, {{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {2, 0, 0, 2}, {0, 2, 0, 2}, {0, 0, 2, 2}}}};
  // clang-format on
  for (const Corners& corners : all) {
    if (corners.type != type) continue;
    const std::size_t each = corners.at[0].size();
    std::vector<std::vector<std::int64_t>> nodes;  // in Gmsh's order
    for (const Nodes& row : gmsh)
      for (const std::string_view node :
           row.type == type ? words(row.nodes) : std::vector<std::string_view>{}) {
        std::vector<std::int64_t> place(each, 0);
        for (const char corner : node)
          for (std::size_t k = 0; k < each; ++k)
            place[k] += corners.at[static_cast<std::size_t>(corner - '0')][k];
        for (std::int64_t& k : place) k /= static_cast<std::int64_t>(node.size());
        nodes.push_back(std::move(place));
      }
    if (places.size() != nodes.size() * each) return {};
    std::vector<int> order;
    std::vector<bool> seen(nodes.size(), false);
    for (std::size_t i = 0; i < places.size(); i += each)
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (std::equal(nodes[k].begin(), nodes[k].end(), places.begin() + static_cast<std::ptrdiff_t>(i)) &&
            !seen[k]) {
          order.push_back(static_cast<int>(k));
          seen[k] = true;
        }
    return order.size() == nodes.size() ? order : std::vector<int>{};
  }
  return {};
}

}  // namespace tetproof::io
