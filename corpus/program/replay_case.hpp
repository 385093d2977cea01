// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the case that --replay names. Not installed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "corpus/program/fuzz_options.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// A case to run again.
struct ReplayCase {
  CampaignOptions options;  ///< seed, surfaces, limits, judge, repeats
  std::uint64_t index = 0;
  std::string surface_file{};  ///< in place of the surface of `index`; empty: that one
  std::vector<ChosenMesher> meshers;
};

/// Finds what `a.replay` names: SEED:INDEX; DIR/INDEX; DIR/findings/NAME; or the id of a group in the
/// journals of `a.out`. What a journal says of seed, surfaces, limits and meshers is taken from it, except
/// the meshers if `a` names some. InputError if there is no such case.
ReplayCase find_replay_case(const FuzzArguments& a);

}  // namespace tetproof::corpus
