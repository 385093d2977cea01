// SPDX-License-Identifier: GPL-3.0-or-later
// What a format cannot hold of a document, asked before it is written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/mesh_files.hpp"

namespace tetproof {

struct Loss {
  std::string item;     ///< what is lost
  std::int64_t count;   ///< how many of it
  std::string example;  ///< the first one
};

/// Everything that `write_document(path, document, options)` leaves out or changes; empty: nothing. What any
/// reader can work out again is no loss: the boxes of entities that are their nodes' boxes, and numbers that
/// only count up from 0 or 1.
std::vector<Loss> losses(const std::string& path, const Document& document, const WriteOptions& options = {});

}  // namespace tetproof
