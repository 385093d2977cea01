// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises the formats that we read.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/content/content.hpp"
#include "io/content/head.hpp"
#include "io/obj/obj_statements.hpp"

namespace tetproof::io {
namespace {

std::optional<Content> gmsh(std::string_view bytes) {
  Scanner scanner = head_scanner(bytes);
  const std::string_view word = scanner.word();
  if (word == "$NOD" || word == "$NOE") return Content{"msh22", "a Gmsh .msh 1 file", {}};
  if (word == "$Comments") return Content{"msh41", "a Gmsh .msh file", {}};
  if (word != "$MeshFormat") return {};
  const std::string_view version = scanner.word();
  const std::string format = version.starts_with("4.1") ? "msh41"
                             : version.starts_with('4') ? "msh40"
                                                        : "msh22";
  double number;
  return Content{format,
                 parse_real(version, number) ? fmt::format("a Gmsh .msh {} file", version)
                                             : std::string("a Gmsh .msh file"),
                 {}};
}

// The first line of a VTK file is a comment for OFF and OBJ, so the third line counts, too. The second is any
// text.
std::optional<Content> vtk(std::string_view bytes) {
  Scanner scanner = head_scanner(bytes);
  if (!lower_case(scanner.rest_of_line()).starts_with("# vtk datafile version")) return {};
  for (int line = 0; line < 2; ++line) scanner.next_line();
  const std::string form = lower_case(scanner.word());
  if (form != "ascii" && form != "binary") return {};
  return Content{"vtk", "a legacy VTK file", {}};
}

std::optional<Content> vtu(std::string_view bytes) {
  if (!first_tag(bytes).starts_with("<VTKFile")) return {};
  return Content{"vtu", "a VTK XML file", {}};
}

std::optional<Content> medit(std::string_view bytes) {
  if (head_scanner(bytes).word('#') == "MeshVersionFormatted")
    return Content{"medit", "a Medit .mesh file", {}};
  // Binary: the number 1, the version, and the keyword of the dimension.
  if (bytes.size() < 12) return {};
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto number = [&](std::size_t i) { return load<std::int32_t>(bytes.data() + 4 * i, order); };
    if (number(0) == 1 && number(1) >= 1 && number(1) <= 4 && number(2) == 3)
      return Content{"medit", "a Medit .meshb file", {}};
  }
  return {};
}

std::optional<Content> ply(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  if (!bytes.starts_with("ply\n") && !bytes.starts_with("ply\r")) return {};
  return Content{"ply", "a PLY file", {}};
}

// The number of facets of a binary STL file, if its size is right for them.
std::optional<std::size_t> facets_of_binary_stl(std::string_view bytes) {
  if (bytes.size() < 84) return {};
  const std::size_t facets = load<std::uint32_t>(bytes.data() + 80, std::endian::little);
  return bytes.size() == 84 + 50 * facets ? std::optional(facets) : std::nullopt;
}

std::optional<Content> binary_stl(std::string_view bytes) {
  const auto facets = facets_of_binary_stl(bytes);
  if (!facets || *facets == 0) return {};
  return Content{"stl", "a binary STL file", {}};
}

// It needs a header: zeros alone may be what is left of any file.
std::optional<Content> empty_binary_stl(std::string_view bytes) {
  const auto facets = facets_of_binary_stl(bytes);
  if (!facets || *facets > 0 || bytes[0] == '\0') return {};
  return Content{"stl", "a binary STL file", {}};
}

std::optional<Content> text_stl(std::string_view bytes) {
  Scanner scanner = head_scanner(bytes);
  if (lower_case(scanner.word().substr(0, 6)) != "solid") return {};
  scanner.next_line();
  const std::string second = lower_case(scanner.word().substr(0, 9));
  if (second != "facet" && second != "endsolid") return {};
  return Content{"stl", "an STL file", {}};
}

std::optional<Content> off(std::string_view bytes) {
  std::string_view word = head_scanner(bytes).word('#');
  for (const std::string_view prefix : {"ST", "C", "N", "4", "n"})
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  // The counts may follow without a blank: OFF8.
  const bool keyword = word.starts_with("OFF") && word.find_first_not_of("0123456789", 3) == word.npos;
  if (!keyword && lower_case(word.substr(0, 4)) != "off") return {};
  return Content{"off", "an OFF file", {}};
}

// Sure is an OBJ that has a point, and whose first statements are all such as OBJ has.
std::optional<Content> obj(std::string_view bytes) {
  Scanner scanner = head_scanner(bytes.substr(0, head_bytes));
  bool has_point = false;
  for (int statements = 0; statements < 100 && !scanner.at_end('#'); ++statements) {
    const std::string_view word = next_field(scanner);
    if (scanner.remaining() == 0 && bytes.size() > head_bytes) break;  // cut
    if (!is_statement(word)) return {};
    double number;
    if (word == "v")
      for (int k = 0; k < 3; ++k)
        if (!parse_real(next_field(scanner), number)) return {};
    has_point = has_point || word == "v";
    skip_statement(scanner);
  }
  if (!has_point) return {};
  return Content{"obj", "a Wavefront OBJ file", {}};
}

}  // namespace

// The header of a binary STL may be any text, also the start of another format: its size speaks first. A size
// of 84 bytes with zeros at the end says little, and speaks last.
std::vector<Content> own_contents(std::string_view bytes) {
  std::vector<Content> contents;
  for (const auto recognise : {binary_stl, gmsh, vtk, vtu, medit, ply, text_stl, off, obj, empty_binary_stl})
    if (std::optional<Content> content = recognise(bytes)) contents.push_back(std::move(*content));
  return contents;
}

}  // namespace tetproof::io
