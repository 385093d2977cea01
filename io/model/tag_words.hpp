// SPDX-License-Identifier: GPL-3.0-or-later
// What tools call the tags of elements where a format has only named arrays, as VTK's do.
#pragma once

#include <array>
#include <string_view>

namespace tetproof::io {

enum class Tag { group, entity };

/// What MMG, and meshio for Medit, call the references of nodes where a format has only named arrays; and
/// what documents call them.
inline constexpr std::string_view node_reference_word = "medit:ref", node_references = "references";

struct TagWord {
  std::string_view word;
  Tag tag;
  std::string_view tools;  ///< that write it
};

inline constexpr std::string_view own_group_word = "gmsh:physical", own_entity_word = "gmsh:geometrical",
                                  old_group_word = "group", medit_group_word = "medit:ref";

/// If a file has several words for the same tag, the first of these counts, and the others are data.
inline constexpr std::array tag_words{
    TagWord{own_group_word, Tag::group, "tetproof, and meshio for Gmsh's groups"},
    TagWord{old_group_word, Tag::group, "tetproof, before it took meshio's word"},
    TagWord{medit_group_word, Tag::group, "MMG, and meshio for Medit's references"},
    TagWord{"tetgen:ref", Tag::group, "meshio for TetGen's attributes and markers"},
    TagWord{"Label", Tag::group, "FreeFem"},
    TagWord{"MaterialID", Tag::group, "deal.II"},
    TagWord{"material", Tag::group, "MFEM's and Elmer's .vtk"},
    TagWord{"attribute", Tag::group, "MFEM's .vtu"},
    TagWord{"cell_scalars", Tag::group, "TetGen's .vtk"},
    TagWord{"GeometryIds", Tag::group, "Elmer's .vtu"},
    TagWord{"MaterialIDs", Tag::group, "OpenGeoSys"},
    TagWord{"nastran:ref", Tag::group, "meshio for Nastran's properties"},
    TagWord{"ugrid:ref", Tag::group, "meshio for UGRID's boundaries and volumes"},
    TagWord{"avsucd:material", Tag::group, "meshio for AVS-UCD's materials"},
    TagWord{"su2:tag", Tag::group, "meshio for SU2's markers"},
    TagWord{"netgen:index", Tag::group, "meshio for Netgen's regions and boundaries"},
    TagWord{own_entity_word, Tag::entity, "tetproof, and meshio for Gmsh's entities"},
    TagWord{"entity", Tag::entity, "tetproof, before it took meshio's word"},
    TagWord{"CellEntityIds", Tag::entity, "Gmsh's .vtk"}};

/// The same of nodes: Medit's references and TetGen's markers, in their own files and in meshio's.
inline constexpr std::array<std::string_view, 4> node_tag_words{"references", "markers", "medit:ref",
                                                                "tetgen:ref"};

}  // namespace tetproof::io
