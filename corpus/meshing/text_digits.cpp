// SPDX-License-Identifier: GPL-3.0-or-later
// Counts digits in the text of a mesh file.
#include "corpus/meshing/text_digits.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <set>
#include <string>
#include <string_view>

#include "io/mesh_files.hpp"

namespace tetproof::corpus {

namespace {

constexpr std::size_t bytes_to_read = 4 << 20;  // some 70,000 points: the most digits show long before

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ',';
}

/// The digits of one word; 0 if it is no number with a point or an exponent.
int digits_of(std::string_view word) {
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) word.remove_prefix(1);
  int digits = 0;
  bool point = false, exponent = false, started = false;
  std::size_t i = 0;
  for (; i < word.size(); ++i) {
    if (is_digit(word[i])) {
      started |= word[i] != '0';
      digits += started;
    } else if (word[i] == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (i < word.size() && i > 0 && (word[i] == 'e' || word[i] == 'E' || word[i] == 'd' || word[i] == 'D')) {
    exponent = true;
    if (++i < word.size() && (word[i] == '-' || word[i] == '+')) ++i;
    const std::size_t first = i;
    while (i < word.size() && is_digit(word[i])) ++i;
    if (i == first) return 0;
  }
  return i == word.size() && (point || exponent) ? digits : 0;
}

}  // namespace

int most_digits(std::string_view text) {
  int most = 0;
  for (std::size_t at = 0; at < text.size();) {
    while (at < text.size() && is_space(text[at])) ++at;
    const std::size_t begin = at;
    while (at < text.size() && !is_space(text[at])) ++at;
    if (at - begin <= 64) most = std::max(most, digits_of(text.substr(begin, at - begin)));
  }
  return most;
}

int coordinate_digits(const std::string& mesh_file, const TetMesh& mesh, const TriangleSurface& surface) {
  const auto key = [](const Eigen::Vector3d& p) { return std::array{p.x(), p.y(), p.z()}; };
  std::set<std::array<double, 3>> vertices;
  for (const Eigen::Vector3d& vertex : surface.vertices) vertices.insert(key(vertex));
  if (std::all_of(mesh.points.begin(), mesh.points.end(),
                  [&](const Eigen::Vector3d& p) { return p.allFinite() && vertices.count(key(p)) > 0; }))
    return 0;

  std::string path = mesh_file;
  if (ending_of(path) == ".ele") path = path.substr(0, path.size() - 4) + ".node";
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return 0;
  std::string text(std::min(bytes_to_read, static_cast<std::size_t>(file.tellg())), ' ');
  file.seekg(0);
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (text.find('\0') != std::string::npos) return 0;
  if (text.size() == bytes_to_read) text.resize(text.find_last_of(" \n\t") + 1);  // no half of a number
  const int most = std::max(6, most_digits(text));
  return most >= 17 ? 0 : most;
}

}  // namespace tetproof::corpus
