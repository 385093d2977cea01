// SPDX-License-Identifier: GPL-3.0-or-later
// What tools call the tags of elements where a format has only named arrays, as VTK's do.
#pragma once

#include <array>
#include <string_view>

namespace tetproof::io {

enum class Tag { group, entity };

struct TagWord {
  std::string_view word;
  Tag tag;
  std::string_view tools;  ///< that write it
};

/// If a file has several words for the same tag, the first of these counts, and the others are data.
inline constexpr std::array tag_words{
    TagWord{"gmsh:physical", Tag::group, "tetproof, and meshio for Gmsh's groups"},
    TagWord{"group", Tag::group, "tetproof, before it took meshio's word"},
    TagWord{"medit:ref", Tag::group, "MMG, and meshio for Medit's references"},
    TagWord{"tetgen:ref", Tag::group, "meshio for TetGen's attributes and markers"},
    TagWord{"Label", Tag::group, "FreeFem"},
    TagWord{"MaterialID", Tag::group, "deal.II"},
    TagWord{"material", Tag::group, "MFEM's and Elmer's .vtk"},
    TagWord{"attribute", Tag::group, "MFEM's .vtu"},
    TagWord{"gmsh:geometrical", Tag::entity, "tetproof, and meshio for Gmsh's entities"},
    TagWord{"entity", Tag::entity, "tetproof, before it took meshio's word"},
    TagWord{"CellEntityIds", Tag::entity, "Gmsh's .vtk"}};

/// Null: it is no such word.
constexpr const TagWord* tag_word(std::string_view name) {
  for (const TagWord& word : tag_words)
    if (word.word == name) return &word;
  return nullptr;
}

/// Values of nodes that are their tags: TetGen's markers, Medit's references, meshio's words for both.
constexpr bool is_node_tag(std::string_view name) {
  return name == "markers" || name == "references" || name == "medit:ref" || name == "tetgen:ref";
}

}  // namespace tetproof::io
