// SPDX-License-Identifier: GPL-3.0-or-later
// Makes values of a document from the arrays of VTK's files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_piece.hpp"

namespace tetproof::io {

/// The points or cells of a piece that an array is about, and where they are in the document.
struct VtkItems {
  std::size_t first = 0;  ///< the position of the first in the document
  std::size_t count = 0;  ///< in the piece
  /// For each item of the document, the item of the piece that has its values; null: the same.
  const std::vector<std::uint32_t>* origin = nullptr;
};

/// Adds an array to the values `to` of the document, or continues the array of the same name of the previous
/// piece. Takes the array's roles out of `roles`. Strings become integers with labels, which count on from
/// piece to piece; `labels`: those of `to` so far. InputError if there is not a value for each item.
void add_vtk_values(Document& document, std::vector<Values>& to, Column&& column, const VtkItems& items,
                    std::vector<VtkRole>& roles, VtkLabels& labels);

}  // namespace tetproof::io
