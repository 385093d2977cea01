// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: vtkStructuredGrid::GetCell and vtkImageData of VTK 9.1.
#include "io/vtk/vtk_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/bytes/words.hpp"

namespace tetproof::io {
namespace {

// The axes along which there is more than one point.
std::vector<std::size_t> wide_axes(const VtkDimensions& dimensions) {
  std::vector<std::size_t> axes;
  for (std::size_t k = 0; k < 3; ++k)
    if (dimensions[k] > 1) axes.push_back(k);
  return axes;
}

}  // namespace

std::int64_t lattice_points(const VtkDimensions& dimensions, std::int64_t most) {
  std::int64_t points = 1;
  for (const std::int64_t n : dimensions) {
    if (n < 0) return -1;
    if (n == 0) return 0;
  }
  for (const std::int64_t n : dimensions) {
    if (points > most / n) return -1;
    points *= n;
  }
  return points;
}

std::int64_t lattice_cells(const VtkDimensions& dimensions) {
  std::int64_t cells = 1;
  for (const std::int64_t n : dimensions) cells *= n == 0 ? 0 : std::max<std::int64_t>(1, n - 1);
  return cells;
}

std::int64_t lattice_cells(const VtkDimensions& dimensions, const VtkDimensions& whole) {
  std::int64_t cells = 1;
  for (std::size_t k = 0; k < 3; ++k)
    cells *= dimensions[k] == 0 ? 0 : whole[k] > 1 ? dimensions[k] - 1 : dimensions[k];
  return cells;
}

std::int64_t most_lattice_points(std::size_t bytes) {
  constexpr std::uint64_t least = 1 << 17, most = std::numeric_limits<Index>::max();
  return static_cast<std::int64_t>(std::clamp<std::uint64_t>(bytes, least, most));
}

void add_lattice_points(const std::array<std::vector<double>, 3>& axes, VtkPiece& piece) {
  piece.points.reserve(piece.points.size() + axes[0].size() * axes[1].size() * axes[2].size());
  for (const double z : axes[2])
    for (const double y : axes[1])
      for (const double x : axes[0]) piece.points.emplace_back(x, y, z);
}

void add_image_points(const VtkDimensions& dimensions, const VtkImage& image, VtkPiece& piece) {
  Eigen::Matrix3d step;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 3; ++k)
      step(row, k) =
          image.direction[static_cast<std::size_t>(3 * row + k)] * image.spacing[static_cast<std::size_t>(k)];
  const Eigen::Vector3d origin(image.origin[0], image.origin[1], image.origin[2]);
  piece.points.reserve(static_cast<std::size_t>(dimensions[0] * dimensions[1] * dimensions[2]));
  Eigen::Vector3d at;
  for (std::int64_t k = 0; k < dimensions[2]; ++k)
    for (std::int64_t j = 0; j < dimensions[1]; ++j)
      for (std::int64_t i = 0; i < dimensions[0]; ++i) {
        at = {static_cast<double>(image.first[0] + i), static_cast<double>(image.first[1] + j),
              static_cast<double>(image.first[2] + k)};
        // In VTK's order of operations, so that every point is VTK's.
        piece.points.emplace_back(
            step(0, 0) * at.x() + step(0, 1) * at.y() + step(0, 2) * at.z() + origin.x(),
            step(1, 0) * at.x() + step(1, 1) * at.y() + step(1, 2) * at.z() + origin.y(),
            step(2, 0) * at.x() + step(2, 1) * at.y() + step(2, 2) * at.z() + origin.z());
      }
}

std::vector<VtkDimensions> lattice_corners(const VtkDimensions& dimensions) {
  std::vector<VtkDimensions> corners{{0, 0, 0}};
  const std::vector<std::size_t> axes = wide_axes(dimensions);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    std::vector<VtkDimensions> moved = corners;
    for (VtkDimensions& corner : moved) ++corner[axes[k]];
    if (k == 1) std::reverse(moved.begin(), moved.end());
    corners.insert(corners.end(), moved.begin(), moved.end());
  }
  return corners;
}

std::int64_t lattice_cell_type(const VtkDimensions& dimensions) {
  constexpr std::int64_t types[] = {1, 3, 9, 12};
  return types[wide_axes(dimensions).size()];
}

void add_lattice_cells(const VtkDimensions& dimensions, VtkPiece& piece) {
  const std::int64_t cells = lattice_cells(dimensions);
  if (cells == 0) return;
  const std::array<std::int64_t, 3> stride{1, dimensions[0], dimensions[0] * dimensions[1]};
  std::vector<std::int64_t> corners;
  for (const auto& [x, y, z] : lattice_corners(dimensions))
    corners.push_back(x * stride[0] + y * stride[1] + z * stride[2]);
  piece.types.insert(piece.types.end(), static_cast<std::size_t>(cells), lattice_cell_type(dimensions));
  piece.connectivity.reserve(piece.connectivity.size() + static_cast<std::size_t>(cells) * corners.size());
  const auto last = [&](std::size_t k) { return std::max<std::int64_t>(1, dimensions[k] - 1); };
  for (std::int64_t k = 0; k < last(2); ++k)
    for (std::int64_t j = 0; j < last(1); ++j)
      for (std::int64_t i = 0; i < last(0); ++i) {
        for (const std::int64_t corner : corners)
          piece.connectivity.push_back(i * stride[0] + j * stride[1] + k * stride[2] + corner);
        piece.ends.push_back(static_cast<std::int64_t>(piece.connectivity.size()));
      }
}

std::string lattice_in_words(const std::string& kind, const VtkDimensions& dimensions, std::int64_t cells) {
  constexpr const char* names[] = {"points", "lines", "quadrangles", "hexahedra"};
  return fmt::format("{} of {} points, kept as {}", kind, fmt::join(dimensions, " x "),
                     counted(cells, names[wide_axes(dimensions).size()]));
}

}  // namespace tetproof::io
