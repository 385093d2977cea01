// SPDX-License-Identifier: GPL-3.0-or-later
// Declares and parses the options of tetproof-mesh. Not installed.
#pragma once

#include <optional>
#include <string>

#include "io/mesh_files.hpp"
#include "io/program/program.hpp"
#include "reference/figure/figure.hpp"
#include "reference/generate.hpp"

namespace tetproof::reference {

/// The command line's arguments. Empty `cells`: the default, raised where the grid would be empty.
struct Arguments {
  std::string surface, grid, trace, cells, points = "auto", v0 = "0.2", v1 = "2", e_avg = "0";
  std::string figure;  ///< a path; empty: none
  /// Of the figure. Without them: a plane's cut, through the middle, with a title from the surface's name.
  std::optional<std::string> view, plane, title;
  ReadOptions read;  ///< of the surface
  FigureColour colour = FigureColour::volume;
  Options options;
  AdaptOptions adapt;
  int voxels = 128;
  int reduce = 0;  ///< triangles; 0: the surface as it is
  bool list_surfaces = false, timings = false, ascii = false, binary = false;
  std::string html;          ///< a path; empty: no page
  std::string save_surface;  ///< a path; empty: the surface is not written
};

/// Adds all options to `app`, which fills `a`.
void declare_options(CLI::App& app, Arguments& a);

/// Makes the options for `generate`: parses the arguments that are texts and checks all. Throws InputError.
Options generate_options(const Arguments& a);

/// Makes the options for `figure`: parses the view, and the plane, which depends on the surface. Throws
/// InputError.
FigureOptions figure_options(const Arguments& a, const TriangleSurface& surface);

}  // namespace tetproof::reference
