// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sections of VTK's legacy files: points, cells, and what describes structured grids.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "io/bytes/text_encoding.hpp"
#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_data.hpp"
#include "io/vtk/vtk_group_names.hpp"
#include "io/vtk/vtk_lattice.hpp"
#include "io/vtk/vtk_legacy.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtk_plan.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  explicit Reader(const InputFile& file)
      : file_(file), in_(file), data_(in_, document_, piece_), size_(file.bytes().size()) {
    document_.path = file.path();
    document_.format = "vtk";
    document_.first_node = document_.first_element = 0;
  }

  Document read() {
    header();
    while (!in_.at_end()) section(in_.word());
    if (is_structured()) {
      structured();
    } else {
      if (!has_points_ && (!piece_.ends.empty() || !lists_.empty())) in_.fail("POINTS", {});
      polygons();
      if (types_.empty() && !piece_.ends.empty() && lists_.empty()) in_.fail("CELL_TYPES", {});
      if (lists_.empty()) check_types();
      piece_.types.insert(piece_.types.end(), types_.begin(), types_.end());
      piece_.faces_in_cells = true;
      data_.finish(piece_.points.size(), piece_.types.size());
    }
    list_odd_types();
    VtkPieces(document_).add(std::move(piece_), true);
    take_group_names(document_);
    return std::move(document_);
  }

 private:
  void header() {
    const std::string_view first = in_.rest_of_line();
    if (!lower_case(first).starts_with("# vtk datafile version")) in_.fail("# vtk DataFile Version", first);
    in_.next_line();
    if (const std::string title(in_.rest_of_line()); title != made_up_vtk_title) document_.title = title;
    in_.next_line();
    const std::string_view kind = in_.word();
    const std::string name = lower_case(kind);
    if (name != "ascii" && name != "binary") in_.fail("ASCII or BINARY", kind);
    if (name == "binary")
      in_.set_binary();
    else
      end_text();
  }

  // Passes over zero bytes and the ^Z of DOS at the end of a text, as VTK does.
  void end_text() {
    if (std::string warning = warning_of_end(file_); !warning.empty())
      document_.warnings.push_back(std::move(warning));
    in_ = VtkLegacyScanner(file_.path(), file_.bytes().substr(0, end_of_text(file_.bytes())), in_.offset());
  }

  void section(std::string_view word) {
    const std::string name = lower_case(word);
    if (name == "dataset") return dataset();
    if (name == "field") return data_.field();
    if (name == "metadata") return data_.metadata();
    if (name == "point_data" || name == "cell_data") return data_.start(name == "point_data");
    if (dataset_.empty()) in_.fail("DATASET or FIELD", word);
    if (name == "points") return points();
    if (!is_structured() && list_of_cells(name)) return;
    if (is_structured() && lattice(name)) return;
    if (!data_.started()) in_.fail("POINTS, CELLS, CELL_TYPES, POINT_DATA or CELL_DATA", word);
    data_.attribute(name, word);
  }

  // Reads cells. Returns false for words that announce none.
  bool list_of_cells(const std::string& name) {
    if (name == "cells") return in_.cells(piece_.connectivity, piece_.ends), true;
    if (name == "cell_types") return cell_types(), true;
    if (name == "vertices" || name == "lines" || name == "polygons" || name == "triangle_strips") {
      List list{.type = name == "vertices"   ? vtk_poly_vertex
                        : name == "lines"    ? vtk_poly_line
                        : name == "polygons" ? vtk_polygon
                                             : vtk_strip};
      in_.cells(list.connectivity, list.ends);
      lists_.push_back(std::move(list));
      return true;
    }
    return false;
  }

  void dataset() {
    if (!dataset_.empty()) in_.fail_in_line("a second DATASET");
    const std::string_view word = in_.word();
    dataset_ = lower_case(word);
    if (dataset_ != "unstructured_grid" && dataset_ != "polydata" && !is_structured())
      in_.fail("UNSTRUCTURED_GRID, POLYDATA, STRUCTURED_POINTS, STRUCTURED_GRID or RECTILINEAR_GRID", word);
  }

  bool is_structured() const {
    return dataset_ == "structured_points" || dataset_ == "structured_grid" || dataset_ == "rectilinear_grid";
  }

  // Reads what describes a structured grid. Returns false for other words.
  bool lattice(const std::string& name) {
    const auto three = [&](auto& to, const auto& read) {
      for (auto& value : to) value = read();
      return true;
    };
    const auto integer = [&] { return in_.integer("a number of points"); };
    const auto real = [&] { return in_.real("a coordinate"); };
    if (name == "blanking") return blanking(), true;
    if (name == "dimensions" || name == "extent" || name.ends_with("_coordinates")) warn_of_second(name);
    if (name == "dimensions") return three(dimensions_, integer);
    if (name == "extent") {
      constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t first = in_.integer("the first index"), last = in_.integer("the last index");
        if (first < -most || last > most || last < first - 1)
          in_.fail_in_line(fmt::format("expected an EXTENT, found {} to {}", first, last));
        image_.first[k] = first;
        dimensions_[k] = last - first + 1;
      }
      return true;
    }
    if (name == "origin") return three(image_.origin, real);
    if (name == "spacing" || name == "aspect_ratio") return three(image_.spacing, real);
    if (name.size() != 13 || name.substr(1) != "_coordinates" || name[0] < 'x' || name[0] > 'z') return false;
    const std::int64_t count = in_.count("the number of coordinates", 1);
    Column column{.type = in_.type()};
    if (column.type == "String" || column.type == "bit") in_.fail_in_line("coordinates are numbers");
    in_.numbers(column, static_cast<std::size_t>(count));
    std::vector<double>& axis = axes_[static_cast<std::size_t>(name[0] - 'x')];
    axis.clear();
    for (std::size_t i = 0; i < column_size(column); ++i) axis.push_back(number_at<double>(column, i));
    return true;
  }

  // VTK takes the last of several.
  void warn_of_second(const std::string& name) {
    if (!described_.insert(name).second)
      document_.warnings.push_back(
          fmt::format("{}:{}: a second {} replaces the first", document_.path, in_.line(), name));
  }

  // Old structured grids say which points are visible.
  void blanking() {
    const std::int64_t count = in_.count("the number of points", 1);
    Column column{.type = in_.type()};
    in_.integers(column, static_cast<std::size_t>(count));
    const auto hidden = std::count(column.integers.begin(), column.integers.end(), 0);
    add_loss(document_.dropped, "points that BLANKING hides", static_cast<std::size_t>(hidden),
             fmt::format("line {}", in_.line()));
  }

  void structured() {
    const std::int64_t points = lattice_points(dimensions_, std::numeric_limits<Index>::max());
    if (points >= 0)  // the data show that there can be so many points
      data_.finish(static_cast<std::size_t>(points), static_cast<std::size_t>(lattice_cells(dimensions_)));
    const bool has_data = !piece_.point_data.empty() || !piece_.cell_data.empty();
    if (points < 0 || (!has_data && points > most_lattice_points(size_)))
      in_.fail_in_line(fmt::format("{} points are more than a file of {} can have data for",
                                   fmt::join(dimensions_, " x "), counted(size_, "bytes")));
    if (dataset_ == "structured_points") {
      add_image_points(dimensions_, image_, piece_);
    } else if (dataset_ == "rectilinear_grid") {
      for (std::size_t k = 0; k < 3; ++k)
        if (static_cast<std::int64_t>(axes_[k].size()) != dimensions_[k])
          in_.fail_in_line(fmt::format("expected {} {}_COORDINATES, found {}", dimensions_[k],
                                       static_cast<char>('X' + k), axes_[k].size()));
      add_lattice_points(axes_, piece_);
    }
    if (static_cast<std::int64_t>(piece_.points.size()) != points)
      in_.fail_in_line(
          fmt::format("expected {} points, found {}", fmt::join(dimensions_, " x "), piece_.points.size()));
    add_lattice_cells(dimensions_, piece_);
    document_.warnings.push_back(
        fmt::format("{}: {}", document_.path,
                    lattice_in_words("a structured grid", dimensions_, lattice_cells(dimensions_))));
  }

  void points() {
    if (has_points_) in_.fail_in_line("a second POINTS");
    const std::int64_t count = in_.count("the number of points", in_.binary() ? 3 : 6);
    if (count > std::numeric_limits<Index>::max())
      in_.fail_in_line(fmt::format("{} points are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    Column coordinates{.type = in_.type()};
    if (coordinates.type == "String" || coordinates.type == "bit") in_.fail_in_line("points are numbers");
    in_.numbers(coordinates, 3 * static_cast<std::size_t>(count));
    has_points_ = true;
    data_.set_last_array("POINTS");
    piece_.points.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < 3 * piece_.points.size(); ++i)
      piece_.points[i / 3][static_cast<Eigen::Index>(i % 3)] = number_at<double>(coordinates, i);
  }

  void cell_types() {
    if (!types_.empty()) in_.fail_in_line("a second CELL_TYPES");
    const std::int64_t count = in_.count("the number of cell types", 1);
    Column types{.type = "Int32"};
    in_.integers(types, static_cast<std::size_t>(count));
    types_ = std::move(types.integers);
    if (!piece_.ends.empty()) check_types();  // else CELLS follow
  }

  void check_types() const {
    if (types_.size() != piece_.ends.size())
      in_.fail_in_line(fmt::format("expected the types of {}, found {}", counted(piece_.ends.size(), "cells"),
                                   types_.size()));
  }

  // Appends vertices, lines, polygons and strips: the cell data come in this order.
  void polygons() {
    for (const VtkCellType type : {vtk_poly_vertex, vtk_poly_line, vtk_polygon, vtk_strip})
      for (const List& list : lists_) {
        if (list.type != type) continue;
        const auto start = static_cast<std::int64_t>(piece_.connectivity.size());
        piece_.connectivity.insert(piece_.connectivity.end(), list.connectivity.begin(),
                                   list.connectivity.end());
        for (const std::int64_t end : list.ends) piece_.ends.push_back(start + end);
        piece_.types.insert(piece_.types.end(), list.ends.size(), type);
      }
  }

  // VTK takes every word that begins with the name of a type for that type.
  void list_odd_types() {
    for (const auto& [word, line, type, count, others] : in_.odd_types()) {
      document_.warnings.push_back(fmt::format("{}:{}: the type '{}'{} is read as {}, as VTK does",
                                               document_.path, line, word,
                                               count > 1 ? fmt::format(", {} times,", count) : "", type));
      if (others > 0)
        document_.warnings.push_back(
            fmt::format("{}: {} by further words of this kind", document_.path, counted(others, "types")));
    }
  }

  struct List {
    VtkCellType type;
    std::vector<std::int64_t> connectivity{}, ends{};
  };

  const InputFile& file_;
  VtkLegacyScanner in_;
  Document document_;
  VtkPiece piece_;
  VtkDataReader data_;
  const std::size_t size_;  // of the file
  std::string dataset_;     // the kind in lower case
  bool has_points_ = false;
  std::vector<std::int64_t> types_;
  std::vector<List> lists_;
  std::set<std::string> described_;  // by words of a structured grid
  VtkDimensions dimensions_{};
  VtkImage image_;
  std::array<std::vector<double>, 3> axes_;
};

}  // namespace

Document read_vtk(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
