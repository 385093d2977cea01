// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/document_in_order.hpp"

#include <stdexcept>

#include "io/model/element_types.hpp"

namespace tetproof::test {
namespace {

void expect(bool holds, const char* otherwise) {
  if (!holds) throw std::logic_error(otherwise);
}

class Checker {
 public:
  explicit Checker(const Document& document)
      : d_(document), nodes_(document.points.size()), unknown_(document.unknown.size()) {}

  void all() {
    nodes();
    elements();
    entities();
    for (const Values& values : d_.node_values) values_of(values, nodes_);
    for (const Values& values : d_.element_values) values_of(values, elements_);
    for (const Values& values : d_.element_node_values) {
      values_of(values, elements_);
      expect(values.nodes.empty() == (values.size() == 0),
             "values of elements' nodes do not say how many nodes");
    }
    links();
    boundary();
    voronoi();
    tables();
  }

 private:
  // A position below `size`, or an unknown number where these are allowed.
  bool is_place(Index i, std::size_t size) const {
    return i < 0 ? static_cast<std::size_t>(-1 - i) < unknown_ : static_cast<std::size_t>(i) < size;
  }
  void tag_set(std::int32_t set) const {
    expect(set >= 0 && static_cast<std::size_t>(set) < d_.tag_sets.size(), "a tag set that does not exist");
  }

  void nodes() const {
    expect(d_.node_tags.empty() || d_.node_tags.size() == nodes_, "not as many node tags as nodes");
    std::size_t covered = 0;
    for (const NodeBlock& block : d_.node_blocks) {
      expect(block.first >= covered && block.count <= nodes_ && block.first <= nodes_ - block.count,
             "a node block outside of the nodes, or over another");
      covered = block.first + block.count;
      expect(block.parameters_each >= 0 && block.parameters_each <= 3, "more than 3 parameters of a node");
      const std::size_t parameters = block.count * static_cast<std::size_t>(block.parameters_each);
      expect(parameters == 0 || block.parameters + parameters <= d_.parameters.size(),
             "a node block's parameters do not exist");
      expect(block.dim >= 0 && block.dim <= 3, "a node block of a dimension that is none");
    }
  }

  void elements() {
    std::size_t connectivity = 0;
    for (const ElementBlock& block : d_.blocks) {
      expect(block.first == elements_ && block.nodes == connectivity, "a block does not follow the last");
      expect(block.nodes_each > 0, "elements without nodes");
      faces(block);
      const io::ElementType* type = io::element_type(block.type);
      expect(!type || type->nodes == block.nodes_each,
             "elements with another number of nodes than their type");
      expect(block.dim >= 0 && block.dim <= 3, "a block of a dimension that is none");
      tag_set(block.groups), tag_set(block.partitions);
      elements_ += block.count;
      connectivity += block.count * static_cast<std::size_t>(block.nodes_each);
    }
    expect(connectivity == d_.connectivity.size(), "the connectivity is not that of the blocks");
    expect(d_.element_tags.empty() || d_.element_tags.size() == elements_,
           "not as many element tags as elements");
    for (const Index node : d_.connectivity)
      expect(is_place(node, nodes_), "an element names a position that does not exist");
  }

  void faces(const ElementBlock& block) const {
    for (std::size_t at = 0; at < block.faces.size();) {
      const std::int32_t corners = block.faces[at++];
      expect(corners >= 0 && static_cast<std::size_t>(corners) <= block.faces.size() - at,
             "a face of a polyhedron that is cut off");
      for (const std::size_t end = at + static_cast<std::size_t>(corners); at < end; ++at)
        expect(block.faces[at] >= 0 && block.faces[at] < block.nodes_each,
               "a face of a polyhedron with a node that it does not have");
    }
  }

  void entities() const {
    expect(!d_.tag_sets.empty() && d_.tag_sets[0].empty(), "the first tag set is not the empty one");
    for (const Entity& entity : d_.entities) {
      expect(entity.dim >= 0 && entity.dim <= 3, "an entity of a dimension that is none");
      tag_set(entity.groups), tag_set(entity.partitions);
    }
  }

  void values_of(const Values& values, std::size_t of) const {
    expect(values.reals.empty() || values.integers.empty(), "values that are reals and integers");
    expect(values.components >= 0, "values of less than no component");
    std::size_t items = values.items();
    expect(values.at.empty() || values.nodes.empty() || values.at.size() == values.nodes.size(),
           "values of nodes of elements at other places than they say");
    for (const Index i : values.at) expect(is_place(i, of), "values of what does not exist");
    if (values.at.empty())
      expect(values.first <= of && items <= of - values.first,
             "more values than there are nodes or elements");
    if (!values.nodes.empty()) {
      items = 0;
      for (const std::int32_t n : values.nodes) {
        expect(n >= 0, "values of less than no node");
        items += static_cast<std::size_t>(n);
      }
    }
    expect(items * static_cast<std::size_t>(values.components) == values.size(),
           "not as many values as places");
  }

  void links() const {
    for (const PeriodicLink& link : d_.periodic)
      for (const auto& pair : link.nodes)
        expect(is_place(pair[0], nodes_) && is_place(pair[1], nodes_), "a periodic link to nowhere");
    for (const GhostElement& ghost : d_.ghost_elements)
      expect(is_place(ghost.element, elements_), "a ghost that does not exist");
  }

  void boundary() const {
    for (const Facet& facet : d_.facets)
      expect(facet.first <= elements_ && facet.polygons <= elements_ - facet.first,
             "a facet of elements that do not exist");
    for (const LengthBound& bound : d_.length_bounds)
      expect(is_place(bound.nodes[0], nodes_) && is_place(bound.nodes[1], nodes_),
             "a bound for a segment that does not exist");
  }

  void voronoi() const {
    const Voronoi& v = d_.voronoi;
    const auto within = [](Index i, std::size_t size) {
      return i == -1 || (i >= 0 && static_cast<std::size_t>(i) < size);
    };
    for (const Voronoi::Edge& edge : v.edges)
      expect(within(edge.points[0], v.points.size()) && within(edge.points[1], v.points.size()),
             "a Voronoi edge of points that do not exist");
    for (const Voronoi::Face& face : v.faces) {
      for (const Index cell : face.cells) expect(within(cell, nodes_), "a Voronoi cell of no node");
      for (const Index edge : face.edges)
        expect(within(edge, v.edges.size()), "a Voronoi face of edges that do not exist");
    }
    for (const auto& cell : v.cells)
      for (const Index face : cell)
        expect(within(face, v.faces.size()), "a Voronoi cell of faces that do not exist");
  }

  void tables() const {
    for (const Table& table : d_.tables)
      for (const Column& column : table.columns) {
        const std::size_t kinds = !column.reals.empty() + !column.integers.empty() + !column.texts.empty();
        expect(kinds <= 1, "a column of several kinds");
        std::size_t items = table.rows;
        if (!column.lengths.empty()) {
          expect(column.lengths.size() == table.rows, "not as many lists as rows");
          items = 0;
          for (const std::int32_t n : column.lengths) {
            expect(n >= 0, "a list of less than nothing");
            items += static_cast<std::size_t>(n);
          }
        }
        expect(items * static_cast<std::size_t>(column.components) ==
                   column.reals.size() + column.integers.size() + column.texts.size(),
               "not as many numbers in a column as rows");
      }
  }

  const Document& d_;
  const std::size_t nodes_, unknown_;
  std::size_t elements_ = 0;
};

}  // namespace

void check_in_order(const Document& document) {
  Checker(document).all();
}

}  // namespace tetproof::test
