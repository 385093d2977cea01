// SPDX-License-Identifier: GPL-3.0-or-later
// The table of element types, compared with the number of nodes of a complete element of each order.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

struct Family {
  Shape shape;
  int dim, corners;
  int (*nodes)(int order);
  std::vector<int> types;  // of order 1, 2, ...: Gmsh's manual, "Node ordering", and its MSH file format
};

const std::vector<Family> families{
    {Shape::line, 1, 2, [](int p) { return p + 1; }, {1, 8, 26, 27, 28, 62, 63, 64, 65, 66}},
    {Shape::triangle,
     2,
     3,
     [](int p) { return (p + 1) * (p + 2) / 2; },
     {2, 9, 21, 23, 25, 42, 43, 44, 45, 46}},
    {Shape::quadrangle,
     2,
     4,
     [](int p) { return (p + 1) * (p + 1); },
     {3, 10, 36, 37, 38, 47, 48, 49, 50, 51}},
    {Shape::tetrahedron,
     3,
     4,
     [](int p) { return (p + 1) * (p + 2) * (p + 3) / 6; },
     {4, 11, 29, 30, 31, 71, 72, 73, 74, 75}},
    {Shape::hexahedron,
     3,
     8,
     [](int p) { return (p + 1) * (p + 1) * (p + 1); },
     {5, 12, 92, 93, 94, 95, 96, 97, 98}},
    {Shape::prism,
     3,
     6,
     [](int p) { return (p + 1) * (p + 1) * (p + 2) / 2; },
     {6, 13, 90, 91, 106, 107, 108, 109, 110}},
    {Shape::pyramid,
     3,
     5,
     [](int p) { return (p + 1) * (p + 2) * (2 * p + 3) / 6; },
     {7, 14, 118, 119, 120, 121, 122, 123, 124}},
};

TEST(ElementTypes, CompleteOnesOfEachOrder) {
  for (const Family& family : families)
    for (std::size_t i = 0; i < family.types.size(); ++i) {
      const int order = static_cast<int>(i) + 1;
      const ElementType* type = element_type(family.types[i]);
      ASSERT_TRUE(type) << family.types[i];
      EXPECT_EQ(type->shape, family.shape) << family.types[i];
      EXPECT_EQ(type->dim, family.dim) << family.types[i];
      EXPECT_EQ(type->corners, family.corners) << family.types[i];
      EXPECT_EQ(type->nodes, family.nodes(order)) << family.types[i];
    }
}

TEST(ElementTypes, NamesOnlyWhatHasAKnownNumberOfNodes) {
  for (int polygon_or_polyhedron : {34, 35, 69}) EXPECT_FALSE(element_type(polygon_or_polyhedron));
  for (std::int64_t none : {-1L, 0L, 76L, 77L, 78L, 141L, 1L << 30, 4L + (1L << 32), -4L})
    EXPECT_FALSE(element_type(none));
  EXPECT_EQ(element_type(15)->nodes, 1);
}

TEST(ElementTypes, HaveAWord) {
  const std::vector<std::pair<int, std::string>> words{
      {15, "points"},     {8, "lines"},      {9, "triangles"},  {16, "quadrangles"},
      {11, "tetrahedra"}, {5, "hexahedra"},  {13, "prisms"},    {7, "pyramids"},
      {34, "polygons"},   {35, "polyhedra"}, {132, "elements"}, {-1, "elements"}};
  for (const auto& [type, word] : words) EXPECT_EQ(name_of_elements(type), word) << type;
}

}  // namespace
}  // namespace tetproof::io
