// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>

#include "io/off/off.hpp"
#include "io/surface/surface_lines.hpp"

namespace tetproof::io {
namespace {

// Many programs take a face of fewer than three corners for an error, or a comment. They are written where
// they stood in an OFF.
bool came_from_off(const Document& document) {
  return document.format == "off";
}

// The values that OFF has a place for.
struct Kept {
  const Values *normal = nullptr, *color = nullptr, *texture = nullptr;
  RowsOf face_colors;

  explicit Kept(const Document& document) : face_colors(document.elements()) {
    const std::size_t nodes = document.points.size();
    for (const Values& values : document.node_values) {
      const auto take = [&](const Values*& place, const char* name) {
        if (!place && values.name == name) place = &values;
      };
      RowsOf rows(nodes);  // that every number may be read as a double first
      if (!of_all(values, nodes) || !rows.add(values)) continue;
      if (values.components == 3 && values.integers.empty()) take(normal, "normal");
      if (values.components == 2 && values.integers.empty()) take(texture, "texture");
      if (values.components == 3 || values.components == 4) take(color, "color");
    }
    for (const Values& values : document.element_values)
      if (values.name == "color" &&
          (values.components == 1 || values.components == 3 || values.components == 4))
        face_colors.add(values);
  }
};

}  // namespace

void write_off(AtomicFile& file, const Document& document, bool) {
  const Kept kept(document);
  file.write(
      fmt::format("{}{}{}OFF\n", kept.texture ? "ST" : "", kept.color ? "C" : "", kept.normal ? "N" : ""));
  write_title(file, "#", came_from_off(document) && title_in_lines(document.title) ? document.title : "");
  std::vector<KeptElement> faces;
  for_each_kept(document, [&](const KeptElement& face) {
    if (face.corners >= 3 || came_from_off(document)) faces.push_back(face);
  });
  file.write(fmt::format("{} {} 0\n", document.points.size(), faces.size()));

  write_items(file, document.points.size(), 12 * (longest_decimal + 1), [&](std::size_t i, char* to) {
    to = put_point(to, document.points[i]);
    for (const Values* values : {kept.normal, kept.color, kept.texture})
      if (values) to = put_row(to, *values, i);
    return put(to, '\n');
  });
  std::size_t most = 0;
  for (const KeptElement& face : faces) most = std::max(most, static_cast<std::size_t>(face.corners));
  const std::size_t longest = (most + 1) * 12 + 4 * (longest_decimal + 1) + 1;
  write_items(file, faces.size(), longest, [&](std::size_t i, char* to) {
    const KeptElement& face = faces[i];
    to = put(to, face.corners);
    for (int k = 0; k < face.corners; ++k) to = put(put(to, ' '), face.nodes[k]);
    std::size_t row = 0;
    if (const Values* colors = kept.face_colors.find(face.element, row)) to = put_row(to, *colors, row);
    return put(to, '\n');
  });
}

Holds off_holds(const Document& document, bool) {
  const auto nodes_each = [thin = came_from_off(document)](const ElementBlock& block) {
    const int corners = corners_kept(block);
    return corners >= 3 || thin ? corners : 0;
  };
  const bool all = keeps_all_elements(document, nodes_each);
  const Kept kept(document);
  std::vector<const Values*> held{kept.normal, kept.color, kept.texture};
  if (all) held.insert(held.end(), kept.face_colors.held().begin(), kept.face_colors.held().end());
  Holds holds;
  holds.title = came_from_off(document) && title_in_lines(document.title);  // other readers take no comments
  holds.nodes_each = nodes_each;
  holds.values = [held](const Values& values, Of) {
    return std::find(held.begin(), held.end(), &values) != held.end();
  };
  return holds;
}

}  // namespace tetproof::io
