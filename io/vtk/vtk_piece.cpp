// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a document of the cells and arrays of VTK's files.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>

#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/element_types.hpp"
#include "io/model/node_order.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_information.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtk_piece_tags.hpp"
#include "io/vtk/vtk_polyhedron.hpp"
#include "io/vtk/vtk_values.hpp"

namespace tetproof::io {
namespace {

// Cells of one type of which something is dropped; the first one, and its points.
struct Dropped {
  std::size_t count = 0, first = 0, points = 0;
};

std::string item_of(std::int64_t type) {
  switch (type) {
    case vtk_poly_vertex:
      return "cells of several vertices, kept as points";
    case vtk_strip:
      return "triangle strips, kept as triangles";
    case vtk_pixel:
      return "pixels, kept as quadrangles";
    case vtk_voxel:
      return "voxels, kept as hexahedra";
    default:
      return fmt::format("cells of type {} ({})", type, name_of_cell(type));
  }
}

// Whether the mesh lacks elements without such cells, of which something is dropped. An empty cell is none.
bool is_element_lost(std::int64_t type) {
  return type != 0 && type != vtk_poly_vertex && type != vtk_strip && type != vtk_pixel && type != vtk_voxel;
}

class Adder {
 public:
  Adder(Document& document, TagSets& sets, VtkPiece& piece, bool whole)
      : document_(document),
        piece_(piece),
        whole_(whole),
        sets_(sets),
        tags_(document, piece),
        base_(document.points.size()),
        first_(document.elements()) {}

  void add(VtkLabels& node_labels, VtkLabels& element_labels) {
    constexpr std::size_t most = std::numeric_limits<Index>::max();
    if (piece_.points.size() > most - base_) fail("more points than can be numbered here");
    if (base_ == 0)
      document_.points = std::move(piece_.points);
    else
      document_.points.insert(document_.points.end(), piece_.points.begin(), piece_.points.end());
    points_ = document_.points.size() - base_;
    cells();
    tags_.add_negative(first_, changed_ ? &origin_ : nullptr);
    name_node_references(piece_.point_data, piece_.point_roles, whole_);
    for (Column& column : piece_.point_data)
      add_vtk_values(document_, document_.node_values, std::move(column), {base_, points_},
                     piece_.point_roles, node_labels);
    for (Column& column : piece_.cell_data)
      add_vtk_values(document_, document_.element_values, std::move(column),
                     {first_, piece_.types.size(), changed_ ? &origin_ : nullptr}, piece_.cell_roles,
                     element_labels);
    for (const auto* roles : {&piece_.point_roles, &piece_.cell_roles})
      for (const VtkRole& role : *roles) add_vtk_role(document_.dropped, role.array, role.role);
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw InputError(fmt::format("{}: {}", document_.path, message));
  }

  void cells() {
    const std::size_t count = piece_.types.size();
    if (piece_.ends.size() != count) fail(fmt::format("cells: {}, types: {}", piece_.ends.size(), count));
    std::int64_t start = 0;
    for (std::size_t c = 0; c < count; ++c) {
      const std::int64_t end = piece_.ends[c];
      if (end < start || end > static_cast<std::int64_t>(piece_.connectivity.size()))
        fail(fmt::format("cell {}: expected an offset from {} to {}, found {}", c, start,
                         piece_.connectivity.size(), end));
      cell(c, {piece_.connectivity.data() + start, static_cast<std::size_t>(end - start)});
      if (!piece_.face_ends.empty() && piece_.face_ends[c] >= 0) face_start_ = piece_.face_ends[c];
      start = end;
    }
    if (start != static_cast<std::int64_t>(piece_.connectivity.size()))
      add_loss(document_.dropped, "numbers of points behind those of the last cell",
               piece_.connectivity.size() - static_cast<std::size_t>(start),
               fmt::format("{}{}", piece_.connectivity[static_cast<std::size_t>(start)], piece_.which));
    if (const auto faces = static_cast<std::size_t>(face_start_);
        !piece_.face_ends.empty() && faces < piece_.faces.size())
      add_loss(document_.dropped, "numbers of faces behind those of the last polyhedron",
               piece_.faces.size() - faces, fmt::format("{}{}", piece_.faces[faces], piece_.which));
    for (const auto& [type, cells] : dropped_)
      add_loss(document_.dropped, item_of(type), cells.count,
               fmt::format("cell {}{}, {}", cells.first, piece_.which, counted(cells.points, "points")),
               is_element_lost(type));
    if (bezier_ > 0)
      document_.warnings.push_back(
          fmt::format("{}: {}{} of Bezier's kind, kept as such: their control points need not lie on them",
                      document_.path, counted(bezier_, "cells"), piece_.which));
    const bool one_to_one = origin_.size() == count && !left_out_ && !split_;
    if (one_to_one) origin_.clear();
    changed_ = !one_to_one;
  }

