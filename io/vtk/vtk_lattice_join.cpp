// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: what vtkXMLImageDataReader of VTK 9.1 makes of several pieces.
#include "io/vtk/vtk_lattice_join.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"

namespace tetproof::io {
namespace {

constexpr const char* ghost_array = "vtkGhostType";
constexpr std::int64_t duplicate = 1;  // the bit of a point or cell that another piece has

// A point or cell: its index in the whole grid, slowest axis first, and where it stands in its piece.
struct Item {
  std::array<std::int64_t, 3> index;
  std::uint32_t piece, place;
  bool ghost;

  auto order() const { return std::tie(index, ghost, piece, place); }
};

using Columns = std::vector<Column> VtkPiece::*;

bool same(const Column& a, std::size_t i, const Column& b, std::size_t k) {
  const auto each = static_cast<std::size_t>(a.components);
  const auto equal = [&](const auto& of_a, const auto& of_b, const auto& alike) {
    return of_a.empty() || std::equal(of_a.begin() + static_cast<std::ptrdiff_t>(i * each),
                                      of_a.begin() + static_cast<std::ptrdiff_t>((i + 1) * each),
                                      of_b.begin() + static_cast<std::ptrdiff_t>(k * each), alike);
  };
  return equal(a.reals, b.reals,
               [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }) &&
         equal(a.integers, b.integers, std::equal_to<>()) && equal(a.texts, b.texts, std::equal_to<>());
}

// Whether two columns are parts of one array. One without values can be of any kind.
bool belong_together(const Column& a, const Column& b) {
  return a.name == b.name && a.components == b.components &&
         (column_size(a) == 0 || column_size(b) == 0 ||
          (a.reals.empty() == b.reals.empty() && a.texts.empty() == b.texts.empty()));
}

class Joiner {
 public:
  Joiner(std::vector<VtkLatticePiece>& pieces, Document& document)
      : pieces_(pieces),
        document_(document),
        box_(box_of(pieces)),
        corners_(lattice_corners(box_.dimensions)) {}

  VtkPiece join() {
    for (const auto columns : {&VtkPiece::point_data, &VtkPiece::cell_data}) drop_partial(columns);
    points();
    cells();
    for (const auto roles : {&VtkPiece::point_roles, &VtkPiece::cell_roles})
      for (const VtkLatticePiece& one : pieces_)
        for (const VtkRole& role : one.piece.*roles)
          if (std::none_of((all_.*roles).begin(), (all_.*roles).end(), [&](const VtkRole& known) {
                return known.array == role.array && known.role == role.role;
              }))
            (all_.*roles).push_back(role);
    warn();
    return std::move(all_);
  }

 private:
  // Brings the columns of all pieces into the order of the first, and drops those that a piece lacks.
  void drop_partial(Columns columns) {
    std::vector<Column>& first = pieces_[0].piece.*columns;
    const auto lose = [&](const Column& column, const VtkPiece& piece) {
      add_loss(document_.dropped, "values of arrays that a piece lacks", column_size(column),
               fmt::format("\"{}\"{}", column.name, piece.which));
    };
    for (std::size_t k = 0; k < first.size();) {
      bool in_all = true;
      for (std::size_t p = 1; p < pieces_.size(); ++p) {
        std::vector<Column>& here = pieces_[p].piece.*columns;
        const auto found =
            std::find_if(here.begin() + static_cast<std::ptrdiff_t>(std::min(k, here.size())), here.end(),
                         [&](const Column& column) { return belong_together(first[k], column); });
        if (found == here.end())
          in_all = false;
        else
          std::iter_swap(here.begin() + static_cast<std::ptrdiff_t>(k), found);
      }
      if (in_all) {
        ++k;
        continue;
      }
      lose(first[k], pieces_[0].piece);
      first.erase(first.begin() + static_cast<std::ptrdiff_t>(k));
    }
    for (std::size_t p = 1; p < pieces_.size(); ++p) {
      std::vector<Column>& here = pieces_[p].piece.*columns;
      for (std::size_t k = first.size(); k < here.size(); ++k) lose(here[k], pieces_[p].piece);
      here.resize(first.size());
    }
  }

  // All points, or all cells, of the pieces: each index once, the others behind it.
  std::vector<Item> items(Columns columns, bool of_points) const {
    std::vector<Item> all;
    for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
      const VtkLatticePiece& one = pieces_[p];
      const auto& data = one.piece.*columns;
      const auto ghosts = std::find_if(data.begin(), data.end(), [](const Column& column) {
        return column.name == ghost_array && column.components == 1 && !column.integers.empty();
      });
      std::array<std::int64_t, 3> count = one.dimensions;
      for (std::size_t k = 0; k < 3; ++k)
        if (!of_points && box_.dimensions[k] > 1) --count[k];
      std::uint32_t place = 0;
      for (std::int64_t z = 0; z < count[2]; ++z)
        for (std::int64_t y = 0; y < count[1]; ++y)
          for (std::int64_t x = 0; x < count[0]; ++x, ++place)
            all.push_back({{one.first[2] + z, one.first[1] + y, one.first[0] + x},
                           p,
                           place,
                           ghosts != data.end() && (ghosts->integers[place] & duplicate) != 0});
    }
    std::sort(all.begin(), all.end(), [](const Item& a, const Item& b) { return a.order() < b.order(); });
    return all;
  }

