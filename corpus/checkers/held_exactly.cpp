// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/checkers/held_exactly.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "io/document.hpp"
#include "io/error.hpp"
#include "io/writing.hpp"

namespace tetproof::corpus {
namespace {

// NaN has many bit patterns, and text has one word for them.
bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

bool names_a_point(const TetMesh& mesh, Index i) {
  return i >= 0 && static_cast<std::size_t>(i) < mesh.points.size();
}

std::string difference(const TetMesh& wanted, const TetMesh& found) {
  if (wanted.points.size() != found.points.size())
    return fmt::format("{} points instead of {}", found.points.size(), wanted.points.size());
  for (std::size_t i = 0; i < wanted.points.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!same(wanted.points[i][c], found.points[i][c]))
        return fmt::format("a coordinate {} instead of {}", found.points[i][c], wanted.points[i][c]);
  if (wanted.tets.size() != found.tets.size())
    return fmt::format("{} tetrahedra instead of {}", found.tets.size(), wanted.tets.size());
  for (std::size_t t = 0; t < wanted.tets.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k) {
      const Index a = wanted.tets[t][k], b = found.tets[t][k];
      if (names_a_point(wanted, a) ? a != b : names_a_point(found, b)) return "another vertex";
    }
  return "";
}

}  // namespace

std::string write_exactly(const std::string& path, const std::string& format, const TetMesh& mesh) {
  try {
    const Document document = document_of(mesh);
    PlannedFile file(
        path, document,
        {.format = format, .binary = format_named(format).ascii ? std::optional(false) : std::nullopt});
    // What is kept aside, only our own reader finds again. Only what is part of the mesh counts.
    for (const Loss& loss : file.losses())
      if (loss.elements) return fmt::format("{}: no place for {}", format, loss.item);
    for (const Loss& item : file.kept_aside().items)
      return fmt::format("{}: no place for {} that other readers see", format, item.item);
    file.write();
    const std::string other = difference(mesh, tet_mesh(read_document(path)));
    return other.empty() ? "" : format + ": " + other;
  } catch (const InputError& error) {
    return fmt::format("{}: {}", format, error.what());
  }
}

}  // namespace tetproof::corpus
