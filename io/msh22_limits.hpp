// SPDX-License-Identifier: GPL-3.0-or-later
// What .msh 2.2 does to a document's numbers; the writer and the list of losses must agree on it.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

struct Msh22Limits {
  bool renumber_nodes = false;  ///< from 1: a tag does not fit the 4 bytes that it has in binary
  bool renumber_elements = false;
  bool parametric =
      false;  ///< parametric coordinates are written; only when all nodes on curves and surfaces have them
};
Msh22Limits msh22_limits(const Document& document, bool binary);

}  // namespace tetproof::io
