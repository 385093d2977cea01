// SPDX-License-Identifier: GPL-3.0-or-later
// A document as VTK's two writers need it: cells, and arrays of points, of cells and of neither.
#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_plan.hpp"

namespace tetproof::io {

/// An array as it is written. It has reals, integers or texts.
struct VtkArray {
  std::string name, type = "Float64";
  int components = 1;
  std::span<const double> reals;
  std::span<const std::int64_t> integers;
  std::span<const std::string> texts;
  std::vector<std::string> roles{};  ///< see `Values`
  std::string_view attribute{};      ///< the keyword of a legacy file that gives it its role; empty: none
  std::size_t size() const { return reals.size() + integers.size() + texts.size(); }
};
struct VtkMesh {
  std::vector<std::size_t> elements;  ///< positions of those that are written
  std::vector<Index> connectivity;
  std::vector<std::int64_t> ends;
  std::vector<unsigned char> types;
  /// The faces of polyhedra: their number, and for each the number of its points and these. `face_ends`:
  /// where those of each cell end; -1: it has none. Empty: there are no polyhedra.
  std::vector<std::int64_t> faces, face_ends;
  std::vector<VtkArray> point_data, cell_data, field_data;
  std::deque<std::vector<double>> own_reals;  ///< the numbers of arrays that differ from the document's
  std::deque<std::vector<std::int64_t>> own_integers;
  std::deque<std::vector<std::string>> own_texts;
};

/// Refers to the document. Values that not all nodes or elements have are filled up: NaN, 0. Elements that
/// name unknown nodes are left out.
VtkMesh vtk_mesh(const Document& document, const VtkPlan& plan);

/// Returns the place of the first number that is `wanted`: "a point", `point data "a"`, ...; empty: there is
/// none.
std::string first_place_of(bool (*wanted)(double), const Document& document, const VtkMesh& mesh);

}  // namespace tetproof::io
