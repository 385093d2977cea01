// SPDX-License-Identifier: GPL-3.0-or-later
// Adds items to a list of losses. Readers add to `Document::dropped`; the search for what a target cannot
// hold adds to its own list.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Adds `count` of `item`. Each item is listed once: its counts are added up and its first example is kept.
/// A count of 0 adds nothing. Both texts can contain names from files: control characters in them become
/// "\x0A" and the like, so that each text is one line. `elements`: the item is elements, which the mesh then
/// lacks.
void add_loss(std::vector<Loss>& losses, const std::string& item, std::size_t count,
              const std::string& example, bool elements = false);

/// Adds to a list in the same way, however many items there are.
class LossList {
 public:
  explicit LossList(std::vector<Loss>& losses);
  void add(const std::string& item, std::size_t count, const std::string& example, bool elements = false);

 private:
  std::vector<Loss>& losses_;
  std::unordered_map<std::string, std::size_t> places_;  // of items in losses_
};

}  // namespace tetproof::io
