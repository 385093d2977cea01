// SPDX-License-Identifier: GPL-3.0-or-later
// The files that every page holds, as they are put into the library when it is built (io/page/embed.cmake).
#pragma once

#include <string_view>

namespace tetproof::io {

/// A file of the page and the hash of its bytes, by which the page's security policy admits it and nothing
/// else.
struct Resource {
  std::string_view text;
  std::string_view sha256;  ///< 64 hexadecimal digits
};

extern const Resource three_js;  ///< three.js, the library that draws; by its authors, MIT licence
extern const Resource orbit_js;  ///< its OrbitControls: turning and zooming
// The page's own scripts. Each uses those before it.
extern const Resource scene_js;     ///< what the page knows of the mesh, and measures
extern const Resource cut_js;       ///< the tetrahedra behind a plane
extern const Resource drawing_js;   ///< triangles, edges and colours
extern const Resource overlay_js;   ///< words over the view
extern const Resource viewer_js;    ///< the view
extern const Resource controls_js;  ///< the switches beside it

extern const Resource page_css;  ///< the page's style

}  // namespace tetproof::io
