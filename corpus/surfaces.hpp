// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces by name: generated ones ("sphere:r=1,n=5000") and files.
#pragma once

#include <optional>
#include <string>

#include "io/surface_files.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// True if `spec` names a generator: all of it, or what stands before its first ':'. (A file of such a name
/// is "./sphere".)
bool is_generated(const std::string& spec);

/// The surface of a specification "name" or "name:key=value,key=value"; keys that are not given have the
/// presets that `list_surfaces` shows. Closed, 2-manifold, oriented outward, free of self-intersections; the
/// same bytes on every machine. Smooth ones carry their parametric definition, and each vertex is bit for bit
/// what `evaluate` gives at each of its corners. InputError, one line, for an unknown name or key, a value
/// that is no number, not finite or out of range.
TriangleSurface make_surface(const std::string& spec);

/// The volume [length^3] that the smooth body (not its triangulation) encloses, where it is known: in closed
/// form, or by quadrature converged to 1e-12 of it. Errors as `make_surface`.
std::optional<double> exact_volume(const std::string& spec);

/// A generated surface, or one read from a file (.stl .off .obj .ply; triangles of a .msh, .smesh or .poly).
TriangleSurface open_surface(const std::string& file_or_spec, const ReadOptions& options = {});
/// As `open_surface`, with what the reader of a file has to say about it.
SurfaceFile open_surface_file(const std::string& file_or_spec, const ReadOptions& options = {});

/// A text for users: each generator with its parameters, presets, ranges, meanings and known volume.
std::string list_surfaces();

}  // namespace tetproof::corpus
