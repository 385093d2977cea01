// SPDX-License-Identifier: GPL-3.0-or-later
// Reads ordinary blocks of nodes and elements of .msh 4.1, text or binary, with several threads.
#pragma once

#include "io/document.hpp"
#include "io/model/node_index.hpp"
#include "io/msh/numbers.hpp"

namespace tetproof::io {

// Each returns false where the block is short, in the other byte order, or has a line that is not plain. Then
// nothing was read.

/// Reads the tags of a block of nodes. The first of them is the node at `position`.
bool read_plain_tags(Numbers& in, std::size_t count, Tags& tags, std::size_t position);
/// Reads the coordinates of the nodes of the block, which are the document's last. There is room for its
/// parameters.
bool read_plain_points(Numbers& in, const NodeBlock& block, Document& document);
/// Reads the tags of elements, the first of which is the one at `position`, and their nodes, `each` for one
/// element. An element that names a node which the index does not have is not plain.
bool read_plain_elements(Numbers& in, std::size_t count, int each, Index* nodes, const NodeIndex& index,
                         Tags& tags, std::size_t position);

}  // namespace tetproof::io
