// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a document that a file of points and polygons keeps: some of its elements, perhaps in another
// order, and the values of these.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/surface/surface_lines.hpp"

namespace tetproof::io {

/// Values of elements that are left out are lost with them; the values of all others are those of the
/// elements in the file. The writer and the list of what is held both look at this part instead of the
/// document.
class KeptPart {
 public:
  /// How values of some elements are told: as a list of elements, or as a run of them where they are one.
  enum class Form { lists, runs };

  /// `elements` gives positions in the document, in the file's order; nothing: the document stays as it is.
  /// It is asked only if elements have values.
  KeptPart(const Document& document,
           const std::function<std::optional<std::vector<std::size_t>>(const Document&)>& elements,
           Form form);
  KeptPart(const KeptPart&) = delete;
  KeptPart& operator=(const KeptPart&) = delete;

  /// The document itself where its elements and values are as they must be; else one without its facets.
  const Document& document() const { return made_ ? *made_ : document_; }

  /// What is held of the document, from what is held of this part. Refers to this part.
  Holds holds(Holds of_part) const;

 private:
  const Document& document_;
  std::unique_ptr<Document> made_;
};

/// The positions of the elements that a file keeps, in the document's order.
std::vector<std::size_t> kept_elements(const Document& document,
                                       const std::function<bool(const KeptElement&)>& is_kept);

}  // namespace tetproof::io
