// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's .msh files. Facts: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format
#pragma once

#include <string>
#include <string_view>

#include "io/atomic_file.hpp"
#include "io/document.hpp"

namespace tetproof::io {

void write_msh41(AtomicFile& file, const Document& document, bool binary);

}  // namespace tetproof::io
