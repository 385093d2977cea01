// SPDX-License-Identifier: GPL-3.0-or-later
// What a format cannot hold of a document, asked before it is written.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/mesh_files.hpp"

namespace tetproof {

/// Everything that `write_document(path, document, options)` leaves out or changes for whoever reads the file
/// with `read_document`; empty: nothing. What any reader can work out again is no loss: the boxes of entities
/// that are their nodes' boxes, numbers that only count up from 0 or 1, and an entity that is nothing but a
/// number for elements or nodes that had none, or the only one.
std::vector<Loss> losses(const std::string& path, const Document& document, const WriteOptions& options = {});

/// What the format has no place for but `write_document` puts where `read_document` takes it back: `where` is
/// "$TetproofSupplement", a section of .msh files, or "comments" of TetGen's. Other programs do not see it.
struct KeptAside {
  std::string where;
  std::vector<Loss> items;
};
KeptAside kept_aside(const std::string& path, const Document& document, const WriteOptions& options = {});

}  // namespace tetproof
