// SPDX-License-Identifier: GPL-3.0-or-later
// Structured grids of VTK: points and cells in rows, layer by layer, without numbers in the file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/vtk/vtk_piece.hpp"

namespace tetproof::io {

/// The numbers of points along the three axes.
using VtkDimensions = std::array<std::int64_t, 3>;

/// The number of points, and of cells. -1: there are more than `most`, or a dimension is negative.
std::int64_t lattice_points(const VtkDimensions& dimensions, std::int64_t most);
std::int64_t lattice_cells(const VtkDimensions& dimensions);
/// The number of cells of a piece with these dimensions of a grid with the dimensions `whole`.
std::int64_t lattice_cells(const VtkDimensions& dimensions, const VtkDimensions& whole);

/// The corners of a cell, from its first one on, and VTK's type of it: hexahedra; quadrangles, lines or a
/// point where one, two or three dimensions are 1.
std::vector<VtkDimensions> lattice_corners(const VtkDimensions& dimensions);
std::int64_t lattice_cell_type(const VtkDimensions& dimensions);

/// The most points of a structured grid in a file of so many bytes, if no data tell that there are more. Such
/// a grid needs no data, so a small file could ask for any memory.
std::int64_t most_lattice_points(std::size_t bytes);

/// Adds points with these coordinates along the axes.
void add_lattice_points(const std::array<std::vector<double>, 3>& axes, VtkPiece& piece);
/// Adds the points of an image: origin + direction * (spacing * index), from the index `first` on.
struct VtkImage {
  VtkDimensions first{};
  std::array<double, 3> origin{}, spacing{1, 1, 1};
  std::array<double, 9> direction{1, 0, 0, 0, 1, 0, 0, 0, 1};
};
void add_image_points(const VtkDimensions& dimensions, const VtkImage& image, VtkPiece& piece);

/// Adds the cells, for points that start at 0.
void add_lattice_cells(const VtkDimensions& dimensions, VtkPiece& piece);

/// "a structured grid of 3 x 4 x 5 points, kept as 24 hexahedra".
std::string lattice_in_words(const std::string& kind, const VtkDimensions& dimensions, std::int64_t cells);

}  // namespace tetproof::io
