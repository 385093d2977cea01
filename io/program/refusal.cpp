// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/refusal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tetproof::program {

Refusal::Refusal(Strictness strictness, const std::vector<Loss>& dropped, const std::vector<Loss>& losses,
                 const std::vector<Loss>& aside, const std::vector<Loss>& without_nodes) {
  if (strictness == Strictness::lax) return;
  const bool native = strictness == Strictness::native;
  not_read = dropped, lost = losses;
  for (const Loss& loss : aside)
    if (native || loss.elements) kept.push_back(loss);
  if (native) dangling = without_nodes;
}

std::string Refusal::why(const std::string& kept_in) const {
  const bool one = items() == 1;
  std::vector<std::string> reasons;
  if (!not_read.empty()) reasons.push_back(one ? "is not read" : "are not read");
  if (!lost.empty()) reasons.push_back("would be lost");
  if (!kept.empty())
    reasons.push_back(fmt::format("would stand in {} only, which other programs do not read", kept_in));
  if (!dangling.empty()) reasons.push_back("would name nodes that do not exist");
  return fmt::format("{}", fmt::join(reasons, " or "));
}

}  // namespace tetproof::program
