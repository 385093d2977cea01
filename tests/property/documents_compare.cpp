// SPDX-License-Identifier: GPL-3.0-or-later
#include "documents_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "difference_list.hpp"
#include "document_texts.hpp"
#include "documents_pairing.hpp"
#include "entities_compare.hpp"
#include "io/model/element_types.hpp"
#include "texts_compare.hpp"

namespace tetproof::test {
namespace {

std::string kind_of(const Element& element) {
  static const std::map<io::Shape, const char*> names{
      {io::Shape::point, "points"},           {io::Shape::line, "lines"},
      {io::Shape::triangle, "triangles"},     {io::Shape::quadrangle, "quadrangles"},
      {io::Shape::tetrahedron, "tetrahedra"}, {io::Shape::hexahedron, "hexahedra"},
      {io::Shape::prism, "prisms"},           {io::Shape::pyramid, "pyramids"}};
  const io::ElementType* type = io::element_type(element.type);
  const auto found = type ? names.find(type->shape) : names.end();
  const char* name = element.type == io::polygon      ? "polygons"
                     : element.type == io::polyhedron ? "polyhedra"
                     : found == names.end()           ? "elements"
                                                      : found->second;
  return fmt::format("{} of {} node{} (type {})", name, element.nodes.size(),
                     element.nodes.size() == 1 ? "" : "s", element.type);
}

bool same_bits(double a, double b) {
  return bits(a) == bits(b);
}

// Whether the tags are 0, 1, 2, ... or 1, 2, 3, ...
bool counts_up(const std::vector<std::int64_t>& tags) {
  for (std::size_t i = 0; i < tags.size(); ++i)
    if (tags[i] != tags[0] + static_cast<std::int64_t>(i)) return false;
  return tags.empty() || tags[0] == 0 || tags[0] == 1;
}

class Comparison {
 public:
  Comparison(const Document& before, const Document& after, Holding holding)
      : before_(before),
        after_(after),
        old_(elements_of(before)),
        new_(elements_of(after)),
        pairs_(pair_up(before, old_, after, new_, holding)),
        may_be_surface_(may_be_surface()) {}