  void drop(std::size_t c, std::size_t nodes) {
    Dropped& dropped = dropped_[piece_.types[c]];
    if (dropped.count++ == 0) dropped.first = c, dropped.points = nodes;
  }

  // VTK reads a polyline of one point and the like. It is no element.
  void leave_out_degenerate(std::size_t c, std::size_t nodes) {
    left_out_ = true;
    add_loss(
        document_.dropped, "cells of too few points", 1,
        fmt::format("cell {}{}: {} of type {}", c, piece_.which, counted(nodes, "points"), piece_.types[c]));
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
    if (type == vtk_polyhedron) return polyhedron(c, nodes);
    if (type == vtk_poly_vertex || type == vtk_poly_line || type == vtk_strip) {
      const std::size_t least = type == vtk_poly_vertex ? 1 : type == vtk_poly_line ? 2 : 3;
      if (n < least) return leave_out_degenerate(c, n);
      if (type == vtk_poly_line) return element(c, n == 2 ? line2 : polyline, nodes);
      if (n != least) {
        split_ = true;
        drop(c, n);
      }
      for (std::size_t i = 0; i + least <= n; ++i)
        if (type == vtk_poly_vertex)
          part(point1, {i});
        else if (i % 2 == 0)
          part(triangle3, {i, i + 1, i + 2});
        else
          part(triangle3, {i + 1, i, i + 2});
      return;
    }
    if (type == vtk_polygon && n == 0) return leave_out_degenerate(c, n);
    if (type == vtk_polygon) return element(c, n == 3 ? triangle3 : n == 4 ? quadrangle4 : polygon, nodes);
    if (type == vtk_pixel && n == 4) {
      drop(c, n);
      return part(quadrangle4, {0, 1, 3, 2});
    }
    if (type == vtk_voxel && n == 8) {
      drop(c, n);
      return part(5, {0, 1, 3, 2, 4, 5, 7, 6});
    }
    if (type != known_.vtk || n != known_.nodes) known_ = {type, n, gmsh_type_of_cell(type, n)};
    if (known_.type != 0) {
      bezier_ += is_bezier(known_.type);
      return element(c, known_.type, nodes);
    }
    if (has_fixed_size(type) && with_surplus(c, nodes)) return;
    if (has_fixed_size(type))
      fail(fmt::format("cell {}: a cell of VTK's type {} does not have {}", c, type, counted(n, "points")));
    left_out_ = true;
    drop(c, n);
  }

  // Gmsh writes elements of third order as cells of first order with all their points. VTK takes the first.
  bool with_surplus(std::size_t c, std::span<const std::int64_t> nodes) {
    constexpr std::size_t most = 27;  // points of a cell of a fixed size
    for (std::size_t n = std::min(most + 1, nodes.size()); n-- > 1;)
      if (const int gmsh = gmsh_type_of_cell(piece_.types[c], n); gmsh != 0) {
        add_loss(document_.dropped, "points of cells behind those that their type has", nodes.size() - n,
                 fmt::format("cell {}{}: {} of type {}", c, piece_.which, counted(nodes.size(), "points"),
                             piece_.types[c]),
                 true);  // the cell may be curved, and what is judged is not
        element(c, gmsh, nodes.first(n));
        return true;
      }
    return false;
  }

