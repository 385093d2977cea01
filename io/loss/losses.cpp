// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/loss/holds.hpp"
#include "io/loss/loss_finder.hpp"

namespace tetproof::io {

std::vector<Loss> unheld(const Document& document, const Holds& holds) {
  const WrittenPart written(document, holds);
  std::vector<Loss> losses;
  find_losses_of_mesh(document, holds, written, losses);
  find_losses_of_entities(document, holds, written, losses);
  find_losses_of_values(document, holds, written, losses);
  return losses;
}

}  // namespace tetproof::io
