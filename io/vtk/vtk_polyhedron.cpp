// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_polyhedron.hpp"

#include <fmt/format.h>

#include <set>

#include "io/bytes/words.hpp"

namespace tetproof::io {

std::int32_t VtkPolyhedron::place(std::int64_t node) {
  const auto [found, is_new] = place_.try_emplace(node, static_cast<std::int32_t>(nodes.size()));
  if (is_new) nodes.push_back(node);
  return found->second;
}

std::string VtkPolyhedron::read(std::span<const std::int64_t> list, std::span<const std::int64_t> more) {
  // Clearing takes as long as the map once was large.
  if (place_.bucket_count() > 16 * nodes.size() + 64)
    std::unordered_map<std::int64_t, std::int32_t>().swap(place_);
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

int nodes_of_faces(const ElementBlock& block) {
  std::set<std::int32_t> named;
  for (std::size_t at = 0; at < block.faces.size();)
    for (std::int32_t left = block.faces[at++]; left > 0; --left) named.insert(block.faces[at++]);
  return static_cast<int>(named.size());
}

std::string VtkFaces::lists(std::vector<std::int64_t>& faces_of_cells,
                            std::vector<std::int64_t>& ends_of_cells) const {
  // The end of item k in a list of `size` numbers, where the one before it ends at `start`. -1: none.
  const auto end_in = [](const std::vector<std::int64_t>& all, std::size_t k, std::int64_t start,
                         std::size_t size) {
    return all[k] < start || all[k] > static_cast<std::int64_t>(size) ? -1 : all[k];
  };
  // A face has two sides. A file in which many cells name a large face could ask for any memory.
  const std::size_t most = 4 * (corners.size() + faces.size()) + 1024;
  std::int64_t start = 0;
  for (std::size_t c = 0; c < ends.size(); ++c) {
    const std::int64_t end = end_in(ends, c, start, faces.size());
    if (end < 0)
      return fmt::format("cell {}: expected a polyhedron offset from {} to {}, found {}", c, start,
                         faces.size(), ends[c]);
    if (end == start) {
      ends_of_cells.push_back(-1);
      continue;
    }
    faces_of_cells.push_back(end - start);
    for (; start < end; ++start) {
      const std::int64_t face = faces[static_cast<std::size_t>(start)];
      if (face < 0 || face >= static_cast<std::int64_t>(face_ends.size()))
        return fmt::format("cell {}: expected one of {}, found {}", c, counted(face_ends.size(), "faces"),
                           face);
      const auto f = static_cast<std::size_t>(face);
      const std::int64_t from = f == 0 ? 0 : face_ends[f - 1];
      const std::int64_t to = from < 0 ? -1 : end_in(face_ends, f, from, corners.size());
      if (to < 0)
        return fmt::format("face {}: expected an offset from {} to {}, found {}", f, from, corners.size(),
                           face_ends[f]);
      faces_of_cells.push_back(to - from);
      faces_of_cells.insert(faces_of_cells.end(), corners.begin() + from, corners.begin() + to);
      if (faces_of_cells.size() > most)
        return fmt::format(
            "cell {}: expected faces of one or two cells each, found more than {} corners for {}", c, most,
            counted(corners.size(), "numbers"));
    }
    ends_of_cells.push_back(static_cast<std::int64_t>(faces_of_cells.size()));
  }
  return {};
}

}  // namespace tetproof::io
