// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of a report that have findings of their own.
#pragma once

#include <string>
#include <vector>

#include "verify/verify.hpp"

namespace tetproof::test {

using Ids = std::vector<std::string>;

/// The ids of the checks that have findings of their own, in the order of the report. Findings that follow
/// from another one do not count.
inline Ids roots(const verify::Report& report) {
  Ids ids;
  for (const auto& result : report.checks)
    if (result.count > 0) ids.push_back(info(result.check).id);
  return ids;
}

}  // namespace tetproof::test
