// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps elements of some types.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/edit/kept_blocks.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

constexpr int known_types[] = {
    point1, line2, polyline, triangle3,  quadrangle4,   polygon,           tetrahedron4,
    5,      6,     7,        polyhedron, bezier(line3), bezier(triangle6), bezier(tetrahedron10)};

// Whether a word of --only means the elements of a type.
bool means(const std::string& word, int type) {
  if (type == polyline && (word == "lines" || word == "line")) return true;
  const std::string many = name_of_elements(type);
  return word == many || word == singular(many) || word == std::to_string(type);
}

std::set<std::string> words_of(const std::string& types) {
  std::set<std::string> words;
  for (std::size_t from = 0; from <= types.size();) {
    const std::size_t end = std::min(types.find(',', from), types.size());
    words.insert(types.substr(from, end - from));
    from = end + 1;
  }
  for (const std::string& word : words) {
    std::int64_t number;
    const bool is_type = std::any_of(std::begin(known_types), std::end(known_types),
                                     [&](int type) { return means(word, type); }) ||
                         (parse_integer(word, number) && (element_type(number) || number == polygon_border));
    if (is_type) continue;
    std::vector<std::string> names;
    for (const int type : known_types) names.push_back(name_of_elements(type));
    throw InputError(fmt::format("'{}' is no type of elements; expected {}, or Gmsh's number of a type", word,
                                 fmt::join(names, ", ")));
  }
  return words;
}

}  // namespace

Edit keep_only(Document& document, const std::string& types) {
  const std::set<std::string> words = words_of(types);
  const auto keep = [&](const ElementBlock& block) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return means(word, block.type); });
  };
  const std::size_t before = document.elements();
  std::map<std::string, std::size_t> left_out;
  for (const ElementBlock& block : document.blocks)
    if (!keep(block) && block.count > 0) left_out[name_of_elements(block.type)] += block.count;
  std::vector<Loss> lost = keep_blocks(document, keep);
  if (document.elements() == 0)
    throw InputError(
        fmt::format("{}: none of the {} is of type {}", document.path, counted(before, "elements"), types));
  std::vector<std::string> others;
  for (const auto& [name, count] : left_out) others.push_back(counted(count, name));
  return {fmt::format("{} of {} kept{}", document.elements(), counted(before, "elements"),
                      others.empty() ? "" : fmt::format("; left out: {}", fmt::join(others, ", "))),
          std::move(lost)};
}

}  // namespace tetproof::io
