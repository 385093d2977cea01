// SPDX-License-Identifier: GPL-3.0-or-later
// A .msh of one tetrahedron in two physical groups, one of them with a name.
#pragma once

namespace tetproof::test {

inline constexpr const char* two_groups =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 7 \"steel\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 2 7 8 0\n$EndEntities\n"
    "$Nodes\n1 4 10 40\n3 1 0 4\n10\n20\n30\n40\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n"
    "$Elements\n1 1 1 1\n3 1 4 1\n1 10 20 30 40\n$EndElements\n";

}  // namespace tetproof::test
