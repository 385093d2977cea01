// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_polyhedron.hpp"

#include <fmt/format.h>

#include "io/bytes/words.hpp"

namespace tetproof::io {

std::int32_t VtkPolyhedron::place(std::int64_t node) {
  const auto [found, is_new] = place_.try_emplace(node, static_cast<std::int32_t>(nodes.size()));
  if (is_new) nodes.push_back(node);
  return found->second;
}

std::string VtkPolyhedron::read(std::span<const std::int64_t> list, std::span<const std::int64_t> more) {
  nodes.clear(), faces.clear(), place_.clear();
  std::size_t at = 1;
  const std::int64_t count = list.empty() ? 0 : list[0];
  for (std::int64_t f = 0; f < count; ++f) {
    const std::int64_t left = static_cast<std::int64_t>(list.size()) - static_cast<std::int64_t>(at) - 1;
    if (left < 0 || list[at] < 0 || list[at] > left)
      return fmt::format("expected {} of a polyhedron, found {} in {}", counted(count, "faces"), f,
                         counted(list.size(), "numbers"));
    const std::int64_t corners = list[at++];
    faces.push_back(static_cast<std::int32_t>(corners));
    for (std::int64_t k = 0; k < corners; ++k) faces.push_back(place(list[at++]));
  }
  if (count < 0 || (!list.empty() && at != list.size()))
    return fmt::format("expected the faces of a polyhedron in {}, found {}", counted(list.size(), "numbers"),
                       counted(at, "numbers"));
  for (const std::int64_t node : more) place(node);
  return {};
}

}  // namespace tetproof::io
