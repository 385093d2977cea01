// SPDX-License-Identifier: GPL-3.0-or-later
// Whether all vertex numbers of a mesh are shifted. Internal.
#pragma once

#include "io/tet_mesh.hpp"

namespace tetproof::corpus {

/// `Truth::shift`. Tries the two numbers that move the used points to one end of all points.
Index shift_of(const TetMesh& mesh);

}  // namespace tetproof::corpus
