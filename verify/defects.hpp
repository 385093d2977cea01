// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts the broken elements out of a mesh, with what is around them, for a viewer.
#pragma once

#include <string>

#include "io/document.hpp"
#include "io/tet_mesh.hpp"
#include "verify/report.hpp"

namespace tetproof::verify {

/// The tetrahedra that the report's findings name, with one ring around them: all tetrahedra that share a
/// vertex with a named element, face or vertex. Where a finding names a vertex or has a witness point, this
/// point is an element of its own. A tetrahedron that lacks a point is shown by the vertices that exist.
///
/// Each check with findings has an integer cell array of its id: 1 for what it names, 0 for the ring. The
/// array `number` is the tetrahedron's or the vertex's number in the file, -1 for a witness point. Without
/// findings the document is empty.
Document defects_document(const TetMesh& mesh, const Numbering& numbering, const Report& report);

/// Writes this document, in the format that `path`'s ending says; .vtu suits viewers. InputError as
/// `write_document`.
void write_defects(const std::string& path, const TetMesh& mesh, const Numbering& numbering,
                   const Report& report);

}  // namespace tetproof::verify
