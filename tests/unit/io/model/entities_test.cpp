// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/model/entities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tetproof::io {
namespace {

// Several tasks share so many points.
constexpr std::size_t many = 500'000;

Document document_with(std::vector<Eigen::Vector3d> points) {
  Document document;
  document.points = std::move(points);
  return document;
}

TEST(EntityBoxes, ReachTheFarthestPointsWhereverTheyStand) {
  Document document = document_with(std::vector<Eigen::Vector3d>(many, {0.5, 0.5, 0.5}));
  document.points[many / 7] = {-1, 0.5, 7};
  document.points[many - 1] = {0.5, -3, 0.5};
  document.points[0] = {2, 0.5, 0.5};
  document.points[many / 2] = {std::numeric_limits<double>::quiet_NaN(), 9, 9};  // left out as a whole
  EntityBox box = empty_box;
  grow(box, document, NodeBlock{.count = many});
  EXPECT_EQ(box, (EntityBox{-1, -3, 0.5, 2, 0.5, 7}));
}

TEST(EntityBoxes, OfElementsLeaveOutUnknownNodes) {
  Document document = document_with({{0, 0, 0}, {1, 2, 3}, {5, 5, 5}});
  document.connectivity.assign(many, 0);
  document.connectivity[many - 2] = 1;
  document.connectivity[many / 3] = -1;
  EntityBox box = empty_box;
  grow(box, document, ElementBlock{.nodes_each = 4, .count = many / 4});
  EXPECT_EQ(box, (EntityBox{0, 0, 0, 1, 2, 3}));
}

// 0 and -0 are equal, but a file shows which of them it is.
TEST(EntityBoxes, KeepTheFirstOfEqualNumbers) {
  for (const double first : {0.0, -0.0}) {
    Document document = document_with(std::vector<Eigen::Vector3d>(many, Eigen::Vector3d::Constant(-first)));
    document.points[0].setConstant(first);
    EntityBox box = empty_box;
    grow(box, document, NodeBlock{.count = many});
    for (const double x : box) EXPECT_EQ(std::signbit(x), std::signbit(first));
  }
}

}  // namespace
}  // namespace tetproof::io
