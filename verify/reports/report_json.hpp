// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the report as a JSON object, for programs that add keys of their own. Not installed.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "verify/report.hpp"

namespace tetproof::verify {

/// The object that `report_json` prints. Its keys are a contract.
nlohmann::ordered_json report_object(const Report& report, const Numbering& numbering = {});

}  // namespace tetproof::verify
