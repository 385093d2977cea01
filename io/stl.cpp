// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/stl.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "io/byte_order.hpp"
#include "io/error.hpp"
#include "io/text_output.hpp"
#include "io/weld.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

bool same_word(std::string_view word, std::string_view lower) {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if ((word[i] >= 'A' && word[i] <= 'Z' ? word[i] - 'A' + 'a' : word[i]) != lower[i]) return false;
  return true;
}

void expect(Scanner& scanner, std::string_view lower) {
  const std::string_view word = scanner.word();
  if (!same_word(word, lower)) scanner.fail(fmt::format("'{}'", lower), word);
}

// Every three points are a facet.
TriangleSurface surface_of(std::vector<Eigen::Vector3d> points, const InputFile& file) {
  if (points.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw InputError(
        fmt::format("{}: {} facets, at most 715827882 can be numbered", file.path(), points.size() / 3));
  TriangleSurface surface;
  const std::vector<Index> moved = weld(points);
  surface.vertices = std::move(points);
  surface.triangles.reserve(moved.size() / 3);
  for (std::size_t i = 0; i + 2 < moved.size(); i += 3)
    surface.triangles.push_back({moved[i], moved[i + 1], moved[i + 2]});
  return surface;
}

// How many facets a binary file of this size holds; none if it is text.
std::optional<std::size_t> binary_facets(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  if (bytes.size() >= header_bytes) {
    const std::size_t announced = load<std::uint32_t>(bytes.data() + 80, std::endian::little);
    const std::size_t facets = (bytes.size() - header_bytes) / facet_bytes;
    const bool whole = (bytes.size() - header_bytes) % facet_bytes == 0;
    if (whole && (announced == facets || announced == 0)) return facets;
    // No text has a zero byte: a binary file that lost its end, or its count.
    if (bytes.substr(0, header_bytes).find('\0') != bytes.npos)
      throw InputError(
          fmt::format("{}: byte 80: expected {} bytes for the {} facets announced here, found {}",
                      file.path(), header_bytes + facet_bytes * announced, announced, bytes.size()));
  }
  return {};
}

TriangleSurface read_binary(const InputFile& file, std::size_t facets) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(3 * facets);
  for (std::size_t i = 0; i < facets; ++i) {
    const char* from = file.bytes().data() + header_bytes + facet_bytes * i + 12;  // past the normal
    for (int corner = 0; corner < 3; ++corner, from += 12)
      points.emplace_back(load<float>(from, std::endian::little), load<float>(from + 4, std::endian::little),
                          load<float>(from + 8, std::endian::little));
  }
  return surface_of(std::move(points), file);
}

// From behind "facet" to behind "endfacet".
void read_facet(Scanner& scanner, std::vector<Eigen::Vector3d>& points) {
  std::string_view word = scanner.word();
  if (same_word(word, "normal")) {  // three words that nobody needs; some writers put "-nan(ind)" there
    word = scanner.word();
    for (int k = 0; k < 3 && !same_word(word, "outer"); ++k) word = scanner.word();
  }
  if (!same_word(word, "outer")) scanner.fail("'outer loop'", word);
  expect(scanner, "loop");
  int vertices = 0;
  while (same_word(word = scanner.word(), "vertex")) {
    Eigen::Vector3d point;
    for (int k = 0; k < 3; ++k) point[k] = scanner.real("a coordinate");
    if (++vertices <= 3) points.push_back(point);
  }
  if (!same_word(word, "endloop")) scanner.fail("'vertex' or 'endloop'", word);
  if (vertices != 3) scanner.fail_in_line(fmt::format("facet has {} vertices, expected 3", vertices));
  expect(scanner, "endfacet");
}

TriangleSurface read_text(const InputFile& file) {
  Scanner scanner(file);
  std::vector<Eigen::Vector3d> points;
  std::string_view word = scanner.word();
  if (!same_word(word, "solid") && !same_word(word, "facet")) scanner.fail("'solid'", word);
  for (; !word.empty(); word = scanner.word()) {
    if (same_word(word, "facet"))
      read_facet(scanner, points);
    else if (same_word(word, "solid") || same_word(word, "endsolid"))
      scanner.rest_of_line();  // a name, or none
    else
      scanner.fail("'facet', 'endsolid' or 'solid'", word);
  }
  return surface_of(std::move(points), file);
}

// Of length 1, or 0 for a triangle without direction.
Eigen::Vector3f normal(const TriangleSurface& surface, const std::array<Index, 3>& t) {
  const Eigen::Vector3d& a = surface.vertices[t[0]];
  Eigen::Vector3d b = surface.vertices[t[1]] - a, c = surface.vertices[t[2]] - a;
  b /= b.cwiseAbs().maxCoeff(), c /= c.cwiseAbs().maxCoeff();  // so that nothing over- or underflows
  const Eigen::Vector3d n = b.cross(c);
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (n / length).cast<float>() + Eigen::Vector3f::Zero();  // without -0
}

}  // namespace

TriangleSurface read_stl(const InputFile& file) {
  if (const auto facets = binary_facets(file)) return read_binary(file, *facets);
  return read_text(file);
}

void write_stl_binary(AtomicFile& file, const TriangleSurface& surface) {
  if (surface.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw InputError(
        fmt::format("STL counts at most 4294967295 triangles, found {}", surface.triangles.size()));
  char header[header_bytes] = "binary STL written by tetproof";  // "solid" would make others take it for text
  store(header + 80, static_cast<std::uint32_t>(surface.triangles.size()), std::endian::little);
  file.write({header, header_bytes});
  write_items(file, surface.triangles.size(), facet_bytes, [&](std::size_t i, char* to) {
    const auto& t = surface.triangles[i];
    const Eigen::Vector3f n = normal(surface, t);
    for (int k = 0; k < 3; ++k) to = store(to, n[k], std::endian::little);
    for (const Index corner : t)
      for (int k = 0; k < 3; ++k)
        to = store(to, static_cast<float>(surface.vertices[corner][k]), std::endian::little);
    return store(to, std::uint16_t{0}, std::endian::little);
  });
}

void write_stl_text(AtomicFile& file, const TriangleSurface& surface) {
  constexpr std::string_view words[]{"facet normal", "\nouter loop\n", "vertex", "endloop\nendfacet\n"};
  const auto put_text = [](char* to, std::string_view text) {
    return std::copy(text.begin(), text.end(), to);
  };
  file.write("solid tetproof\n");
  write_items(file, surface.triangles.size(), 512, [&](std::size_t i, char* to) {
    const auto& t = surface.triangles[i];
    const Eigen::Vector3f n = normal(surface, t);
    to = put_text(to, words[0]);
    for (int k = 0; k < 3; ++k) to = std::to_chars(put(to, ' '), to + 32, n[k]).ptr;
    to = put_text(to, words[1]);
    for (const Index corner : t) {
      to = put_text(to, words[2]);
      for (int k = 0; k < 3; ++k) to = put(put(to, ' '), surface.vertices[corner][k]);
      to = put(to, '\n');
    }
    return put_text(to, words[3]);
  });
  file.write("endsolid tetproof\n");
}

}  // namespace tetproof::io
