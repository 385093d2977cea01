// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/random_surface.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "corpus/generators/random.hpp"
#include "corpus/surfaces.hpp"

namespace tetproof::corpus {
namespace {

struct Part {
  std::string spec;
  double scale = 1;  // about the origin; exact
  bool inward = false;
};

struct Recipe {
  std::vector<Part> parts;
  bool inward = false;
};

// The specification of a star whose radius is between 1 - roughness and 1 + roughness.
std::string star(Random& random, double roughness, int most_frequency, double x) {
  const int f = 1 + random.below(most_frequency);
  return fmt::format("random:seed={},n={},roughness={},waves={},x={},y={},z={}", random.below(1 << 30),
                     8 * f * f, roughness, random.between(0.5, 2.5), x, random.between(-0.1, 0.1),
                     random.between(-0.1, 0.1));
}

Recipe recipe(std::uint64_t seed) {
  Random random(seed);
  Recipe recipe;
  switch (random.below(5)) {
    case 0:
    case 1:
      recipe.parts.push_back({star(random, random.between(0, 0.9), 10, random.between(-0.1, 0.1))});
      break;
    case 2: {
      // Copies of one star about one centre, each half as large as the one before, so that every triangle of
      // an inner copy lies within the corresponding triangle of the outer one, seen from the centre.
      const int f = 2 + random.below(5), shells = 2 + random.below(2);
      const std::string spec = fmt::format("random:seed={},n={},roughness={}", random.below(1 << 30),
                                           8 * f * f, random.between(0, 0.8));
      for (int shell = 0; shell < shells; ++shell)
        recipe.parts.push_back({spec, 1.0 / (1 << shell), shell % 2 == 1 && random.below(4) > 0});
      break;
    }
    case 3: {
      const int bodies = 2 + random.below(3);
      for (int body = 0; body < bodies; ++body)  // radii below 1.6, centres 3.3 apart
        recipe.parts.push_back({star(random, random.between(0, 0.6), 6, 3.3 * body)});
      break;
    }
    default:
      if (random.below(2) == 0) {
        recipe.parts.push_back(
            {fmt::format("terrain:seed={},m={},h={},n={}", random.below(1 << 30), 2 + random.below(4),
                         random.below(2) ? 1.0 : 0.5, 1 + random.below(2))});
      } else {
        const auto half = [&] { return 0.5 * (1 + random.below(6)); };
        const double rx = half(), ry = half(), rz = half();
        recipe.parts.push_back(
            {fmt::format("octahedron:rx={},ry={},rz={},x={}", rx, ry, rz, random.below(3))});
      }
  }
  recipe.inward = random.below(8) == 0;
  return recipe;
}

}  // namespace

TriangleSurface random_closed_surface(std::uint64_t seed) {
  const Recipe recipe = corpus::recipe(seed);
  TriangleSurface all;
  for (const Part& part : recipe.parts) {
    const TriangleSurface one = make_surface(part.spec);
    const Index first = static_cast<Index>(all.vertices.size());
    for (const Eigen::Vector3d& v : one.vertices) all.vertices.push_back(part.scale * v);
    for (auto [a, b, c] : one.triangles) {
      if (part.inward != recipe.inward) std::swap(b, c);
      all.triangles.push_back({first + a, first + b, first + c});
    }
  }
  return all;
}

std::string describe_random_surface(std::uint64_t seed) {
  const Recipe recipe = corpus::recipe(seed);
  std::string text;
  for (const Part& part : recipe.parts)
    text += fmt::format("{}{}{}{}", text.empty() ? "" : " + ", part.spec,
                        part.scale == 1 ? "" : fmt::format(" scaled by {}", part.scale),
                        part.inward != recipe.inward ? " inward" : "");
  return text;
}

}  // namespace tetproof::corpus
