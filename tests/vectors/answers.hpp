// SPDX-License-Identifier: GPL-3.0-or-later
// Answers to the conformance vectors from reference/.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tetproof::test {

/// The result for one case of a kind (corpus/vectors/README.md). `mistake`: empty, or one made on purpose, so
/// that the runner can be seen to find it: "14-cases" (E8 forgotten), "orientation" (E7 forgotten),
/// "l-plus-3" (eq. (3.5) as printed, for every split), or one of geometry_answers.cpp.
nlohmann::json answer(const std::string& kind, const nlohmann::json& input, const std::string& mistake);

/// The same for the kinds about geometry. Lattices, qualities and flips are those of engine/; indicators,
/// points of edges and closest points are those of paper/, because engine/ knows them for whole lattices
/// only.
nlohmann::json geometry_answer(const std::string& kind, const nlohmann::json& input,
                               const std::string& mistake);

}  // namespace tetproof::test
