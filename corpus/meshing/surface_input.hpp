// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as the file that a mesher needs to fill it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/error.hpp"
#include "io/triangle_surface.hpp"

namespace tetproof::corpus {

/// A format asks for a point in each cavity, and there is no double in one of them.
struct NoPointInCavity : InputError {
  using InputError::InputError;
};

/// What a mesher is given.
struct SurfaceInput {
  std::vector<std::string> files;  ///< the file first, then those that it needs beside it
  /// The surface as the file has it, if the format rounds coordinates.
  std::shared_ptr<const TriangleSurface> given{};
};

/// Writes `STEM + ending`. Beside the formats of io/surface_files.hpp: .smesh for TetGen, with a point in
/// each cavity; .msh for Gmsh, one surface for each part; .geo, which merges such a .msh and bounds one
/// volume by each outer part and the cavities in it. InputError for an unknown ending, for a place that
/// cannot be written, or for a cavity in which no point can be named.
SurfaceInput write_surface_input(const std::string& stem, const std::string& ending,
                                 const TriangleSurface& surface);

}  // namespace tetproof::corpus
