// SPDX-License-Identifier: GPL-3.0-or-later
// The report as a JSON object, for programs that add keys of their own. Internal.
#pragma once

#include <nlohmann/json.hpp>

#include "verify/report.hpp"

namespace tetproof::verify {

/// The object that `report_json` prints.
nlohmann::ordered_json report_json_object(const Report& report, const Numbering& numbering = {});

/// A JSON object as `report_json` prints it. Bytes that are no UTF-8 are replaced.
std::string json_text(const nlohmann::ordered_json& object);

}  // namespace tetproof::verify
