// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/off.hpp"

#include <fmt/core.h>

#include <algorithm>

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

  const std::int64_t vertices = scanner.count("the number of vertices", 6, '#');
  const std::int64_t faces = scanner.count("the number of faces", 2, '#');
  if (!scanner.at_line_end('#')) scanner.integer("the number of edges", '#');

  std::vector<Eigen::Vector3d> points;
  points.reserve(vertices);
  for (std::int64_t i = 0; i < vertices; ++i) {
    Eigen::Vector3d& point = points.emplace_back();
    scanner.at_end('#');
    for (int k = 0; k < 3; ++k) point[k] = scanner.real_in_line("a coordinate", '#');
    skip_numbers(scanner);
  }
  SurfaceFaces surface(file, std::move(points), 0, true);
  surface.reserve(
      std::min<std::size_t>(faces, scanner.remaining() / 7));  // no triangle is shorter than "3 0 1 2"
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < faces; ++i) {
    scanner.at_end('#');
    const std::size_t place = scanner.offset();
    corners.resize(scanner.count("the number of a face's corners", 2, '#'));
    for (std::int64_t& corner : corners) corner = scanner.integer_in_line("a vertex", '#');
    skip_numbers(scanner);
    surface.add(corners, place);
  }
  if (!scanner.at_end('#')) {
    const std::string_view found = scanner.word('#');
    scanner.fail(fmt::format("the end of the file after {} faces", faces), found);
  }
  return surface.take();
}

void write_off(AtomicFile& file, const TriangleSurface& surface) {
  file.write(fmt::format("OFF\n{} {} 0\n", surface.vertices.size(), surface.triangles.size()));
  write_points(file, "", surface.vertices);
  write_triangles(file, "3 ", surface.triangles, 0);
}

}  // namespace tetproof::io
