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

extern const Resource three_js;   ///< three.js, the library that draws; by its authors, MIT licence
extern const Resource orbit_js;   ///< its OrbitControls: turning and zooming
extern const Resource viewer_js;  ///< the page's own script
extern const Resource page_css;   ///< the page's style

}  // namespace tetproof::io
