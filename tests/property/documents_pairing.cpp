// SPDX-License-Identifier: GPL-3.0-or-later
#include "documents_pairing.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include "facet_cover.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::test {
namespace {

// The type of the first-order element with the same corners, and the number of corners; 0, 0: the element is
// of first order itself.
std::pair<int, std::size_t> corners_of(const Element& element) {
  static const std::map<io::Shape, int> first_order{{io::Shape::line, 1},       {io::Shape::triangle, 2},
                                                    {io::Shape::quadrangle, 3}, {io::Shape::tetrahedron, 4},
                                                    {io::Shape::hexahedron, 5}, {io::Shape::prism, 6},
                                                    {io::Shape::pyramid, 7}};
  const io::ElementType* type = io::element_type(element.type);
  if (!type || type->corners == type->nodes) return {0, 0};
  const auto found = first_order.find(type->shape);
  if (found == first_order.end()) return {0, 0};
  return {found->second, static_cast<std::size_t>(type->corners)};
}

using Key = std::pair<int, std::vector<Index>>;

// The number of corners of an element that may be cut into triangles; 0 for any other one.
std::size_t corners_to_cut(const Element& element) {
  const io::ElementType* type = io::element_type(element.type);
  if (element.names_unknown()) return 0;
  if (element.type == io::polygon) return element.nodes.size();
  return type && type->shape == io::Shape::quadrangle ? 4 : 0;
}

using Triangle = std::array<Index, 3>;

// Finds polygons and facets in the triangles that they were cut into.
class Cutting {
 public:
  Cutting(const Document& document, const std::vector<Element>& before, const std::vector<Element>& after,
          Pairing& pairs)
      : before_(before), after_(after), pairs_(pairs), facet_(before.size()), taken_(before.size()) {
    for (const Facet& facet : document.facets) {
      covers_.try_emplace(&facet, document, before, facet);
      for (std::size_t k = 0; k < facet.polygons; ++k) facet_[facet.first + k] = &facet;
    }
    for (const Element& element : after) {
      Triangle corners{none, none, none};
      for (std::size_t k = 0; element.type == io::triangle3 && k < 3; ++k)
        corners[k] =
            element.nodes[k] < 0 ? none : pairs.node_before[static_cast<std::size_t>(element.nodes[k])];
      triangles_.push_back(corners);
      ++surplus_[corners];
    }
    for (std::size_t b = 0; b < before.size(); ++b)
      if (is_triangle(b)) --surplus_[{before[b].nodes[0], before[b].nodes[1], before[b].nodes[2]}];
  }

  // Tries until no triangle is left over. If polygons name nodes several times, the triangles of one may be
  // part of another one.
  void find() {
    for (const auto& [corners, more] : surplus_) left_ += static_cast<std::size_t>(std::max(more, 0));
    if (left_ > 0) find_from(0, 0);
  }

  // Whether an element comes back only with its facet, as triangles that are not it.
  bool comes_with_facet(std::size_t b) const {
    return facet_[b] && !(taken_[b] == 1 && pairs_.cut_after[b] == none);
  }

 private:
  // A triangle that came back as it was, or by its corners.
  bool is_triangle(std::size_t b) const {
    const Element& element = before_[b];
    return !facet_[b] &&
           (element.type == io::triangle3 || corners_of(element) == std::pair(2, std::size_t{3})) &&
           !element.names_unknown();
  }

  bool find_from(std::size_t b, std::size_t from) {
    if (left_ == 0) return true;
    if (b == before_.size() || ++tries_ > 100000) return false;
    const std::size_t n = facet_[b] ? 0 : corners_to_cut(before_[b]),
                      behind = b + (facet_[b] ? facet_[b]->polygons : 1);
    const auto cut_at = [&](std::size_t e, std::size_t count) {
      if (e + count > after_.size() || !(facet_[b] ? cover(*facet_[b], count, e) : cover(before_[b], n, e)))
        return false;
      claim(b, e, count, 1);
      if (find_from(behind, e + count)) return true;
      claim(b, e, count, -1);
      return false;
    };
    // The triangles of others may fit into a facet too, so it comes last; of its numbers of triangles, the
    // largest comes first.
    if (facet_[b] && find_from(behind, from)) return true;
    const auto any_cut_at = [&](std::size_t e) {
      if (!facet_[b]) return n >= 4 && cut_at(e, n - 2);
      for (std::size_t count = after_.size() - e; count > 0; --count)
        if (cut_at(e, count)) return true;
      return false;
    };
    // Most likely they follow the triangles of the elements before the polygon.
    std::size_t place = 0;
    for (std::size_t i = 0; i < b; ++i) place += is_triangle(i) ? 1 : taken_[i];
    if (place >= from && place < after_.size() && any_cut_at(place)) return true;
    for (std::size_t e = from; e < after_.size(); ++e)
      if (e != place && any_cut_at(e)) return true;
    return !facet_[b] && find_from(behind, from);
  }

