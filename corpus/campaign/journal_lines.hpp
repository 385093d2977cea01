// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of a journal: cases and shrunk cases as JSON. Not installed.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "corpus/fuzz_campaign.hpp"

namespace tetproof::corpus {

/// A line with its end.
std::string header_line(const CampaignSettings& settings);
std::string line_of(const CaseResult& result);
std::string line_of(const ShrunkCase& shrunk);

/// Whether the object is such a line; `CaseResult` and so on are then made of it. They throw what
/// nlohmann-json throws, or InputError, if a value is missing or has the wrong type.
bool is_header(const nlohmann::ordered_json& json);
bool is_shrunk(const nlohmann::ordered_json& json);
CampaignSettings header_of(const nlohmann::ordered_json& json);
CaseResult case_of(const nlohmann::ordered_json& json);
ShrunkCase shrunk_of(const nlohmann::ordered_json& json);

}  // namespace tetproof::corpus
