// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats: for each, who reads it and who plans how to write it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/mesh_files.hpp"
#include "io/model/read_document.hpp"

namespace tetproof::io {

/// A format with its reader and its planner.
struct Codec {
  Format format;
  ReadDocument (*read)(const InputFile&, Wanted);
  /// `binary`: the encoding, which must be one that the format has. The plan refers to the document.
  std::unique_ptr<FilePlan> (*plan)(const Document&, bool binary);
  bool polylines = false;  ///< whether the format has them; to others they are cut into lines
  /// Whether its files have a corner for what the format has no place for, such as signs of groups.
  bool keeps_aside = false;
  bool groups_below_zero = false;  ///< whether such groups are others than those above 0, and no values
};

/// All formats, in the order of `formats()`.
const std::vector<Codec>& codecs();
/// Returns the codec called `name`, which must be a name of `formats()`.
const Codec& codec_named(const std::string& name);

/// Reads a file of the format with this name in `formats()`.
ReadDocument read_as(const std::string& format, const InputFile& file, Wanted wanted);

}  // namespace tetproof::io