  // Gives the triangles from `e` on to a polygon or to the first face of a facet (`sign` 1), or takes them
  // away again (-1). A facet's first face that is the only triangle itself was not cut.
  void claim(std::size_t b, std::size_t e, std::size_t count, int sign) {
    std::size_t face = b;
    const std::size_t behind = b + (facet_[b] ? facet_[b]->polygons : 1);
    while (before_[face].nodes.size() < 3) ++face;
    const std::vector<Index> only(triangles_[e].begin(), triangles_[e].end());
    const bool as_it_was = count == 1 && before_[face].nodes == only;
    taken_[face] = sign > 0 ? count : 0;
    for (std::size_t i = face; i < behind; ++i)
      if (before_[i].nodes.size() >= 3 && !(i == face && as_it_was))
        pairs_.cut_after[i] = sign > 0 ? static_cast<Index>(e) : none;
    for (std::size_t i = e; i < e + count; ++i) {
      if (!as_it_was) pairs_.cut_before[i] = sign > 0 ? static_cast<Index>(face) : none;
      surplus_[triangles_[i]] -= sign;
    }
    left_ = sign > 0 ? left_ - count : left_ + count;
  }

  // Whether the triangles from `e` on are a fan of the polygon.
  bool is_fan(const Element& polygon, std::size_t n, std::size_t e) {
    for (std::size_t start = 0; start < n; ++start) {
      bool all = true;
      for (std::size_t i = 1; i + 1 < n && all; ++i)
        all = triangles_[e + i - 1] == Triangle{polygon.nodes[start], polygon.nodes[(start + i) % n],
                                                polygon.nodes[(start + i + 1) % n]};
      if (all) return true;
    }
    return false;
  }

  // Whether the triangles from `e` on cover the polygon, and none of them was a triangle before: they have
  // the polygon's sides, and all others twice, in both directions.
  bool cover(const Element& polygon, std::size_t n, std::size_t e) {
    std::map<Triangle, int> used;
    std::map<std::pair<Index, Index>, int> sides;
    const auto add = [&](Index from, Index to, int more) {
      sides[std::minmax(from, to)] += from < to ? more : -more;
    };
    for (std::size_t i = e; i < e + n - 2; ++i) {
      const Triangle& t = triangles_[i];
      if (++used[t] > surplus_[t] || t[0] == none) return false;
      for (std::size_t k = 0; k < 3; ++k) {
        if (std::find(polygon.nodes.begin(), polygon.nodes.begin() + static_cast<std::ptrdiff_t>(n), t[k]) ==
            polygon.nodes.begin() + static_cast<std::ptrdiff_t>(n))
          return false;
        add(t[k], t[(k + 1) % 3], 1);
      }
    }
    if (is_fan(polygon, n, e)) return true;
    for (std::size_t k = 0; k < n; ++k) add(polygon.nodes[k], polygon.nodes[(k + 1) % n], -1);
    return std::all_of(sides.begin(), sides.end(), [](const auto& side) {
      return side.second == 0 || side.first.first == side.first.second;
    });
  }

  // Whether the triangles from `e` on may be those of a facet, and none of them was a triangle before.
  bool cover(const Facet& facet, std::size_t count, std::size_t e) {
    std::map<Triangle, int> used;
    for (std::size_t i = e; i < e + count; ++i)
      if (const Triangle& t = triangles_[i]; ++used[t] > surplus_[t] || t[0] == none) return false;
    return covers_.at(&facet).may_be(std::span(triangles_).subspan(e, count));
  }

  const std::vector<Element>&before_, &after_;
  Pairing& pairs_;
  std::map<const Facet*, FacetCover> covers_;
  std::vector<const Facet*> facet_;  // of each element of `before`; null: none
  std::vector<std::size_t> taken_;   // how many triangles of `after` each element of `before` has now
  std::vector<Triangle> triangles_;  // of `after`, with the node numbers of `before`
  std::map<Triangle, int> surplus_;  // the number in `after` minus the number in `before`
  std::size_t left_ = 0, tries_ = 0;
};

}  // namespace

bool Element::names_unknown() const {
  return std::any_of(nodes.begin(), nodes.end(), [](Index i) { return i < 0; });
}

std::vector<Element> elements_of(const Document& document) {
  std::vector<Element> elements;
  for (const ElementBlock& block : document.blocks)
    for (std::size_t e = 0; e < block.count; ++e) {
      const auto node =
          document.connectivity.begin() +
          static_cast<std::ptrdiff_t>(block.nodes + e * static_cast<std::size_t>(block.nodes_each));
      elements.push_back({block.type,
                          block.dim,
                          block.entity,
                          document.element_tag(elements.size()),
                          document.tag_sets.at(static_cast<std::size_t>(block.groups)),
                          document.tag_sets.at(static_cast<std::size_t>(block.partitions)),
                          block.of_boundary,
                          {node, node + block.nodes_each}});
    }
  return elements;
}

