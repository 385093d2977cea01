// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/triangles/near_pieces.hpp"

#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <utility>

#include "verify/triangles/separation.hpp"

namespace tetproof::verify {
namespace {

using Vector = Eigen::Vector3d;
using Hubs = std::array<Index, 3>;
constexpr Hubs no_hubs{-1, -1, -1};
constexpr std::size_t large = 2048;  // sets from here on are worth two threads

bool have_common(const Hubs& a, const Hubs& b) {
  for (const Index hub : a)
    if (hub >= 0 && (hub == b[0] || hub == b[1] || hub == b[2])) return true;
  return false;
}

template <class F, class G>
void both(bool parallel, const F& f, const G& g) {
  if (parallel)
    tbb::parallel_invoke(f, g);
  else
    f(), g();
}

using Bounds = Eigen::AlignedBox3d;

Bounds bounds(const Piece& piece) {
  Bounds box;
  for (const Vector& p : piece.corners) box.extend(p);
  box.min().array() -= piece.slack, box.max().array() += piece.slack;
  return box;
}

// The pieces [begin, end) of a tree.
struct Group {
  std::size_t begin, end;
  Hubs hubs = no_hubs;                 // which all have
  bool no_hub = false;                 // of any of them
  double slack = 0;                    // the largest
  Bounds box;                          // of the enlarged pieces
  std::unique_ptr<Group> left, right;  // none in a group of few

  std::size_t size() const { return end - begin; }
};

// Groups pieces so that groups are likely to be separated by planes.
class Tree {
 public:
  explicit Tree(const std::vector<Piece>& pieces) : pieces_(pieces), order_(pieces.size()) {
    // Pieces with other hubs, or with a quite different slack, do not belong together.
    using Key = std::tuple<Hubs, int, std::uint32_t>;
    std::vector<Key> keys;
    keys.reserve(pieces.size());
    for (const Piece& piece : pieces) {
      Hubs hubs = piece.hubs;
      std::sort(hubs.begin(), hubs.end());
      keys.emplace_back(hubs, std::ilogb(piece.slack) / 8, static_cast<std::uint32_t>(keys.size()));
    }
    tbb::parallel_sort(keys.begin(), keys.end());
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto& [hubs, magnitude, piece] = keys[i];
      if (i == 0 || hubs != std::get<0>(keys[i - 1]) || magnitude != std::get<1>(keys[i - 1]))
        starts.push_back(i);
      order_[i] = piece;
    }
    starts.push_back(order_.size());
    root_ = build_of(starts);
    corners_.reserve(3 * order_.size());
    for (const std::uint32_t i : order_)
      corners_.insert(corners_.end(), pieces_[i].corners.begin(), pieces_[i].corners.end());
  }

  const Group& root() const { return *root_; }
  const Piece& piece(std::size_t place) const { return pieces_[order_[place]]; }
  std::span<const Vector> corners(const Group& group) const {
    return {corners_.data() + 3 * group.begin, 3 * group.size()};
  }

 private:
  static constexpr std::size_t few = 4;