  std::vector<Difference> list() {
    groups_below_zero();
    nodes();
    elements();
    order_and_numbers();
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.element_before[e] != none) element(old_[at(pairs_.element_before[e])], new_[e]);
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.cut_after[e] != none) triangles(e);
    for (const Difference& d : differences_of_entities(before_, after_, pairs_))
      differences_.add(d.item, d.count, d.example, d.unsure);
    parts();
    return differences_.take();
  }

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  // Whether the faces may be the surface of a solid: then it is no loss that they are no facets any more. No
  // side of a face may be left over, except those of facets, of which only a part may belong to the surface.
  bool may_be_surface() const {
    std::map<std::pair<Index, Index>, int> sides;
    for (const Element& element : old_) {
      const io::ElementType* type = io::element_type(element.type);
      const int dim = type ? type->dim : element.dim;
      if (dim == 3) return false;
      if (dim != 2) continue;
      const std::size_t n = type ? static_cast<std::size_t>(type->corners) : element.nodes.size();
      for (std::size_t k = 0; k < n; ++k) {
        const Index a = element.nodes[k], b = element.nodes[(k + 1) % n];
        sides[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    return !before_.facets.empty() || std::all_of(sides.begin(), sides.end(), [](const auto& side) {
      return side.second == 0 || side.first.first == side.first.second;
    });
  }

  // TetGen's numbers below 0 may come back as groups: both say the same of elements that have no other group.
  void groups_below_zero() {
    for (const Values& values : before_.element_values) {
      if ((values.name != "attributes" && values.name != "markers") || values.components != 1) continue;
      bool all = !values.integers.empty() && values.integers.size() == values.items();
      std::map<std::size_t, std::int64_t> numbers;
      for (std::size_t i = 0; all && i < values.integers.size(); ++i) {
        const auto e = values.at.empty() ? static_cast<Index>(values.first + i) : values.at[i];
        if (values.integers[i] == 0) continue;
        all = values.integers[i] < 0 && e >= 0 && at(e) < old_.size() && old_[at(e)].groups.empty() &&
              numbers.emplace(at(e), values.integers[i]).second;
      }
      bool any = false;
      for (const auto& [e, number] : numbers) {
        const Index came = pairs_.element_after[e];
        any = any || came != none;
        all = all && (came == none || new_[at(came)].groups == std::vector<std::int64_t>{number});
      }
      // Numbers of lost elements are lost with these where others would have come as groups.
      if (!all || numbers.empty() || (!any && after_.format != "medit")) continue;
      for (const auto& [e, number] : numbers) old_[e].groups = {number};
      became_groups_.insert(&values);
    }
  }

  void nodes() {
    for (std::size_t i = 0; i < before_.points.size(); ++i) {
      const Index after = pairs_.node_after[i];
      if (after == none) {
        differences_.add_one("nodes of no element that is written",
                             fmt::format("node {}", before_.node_tag(i)));
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        const double a = before_.points[i][k], b = after_.points[at(after)][k];
        if (same_bits(a, b)) continue;
        const bool rounded = same_bits(static_cast<double>(static_cast<float>(a)), b);
        differences_.add_one(rounded ? "coordinates rounded to 32 bits" : "changed coordinates",
                             fmt::format("{} becomes {}", a, b));
      }
    }
    for (std::size_t i = 0; i < after_.points.size(); ++i)
      if (pairs_.node_before[i] == none)
        differences_.add("gained nodes", 1, fmt::format("node {}", after_.node_tag(i)));
  }

  void elements() {
    // If other elements of the kind came back, these are missing for another reason.
    std::set<std::tuple<int, std::size_t, bool>> kinds;
    const auto kind = [](const Element& e) { return std::tuple(e.type, e.nodes.size(), e.of_boundary); };
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.element_after[e] != none) kinds.insert(kind(old_[e]));
    for (std::size_t e = 0; e < old_.size(); ++e) {
      const std::string example = fmt::format("element {}", old_[e].tag);
      const Index after = pairs_.element_after[e];
      if (pairs_.cut_after[e] != none)
        differences_.add_one(kind_of(old_[e]) + " cut into triangles", example);
      else if (after == none)
        differences_.add_one(old_[e].names_unknown() && kinds.count(kind(old_[e]))
                                 ? "elements that name nodes which do not exist"
                                 : kind_of(old_[e]),
                             example);
      else if (new_[at(after)].nodes.size() < old_[e].nodes.size())
        differences_.add_one(fmt::format("nodes between the corners of {}", kind_of(old_[e])), example);
    }
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.element_before[e] == none && pairs_.cut_before[e] == none)
        differences_.add("gained elements", 1, fmt::format("element {}", new_[e].tag));
  }

  void order_and_numbers() {
    std::vector<std::int64_t> was, is;
    Index last = -1;
    bool in_order = true;
    for (std::size_t e = 0; e < new_.size(); ++e) {
      const Index b = pairs_.element_before[e];
      if (b == none) continue;
      in_order = in_order && b > last;
      last = b;
      was.push_back(old_[at(b)].tag), is.push_back(new_[e].tag);
    }
    if (!in_order) differences_.add("order of elements", 1, "");
    if (was != is && !(counts_up(was) && counts_up(is)))
      differences_.add("numbers of elements", static_cast<std::int64_t>(was.size()),
                       fmt::format("the first was {}", was[0]), false,
                       fmt::format("the first is {}", was[0]));
    was.clear(), is.clear();
    in_order = true, last = -1;
    for (std::size_t i = 0; i < after_.points.size(); ++i) {
      const Index b = pairs_.node_before[i];
      if (b == none) continue;
      in_order = in_order && b > last;
      last = b;
      was.push_back(before_.node_tag(at(b))), is.push_back(after_.node_tag(i));
    }
    if (was != is && !(counts_up(was) && counts_up(is)))
      differences_.add("numbers of nodes", static_cast<std::int64_t>(was.size()),
                       fmt::format("the first was {}", was[0]), false,
                       fmt::format("the first is {}", was[0]));
    if (!in_order) differences_.add("order of nodes", 1, "");
  }

  void element(const Element& was, const Element& is) {
    const std::string example = fmt::format("element {}", was.tag);
    std::vector<std::int64_t> groups = was.groups;
    const auto is_there = [](const std::vector<std::int64_t>& all, std::int64_t group) {
      return std::find(all.begin(), all.end(), group) != all.end();
    };
    if (std::any_of(groups.begin(), groups.end(), [&](std::int64_t group) {
          return group < 0 && is_there(is.groups, -group) && !is_there(was.groups, -group);
        })) {
      differences_.add_one("signs of physical groups", example);
      groups.clear();
      for (const std::int64_t group : was.groups)
        if (!is_there(groups, std::abs(group))) groups.push_back(std::abs(group));
    }
    if (groups != is.groups) {
      if (is.groups.empty())
        differences_.add_one("physical groups of elements", example);
      else if (is.groups.size() == 1 && !groups.empty() && is.groups[0] == groups[0])
        differences_.add_one("physical groups beyond an element's first", example);
      else
        differences_.add("changed physical groups", 1, example);
    }
    if (was.partitions != is.partitions)
      differences_.add_one(is.partitions.empty() ? "partitions of elements" : "changed partitions", example);
    if (was.of_boundary && !is.of_boundary && was.dim < 2)
      differences_.add_one("that lines and points belong to TetGen's facets", example);
    else if (was.of_boundary && !is.of_boundary)
      differences_.add(
          "that faces are TetGen's facets, which have no direction and may lie inside of the body", 1,
          example, may_be_surface_, example);
    else if (was.of_boundary != is.of_boundary)
      differences_.add("that faces are of a mesh, not facets of a body to mesh", 1, example, may_be_surface_,
                       example);
    for (std::size_t k = 0; k < is.nodes.size(); ++k) {
      if (is.nodes[k] >= 0) continue;
      const std::int64_t a = before_.named(was.nodes[k]), b = after_.named(is.nodes[k]);
      if (a != b && renumbered_unknown_.insert(a).second)
        differences_.add("numbers of nodes that do not exist", 1, fmt::format("{} became {}", a, b), false,
                         fmt::format("{} becomes {}", a, b));
    }
  }

  // All triangles of a polygon must have the same groups, partitions and entity.
  void triangles(std::size_t polygon) {
    const Element& first = new_[at(pairs_.cut_after[polygon])];
    Element alike = first;
    alike.nodes.clear();
    element(old_[polygon], alike);
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.cut_before[e] == static_cast<Index>(polygon) &&
          (new_[e].groups != first.groups || new_[e].partitions != first.partitions ||
           new_[e].entity != first.entity || new_[e].of_boundary != first.of_boundary))
        differences_.add("triangles of a polygon that differ", 1, fmt::format("element {}", new_[e].tag));
  }