Pairing pair_up(const Document& before, const std::vector<Element>& elements_before, const Document& after,
                const std::vector<Element>& elements_after, Holding holding) {
  Pairing pairs;
  std::map<std::uint32_t, Index> by_x;
  const auto bits = [](const Eigen::Vector3d& p) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(p.x()));
  };
  for (std::size_t i = 0; i < before.points.size(); ++i)
    if (!by_x.try_emplace(bits(before.points[i]), static_cast<Index>(i)).second)
      throw std::logic_error("two nodes with the same x cannot be told apart");
  pairs.node_after.assign(before.points.size(), none);
  for (std::size_t i = 0; i < after.points.size(); ++i) {
    const auto found = by_x.find(bits(after.points[i]));
    pairs.node_before.push_back(found == by_x.end() ? none : found->second);
    if (found == by_x.end()) continue;
    pairs.node_after[static_cast<std::size_t>(found->second)] = static_cast<Index>(i);
    by_x.erase(found);
  }

  std::map<Key, std::vector<Index>> whole, by_corners;
  for (std::size_t e = 0; e < elements_before.size(); ++e) {
    if (holding > Holding::elements && elements_before[e].names_unknown()) continue;
    Key key{elements_before[e].type, elements_before[e].nodes};
    for (Index& node : key.second)
      if (node < 0) node = none;
    whole[key].push_back(static_cast<Index>(e));
    const auto [type, corners] = corners_of(elements_before[e]);
    if (corners == 0) continue;
    key.first = type, key.second.resize(corners);
    by_corners[key].push_back(static_cast<Index>(e));
  }
  pairs.element_after.assign(elements_before.size(), none);
  pairs.element_before.assign(elements_after.size(), none);
  pairs.cut_before.assign(elements_after.size(), none);
  pairs.cut_after.assign(elements_before.size(), none);
  std::optional<Cutting> cutting;
  if (holding == Holding::triangles) cutting.emplace(before, elements_before, elements_after, pairs).find();
  std::vector<Key> keys;                // elements of `after`, with the node numbers of `before`
  std::map<Key, std::size_t> unpaired;  // how many of each are not paired yet
  for (std::size_t e = 0; e < elements_after.size(); ++e) {
    Key key{elements_after[e].type, elements_after[e].nodes};
    constexpr Index new_node = -2;
    for (Index& node : key.second) {
      if (node >= 0 && pairs.node_before[static_cast<std::size_t>(node)] == none)
        node = new_node;
      else
        node = node < 0 ? none : pairs.node_before[static_cast<std::size_t>(node)];
    }
    if (pairs.cut_before[e] == none) ++unpaired[key];
    keys.push_back(std::move(key));
  }
  const auto pair = [&](std::size_t e, std::initializer_list<const std::map<Key, std::vector<Index>>*> among,
                        bool same_part) {
    if (pairs.cut_before[e] != none || pairs.element_before[e] != none) return;
    std::vector<Index> candidates;
    for (const auto* in : among)
      if (const auto like = in->find(keys[e]); like != in->end())
        for (const Index b : like->second)
          if (pairs.element_after[static_cast<std::size_t>(b)] == none &&
              !(cutting && cutting->comes_with_facet(static_cast<std::size_t>(b))))
            candidates.push_back(b);
    // If all came back there is no need to choose.
    if (same_part && candidates.size() > unpaired[keys[e]])
      std::erase_if(candidates, [&](Index b) {
        return elements_before[static_cast<std::size_t>(b)].of_boundary != elements_after[e].of_boundary;
      });
    if (candidates.empty()) return;
    const Index found = *std::min_element(candidates.begin(), candidates.end());
    --unpaired[keys[e]];
    pairs.element_before[e] = found;
    pairs.element_after[static_cast<std::size_t>(found)] = static_cast<Index>(e);
  };
  // First pairs elements of higher order, which came back whole; the remaining ones lost their mid-edge
  // nodes. Before that, pairs elements that are part of the boundary to mesh in both documents or in none.
  for (const bool same_part : {true, false}) {
    for (std::size_t e = 0; e < elements_after.size(); ++e)
      if (corners_of(elements_after[e]).first != 0) pair(e, {&whole}, same_part);
    for (std::size_t e = 0; e < elements_after.size(); ++e)
      if (corners_of(elements_after[e]).first == 0) pair(e, {&whole, &by_corners}, same_part);
  }
  return pairs;
}

}  // namespace tetproof::test