  // Keeps the first item of each index, and lists those that differ from it.
  void keep_first(std::vector<Item>& all, Columns columns, bool of_points) {
    std::size_t kept = 0, different = 0;
    std::string example;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (kept == 0 || all[i].index != all[kept - 1].index) {
        all[kept++] = all[i];
        continue;
      }
      const Item &first = all[kept - 1], &other = all[i];
      const VtkPiece &one = pieces_[first.piece].piece, &two = pieces_[other.piece].piece;
      bool equal = !of_points || one.points[first.place] == two.points[other.place];
      for (std::size_t k = 0; equal && k < (one.*columns).size(); ++k)
        equal = (one.*columns)[k].name == ghost_array ||
                same((one.*columns)[k], first.place, (two.*columns)[k], other.place);
      if (!equal && different++ == 0)
        example = fmt::format("index {} {} {}{}", other.index[2], other.index[1], other.index[0], two.which);
    }
    all.resize(kept);
    add_loss(document_.dropped,
             fmt::format("{} that differ from those of another piece", of_points ? "points" : "cells"),
             different, example);
  }

  void gather(const std::vector<Item>& kept, Columns columns) {
    const std::vector<Column>& first = pieces_[0].piece.*columns;
    for (std::size_t k = 0; k < first.size(); ++k) {
      Column column{.name = first[k].name, .type = first[k].type, .components = first[k].components};
      const auto each = static_cast<std::size_t>(column.components);
      for (const Item& item : kept) {
        const Column& from = (pieces_[item.piece].piece.*columns)[k];
        const auto take = [&](const auto& of, auto& to) {
          if (!of.empty())
            to.insert(to.end(), of.begin() + static_cast<std::ptrdiff_t>(item.place * each),
                      of.begin() + static_cast<std::ptrdiff_t>((item.place + 1) * each));
        };
        take(from.reals, column.reals), take(from.integers, column.integers), take(from.texts, column.texts);
      }
      (all_.*columns).push_back(std::move(column));
    }
  }

  void points() {
    points_ = items(&VtkPiece::point_data, true);
    keep_first(points_, &VtkPiece::point_data, true);
    for (const Item& item : points_) all_.points.push_back(pieces_[item.piece].piece.points[item.place]);
    gather(points_, &VtkPiece::point_data);
  }

  // The points of the cell whose first corner has this index; none if one is missing.
  std::vector<std::int64_t> corners_at(const std::array<std::int64_t, 3>& index) const {
    std::vector<std::int64_t> nodes;
    for (const VtkDimensions& corner : corners_) {
      const std::array<std::int64_t, 3> wanted{index[0] + corner[2], index[1] + corner[1],
                                               index[2] + corner[0]};
      const auto found = std::lower_bound(points_.begin(), points_.end(), wanted,
                                          [](const Item& item, const auto& at) { return item.index < at; });
      if (found == points_.end() || found->index != wanted) return {};
      nodes.push_back(found - points_.begin());
    }
    return nodes;
  }

  void add_cell(const std::vector<std::int64_t>& nodes) {
    all_.connectivity.insert(all_.connectivity.end(), nodes.begin(), nodes.end());
    all_.ends.push_back(static_cast<std::int64_t>(all_.connectivity.size()));
    all_.types.push_back(lattice_cell_type(box_.dimensions));
  }

  void cells() {
    const bool have_data = !pieces_[0].piece.cell_data.empty();
    std::vector<Item> cells;
    if (have_data) {
      cells = items(&VtkPiece::cell_data, false);
      keep_first(cells, &VtkPiece::cell_data, false);
      for (const Item& cell : cells) add_cell(corners_at(cell.index));
      gather(cells, &VtkPiece::cell_data);
    }
    std::size_t between = 0;
    std::string example;
    for (const Item& point : points_) {
      if (std::binary_search(cells.begin(), cells.end(), point,
                             [](const Item& a, const Item& b) { return a.index < b.index; }))
        continue;
      const std::vector<std::int64_t> nodes = corners_at(point.index);
      if (nodes.empty()) continue;
      if (!have_data)
        add_cell(nodes);
      else if (between++ == 0)
        example = fmt::format("index {} {} {}", point.index[2], point.index[1], point.index[0]);
    }
    add_loss(document_.dropped, "cells between pieces, without data", between, example, true);
  }

  void warn() const {
    std::string text =
        lattice_in_words(fmt::format("{} of a structured grid", counted(pieces_.size(), "pieces")),
                         box_.dimensions, static_cast<std::int64_t>(all_.types.size()));
    const double all = static_cast<double>(box_.dimensions[0]) * static_cast<double>(box_.dimensions[1]) *
                       static_cast<double>(box_.dimensions[2]);
    if (static_cast<double>(points_.size()) < all)
      text += fmt::format("; the pieces have {} of its points", points_.size());
    document_.warnings.push_back(fmt::format("{}: {}", document_.path, text));
  }

  std::vector<VtkLatticePiece>& pieces_;
  Document& document_;
  const VtkLatticeBox box_;
  const std::vector<VtkDimensions> corners_;
  std::vector<Item> points_;  // by their index
  VtkPiece all_;
};

}  // namespace

VtkLatticeBox box_of(const std::vector<VtkLatticePiece>& pieces) {
  VtkLatticeBox box{pieces[0].first, pieces[0].dimensions};
  for (const VtkLatticePiece& one : pieces)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t first = std::min(box.first[k], one.first[k]);
      box.dimensions[k] =
          std::max(box.first[k] + box.dimensions[k], one.first[k] + one.dimensions[k]) - first;
      box.first[k] = first;
    }
  return box;
}

VtkPiece joined(std::vector<VtkLatticePiece>&& pieces, Document& document) {
  return Joiner(pieces, document).join();
}

}  // namespace tetproof::io
