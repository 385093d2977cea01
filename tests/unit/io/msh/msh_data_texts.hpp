// SPDX-License-Identifier: GPL-3.0-or-later
// The same mesh in three versions of .msh, and sections of data that fit each of them, all written by hand.
#pragma once

#include <string>

namespace tetproof::test {

/// The text behind the last `mark`, for parts of a document or file that follow it.
inline std::string behind(const std::string& text, const std::string& mark) {
  const std::size_t at = text.rfind(mark);
  return at == text.npos ? "no " + mark : text.substr(at + mark.size());
}

inline const std::string mesh22 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n$EndNodes\n"
    "$Elements\n2\n5 4 2 7 1 10 20 30 40\n6 2 2 8 2 10 20 30\n$EndElements\n";
inline const std::string mesh40 =
    "$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n0 0 1 1\n2 0 0 0 1 1 0 1 8 0\n1 0 0 0 1 1 1 1 7 0\n"
    "$EndEntities\n$Nodes\n2 4\n2 2 0 3\n10 0 0 0\n20 1 0 0\n30 0 1 0\n1 3 0 1\n40 0 0 1\n$EndNodes\n"
    "$Elements\n2 2\n1 3 4 1\n5 10 20 30 40\n2 2 2 1\n6 10 20 30\n$EndElements\n";
inline const std::string mesh41 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 1\n2 0 0 0 1 1 0 1 8 0\n1 0 0 0 1 1 1 1 7 0\n"
    "$EndEntities\n$Nodes\n2 4 10 40\n2 2 0 3\n10\n20\n30\n0 0 0\n1 0 0\n0 1 0\n3 1 0 1\n40\n0 0 "
    "1\n$EndNodes\n"
    "$Elements\n2 2 5 6\n3 1 4 1\n5 10 20 30 40\n2 2 2 1\n6 10 20 30\n$EndElements\n";

inline const std::string affine = "1 0 0 0 0 1 0 0 0 0 1 0.5 0 0 0 1";
inline const std::string data =
    "$NodeData\n1\n\"heat flow\"\n1\n0.1\n3\n2\n3\n2\n20 1 2 -0\n30 4 5e-324 6\n$EndNodeData\n"
    "$NodeData\n2\n\"T\"\n\"scheme\"\n1\n-1.5\n4\n0\n1\n3\n2\n40 nan\n10 inf\n99 -1\n$EndNodeData\n"
    "$ElementData\n1\n\"of no view\"\n0\n3\n0\n1\n2\n5 0.25\n6 0.75\n$EndElementData\n"
    "$ElementNodeData\n1\n\"jump\"\n1\n0\n3\n0\n2\n2\n6 3 1 2 3 4 5 6\n77 1 7 8\n$EndElementNodeData\n";

}  // namespace tetproof::test
