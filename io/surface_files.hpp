// SPDX-License-Identifier: GPL-3.0-or-later
// Reads surfaces from files of every format, and writes surface files.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/mesh_files.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof {

/// A surface from a file, with the file's numbers, its reader's warnings and the list of what it dropped.
struct SurfaceFile {
  TriangleSurface surface;
  SurfaceNumbering numbering;
  std::vector<std::string> warnings;  ///< as in `Document::warnings`
  std::vector<Loss> dropped;          ///< as in `Document::dropped`, as far as it is about the surface
};

/// Reads the faces of a file of any format as `surface_of(read_document(path, options))` does; see there.
/// Values (colours, normals, texture coordinates) and lines are not read, and are not in `dropped`. Normals
/// of STL that point against the order of a facet's corners are in it. Degenerate triangles, and vertices
/// that no triangle uses, are kept: `verify/surface.hpp` judges them.
///
/// InputError with file, place, what was expected and what was found. The place is the line or byte in .stl,
/// .off, .obj, .ply, .poly and .smesh, and else the element's number.
SurfaceFile read_surface_file(const std::string& path, const ReadOptions& options = {});

/// The surface alone.
TriangleSurface read_surface(const std::string& path, const ReadOptions& options = {});

/// Whether the ending is one of formats that hold surfaces only: .stl, .off, .obj or .ply.
bool is_surface_file(const std::string& path);

/// How a surface is written.
struct SurfaceWriteOptions {
  std::string format;  ///< stl, off, obj or ply; empty: the ending decides
  bool ascii = false;  ///< STL and PLY as text; OFF and OBJ are always text
};

/// Writes vertices and triangles, all of them or nothing. OFF, OBJ and PLY hold every double exactly. STL in
/// its binary form (the default) has float32, and keeps triangles only: coordinates are rounded, vertices
/// that no triangle uses are lost, and the rest are renumbered when it is read again. OBJ has (u,v), as `vt`;
/// no format has the evaluator. OBJ counts vertices from 1, OFF and PLY from 0. PLY has type float if every
/// coordinate is a float. InputError if the place cannot be written, if the ending names no format, or if a
/// triangle names a vertex that does not exist.
void write_surface(const std::string& path, const TriangleSurface& surface,
                   const SurfaceWriteOptions& options = {});

}  // namespace tetproof
