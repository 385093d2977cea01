// SPDX-License-Identifier: GPL-3.0-or-later
// A document from what VTK's files say.
#include <fmt/format.h>

#include <limits>
#include <map>
#include <unordered_map>

#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/model/node_order.hpp"
#include "io/model/tag_sets.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_piece.hpp"

namespace tetproof::io {
namespace {

class Adder {
 public:
  Adder(Document& document, VtkPiece& piece, bool whole)
      : document_(document),
        piece_(piece),
        whole_(whole),
        sets_(document),
        base_(document.points.size()),
        first_(document.elements()) {}

  void add() {
    constexpr std::size_t most = std::numeric_limits<Index>::max();
    if (piece_.points.size() > most - base_) fail("more points than can be numbered here");
    if (base_ == 0)
      document_.points = std::move(piece_.points);
    else
      document_.points.insert(document_.points.end(), piece_.points.begin(), piece_.points.end());
    points_ = document_.points.size() - base_;
    names();
    cells();
    for (Column& column : piece_.point_data)
      add_values(document_.node_values, std::move(column), base_, points_, {});
    for (Column& column : piece_.cell_data)
      add_values(document_.element_values, std::move(column), first_, piece_.types.size(), origin_);
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw InputError(fmt::format("{}: {}", document_.path, message));
  }

  // Takes the arrays of entities and groups out of the cell data.
  void names() {
    const auto take = [&](std::string_view name, std::vector<std::int64_t>& to) {
      for (auto column = piece_.cell_data.begin(); column != piece_.cell_data.end(); ++column)
        if (column->name == name && column->components == 1 &&
            column->integers.size() == piece_.types.size() && column->reals.empty() &&
            column->texts.empty()) {
          to = std::move(column->integers);
          piece_.cell_data.erase(column);
          return true;
        }
      return false;
    };
    if (!take("entity", entities_)) take("CellEntityIds", entities_);
    std::vector<std::int64_t> groups;
    for (std::size_t k = 1; take(k == 1 ? "group" : fmt::format("group {}", k), groups); ++k)
      groups_.push_back(std::move(groups));
  }

  void cells() {
    const std::size_t count = piece_.types.size();
    if (piece_.ends.size() != count) fail(fmt::format("{} cells have {} types", piece_.ends.size(), count));
    std::int64_t start = 0;
    for (std::size_t c = 0; c < count; ++c) {
      const std::int64_t end = piece_.ends[c];
      if (end < start || end > static_cast<std::int64_t>(piece_.connectivity.size()))
        fail(fmt::format("cell {}: expected an offset from {} to {}, found {}", c, start,
                         piece_.connectivity.size(), end));
      cell(c, {piece_.connectivity.data() + start, static_cast<std::size_t>(end - start)});
      start = end;
    }
    if (start != static_cast<std::int64_t>(piece_.connectivity.size()))
      document_.warnings.push_back(fmt::format("{}: {} numbers of points after those of the last cell",
                                               document_.path, piece_.connectivity.size() - start));
    for (const auto& [type, cells] : left_out_)
      document_.warnings.push_back(
          fmt::format("{}: cells of VTK's type {} are left out: {}", document_.path, type, cells));
    const bool one_to_one = origin_.size() == count && left_out_.empty() && !split_;
    if (one_to_one) origin_.clear();
    changed_ = !one_to_one;
  }

  void cell(std::size_t c, std::span<const std::int64_t> nodes) {
    const std::int64_t type = piece_.types[c];
    const std::size_t n = nodes.size();
    const auto part = [&](int gmsh, std::initializer_list<std::size_t> which) {
      std::int64_t some[8];
      std::size_t k = 0;
      for (const std::size_t i : which) some[k++] = nodes[i];
      element(c, gmsh, {some, k});
    };
    if (type == vtk_poly_vertex || type == vtk_poly_line || type == vtk_strip) {
      const std::size_t least = type == vtk_poly_vertex ? 1 : type == vtk_poly_line ? 2 : 3;
      if (n < least) fail(fmt::format("cell {}: expected {} points or more, found {}", c, least, n));
      split_ = split_ || n != least;
      for (std::size_t i = 0; i + least <= n; ++i)
        if (type == vtk_poly_vertex)
          part(point1, {i});
        else if (type == vtk_poly_line)
          part(line2, {i, i + 1});
        else if (i % 2 == 0)
          part(triangle3, {i, i + 1, i + 2});
        else
          part(triangle3, {i + 1, i, i + 2});
      return;
    }
    if (type == vtk_polygon && n > 0)
      return element(c, n == 3 ? triangle3 : n == 4 ? quadrangle4 : polygon, nodes);
    if (type == vtk_pixel && n == 4) return part(quadrangle4, {0, 1, 3, 2});
    if (type == vtk_voxel && n == 8) return part(5, {0, 1, 3, 2, 4, 5, 7, 6});
    const int gmsh = gmsh_type_of_cell(type, n);
    if (gmsh != 0) return element(c, gmsh, nodes);
    if (has_fixed_size(type))
      fail(fmt::format("cell {}: a cell of VTK's type {} does not have {} points", c, type, n));
    ++left_out_[type];
  }

