// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/medit/medit_solution.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>

#include "io/mesh_files.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

constexpr std::array<MeditSolutionKeyword, 8> keywords{{{medit_sol_at_vertices, "SolAtVertices", 0},
                                                        {63, "SolAtEdges", 1},
                                                        {64, "SolAtTriangles", 2},
                                                        {65, "SolAtQuadrilaterals", 3},
                                                        {66, "SolAtTetrahedra", 4},
                                                        {67, "SolAtPrisms", 6},
                                                        {68, "SolAtHexahedra", 5},
                                                        {26, "SolAtPyramids", 7}}};

// Of each number of a symmetric tensor in a file, row by row of its lower half: one of its places in nine.
constexpr std::array<std::size_t, 6> lower_half{0, 3, 4, 6, 7, 8};
constexpr std::size_t mirrored(std::size_t place) {
  return place % 3 * 3 + place / 3;
}

bool is_symmetric(const Values& values) {
  for (std::size_t i = 0; i + 9 <= values.reals.size(); i += 9)
    for (const std::size_t k : {1, 2, 5})
      if (std::bit_cast<std::uint64_t>(values.reals[i + k]) !=
          std::bit_cast<std::uint64_t>(values.reals[i + mirrored(k)]))
        return false;
  return true;
}

std::vector<std::string> beside(const std::string& path, const std::vector<std::string>& endings) {
  std::vector<std::string> files;
  const std::string stem = path.substr(0, path.size() - ending_of(path).size());
  for (const std::string& ending : endings) files.push_back(stem + ending);
  return files;
}

}  // namespace

int medit_numbers(std::int64_t field, int dimension) {
  switch (field) {
    case 1:
      return 1;
    case 2:
      return dimension;
    case 3:
      return dimension * (dimension + 1) / 2;
    case 4:
      return dimension * dimension;
    default:
      return 0;
  }
}

const MeditSolutionKeyword* medit_solution_keyword(int code) {
  for (const MeditSolutionKeyword& keyword : keywords)
    if (keyword.code == code) return &keyword;
  return nullptr;
}

const MeditSolutionKeyword* medit_solution_keyword(std::string_view name) {
  if (name == "SolAtPentahedra") name = "SolAtPrisms";
  for (const MeditSolutionKeyword& keyword : keywords)
    if (keyword.name == name) return &keyword;
  return nullptr;
}

const MeditSolutionKeyword* medit_solution_keyword_of(int element) {
  for (const MeditSolutionKeyword& keyword : keywords)
    if (keyword.element == element) return &keyword;
  return nullptr;
}

std::string medit_field_name(std::size_t k) {
  return k == 0 ? "solution" : fmt::format("solution {}", k + 1);
}

std::vector<Values> medit_values(const MeditSolution& solution) {
  std::vector<Values> all;
  std::size_t row = 0;
  for (const int field : solution.fields)
    row += static_cast<std::size_t>(medit_numbers(field, solution.dimension));
  std::size_t first = 0;
  const auto dimension = static_cast<std::size_t>(solution.dimension);
  for (std::size_t f = 0; f < solution.fields.size(); ++f) {
    const auto field = static_cast<MeditField>(solution.fields[f]);
    const auto here = static_cast<std::size_t>(medit_numbers(solution.fields[f], solution.dimension));
    const std::size_t each = field == MeditField::scalar ? 1 : field == MeditField::vector ? 3 : 9;
    Values& values = all.emplace_back();
    values.name = medit_field_name(f);
    values.components = static_cast<int>(each);
    values.reals.resize(each * solution.count);
    for (std::size_t i = 0; i < solution.count; ++i) {
      const double* from = solution.numbers.data() + i * row + first;
      double* to = values.reals.data() + i * each;
      for (std::size_t k = 0; k < here; ++k)
        if (field == MeditField::symmetric)
          to[lower_half[k]] = to[mirrored(lower_half[k])] = from[k];
        else if (field == MeditField::matrix)
          to[k / dimension * 3 + k % dimension] = from[k];
        else
          to[k] = from[k];
    }
    first += here;
  }
  return all;
}

int medit_field_of(const Values& values, std::size_t items) {
  if (!plain_numbers(values, items) || values.reals.empty()) return 0;
  return values.components == 1                           ? 1
         : values.components == 3                         ? 2
         : values.components == 9 && is_symmetric(values) ? 3
         : values.components == 9                         ? 4
                                                          : 0;
}

void add_medit_numbers(const Values& values, int field, std::size_t item, std::vector<double>& numbers) {
  const auto each = static_cast<std::size_t>(values.components);
  const double* from = values.reals.data() + item * each;
  if (static_cast<MeditField>(field) == MeditField::symmetric)
    for (const std::size_t place : lower_half) numbers.push_back(from[place]);
  else
    numbers.insert(numbers.end(), from, from + each);
}

std::vector<std::string> medit_solutions_beside(const std::string& mesh) {
  const std::string ending = ending_of(mesh);
  if (ending == ".mesh") return beside(mesh, {".sol", ".solb"});
  if (ending == ".meshb") return beside(mesh, {".solb", ".sol"});
  return is_medit_solution(mesh) ? std::vector<std::string>{} : beside(mesh, {".sol", ".solb"});
}

std::vector<std::string> medit_meshes_beside(const std::string& solution) {
  const std::string ending = ending_of(solution);
  if (ending == ".sol") return beside(solution, {".mesh", ".meshb"});
  if (ending == ".solb") return beside(solution, {".meshb", ".mesh"});
  return {};
}

bool is_medit_solution(const std::string& path) {
  return !medit_meshes_beside(path).empty();
}

std::vector<std::string> medit_files_read(const std::string& path) {
  std::vector<std::string> files{path};
  for (const std::string& other :
       is_medit_solution(path) ? medit_meshes_beside(path) : medit_solutions_beside(path)) {
    std::error_code unknown;
    if (!std::filesystem::exists(other, unknown)) continue;
    files.push_back(other);
    break;
  }
  return files;
}

}  // namespace tetproof::io
