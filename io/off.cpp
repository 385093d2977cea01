// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/off.hpp"

#include <fmt/core.h>

#include <limits>

#include "io/polygons.hpp"
#include "io/surface_lines.hpp"

namespace tetproof::io {
namespace {

// [ST][C][N][4][n]OFF; what may follow without a blank, as in "OFF8 6 12", is left to be read. A file without
// keyword starts with its counts.
std::size_t keyword_length(std::string_view bytes, Scanner& scanner) {
  const std::string_view word = scanner.peek_word('#');
  std::size_t at = 0;
  const auto skip = [&](std::string_view letters) {
    if (word.substr(at, letters.size()) != letters) return false;
    at += letters.size();
    return true;
  };
  skip("ST"), skip("C"), skip("N");
  const bool four = skip("4"), many = skip("n");
  std::int64_t number;
  if (!skip("OFF")) {
    if (parse_integer(word, number)) return 0;
    scanner.word('#');
    scanner.fail("OFF or the number of vertices", word);
  }
  if (four || many)
    scanner.fail_in_line(fmt::format("expected three coordinates a vertex, found {}", word.substr(0, at)));
  return static_cast<std::size_t>(word.data() - bytes.data()) + at;
}

// Colours, normals and the like.
void skip_numbers(Scanner& scanner) {
  while (!scanner.at_line_end('#')) scanner.real("a number or the end of the line", '#');
}

}  // namespace

TriangleSurface read_off(const InputFile& file) {
  Scanner start(file);
  start.at_end('#');
  Scanner scanner(file.path(), file.bytes(), keyword_length(file.bytes(), start));
  if (scanner.peek_word('#') == "BINARY") scanner.fail_in_line("expected OFF as text, found binary OFF");

  Polygons polygons;
  const std::int64_t points = scanner.count("the number of vertices", 6, '#');
  const std::int64_t faces = scanner.count("the number of faces", 2, '#');
  if (!scanner.at_line_end('#')) scanner.integer("the number of edges", '#');

  polygons.points.reserve(points);
  for (std::int64_t i = 0; i < points; ++i) {
    Eigen::Vector3d& point = polygons.points.emplace_back();
    for (int k = 0; k < 3; ++k) point[k] = scanner.real("a coordinate", '#');
    skip_numbers(scanner);
  }
  polygons.ends.reserve(faces);
  polygons.places.reserve(faces);
  for (std::int64_t i = 0; i < faces; ++i) {
    scanner.at_end('#');
    polygons.places.push_back(scanner.offset());
    const std::int64_t corners = scanner.count("the number of a face's corners", 2, '#');
    for (std::int64_t k = 0; k < corners; ++k) {
      const std::int64_t corner = scanner.integer("a vertex", '#');
      if (corner < 0 || corner >= points)
        scanner.fail_in_line(fmt::format("expected a vertex from 0 to {}, found {}", points - 1, corner));
      polygons.corners.push_back(static_cast<Index>(corner));
    }
    polygons.ends.push_back(polygons.corners.size());
    skip_numbers(scanner);
  }
  if (!scanner.at_end('#'))
    scanner.fail(fmt::format("the end of the file after {} faces", faces), scanner.peek_word('#'));
  return triangulate(std::move(polygons), file);
}

void write_off(AtomicFile& file, const TriangleSurface& surface) {
  file.write(fmt::format("OFF\n{} {} 0\n", surface.vertices.size(), surface.triangles.size()));
  write_points(file, "", surface.vertices);
  write_triangles(file, "3 ", surface.triangles, 0);
}

}  // namespace tetproof::io
