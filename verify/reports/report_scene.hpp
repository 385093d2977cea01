// SPDX-License-Identifier: GPL-3.0-or-later
// The scene of a report's page: what of the mesh is shown, and what it leaves out. Internal.
#pragma once

#include <string>
#include <vector>

#include "io/page/scene.hpp"
#include "verify/report_page.hpp"

namespace tetproof::verify {

struct ReportScene {
  io::Scene scene;
  /// Of each finding, in the order of the checks and of their findings: its position in `scene.targets`.
  std::vector<int> targets;
  int to_surface = -1, to_mesh = -1;  ///< the places of the largest distances, likewise; -1: none
  std::vector<std::string> left_out;  ///< a sentence for each thing that the view does not show
};

/// So many bytes make 18 MB of base64. The page's scripts and tables have the rest of 20 MB.
inline constexpr std::size_t most_scene_bytes = 13'500'000;

/// `most_bytes`: of the scene, before it is written as base64. Only what findings name may go beyond.
ReportScene report_scene(const Report& report, const PageSubject& subject,
                         std::size_t most_bytes = most_scene_bytes);

}  // namespace tetproof::verify
