// SPDX-License-Identifier: GPL-3.0-or-later
// The table of Medit's keywords, and the numbers of sections of a fixed form.
#include "io/medit/medit_keywords.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/scanner.hpp"
#include "io/bytes/text_output.hpp"

namespace tetproof::io {
namespace {

// clang-format off
constexpr MeditKeyword keywords[] = {
    {5, "Edges", 1, ""}, {25, "EdgesP2", 8, ""}, {6, "Triangles", 2, ""}, {24, "TrianglesP2", 9, ""},
    {7, "Quadrilaterals", 3, ""}, {27, "QuadrilateralsQ2", 10, ""}, {8, "Tetrahedra", 4, ""},
    {30, "TetrahedraP2", 11, ""}, {9, "Prisms", 6, ""}, {86, "PrismsP2", 13, ""}, {10, "Hexahedra", 5, ""},
    {33, "HexahedraQ2", 12, ""}, {49, "Pyramids", 7, ""}, {87, "PyramidsP2", 14, ""},
    {12, "RequiredTetrahedra", 0, "i"}, {no_medit_code, "ParallelVertices", 0, "i"},
    {no_medit_code, "ParallelEdges", 0, "i"}, {no_medit_code, "ParallelTriangles", 0, "i"},
    {no_medit_code, "ParallelQuadrilaterals", 0, "i"}, {no_medit_code, "ParallelTetrahedra", 0, "i"},
    {13, "Corners", 0, "i"}, {14, "Ridges", 0, "i"}, {15, "RequiredVertices", 0, "i"},
    {16, "RequiredEdges", 0, "i"}, {17, "RequiredTriangles", 0, "i"}, {18, "RequiredQuadrilaterals", 0, "i"},
    {19, "TangentAtEdgeVertices", 0, "iii"}, {20, "NormalAtVertices", 0, "ii"},
    {21, "NormalAtTriangleVertices", 0, "iii"}, {22, "NormalAtQuadrilateralVertices", 0, "iiii"},
    {23, "AngleOfCornerBound", 0, "r", false}, {29, "SubDomainFromGeom", 0, "iii"},
    {40, "VerticesOnGeometricVertices", 0, "ii"}, {41, "VerticesOnGeometricEdges", 0, "iirr"},
    {42, "VerticesOnGeometricTriangles", 0, "iirrr"}, {43, "VerticesOnGeometricQuadrilaterals", 0, "iirrr"},
    {44, "EdgesOnGeometricEdges", 0, "ii"}, {50, "BoundingBox", 0, "cc", false},
    {55, "TrianglesOnGeometricTriangles", 0, "ii"}, {56, "TrianglesOnGeometricQuadrilaterals", 0, "ii"},
    {57, "QuadrilateralsOnGeometricTriangles", 0, "ii"}, {58, "QuadrilateralsOnGeometricQuadrilaterals", 0, "ii"},
    {59, "Tangents", 0, "c"}, {60, "Normals", 0, "c"}, {61, "TangentAtVertices", 0, "ii"},
    {77, "Iterations", 0, "i", false}, {78, "Time", 0, "r", false},
    {82, "PeriodicVertices", 0, "ii"}, {83, "PeriodicEdges", 0, "ii"}, {84, "PeriodicTriangles", 0, "ii"},
    {85, "PeriodicQuadrilaterals", 0, "ii"}, {127, "EdgesP2Ordering", 0, "i"},
    {129, "TrianglesP2Ordering", 0, "iii"}, {131, "QuadrilateralsQ2Ordering", 0, "ii"},
    {133, "TetrahedraP2Ordering", 0, "iiii"}, {135, "PyramidsP2Ordering", 0, "iii"},
    {137, "PrismsP2Ordering", 0, "iiii"}, {139, "HexahedraQ2Ordering", 0, "iii"}};
// clang-format on

// Other names that programs give to keywords.
constexpr std::pair<std::string_view, std::string_view> synonyms[] = {
    {"Hexaedra", "Hexahedra"}, {"Pentahedra", "Prisms"}, {"PentahedraP2", "PrismsP2"}};

// The names with Tetrahedra and Parallel are MMG's.
constexpr MeditMark marks[] = {{"Corners", 0},
                               {"RequiredVertices", 0},
                               {"Ridges", 1},
                               {"RequiredEdges", 1},
                               {"RequiredTriangles", 2},
                               {"RequiredQuadrilaterals", 3},
                               {"RequiredTetrahedra", 4},
                               {"ParallelVertices", 0},
                               {"ParallelEdges", 1},
                               {"ParallelTriangles", 2},
                               {"ParallelQuadrilaterals", 3},
                               {"ParallelTetrahedra", 4}};

}  // namespace

bool looks_like_medit_keyword(std::string_view word) {
  return !word.empty() && is_medit_letter(word[0]) && std::all_of(word.begin(), word.end(), [](char c) {
    return is_medit_letter(c) || c == '_' || (c >= '0' && c <= '9');
  });
}

const MeditKeyword* medit_keyword(int code) {
  for (const MeditKeyword& keyword : keywords)
    if (keyword.code == code) return &keyword;
  return nullptr;
}

const MeditKeyword* medit_keyword(std::string_view name) {
  for (const auto& [synonym, usual] : synonyms)
    if (name == synonym) name = usual;
  for (const MeditKeyword& keyword : keywords)
    if (keyword.name == name) return &keyword;
  return nullptr;
}

const std::vector<const MeditKeyword*>& medit_elements() {
  static const std::vector<const MeditKeyword*> all = [] {
    std::vector<const MeditKeyword*> found;
    for (const MeditKeyword& keyword : keywords)
      if (keyword.element != 0) found.push_back(&keyword);
    return found;
  }();
  return all;
}

const MeditMark* medit_mark(std::string_view name) {
  for (const MeditMark& mark : marks)
    if (mark.name == name) return &mark;
  return nullptr;
}

std::optional<MeditLines> medit_lines(const MeditKeyword& keyword, const std::string& body, int dimension) {
  const std::string no_path;
  Scanner in(no_path, body);
  MeditLines lines;
  std::int64_t count = 1;
  if (keyword.counted && (!parse_integer(in.word('#'), count) || count < 0)) return std::nullopt;
  if (keyword.element != 0 || static_cast<std::uint64_t>(count) > body.size()) return std::nullopt;
  lines.count = static_cast<std::size_t>(count);
  for (std::int64_t line = 0; line < count; ++line)
    for (const char kind : keyword.format)
      for (int k = 0; k < (kind == 'c' ? dimension : 1); ++k)
        if (kind == 'i') {
          std::int64_t value;
          if (!parse_integer(in.word('#'), value)) return std::nullopt;
          lines.integers.push_back(value);
        } else {
          double value;
          if (!parse_real(in.word('#'), value)) return std::nullopt;
          lines.reals.push_back(value);
        }
  return in.at_end('#') ? std::optional(std::move(lines)) : std::nullopt;
}

std::string medit_body(const MeditKeyword& keyword, const MeditLines& lines, int dimension) {
  char number[longest_real];
  const auto text = [&](auto value) { return std::string(number, put(number, value)); };
  std::string body = keyword.counted ? text(static_cast<std::int64_t>(lines.count)) : "";
  std::size_t integer = 0, real = 0;
  for (std::size_t line = 0; line < lines.count; ++line) {
    if (!body.empty()) body += '\n';
    const char* between = "";
    for (const char kind : keyword.format)
      for (int k = 0; k < (kind == 'c' ? dimension : 1); ++k, between = " ") {
        body += between;
        body += kind == 'i' ? text(lines.integers[integer++]) : text(lines.reals[real++]);
      }
  }
  return body;
}

}  // namespace tetproof::io
