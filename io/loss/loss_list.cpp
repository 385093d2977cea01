// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/loss/loss_list.hpp"

#include "io/bytes/one_line.hpp"

namespace tetproof::io {

void add_loss(std::vector<Loss>& losses, const std::string& item, std::size_t count,
              const std::string& example, bool elements) {
  if (count == 0) return;
  const std::string name = in_one_line(item);
  for (Loss& loss : losses)
    if (loss.item == name) {
      loss.count += static_cast<std::int64_t>(count);
      loss.elements = loss.elements || elements;
      return;
    }
  losses.push_back({name, static_cast<std::int64_t>(count), in_one_line(example), elements});
}

}  // namespace tetproof::io
