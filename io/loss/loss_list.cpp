// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/loss/loss_list.hpp"

namespace tetproof::io {

void add_loss(std::vector<Loss>& losses, const std::string& item, std::size_t count,
              const std::string& example, bool elements) {
  if (count == 0) return;
  for (Loss& loss : losses)
    if (loss.item == item) {
      loss.count += static_cast<std::int64_t>(count);
      loss.elements = loss.elements || elements;
      return;
    }
  losses.push_back({item, static_cast<std::int64_t>(count), example, elements});
}

}  // namespace tetproof::io
