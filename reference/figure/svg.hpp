// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of an SVG file. Not installed.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace tetproof::reference::svg {

/// Coordinates in a drawing are whole numbers, in units of 1/fineness pixel: short, and fine enough to
/// magnify.
inline constexpr int fineness = 5;
using Pixel = std::array<int, 2>;  ///< in these units, to the right and down

/// Text for XML. Bytes outside printable ASCII become '?', because they may not be valid UTF-8.
std::string escaped(const std::string& text);

/// The data of a path: closed polygons or open lines, in relative coordinates.
class PathData {
 public:
  void add(const std::vector<Pixel>& points, bool closed);
  /// A closed polygon without repeated points; one of fewer than three is too small to be seen and left out.
  void add_polygon(const std::vector<Pixel>& points);
  const std::string& text() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  std::string text_;
  Pixel at_{0, 0};
};

/// Joins segments that share an end into lines that are as long as possible.
PathData chained(const std::vector<std::array<Pixel, 2>>& segments);

/// A picture with its title above, its caption below and its legend beside it. Sizes are in pixels; `drawing`
/// is in units of 1/fineness pixel, `legend` in pixels, both from their own upper left corner.
struct Page {
  std::string title, drawing, legend;
  std::vector<std::string> caption;  ///< lines
  int width, height, legend_height;
};
std::string page(const Page& page);

}  // namespace tetproof::reference::svg
