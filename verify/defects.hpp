// SPDX-License-Identifier: GPL-3.0-or-later
// The broken elements as a mesh for a viewer.
#pragma once

#include <string>

#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// Writes the tetrahedra that the report's findings name, with all that share a vertex with one of them. For
/// each check with findings an integer cell array of its id: 1 on its tetrahedra, 0 around them; and
/// `number`, the tetrahedron's in the file. A mesh format by `path`'s ending, .vtu for viewers. Without
/// findings the mesh is empty. InputError as `write_document`.
void write_defects(const std::string& path, const TetMesh& mesh, const Numbering& numbering,
                   const Report& report);

}  // namespace tetproof::verify
