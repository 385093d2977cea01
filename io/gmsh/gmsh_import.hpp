// SPDX-License-Identifier: GPL-3.0-or-later
// Reads files through Gmsh: geometry, and the files of many solvers. The Gmsh SDK runs in a process of its
// own, the program tetproof-gmsh-import, so its crashes, its output and its global state do not reach our
// programs.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The endings of files that are read through Gmsh, in lower case with the dot. A Gmsh that was built without
/// support for .med, .cgns, .sat or .x_t, such as Debian's, says so itself.
const std::vector<std::string>& gmsh_endings();

/// Reads a file as Gmsh does, with exactly its doubles. Geometry without a mesh is meshed with Gmsh's default
/// sizes; a warning says so. `format` is "gmsh:" and the ending. Gmsh's warnings become warnings of the
/// document.
///
/// Parts of Gmsh's model that are no mesh are listed as dropped: geometry, and views of values. Gmsh does not
/// say what it leaves out itself when it reads a file, so that cannot be listed.
///
/// A .geo file is a script that may run programs and write files. Read only those that you trust, as with
/// Gmsh.
///
/// InputError if Gmsh finds an error or no mesh, crashes, or needs more than TETPROOF_GMSH_TIMEOUT seconds
/// (600); or if there is no tetproof-gmsh-import. It is looked for at TETPROOF_GMSH_IMPORT if that is set,
/// otherwise in the running program's folder and where it is installed.
Document read_through_gmsh(const std::string& path);

}  // namespace tetproof::io
