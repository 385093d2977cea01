// SPDX-License-Identifier: GPL-3.0-or-later
// Small legacy files of VTK as text.
#pragma once

#include <string>

namespace tetproof::test {

/// A file with this behind its DATASET.
inline std::string legacy(const std::string& rest, const std::string& dataset = "UNSTRUCTURED_GRID") {
  return "# vtk DataFile Version 3.0\n\nASCII\nDATASET " + dataset + "\n" + rest;
}

inline const std::string points4 = "POINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n",
                         tet = points4 + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";

}  // namespace tetproof::test
