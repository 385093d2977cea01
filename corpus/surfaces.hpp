// SPDX-License-Identifier: GPL-3.0-or-later
// Closed surfaces by name: generated ones ("sphere:r=1,n=5000") and files.
#pragma once

#include <optional>
#include <string>

#include "io/surface_files.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// True if `spec`, or its part before the first ':', is the name of a generator. (A file of such a name is
/// "./sphere".)
bool is_generated(const std::string& spec);

/// The surface of a specification "name" or "name:key=value,key=value". Keys that are not given have the
/// presets that `list_surfaces` shows. It is closed, 2-manifold, oriented outward, free of
/// self-intersections, and has the same bytes on every machine. Smooth surfaces have their parametric
/// definition: `evaluate` gives each vertex bit for bit, at each of its corners. "fuzz:seed=7,case=12" and
/// "fuzz:RECIPE" are random surfaces that are hard for meshers (corpus/fuzz_surface.hpp). InputError, one
/// line, for an unknown name or key, or a value that is no number, not finite or out of range.
TriangleSurface make_surface(const std::string& spec);

/// The volume [length^3] of the smooth body (not of its triangulation), if it is known: in closed form, or by
/// quadrature converged to 1e-12 of it. Of "fuzz:..." that of its triangulation, exact. Errors as
/// `make_surface`.
std::optional<double> exact_volume(const std::string& spec);

/// A generated surface, or one from a file of any format, as `read_surface` reads it.
TriangleSurface open_surface(const std::string& file_or_spec, const ReadOptions& options = {});
/// As `open_surface`, with the warnings of the file's reader and the list of what it dropped.
SurfaceFile open_surface_file(const std::string& file_or_spec, const ReadOptions& options = {});

/// A text for users: each generator with its parameters, presets, ranges, meanings and known volume.
std::string list_surfaces();

}  // namespace tetproof::corpus
