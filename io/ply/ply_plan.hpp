// SPDX-License-Identifier: GPL-3.0-or-later
// Plans which elements and properties of a PLY file store which parts of a document. The writer and the list
// of what is held share this plan.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/ply/ply_header.hpp"
#include "io/ply/ply_names.hpp"
#include "io/surface/surface_lines.hpp"

namespace tetproof::io {

/// Where the numbers of a property are: that of instance i at i x stride. Those of a list: from `starts[i]`
/// to `starts[i + 1]`.
struct PlySource {
  std::string name, type_words;
  const PlyType *type = nullptr, *count = nullptr;
  const double* reals = nullptr;
  const std::int64_t* integers = nullptr;
  std::size_t stride = 1;
  std::vector<std::size_t> starts;

  std::size_t longest() const {  // in text
    std::size_t most = 1;
    for (std::size_t i = 1; i < starts.size(); ++i) most = std::max(most, starts[i] - starts[i - 1] + 1);
    return most * (longest_real + 1);
  }
};

/// An element of the file. Its coordinates or corners are written before these properties.
struct PlyPart {
  std::string name;
  std::size_t rows = 0;
  std::vector<PlySource> sources;
  std::size_t longest() const {
    std::size_t sum = 1;
    for (const PlySource& source : sources) sum += source.longest();
    return sum;
  }
};

/// Refers to the document, which must outlive the plan.
class PlyPlan {
 public:
  PlyPlan(const Document& document, bool binary);

  std::vector<KeptElement> faces, lines;
  PlyPart vertex, face, edge;
  std::vector<PlyPart> others;  ///< tables that are elements of their own
  std::vector<const Values*> held;
  std::vector<const Table*> held_tables;

 private:
  void node_values();
  void element_values();
  void texture();
  void tables();
  bool column(const Column& column, std::size_t rows, PlySource& source) const;

  const Document& document_;
  const bool binary_;
  bool ordered_ = false;  // every element comes back at its position in the document
};

Holds ply_holds(const Document& document, const PlyPlan& plan);

}  // namespace tetproof::io
