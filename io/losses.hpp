// SPDX-License-Identifier: GPL-3.0-or-later
// Losses of a conversion: what a format cannot hold of a document. Can be asked before anything is written.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/mesh_files.hpp"

namespace tetproof {

/// Lists everything that `write_document(path, document, options)` leaves out or changes, as seen by
/// `read_document`. Empty: nothing is lost. Anything a reader can recompute is not a loss: the box of an
/// entity if it is the box of its nodes; numbers that count up from 0 or 1; and an entity that is only a
/// number, if it is the only one or if the elements or nodes had none. InputError as `encoding_of` throws it.
/// To ask several questions about one conversion: `PlannedFile` in io/writing.hpp.
std::vector<Loss> losses(const std::string& path, const Document& document, const WriteOptions& options = {});

/// What the format has no place for, but `write_document` stores in a corner of the file where
/// `read_document` finds it again. Other programs do not see it.
struct KeptAside {
  /// "$TetproofSupplement", a section of .msh files; "comments", in TetGen's files; empty: the format keeps
  /// nothing aside.
  std::string where;
  std::vector<Loss> items;
};
KeptAside kept_aside(const std::string& path, const Document& document, const WriteOptions& options = {});

}  // namespace tetproof
