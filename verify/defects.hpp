// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the broken elements and the witness points as a mesh for a viewer.
#pragma once

#include <string>

#include "io/document.hpp"
#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// Makes a mesh of the tetrahedra that the report's findings name, and one ring around them: all tetrahedra
/// that share a vertex with a named element. A vertex that a finding names, and a witness point, is an
/// element of its own.
///
/// Each check with findings has an integer cell array, called by its id: 1 on the elements that it names, 0
/// on the others. The array `number` has the number of the tetrahedron or vertex in the file, and -1 for a
/// witness point. A tetrahedron that lacks a point is shown by the vertices that it has. Without findings the
/// mesh is empty.
Document defects_document(const TetMesh& mesh, const Numbering& numbering, const Report& report);

/// Writes this mesh. The ending of `path` tells the format; .vtu is for viewers. InputError as for
/// `write_document`.
void write_defects(const std::string& path, const TetMesh& mesh, const Numbering& numbering,
                   const Report& report);

}  // namespace tetproof::verify