  // The list of a polyhedron's faces, as it stands in the file.
  std::span<const std::int64_t> faces_of(std::size_t c, std::span<const std::int64_t> nodes) {
    if (piece_.face_ends.empty()) return piece_.faces_in_cells ? nodes : std::span<const std::int64_t>{};
    const std::int64_t end = piece_.face_ends[c], start = face_start_;
    if (end < 0) return {};
    if (end < start || end > static_cast<std::int64_t>(piece_.faces.size()))
      fail(fmt::format("cell {}: expected an offset of faces from {} to {}, found {}", c, start,
                       piece_.faces.size(), end));
    return std::span(piece_.faces)
        .subspan(static_cast<std::size_t>(start), static_cast<std::size_t>(end - start));
  }

  void polyhedron(std::size_t c, std::span<const std::int64_t> nodes) {
    const std::span<const std::int64_t> list = faces_of(c, nodes);
    const std::string wrong =
        polyhedron_.read(list, piece_.faces_in_cells ? std::span<const std::int64_t>{} : nodes);
    if (!wrong.empty()) fail(fmt::format("cell {}: {}", c, wrong));
    if (polyhedron_.faces.empty() || polyhedron_.nodes.empty()) {
      left_out_ = true;
      return drop(c, nodes.size());
    }
    element(c, tetproof::io::polyhedron, polyhedron_.nodes, std::move(polyhedron_.faces));
  }

  void element(std::size_t c, int type, std::span<const std::int64_t> nodes,
               std::vector<std::int32_t>&& faces = {}) {
    const std::int64_t entity = tags_.entity(c);
    const std::int32_t groups = tags_.groups(c, sets_);
    auto& blocks = document_.blocks;
    const auto each = static_cast<std::int32_t>(nodes.size());
    if (blocks.empty() || blocks.back().first < first_ || blocks.back().type != type ||
        blocks.back().nodes_each != each || blocks.back().entity != entity ||
        blocks.back().groups != groups || blocks.back().faces != faces) {
      blocks.push_back({.type = type,
                        .dim = dimension_of_type(type),
                        .entity = entity,
                        .groups = groups,
                        .nodes_each = each,
                        .first = document_.elements(),
                        .nodes = document_.connectivity.size(),
                        .faces = std::move(faces)});
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

  Document& document_;
  VtkPiece& piece_;
  const bool whole_;
  TagSets& sets_;
  VtkPieceTags tags_;
  const std::size_t base_, first_;
  std::size_t points_ = 0;
  std::span<const int> order_;
  std::vector<std::uint32_t> origin_;  // the cell of each element
  bool split_ = false, left_out_ = false, changed_ = false;
  struct {
    std::int64_t vtk = 0;
    std::size_t nodes = 0;
    int type = 0;
  } known_;  // the type of the last cell
  std::int64_t face_start_ = 0;
  VtkPolyhedron polyhedron_;
  std::size_t bezier_ = 0;
  std::map<std::int64_t, Dropped> dropped_;  // by VTK's type
  std::unordered_map<std::int64_t, Index> unknown_;
};

}  // namespace

void VtkPieces::add(VtkPiece&& piece, bool whole) {
  Adder(document_, sets_, piece, whole).add(node_labels_, element_labels_);
}

void add_vtk_field(Document& document, Column&& column) {
  Table table{.name = column.name};
  table.rows = column_size(column) / static_cast<std::size_t>(column.components > 0 ? column.components : 1);
  table.columns.push_back(std::move(column));
  document.tables.push_back(std::move(table));
}

}  // namespace tetproof::io
