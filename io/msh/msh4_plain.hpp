// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of nodes and elements of .msh 4.1, text or binary, where all is as usual: read by several threads.
#pragma once

#include "io/document.hpp"
#include "io/model/node_index.hpp"
#include "io/msh/numbers.hpp"

namespace tetproof::io {

// Each is false where the block is short, in the other byte order, or has a line that is not plain; nothing
// was read then.

/// The tags of a block of nodes, the first of which is the node at `position`.
bool read_plain_tags(Numbers& in, std::size_t count, Tags& tags, std::size_t position);
/// Coordinates of the nodes of the block, which are the document's last; its parameters have their places.
bool read_plain_points(Numbers& in, const NodeBlock& block, Document& document);
/// Tags of elements, the first of which is the one at `position`, and their nodes, `each` for one. Not plain
/// is one that names a node which the index does not have.
bool read_plain_elements(Numbers& in, std::size_t count, int each, Index* nodes, const NodeIndex& index,
                         Tags& tags, std::size_t position);

}  // namespace tetproof::io
