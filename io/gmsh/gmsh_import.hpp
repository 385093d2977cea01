// SPDX-License-Identifier: GPL-3.0-or-later
// What only Gmsh reads: geometry, and the files of many solvers. The Gmsh SDK works in a process of its own,
// the program tetproof-gmsh-import, so that its crash, its output and its global state are not ours.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The endings of files that are read through Gmsh, lower case with the dot. Of .med, .cgns, .sat and .x_t
/// Gmsh says so itself when it was built without what reads them, as Debian's is.
const std::vector<std::string>& gmsh_endings();

/// Reads a file as Gmsh does, with exactly its doubles; geometry without a mesh is meshed with Gmsh's default
/// sizes, which is a warning of the document. `format` is "gmsh:" and the ending. What Gmsh warns of, and
/// what of its model is not a mesh, are warnings too.
///
/// A .geo file is a script, and may run programs and write files: as with Gmsh, read those you trust.
///
/// InputError: Gmsh finds an error or no mesh, crashes, or is not done after TETPROOF_GMSH_TIMEOUT seconds
/// (600); or there is no tetproof-gmsh-import: it is looked for where TETPROOF_GMSH_IMPORT says, or else in
/// the running program's folder and where it is installed.
Document read_through_gmsh(const std::string& path);

}  // namespace tetproof::io
