// SPDX-License-Identifier: GPL-3.0-or-later
// The broken elements, and the witnesses, as a mesh for a viewer.
#pragma once

#include <string>

#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// Writes the tetrahedra that the report's findings name with one ring around them: all that share a vertex
/// with what a finding names. Points are elements of their own where a finding names a vertex or has a
/// witness point. For each check with findings an integer cell array of its id: 1 on what it names, 0 around
/// it; and `number`, the tetrahedron's or the vertex's in the file, -1 for a witness point. A tetrahedron
/// that lacks a point is shown by the vertices that it has. A mesh format by `path`'s ending, .vtu for
/// viewers. Without findings the mesh is empty. InputError as `write_document`.
void write_defects(const std::string& path, const TetMesh& mesh, const Numbering& numbering,
                   const Report& report);

}  // namespace tetproof::verify
