// SPDX-License-Identifier: GPL-3.0-or-later
// A document as the plain arrays of the C interface.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "io/document.hpp"
#include "verify/c/tetproof.h"

namespace tetproof::c {

/// The arrays of a document. They refer to its points and names, so that it must outlive them and stay as it
/// is.
class DocumentView {
 public:
  explicit DocumentView(const Document& document);
  DocumentView(const DocumentView&) = delete;
  DocumentView& operator=(const DocumentView&) = delete;
  const tetproof_document_arrays& arrays() const { return arrays_; }

 private:
  template <std::size_t Corners>
  struct Elements {
    std::vector<std::array<Index, Corners>> corners;
    std::vector<std::int64_t> numbers, groups, entities;
    void add(const Document& document, const ElementBlock& block);
  };

  std::vector<std::int64_t> point_numbers_;
  Elements<4> tets_;
  Elements<3> triangles_;
  std::deque<tetproof_group> groups_;
  std::vector<const tetproof_group*> group_list_;
  tetproof_document_arrays arrays_{};
};

}  // namespace tetproof::c
