// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the Voronoi diagram as TetGen's .v.node, .v.edge, .v.face and .v.cell.
#include <fmt/format.h>

#include "io/tetgen/tetgen_write_parts.hpp"

namespace tetproof::io {
namespace {

// Returns the number of a position; -1 if there is none.
std::int64_t number(Index position, std::int64_t first) {
  return position < 0 ? -1 : first + position;
}

void write_list(AtomicFile& file, const std::string& start, const std::vector<Index>& items,
                std::int64_t first) {
  std::string line = fmt::format("{} {}", start, items.size());
  for (const Index item : items) line += fmt::format(" {}", number(item, first));
  file.write(line + "\n");
}

}  // namespace

void write_tetgen_voronoi(TetgenFiles& files, const Voronoi& voronoi) {
  const std::int64_t first = voronoi.first;
  AtomicFile& points = files.add(".v.node");
  points.write(fmt::format("{} 3 0 0\n", voronoi.points.size()));
  write_items(points, voronoi.points.size(), 4 * (longest_real + 1), [&](std::size_t i, char* to) {
    to = put(to, first + static_cast<std::int64_t>(i));
    for (double x : voronoi.points[i]) to = put(put(to, ' '), x);
    return put(to, '\n');
  });
  AtomicFile& edges = files.add(".v.edge");
  edges.write(fmt::format("{} 0\n", voronoi.edges.size()));
  write_items(edges, voronoi.edges.size(), 6 * (longest_real + 1), [&](std::size_t i, char* to) {
    const Voronoi::Edge& edge = voronoi.edges[i];
    to = put(to, first + static_cast<std::int64_t>(i));
    for (const Index point : edge.points) to = put(put(to, ' '), number(point, first));
    if (edge.points[1] < 0)
      for (double x : edge.direction) to = put(put(to, ' '), x);
    return put(to, '\n');
  });
  AtomicFile& faces = files.add(".v.face");
  faces.write(fmt::format("{} 0\n", voronoi.faces.size()));
  for (std::size_t i = 0; i < voronoi.faces.size(); ++i) {
    const Voronoi::Face& face = voronoi.faces[i];
    write_list(faces,
               fmt::format("{} {} {}", first + static_cast<std::int64_t>(i), number(face.cells[0], first),
                           number(face.cells[1], first)),
               face.edges, first);
  }
  AtomicFile& cells = files.add(".v.cell");
  cells.write(fmt::format("{}\n", voronoi.cells.size()));
  for (std::size_t i = 0; i < voronoi.cells.size(); ++i)
    write_list(cells, fmt::format("{}", first + static_cast<std::int64_t>(i)), voronoi.cells[i], first);
}

}  // namespace tetproof::io