  void element(std::size_t c, int type, std::span<const std::int64_t> nodes) {
    const std::int64_t entity = entities_.empty() ? 0 : entities_[c];
    tags_.clear();
    for (const auto& groups : groups_)
      if (groups[c] != 0) tags_.push_back(groups[c]);
    const std::int32_t groups = groups_.empty() ? 0 : sets_(tags_);
    auto& blocks = document_.blocks;
    const auto each = static_cast<std::int32_t>(nodes.size());
    if (blocks.empty() || blocks.back().first < first_ || blocks.back().type != type ||
        blocks.back().nodes_each != each || blocks.back().entity != entity ||
        blocks.back().groups != groups) {
      const ElementType* known = element_type(type);
      blocks.push_back({.type = type,
                        .dim = known ? known->dim : 2,
                        .entity = entity,
                        .groups = groups,
                        .nodes_each = each,
                        .first = document_.elements(),
                        .nodes = document_.connectivity.size()});
      order_ = node_order(type, NodeOrder::vtk);
    }
    ++blocks.back().count;
    const std::size_t start = document_.connectivity.size();
    document_.connectivity.resize(start + nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      document_.connectivity[start + (order_.empty() ? k : static_cast<std::size_t>(order_[k]))] =
          position(c, nodes[k]);
    origin_.push_back(static_cast<std::uint32_t>(c));
  }

  Index position(std::size_t c, std::int64_t number) {
    if (number >= 0 && number < static_cast<std::int64_t>(points_))
      return static_cast<Index>(static_cast<std::int64_t>(base_) + number);
    if (!whole_)
      fail(fmt::format("cell {}: expected the number of one of its piece's {} points, found {}", c, points_,
                       number));
    const auto [place, is_new] =
        unknown_.try_emplace(number, -1 - static_cast<Index>(document_.unknown.size()));
    if (is_new) document_.unknown.push_back(number);
    return place->second;
  }

  // `origin`: the item whose values each one has; empty: its own.
  void add_values(std::vector<Values>& to, Column&& column, std::size_t first, std::size_t items,
                  const std::vector<std::uint32_t>& origin) {
    const auto each = static_cast<std::size_t>(column.components);
    if (column.components < 1 || column_size(column) != items * each)
      fail(fmt::format("array \"{}\": expected {} values, found {}", column.name, items * each,
                       column_size(column)));
    Values values{.name = std::move(column.name), .components = column.components};
    if (!column.texts.empty()) {
      std::unordered_map<std::string, std::int64_t> known;
      for (std::string& text : column.texts) {
        const auto [place, is_new] = known.try_emplace(text, static_cast<std::int64_t>(known.size()));
        if (is_new) values.labels.push_back(std::move(text));
        column.integers.push_back(place->second);
      }
    }
    const auto pick = [&](auto& from) {
      if (!changed_ || &to == &document_.node_values) return std::move(from);
      std::remove_cvref_t<decltype(from)> picked;
      picked.reserve(from.empty() ? 0 : origin.size() * each);
      for (const std::uint32_t c : origin)
        for (std::size_t k = 0; k < each && !from.empty(); ++k) picked.push_back(from[c * each + k]);
      return picked;
    };
    values.reals = pick(column.reals);
    values.integers = pick(column.integers);
    // The same array of the piece before goes on here.
    for (Values& before : to)
      if (before.name == values.name && before.components == values.components && first > 0 &&
          before.first + before.items() == first && before.labels.empty() && values.labels.empty() &&
          (values.size() == 0 || before.integers.empty() == values.integers.empty())) {
        before.reals.insert(before.reals.end(), values.reals.begin(), values.reals.end());
        before.integers.insert(before.integers.end(), values.integers.begin(), values.integers.end());
        return;
      }
    values.first = first;
    to.push_back(std::move(values));
  }

  Document& document_;
  VtkPiece& piece_;
  const bool whole_;
  TagSets sets_;
  const std::size_t base_, first_;
  std::size_t points_ = 0;
  std::vector<std::int64_t> entities_, tags_;
  std::vector<std::vector<std::int64_t>> groups_;
  std::span<const int> order_;
  std::vector<std::uint32_t> origin_;  // the cell of each element
  bool split_ = false, changed_ = false;
  std::map<std::int64_t, std::int64_t> left_out_;
  std::unordered_map<std::int64_t, Index> unknown_;
};

}  // namespace

void add_vtk_piece(Document& document, VtkPiece&& piece, bool whole) {
  Adder(document, piece, whole).add();
}

void add_vtk_field(Document& document, Column&& column) {
  Table table{.name = column.name};
  table.rows = column_size(column) / static_cast<std::size_t>(column.components > 0 ? column.components : 1);
  table.columns.push_back(std::move(column));
  document.tables.push_back(std::move(table));
}

}  // namespace tetproof::io
