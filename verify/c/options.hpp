// SPDX-License-Identifier: GPL-3.0-or-later
// The options of the C interface: their defaults, their ranges, and what they are in C++.
#pragma once

#include <string>

#include "io/mesh_files.hpp"
#include "reference/options.hpp"
#include "verify/c/tetproof.h"
#include "verify/verify.hpp"

namespace tetproof::c {

/// Options of the judge that were checked.
struct JudgeOptions {
  verify::Options options;
  std::string region_kind;
  std::int32_t threads = 0;
};

/// Null: the defaults. Refused: a size that is not this version's, a value out of its range, an unknown id.
JudgeOptions checked(const tetproof_judge_options* options, bool has_surface);

/// Options of the mesher that were checked.
struct MeshOptions {
  reference::Options options;  ///< they listen, to keep the deadline
  std::int32_t threads = 0;
};
MeshOptions checked(const tetproof_mesh_options* options);

/// Options of a writer that were checked, but not against the path.
struct StrictWriteOptions {
  WriteOptions options;
  std::int32_t strict = TETPROOF_STRICT_OFF;
};
StrictWriteOptions checked(const tetproof_write_options* options);

/// How a file is read as `format`; null or empty: as its content and ending say. Refused: an unknown format.
ReadOptions read_options(const char* format);

}  // namespace tetproof::c
