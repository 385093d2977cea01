// SPDX-License-Identifier: GPL-3.0-or-later
// Medit's solutions: values of vertices or elements under keywords such as SolAtVertices, mostly in a .sol or
// .solb beside the mesh.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The type of a field, as a file tells it.
enum class MeditField { scalar = 1, vector = 2, symmetric = 3, matrix = 4 };
/// How many numbers a value of a field has in a file of this dimension; 0: there is no such type.
int medit_numbers(std::int64_t field, int dimension);

/// A keyword for values: the Gmsh type of the elements that have them; 0: vertices.
struct MeditSolutionKeyword {
  int code;
  std::string_view name;
  int element;
};
const MeditSolutionKeyword* medit_solution_keyword(int code);
const MeditSolutionKeyword* medit_solution_keyword(std::string_view name);
const MeditSolutionKeyword* medit_solution_keyword_of(int element);
inline constexpr int medit_sol_at_vertices = 62;

/// What follows such a keyword.
struct MeditSolution {
  const MeditSolutionKeyword* keyword = nullptr;
  int dimension = 3;
  std::size_t count = 0;        ///< of vertices or elements
  std::vector<int> fields;      ///< their types
  std::vector<double> numbers;  ///< all fields of the first vertex, of the second, ...
};

/// The name of field k, from 0: "solution", "solution 2", ... Files have no names.
std::string medit_field_name(std::size_t k);

/// The values of each field. Vectors have three components, tensors nine, row by row; what a file of
/// dimension 2 lacks is 0.
std::vector<Values> medit_values(const MeditSolution& solution);

/// The field as which a file of dimension 3 has these values; none (0) if it cannot have them. They must be
/// reals, one value for each of `items`. A tensor that is symmetric, bit by bit, is written as such.
int medit_field_of(const Values& values, std::size_t items);
/// Adds the numbers of one item for such a field.
void add_medit_numbers(const Values& values, int field, std::size_t item, std::vector<double>& numbers);

/// The files that belong to a mesh (or to a solution) if they exist, the first one before the second. Empty
/// for a solution (for a file that is none by its ending).
std::vector<std::string> medit_solutions_beside(const std::string& mesh);
std::vector<std::string> medit_meshes_beside(const std::string& solution);
bool is_medit_solution(const std::string& path);
/// The files that are read when `path` is: the one named, and a mesh or solution beside it.
std::vector<std::string> medit_files_read(const std::string& path);

}  // namespace tetproof::io
