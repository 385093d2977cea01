// SPDX-License-Identifier: GPL-3.0-or-later
// The search for losses: its input (a document, and what the format holds of it) and the list it adds to.
// Each kind of loss has a class derived from this one.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/loss/holds.hpp"
#include "io/loss/loss_list.hpp"
#include "io/loss/written_part.hpp"
#include "io/losses.hpp"

namespace tetproof::io {

class LossFinder {
 public:
  LossFinder(const Document& document, const Holds& holds, const WrittenPart& written,
             std::vector<Loss>& losses)
      : document_(document), holds_(holds), written_(written), losses_(losses) {}

 protected:
  using Cut = WrittenPart::Cut;
  using Written = WrittenPart::Block;

  void add(const std::string& item, std::size_t count, const std::string& example, bool elements = false) {
    losses_.add(item, count, example, elements);
  }

  std::string element(const ElementBlock& block, std::size_t e = 0) const {
    return fmt::format("element {}", document_.element_tag(block.first + e));
  }

  // Calls `each` for every block that comes back, and then for every element that comes back as triangles.
  template <class Each>
  void each_written(const Each& each) const {
    for (const Written& written : written_.blocks())
      each(*written.block, written.count, element(*written.block));
    for (const Cut& cut : written_.cut()) each(*cut.block, 1, element(*cut.block, cut.element));
  }

  const Document& document_;
  const Holds& holds_;
  const WrittenPart& written_;

 private:
  LossList losses_;
};

/// Elements, nodes, their order, numbers and coordinates.
void find_losses_of_mesh(const Document& document, const Holds& holds, const WrittenPart& written,
                         std::vector<Loss>& losses);
/// Entities, physical groups, partitions, parametric coordinates and periodic links.
void find_losses_of_entities(const Document& document, const Holds& holds, const WrittenPart& written,
                             std::vector<Loss>& losses);

/// Values, what is to be meshed, tables, the title and sections.
void find_losses_of_values(const Document& document, const Holds& holds, const WrittenPart& written,
                           std::vector<Loss>& losses);

}  // namespace tetproof::io
