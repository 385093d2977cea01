// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the differences between a document and what came back of it, by looking at both. It knows nothing of
// the format except which elements it can hold, and shares no code with the list of losses that it is
// compared with.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "documents_pairing.hpp"
#include "io/document.hpp"

namespace tetproof::test {

struct Difference {
  std::string
      item;  ///< in the words of io/loss/losses.cpp, or "changed ...", "gained ..." for what no list may hold
  std::int64_t count = 0;
  std::string example;
  std::vector<std::string>
      subjects{};       ///< of what it is true, as the example of a loss names it; none: of all
  bool unsure = false;  ///< it may as well be a consequence of another difference
};

/// What `after` lacks of `before`, up to what io/losses.hpp says is none. Nodes are known again by their x,
/// which must differ from node to node even as 32-bit numbers (std::logic_error); elements by their nodes.
/// `holding`: what the format that it came through has place for.
std::vector<Difference> differences(const Document& before, const Document& after,
                                    Holding holding = Holding::elements);

}  // namespace tetproof::test
