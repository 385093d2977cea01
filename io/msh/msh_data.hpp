// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of .msh about nodes and elements of other sections: $Periodic, $GhostElements, and the data of
// views.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/scanner.hpp"
#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/model/node_index.hpp"
#include "io/msh/numbers.hpp"

namespace tetproof::io {

/// An element's tag and its position. The copies of an element in several groups have such a pair too.
using ElementTag = std::pair<std::int64_t, Index>;

/// The content of these sections. They name nodes and elements by their tags, and may stand in front of them.
/// So the tags are looked up when everything has been read.
class MshData {
 public:
  bool empty() const { return values_.empty() && links_.empty() && ghosts_.empty(); }

  /// `affine_word`: a transformation stands behind the word "Affine" (versions 1 to 3, 4.0 as text).
  /// Otherwise it stands behind the number of its values.
  void read_periodic(Numbers& in, bool affine_word);
  void read_ghosts(Numbers& in);

  /// The lines in front of the rows: Values that are still empty, and how many rows follow.
  struct Header {
    Values values;
    std::int64_t rows = 0;
  };
  /// None if there are tags that `Values` has no place for.
  static std::optional<Header> read_header(Scanner& in);
  void read_rows(Numbers& in, Header header, Of of);

  /// Adds all that was read to `document`. `copies`: tags of elements that were merged into others.
  void look_up(Document& document, NodeIndex& nodes, const std::vector<ElementTag>& copies);

 private:
  void warn_of_maps(Document& document) const;

  struct TaggedValues {
    Values values;
    Of of = Of::node;
    std::vector<std::int64_t> tags{};
  };
  struct TaggedLink {
    PeriodicLink link;
    std::vector<std::array<std::int64_t, 2>> tags{};
  };
  struct TaggedGhost {
    GhostElement ghost;
    std::int64_t tag = 0;
  };

  std::vector<TaggedValues> values_;
  std::vector<TaggedLink> links_;
  std::vector<TaggedGhost> ghosts_;
};

}  // namespace tetproof::io
