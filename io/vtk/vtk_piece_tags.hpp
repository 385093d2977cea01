// SPDX-License-Identifier: GPL-3.0-or-later
// The entities and physical groups of the cells of a piece of one of VTK's files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "io/document.hpp"
#include "io/model/tag_sets.hpp"
#include "io/vtk/vtk_piece.hpp"

namespace tetproof::io {

class VtkPieceTags {
 public:
  /// Takes their arrays out of the piece's cell data, and the roles of these. InputError if there is not a
  /// number for each cell.
  VtkPieceTags(Document& document, VtkPiece& piece);

  std::int64_t entity(std::size_t cell) const { return entities_.empty() ? 0 : entities_[cell]; }
  /// The position of the cell's groups in `Document::tag_sets`.
  std::int32_t groups(std::size_t cell, TagSets& sets);
  /// Negative numbers that are no groups become values of the elements from `first` on. `origin`: the cell of
  /// each; null: they are the cells.
  void add_negative(std::size_t first, const std::vector<std::uint32_t>* origin) const;

 private:
  Document& document_;
  const VtkTagNames names_;
  std::vector<std::int64_t> entities_, tags_;
  std::vector<std::vector<std::int64_t>> groups_;  // empty where this piece has no array of this name
  bool any_group_ = false;                         // whether negative numbers are groups
};

}  // namespace tetproof::io