  void texts(std::vector<Text> was, std::vector<Text> is) {
    for (Text& text : is) text.format = after_.format;
    compare_texts(std::move(was), std::move(is), differences_, renumbered_unknown_);
  }

  void parts() {
    // A file may still name a lost node or element by a number that nothing has now.
    std::set<std::int64_t> lost_nodes, lost_elements;
    for (std::size_t i = 0; i < before_.points.size(); ++i)
      if (pairs_.node_after[i] == none) lost_nodes.insert(before_.node_tag(i));
    // This number is the old one or the position. If no element that came back shows which, it may be either.
    bool renumbered = false, same = false;
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (const Index was = pairs_.element_before[e]; was != none)
        (old_[at(was)].tag == new_[e].tag ? same : renumbered) = true;
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.element_after[e] == none) {
        if (!renumbered) lost_elements.insert(old_[e].tag);
        if (!same || renumbered) lost_elements.insert(static_cast<std::int64_t>(e + 1));
      }
    const auto name_in = [](const Document& document, const std::vector<Index>* to_before,
                            const std::vector<Index>* to_after, const std::set<std::int64_t>* lost) {
      return [&document, to_before, to_after, lost](Index i) -> std::string {
        if (i < 0 && lost && lost->count(document.unknown.at(at(-1 - i))) > 0) return {};
        if (i < 0) return fmt::format("?{}", document.unknown.at(at(-1 - i)));
        if (to_before) return fmt::format("{}", to_before->at(at(i)));
        return to_after->at(at(i)) == none ? std::string{} : fmt::format("{}", i);
      };
    };
    // Values of triangles belong to the polygon that was cut into them.
    std::vector<Index> elements_after = pairs_.element_after, elements_before = pairs_.element_before;
    for (std::size_t e = 0; e < old_.size(); ++e)
      if (pairs_.cut_after[e] != none) elements_after[e] = pairs_.cut_after[e];
    for (std::size_t e = 0; e < new_.size(); ++e)
      if (pairs_.cut_before[e] != none) elements_before[e] = pairs_.cut_before[e];
    const Names node_was = name_in(before_, nullptr, &pairs_.node_after, nullptr),
                node_is = name_in(after_, &pairs_.node_before, nullptr, &lost_nodes),
                element_was = name_in(before_, nullptr, &elements_after, nullptr),
                element_is = name_in(after_, &elements_before, nullptr, &lost_elements);
    texts(texts_of_values(before_.node_values, "nodes", node_was),
          texts_of_values(after_.node_values, "nodes", node_is));
    std::vector<Values> element_values;
    for (const Values& values : before_.element_values)
      if (became_groups_.count(&values) == 0) element_values.push_back(values);
    texts(texts_of_values(element_values, "elements", element_was),
          texts_of_values(after_.element_values, "elements", element_is));
    texts(texts_of_values(before_.element_node_values, "elements' nodes", element_was),
          texts_of_values(after_.element_node_values, "elements' nodes", element_is));
    texts(texts_of_names(before_), texts_of_names(after_));
    texts(texts_of_links(before_, node_was), texts_of_links(after_, node_is));
    texts(texts_of_ghosts(before_, element_was), texts_of_ghosts(after_, element_is));
    std::vector<Text> boundary_was = texts_of_boundary(before_, node_was, element_was);
    for (Text& text : boundary_was) text.may_be_said_otherwise = may_be_surface_ && text.item == "holes";
    texts(std::move(boundary_was), texts_of_boundary(after_, node_is, element_is));
    texts(texts_of_voronoi(before_), texts_of_voronoi(after_));
    texts(texts_of_rest(before_), texts_of_rest(after_));
  }

  const Document &before_, &after_;
  std::vector<Element> old_;
  const std::vector<Element> new_;
  const Pairing pairs_;
  const bool may_be_surface_;
  std::set<const Values*> became_groups_;
  std::set<std::int64_t> renumbered_unknown_;
  DifferenceList differences_;
};

}  // namespace

std::vector<Difference> differences(const Document& before, const Document& after, Holding holding) {
  return Comparison(before, after, holding).list();
}

}  // namespace tetproof::test
