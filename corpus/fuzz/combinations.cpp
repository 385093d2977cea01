// SPDX-License-Identifier: GPL-3.0-or-later
// The combinations of random surfaces. The bounding boxes of the parts prove that these do not meet.
#include "corpus/fuzz/kind.hpp"

namespace tetproof::corpus {
namespace {

using Count = std::optional<std::int64_t>;

Count sum(const Count& a, const Count& b) {
  return a && b ? Count(*a + *b) : std::nullopt;
}

Shape beside(const Numbers& values, const std::vector<Shape>& parts) {
  Shape all{{}, 0, 0, 0};
  double x = 0;
  for (const Shape& part : parts) {
    const Box box = bounding_box(part.surface);
    append(all.surface, part.surface, {x - box.low[0], 0, 0});
    x = bounding_box(all.surface).high[0] + values["gap"];
    all.components = sum(all.components, part.components);
    all.cavities = sum(all.cavities, part.cavities);
    all.genus = sum(all.genus, part.genus);
  }
  return all;
}

Shape nested(const Numbers& values, const std::vector<Shape>& parts) {
  const Shape& part = parts[0];
  const Box box = bounding_box(part.surface);
  const Eigen::Vector3d gap = Eigen::Vector3d::Constant(values["gap"]),
                        wall = Eigen::Vector3d::Constant(values["wall"]);
  Shape all{box_surface(box.low - gap - wall, box.high + gap + wall), 1, 0, part.genus};
  all.components = sum(1, part.components);
  if (values["wall"] > 0) {
    append(all.surface, box_surface(box.low - gap, box.high + gap), {0, 0, 0}, true);
    append(all.surface, part.surface);
    all.components = sum(1, all.components);
    all.cavities = sum(1, part.cavities);
  } else {
    append(all.surface, part.surface, {0, 0, 0}, true);
    all.cavities.reset();  // what was solid is a cavity now, and what was a cavity is solid
    if (part.components && part.cavities) all.cavities = *part.components - *part.cavities;
  }
  return all;
}

}  // namespace

const std::vector<FuzzCombination>& fuzz_combinations() {
  static const std::vector<FuzzCombination> all{
      {"beside",
       "the parts side by side along x",
       {{"gap", Draw::length, 1e-9, 1e6, 1e-6, 1, 1, "between the boxes of two parts"}},
       1,
       64,
       beside},
      {"nested",
       "a box with a cavity of the part's shape; with a wall, a hollow box with the part inside",
       {{"gap", Draw::length, 1e-9, 1e6, 1e-6, 1, 1, "from the part's box to the box around it"},
        {"wall", Draw::share, 0, 1e6, 0, 1, 0, "thickness of the hollow box; 0: the part is the cavity"}},
       1,
       1,
       nested},
  };
  return all;
}

}  // namespace tetproof::corpus
