// SPDX-License-Identifier: GPL-3.0-or-later
// Tells which formats hold tetrahedra, and lists endings for --help.
#pragma once

#include <string>
#include <vector>

#include "io/mesh_files.hpp"

namespace tetproof::program {

/// Throws an InputError if a file of this name could not hold the tetrahedra of a grid: an STL, a .vol of
/// TetGen's. Throws as `format_of` does for an unknown ending.
void check_holds_tetrahedra(const std::string& path);

/// For --help: the endings that a grid of tetrahedra can be written to.
std::string grid_endings_written();
/// For --help: the endings that can bring tetrahedra, those that are read through Gmsh too.
std::string grid_endings_read();
/// For --help: all endings that are read, by our readers and through Gmsh.
std::string endings_read();
/// The names of all formats.
std::vector<std::string> format_list();
/// For --help: the names of all formats, as `--from` and `--to` take them.
std::string format_names();

}  // namespace tetproof::program