  // Of several sets of pieces, one beginning at each start and the last start being the end.
  std::unique_ptr<Group> build_of(const std::vector<std::size_t>& starts) {
    // Sets that are near each other in space come together.
    struct Set {
      std::size_t begin, end;
      Vector middle;
    };
    std::vector<Set> sets;
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
      Bounds box;
      for (std::size_t k = starts[i]; k < starts[i + 1]; ++k) box.extend(bounds(pieces_[order_[k]]));
      sets.push_back({starts[i], starts[i + 1], box.min() + box.sizes() / 2});
    }
    const auto arrange = [&](const auto& self, std::span<Set> part) -> void {
      if (part.size() < 3) return;
      Bounds box;
      for (const Set& set : part) box.extend(set.middle);
      Eigen::Index axis = 0;
      box.sizes().maxCoeff(&axis);
      const std::size_t half = part.size() / 2;
      std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                       [&](const Set& a, const Set& b) { return a.middle[axis] < b.middle[axis]; });
      self(self, part.first(half));
      self(self, part.subspan(half));
    };
    arrange(arrange, sets);
    std::vector<std::uint32_t> order;
    order.reserve(order_.size());
    for (Set& set : sets) {
      const std::size_t begin = order.size();
      order.insert(order.end(), order_.begin() + static_cast<std::ptrdiff_t>(set.begin),
                   order_.begin() + static_cast<std::ptrdiff_t>(set.end));
      set.begin = begin, set.end = order.size();
    }
    order_ = std::move(order);
    const auto join = [&](const auto& self, std::span<const Set> part) -> std::unique_ptr<Group> {
      if (part.size() == 1) return build(part[0].begin, part[0].end);
      const std::size_t half = part.size() / 2;
      auto group = std::make_unique<Group>(Group{part.front().begin, part.back().end});
      both(
          group->size() >= large, [&] { group->left = self(self, part.first(half)); },
          [&] { group->right = self(self, part.subspan(half)); });
      summarise(*group);
      group->hubs = no_hubs;
      group->no_hub = group->left->no_hub && group->right->no_hub;
      return group;
    };
    return join(join, sets);
  }

  // Of pieces with the same hubs.
  std::unique_ptr<Group> build(std::size_t begin, std::size_t end) {
    auto group = std::make_unique<Group>(Group{begin, end});
    group->hubs = pieces_[order_[begin]].hubs;
    group->no_hub = group->hubs == no_hubs;
    if (end - begin > few) {
      const std::size_t middle = divide(begin, end);
      both(
          end - begin >= large, [&] { group->left = build(begin, middle); },
          [&] { group->right = build(middle, end); });
    }
    summarise(*group);
    return group;
  }

  void summarise(Group& group) const {
    if (group.left) {
      group.box = group.left->box;
      group.box.extend(group.right->box);
      group.slack = std::max(group.left->slack, group.right->slack);
      return;
    }
    for (std::size_t k = group.begin; k < group.end; ++k) {
      group.box.extend(bounds(pieces_[order_[k]]));
      group.slack = std::max(group.slack, pieces_[order_[k]].slack);
    }
  }

  // Divides pieces in halves by their centres, along the direction in which the centres spread most in
  // proportion to the pieces themselves: across them, if they are long and lie side by side. Returns the
  // place of the second half.
  std::size_t divide(std::size_t begin, std::size_t end) {
    const auto centre = [&](std::uint32_t i) {
      const auto& [a, b, c] = pieces_[i].corners;
      return Vector((a + b + c) / 3);
    };
    const auto count = static_cast<double>(end - begin);
    Vector mean = Vector::Zero();
    double scale = 0;
    for (std::size_t k = begin; k < end; ++k) mean += centre(order_[k]) / count;
    for (std::size_t k = begin; k < end; ++k)
      for (const Vector& p : pieces_[order_[k]].corners)
        scale = std::max(scale, (p - mean).cwiseAbs().maxCoeff());
    const std::size_t middle = begin + (end - begin) / 2;
    if (!(scale > 0x1p-1000)) return middle;
    Eigen::Matrix3d centres = Eigen::Matrix3d::Zero(), spans = centres;
    for (std::size_t k = begin; k < end; ++k) {
      const Vector c = centre(order_[k]), way = (c - mean) / scale;
      centres += way * way.transpose();
      for (const Vector& p : pieces_[order_[k]].corners) {
        const Vector span = (p - c) / scale;
        spans += span * span.transpose();
      }
    }
    spans += 1e-12 * (centres.trace() + spans.trace()) * Eigen::Matrix3d::Identity();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(centres, spans);
    if (solver.info() != Eigen::Success) return middle;
    const Vector along = solver.eigenvectors().col(2);
    std::vector<std::pair<double, std::uint32_t>> keys;
    keys.reserve(end - begin);
    for (std::size_t k = begin; k < end; ++k)
      keys.emplace_back(along.dot(centre(order_[k]) - mean), order_[k]);
    std::nth_element(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(middle - begin), keys.end());
    for (std::size_t k = begin; k < end; ++k) order_[k] = keys[k - begin].second;
    return middle;
  }

  const std::vector<Piece>& pieces_;
  std::vector<std::uint32_t> order_;
  std::vector<Vector> corners_;
  std::unique_ptr<Group> root_;
};

class Search {
 public:
  Search(const std::vector<Piece>& pieces, Compare compare, Threads threads,
         const std::function<void(Index, Index)>& report)
      : tree_(pieces),
        compare_(compare),
        smallest_task_(threads == Threads::all ? large : ~std::size_t{0}),
        report_(report) {
    within(tree_.root());
  }

 private:
  bool to_compare(const Group& a, const Group& b) const {
    return !(compare_ == Compare::pairs_with_hub && a.no_hub && b.no_hub) && !have_common(a.hubs, b.hubs) &&
           a.box.intersects(b.box);
  }

  // Pairs inside one group.
  void within(const Group& group) const {
    if (!to_compare(group, group)) return;
    if (!group.left) {
      for (std::size_t i = group.begin; i < group.end; ++i)
        for (std::size_t k = i + 1; k < group.end; ++k) compare(tree_.piece(i), tree_.piece(k));
      return;
    }
    both(
        group.size() >= smallest_task_, [&] { within(*group.left), within(*group.right); },
        [&] { between(*group.left, *group.right); });
  }

  void between(const Group& a, const Group& b) const {
    if (!to_compare(a, b)) return;
    if (separated(tree_.corners(a), tree_.corners(b), a.slack + b.slack)) return;
    if (!a.left && !b.left) {
      for (std::size_t i = a.begin; i < a.end; ++i)
        for (std::size_t k = b.begin; k < b.end; ++k) compare(tree_.piece(i), tree_.piece(k));
      return;
    }
    const bool first = a.left && (!b.left || a.size() >= b.size());
    const Group &whole = first ? a : b, &other = first ? b : a;
    both(
        a.size() + b.size() >= smallest_task_, [&] { between(*whole.left, other); },
        [&] { between(*whole.right, other); });
  }

  void compare(const Piece& a, const Piece& b) const {
    if (a.owner != b.owner && !have_common(a.hubs, b.hubs) && bounds(a).intersects(bounds(b)))
      report_(a.owner, b.owner);
  }

  const Tree tree_;
  Compare compare_;
  std::size_t smallest_task_;
  const std::function<void(Index, Index)>& report_;
};

}  // namespace

void near_pieces(const std::vector<Piece>& pieces, Compare compare, Threads threads,
                 const std::function<void(Index, Index)>& report) {
  if (pieces.size() > 1) Search(pieces, compare, threads, report);
}

}  // namespace tetproof::verify
