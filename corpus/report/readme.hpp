// SPDX-License-Identifier: GPL-3.0-or-later
// The README of a finding's folder. Internal.
#pragma once

#include <string>
#include <vector>

#include "corpus/report/finding.hpp"
#include "corpus/report/statements.hpp"

namespace tetproof::corpus {

/// A mesh file in the finding, and the numbers by which statements name its points and tetrahedra.
struct GivenMesh {
  std::string file{};     ///< what the mesher wrote; empty: nothing
  std::string checked{};  ///< what statements are about: the same, or a copy in a format that check.py reads
  Numbering numbering{};
};

struct ReadmeFacts {
  const FindingFacts& facts;
  const Statements& statements;  ///< the last is about the surface
  const GivenMesh& mesh;
  const std::string& command;
  const TriangleSurface& surface;  ///< as the mesher got it
  const std::vector<std::string>& files;
};

/// Some ten lines in Markdown.
std::string readme(const ReadmeFacts& about);

}  // namespace tetproof::corpus
