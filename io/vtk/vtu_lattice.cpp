// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtu_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_lattice.hpp"
#include "io/vtk/vtk_lattice_join.hpp"
#include "io/vtk/vtk_types.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  Reader(const VtuFile& file, const pugi::xml_node& grid, VtuLattice kind, std::size_t bytes,
         Document& document)
      : file_(file), grid_(grid), kind_(kind), bytes_(bytes), document_(document), parts_(file, document) {}

  VtkPiece read(std::size_t& filled) {
    list_surplus(grid_, "WholeExtent", 6);
    if (kind_ == VtuLattice::image)
      list_surplus(grid_, "Origin", 3), list_surplus(grid_, "Spacing", 3),
          list_surplus(grid_, "Direction", 9);
    std::vector<VtkLatticePiece> pieces;
    std::vector<pugi::xml_node> nodes;
    std::size_t number = 0;
    for (const pugi::xml_node node : grid_.children("Piece")) {
      list_surplus(node, "Extent", 6);
      VtkLatticePiece one = extent(node);
      one.piece.which = fmt::format(" of piece {}", number++);
      if (std::find(one.dimensions.begin(), one.dimensions.end(), 0) != one.dimensions.end()) continue;
      pieces.push_back(std::move(one));
      nodes.push_back(node);
    }
    filled = pieces.size();
    if (pieces.empty()) return {};
    const VtkDimensions whole = box_of(pieces).dimensions;
    for (std::size_t p = 0; p < pieces.size(); ++p) content(nodes[p], whole, pieces[p]);
    if (pieces.size() > 1) return joined(std::move(pieces), document_);
    VtkPiece piece = std::move(pieces[0].piece);
    piece.which.clear();
    add_lattice_cells(whole, piece);
    document_.warnings.push_back(fmt::format(
        "{}: {}", document_.path, lattice_in_words("a structured grid", whole, lattice_cells(whole))));
    return piece;
  }

 private:
  // Lists what stands in an attribute behind so many numbers.
  void list_surplus(const pugi::xml_node& node, const char* attribute, int numbers) {
    Scanner in(document_.path, node.attribute(attribute).value());
    for (int k = 0; k < numbers; ++k) in.word();
    if (in.at_end()) return;
    const std::string example = fmt::format("line {}: {}", file_.line_of(node), Scanner(in).rest_of_line());
    std::size_t more = 0;
    for (; !in.at_end(); ++more) in.word();
    add_loss(document_.dropped, fmt::format("words behind the {} numbers of {}", numbers, attribute), more,
             example);
  }

  // From which to which index a piece goes.
  VtkLatticePiece extent(const pugi::xml_node& node) const {
    std::array<std::int64_t, 6> extent{0, -1, 0, -1, 0, -1};
    file_.integers_in(grid_, "WholeExtent", extent);
    file_.integers_in(node, "Extent", extent);
    constexpr std::int64_t most_index = std::numeric_limits<std::int32_t>::max();
    VtkLatticePiece piece;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t first = extent[2 * k], last = extent[2 * k + 1];
      if (first < -most_index || last > most_index || last < first - 1)
        file_.fail(node, fmt::format("expected an Extent, found {} to {}", first, last));
      piece.first[k] = first;
      piece.dimensions[k] = last - first + 1;
    }
    return piece;
  }

  void content(const pugi::xml_node& node, const VtkDimensions& whole, VtkLatticePiece& one) {
    VtkPiece& piece = one.piece;
    const VtkDimensions& dimensions = one.dimensions;
    const std::int64_t count = lattice_points(dimensions, std::numeric_limits<Index>::max());
    const auto check = [&](std::size_t bytes) {
      if (count < 0 || points_ + count > most_lattice_points(bytes))
        file_.fail(node, fmt::format("{} points are more than a file of {} can have data for",
                                     fmt::join(dimensions, " x "), counted(bytes_, "bytes")));
    };
    constexpr std::size_t densest = 256;  // points for a byte: zlib packs reals that are all the same so
    check(densest * bytes_);
    parts_.data(node, static_cast<std::size_t>(count),
                static_cast<std::size_t>(lattice_cells(dimensions, whole)), piece);
    if (piece.point_data.empty() && piece.cell_data.empty()) check(bytes_);
    points_ += count;
    if (points_ > std::numeric_limits<Index>::max())
      file_.fail(node, fmt::format("{} points are more than can be numbered here", points_));
    if (kind_ == VtuLattice::structured) {
      parts_.points(node, static_cast<std::size_t>(count), piece);
    } else if (kind_ == VtuLattice::image) {
      VtkImage image;
      image.first = one.first;
      file_.reals_in(grid_, "Origin", image.origin);
      file_.reals_in(grid_, "Spacing", image.spacing);
      file_.reals_in(grid_, "Direction", image.direction);
      add_image_points(dimensions, image, piece);
    } else {
      add_lattice_points(axes(node, dimensions), piece);
    }
  }

  // The coordinates along the three axes.
  std::array<std::vector<double>, 3> axes(const pugi::xml_node& node, const VtkDimensions& dimensions) {
    std::array<std::vector<double>, 3> found;
    std::size_t k = 0;
    each_array(node, "Coordinates", [&](const pugi::xml_node& array) {
      if (k == 3) file_.fail(array, "expected three arrays of coordinates, found a fourth");
      const auto items = static_cast<std::size_t>(dimensions[k]);
      const Column column = file_.column(array, items, document_.dropped);
      if (!column.texts.empty() || column.components != 1) file_.fail(array, "expected coordinates");
      for (std::size_t i = 0; i < items; ++i) found[k].push_back(number_at<double>(column, i));
      ++k;
    });
    if (k != 3) file_.fail(node, fmt::format("expected three arrays of <Coordinates>, found {}", k));
    return found;
  }

  const VtuFile& file_;
  const pugi::xml_node grid_;
  const VtuLattice kind_;
  const std::size_t bytes_;
  Document& document_;
  VtuParts parts_;
  std::int64_t points_ = 0;  // of all pieces so far
};

}  // namespace

VtkPiece read_vtu_lattice(const VtuFile& file, const pugi::xml_node& grid, VtuLattice kind, std::size_t bytes,
                          Document& document, std::size_t& filled) {
  return Reader(file, grid, kind, bytes, document).read(filled);
}

}  // namespace tetproof::io
