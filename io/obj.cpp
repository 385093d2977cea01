// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/polygons.hpp"
#include "io/surface_lines.hpp"

namespace tetproof::io {
namespace {

// Statements without points or polygons of ours. A misspelt `v` must not vanish silently: it would shift all
// numbers.
constexpr std::array<std::string_view, 42> skipped{
    "vt",     "vn",     "vp",     "cstype",     "deg",       "bmat",     "step",     "p",   "l",
    "curv",   "curv2",  "parm",   "trim",       "hole",      "scrv",     "sp",       "end", "con",
    "g",      "s",      "mg",     "o",          "bevel",     "c_interp", "d_interp", "lod", "usemtl",
    "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj", "ctech",    "stech",    "bsp", "bzp",
    "cdc",    "cdp",    "res",    "call",       "csh",       "mtlib"};

// The next word of a statement, which goes on in the next line where a line ends in a backslash; empty at the
// statement's end.
std::string_view next_field(Scanner& scanner) {
  while (!scanner.at_line_end('#')) {
    std::string_view field = scanner.word('#');
    if (field.back() != '\\' || !scanner.ends_line()) return field;
    scanner.next_line();
    field.remove_suffix(1);
    if (!field.empty()) return field;
  }
  return {};
}

void skip_statement(Scanner& scanner) {
  for (;;) {
    const std::string_view line = scanner.rest_of_line();
    if (line.empty() || line.back() != '\\' || line.find('#') != line.npos || scanner.remaining() == 0)
      return;
    scanner.next_line();
  }
}

double real_field(Scanner& scanner) {
  const std::string_view field = next_field(scanner);
  double value;
  if (!parse_real(field, value))
    field.empty() ? scanner.fail_in_line("expected 3 coordinates, found fewer")
                  : scanner.fail("a coordinate", field);
  return value;
}

// The point of i, i/t, i//n or i/t/n, counted from 0.
std::int64_t corner_of(std::string_view field, std::int64_t points_above, const Scanner& scanner) {
  const std::string_view number = field.substr(0, field.find('/'));
  const std::string_view rest = field.substr(number.size());
  std::int64_t value;
  if (!parse_integer(number, value) || value == 0 || rest.find_first_not_of("/-0123456789") != rest.npos ||
      std::count(rest.begin(), rest.end(), '/') > 2)
    scanner.fail("a vertex as in 7, 7/1, 7//3, 7/1/3 or -1", field);
  if (value > 0) return value - 1;
  if (value < -points_above)
    scanner.fail_in_line(
        fmt::format("face names vertex {}, but only {} stand above it", value, points_above));
  return points_above + value;
}

bool is_face(std::string_view statement) {
  return statement == "f" || statement == "fo";
}

}  // namespace

TriangleSurface read_obj(const InputFile& file) {
  // First the points, since a face may name points that come later.
  Scanner scanner(file);
  std::vector<Eigen::Vector3d> points;
  std::size_t first_face = file.bytes().size();
  std::int64_t points_above = 0;
  while (!scanner.at_end('#')) {
    const std::size_t place = scanner.offset();
    const std::string_view statement = next_field(scanner);
    if (statement == "v") {
      Eigen::Vector3d& point = points.emplace_back();
      for (int k = 0; k < 3; ++k) point[k] = real_field(scanner);
      double extra;  // a weight or a colour
      for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
        if (!parse_real(field, extra)) scanner.fail("a number or the end of the line", field);
    } else if (is_face(statement)) {
      if (place < first_face) first_face = place, points_above = static_cast<std::int64_t>(points.size());
      skip_statement(scanner);
    } else if (std::find(skipped.begin(), skipped.end(), statement) != skipped.end()) {
      skip_statement(scanner);
    } else if (!statement.empty()) {
      scanner.fail("a statement of OBJ (v, f, ...)", statement);
    }
  }

  SurfaceFaces surface(file, std::move(points), 1, true);
  scanner = Scanner(file.path(), file.bytes(), first_face);
  std::vector<std::int64_t> corners;
  while (!scanner.at_end('#')) {
    const std::size_t place = scanner.offset();
    const std::string_view statement = next_field(scanner);
    points_above += statement == "v";
    if (!is_face(statement)) {
      skip_statement(scanner);
      continue;
    }
    corners.clear();
    for (std::string_view field = next_field(scanner); !field.empty(); field = next_field(scanner))
      corners.push_back(corner_of(field, points_above, scanner));
    surface.add(corners, place);
  }
  return surface.take();
}

void write_obj(AtomicFile& file, const TriangleSurface& surface) {
  write_points(file, "v ", surface.vertices);
  write_triangles(file, "f ", surface.triangles, 1);
}

}  // namespace tetproof::io
