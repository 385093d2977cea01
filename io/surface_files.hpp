// SPDX-License-Identifier: GPL-3.0-or-later
// Every surface format behind one reader and one writer; the ending says which, or else the content.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/mesh_files.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof {

/// Reads a surface from a file: .stl, .off, .obj or .ply in any case, .poly and .smesh; the triangles of a
/// mesh (.msh, .vtk, .vtu, .mesh, .meshb, ...; its other elements are passed over, but a quadrangle is an
/// error); another ending is decided by the content.
///
/// Vertices are welded by exact equality whatever the format (-0 equals 0; NaN equals nothing) and numbered
/// in the order of their first occurrence. Polygons become fans of triangles if they are planar and convex
/// (io/surface/polygons.hpp has the rule). Degenerate triangles, and vertices that no triangle uses, are
/// kept: `verify/surface.hpp` judges. Throws InputError with file, line or byte, what was expected and what
/// was found.
TriangleSurface read_surface(const std::string& path, const ReadOptions& options = {});

/// A surface, and what its reader has to say about the file.
struct SurfaceFile {
  TriangleSurface surface;
  std::vector<std::string> warnings;  ///< as in `Document::warnings`
  std::vector<Loss> dropped;          ///< as in `Document::dropped`
};
/// As `read_surface`, with the reader's warnings and the list of what it dropped.
SurfaceFile read_surface_file(const std::string& path, const ReadOptions& options = {});

/// Whether the ending says that the file can be nothing but a surface: .stl, .off, .obj or .ply.
bool is_surface_file(const std::string& path);

/// What a surface is written as.
struct SurfaceWriteOptions {
  std::string format;  ///< stl, off, obj or ply; empty: what the ending says
  bool ascii = false;  ///< STL and PLY as text; OFF and OBJ always are
};

/// Writes vertices and triangles, whole or not at all. OFF, OBJ and PLY hold every double exactly; STL has
/// float32 in its binary form (the default) and keeps triangles only, so that coordinates are rounded,
/// vertices that no triangle uses are lost, and the rest are renumbered when read again. The parametric
/// definition is not written. OBJ counts vertices from 1, OFF and PLY from 0; PLY says float where every
/// coordinate is one. Throws InputError if the place
/// cannot be written, the ending names no format, or a triangle names a vertex that does not exist.
void write_surface(const std::string& path, const TriangleSurface& surface,
                   const SurfaceWriteOptions& options = {});

}  // namespace tetproof
