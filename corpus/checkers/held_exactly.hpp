// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a file says exactly what a mesh is, defects included. Not installed.
#pragma once

#include <string>

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// Writes the mesh in a format. Empty: every reader of the file gets the same points, bit by bit, and the
/// same tetrahedra, with numbers that no point has where the mesh has such. Else: what stands in the way; the
/// file may be there or not.
std::string write_exactly(const std::string& path, const std::string& format, const TetMesh& mesh);

}  // namespace tetproof::corpus
