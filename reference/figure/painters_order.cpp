// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/figure/painters_order.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace tetproof::reference {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// A part of a triangle's picture, with room for a triangle that six half-planes have cut.
struct Polygon {
  std::array<Vector2d, 9> points;
  int count = 0;

  void add(const Vector2d& point) { points[count++] = point; }
  double area() const {
    double twice = 0;
    for (int i = 1; i + 1 < count; ++i) twice += cross(points[i] - points[0], points[i + 1] - points[0]);
    return twice / 2;
  }
};

// The part on the left of the line from a to b.
Polygon left_of(const Polygon& polygon, const Vector2d& a, const Vector2d& b) {
  Polygon part;
  for (int i = 0; i < polygon.count; ++i) {
    const Vector2d &p = polygon.points[i], &q = polygon.points[(i + 1) % polygon.count];
    const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
    if (at_p >= 0) part.add(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) part.add(p + at_p / (at_p - at_q) * (q - p));
  }
  return part;
}

class Picture {
 public:
  explicit Picture(const std::vector<SeenTriangle>& triangles) : triangles_(triangles) {
    Vector2d low(HUGE_VAL, HUGE_VAL), high = -low;
    for (const SeenTriangle& t : triangles)
      for (const Vector3d& p : t.corners) {
        low = low.cwiseMin(p.head<2>());
        high = high.cwiseMax(p.head<2>());
      }
    const double side = triangles.empty() ? 0 : (high - low).maxCoeff();
    least_area_ = 1e-9 * side * side;
  }

  // 1 if triangle i is nearer than j where both are seen, -1 if it is farther, 0 if they do not overlap.
  int nearer(std::size_t i, std::size_t j) const {
    Polygon overlap = picture(i);
    for (int k = 0; k < 3 && overlap.count > 0; ++k)
      overlap = left_of(overlap, corner(j, k), corner(j, (k + 1) % 3));
    if (!(overlap.area() > least_area_)) return 0;
    // Two triangles that meet only at their borders are at different depths all over the overlap, but for
    // common points. The largest difference is the one that rounding cannot turn over.
    double difference = 0;
    for (int k = 0; k < overlap.count; ++k) {
      const double here = depth(i, overlap.points[k]) - depth(j, overlap.points[k]);
      if (std::abs(here) > std::abs(difference)) difference = here;
    }
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
  }

  // All pairs (farther, nearer), found by a sweep over the boxes.
  std::vector<std::pair<std::size_t, std::size_t>> pairs() const {
    struct Box {
      Vector2d low, high;
      std::size_t triangle;
    };
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (!(picture(i).area() > 0)) continue;  // seen from behind, or from the edge
      const Vector2d a = corner(i, 0), b = corner(i, 1), c = corner(i, 2);
      boxes.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), i});
    }
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
      return std::pair(a.low.x(), a.triangle) < std::pair(b.low.x(), b.triangle);
    });
    std::vector<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t a = 0; a < boxes.size(); ++a)
      for (std::size_t b = a + 1; b < boxes.size() && boxes[b].low.x() < boxes[a].high.x(); ++b) {
        if (boxes[b].low.y() >= boxes[a].high.y() || boxes[a].low.y() >= boxes[b].high.y()) continue;
        const std::size_t i = boxes[a].triangle, j = boxes[b].triangle;
        if (const int order = nearer(i, j)) found.push_back(order > 0 ? std::pair(j, i) : std::pair(i, j));
      }
    std::sort(found.begin(), found.end());
    return found;
  }

  double mean_depth(std::size_t i) const {
    const auto& [a, b, c] = triangles_[i].corners;
    return a.z() + b.z() + c.z();
  }

 private:
  Vector2d corner(std::size_t i, int k) const { return triangles_[i].corners[k].head<2>(); }
  Polygon picture(std::size_t i) const {
    Polygon polygon;
    for (int k = 0; k < 3; ++k) polygon.add(corner(i, k));
    return polygon;
  }
  double depth(std::size_t i, const Vector2d& at) const {
    const Vector2d a = corner(i, 0), b = corner(i, 1), c = corner(i, 2);
    const double all = cross(b - a, c - a), of_b = cross(at - a, c - a) / all,
                 of_c = cross(b - a, at - a) / all;
    const auto& z = triangles_[i].corners;
    return z[0].z() + of_b * (z[1].z() - z[0].z()) + of_c * (z[2].z() - z[0].z());
  }

  const std::vector<SeenTriangle>& triangles_;
  double least_area_;
};

// Takes triangles whose farther ones are all painted, layer by layer.
class Painting {
 public:
  Painting(const Picture& picture, const std::vector<SeenTriangle>& triangles)
      : picture_(picture),
        triangles_(triangles),
        nearer_(triangles.size()),
        farther_(triangles.size()),
        waits_for_(triangles.size(), 0),
        state_(triangles.size(), State::waits) {
    for (const auto& [far, near] : picture.pairs()) {
      nearer_[far].push_back(near);
      farther_[near].push_back(far);
      ++waits_for_[near];
    }
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (waits_for_[i] == 0) make_ready(i);
  }

  PaintersOrder paint() {
    PaintersOrder order;
    for (std::size_t painted = 0; painted < triangles_.size();) {
      if (ready_.empty()) {
        const std::size_t i = farthest_of_a_circle();
        order.wrong_pairs += waits_for_[i];
        make_ready(i);
      }
      // The colour of most: few layers.
      const auto largest = std::max_element(ready_.begin(), ready_.end(), [](const auto& a, const auto& b) {
        return a.second.size() < b.second.size();
      });
      std::vector<std::size_t> layer = std::move(largest->second);
      ready_.erase(largest);
      std::sort(layer.begin(), layer.end());
      for (const std::size_t i : layer) state_[i] = State::painted;
      for (const std::size_t i : layer)
        for (const std::size_t near : nearer_[i])
          if (--waits_for_[near] == 0 && state_[near] == State::waits) make_ready(near);
      painted += layer.size();
      order.layers.push_back(std::move(layer));
    }
    return order;
  }

 private:
  enum class State : char { waits, ready, painted };

  void make_ready(std::size_t i) {
    state_[i] = State::ready;
    ready_[triangles_[i].colour].push_back(i);
  }

  // Every triangle that is left waits for another one that is left; so the way from one to the next ends in a
  // circle.
  std::size_t farthest_of_a_circle() const {
    std::size_t at = std::find(state_.begin(), state_.end(), State::waits) - state_.begin();
    std::vector<std::size_t> way;
    std::vector<bool> met(triangles_.size(), false);
    while (!met[at]) {
      met[at] = true;
      way.push_back(at);
      at = *std::find_if(farther_[at].begin(), farther_[at].end(),
                         [&](std::size_t i) { return state_[i] == State::waits; });
    }
    const auto circle = std::find(way.begin(), way.end(), at);
    return *std::min_element(circle, way.end(), [&](std::size_t i, std::size_t j) {
      return std::pair(picture_.mean_depth(i), i) < std::pair(picture_.mean_depth(j), j);
    });
  }

  const Picture& picture_;
  const std::vector<SeenTriangle>& triangles_;
  std::vector<std::vector<std::size_t>> nearer_, farther_;
  std::vector<std::int64_t> waits_for_;  // how many triangles behind this one are not painted yet
  std::vector<State> state_;
  std::map<int, std::vector<std::size_t>> ready_;  // by colour
};

}  // namespace

PaintersOrder painters_order(const std::vector<SeenTriangle>& triangles) {
  const Picture picture(triangles);
  return Painting(picture, triangles).paint();
}

}  // namespace tetproof::reference
