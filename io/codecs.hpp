// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats: who reads and who writes each of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/file_plan.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::io {

/// A format, who reads it, and who plans how to write it.
struct Codec {
  Format format;
  Document (*read)(const std::string& path);
  /// `binary`: which of the two encodings. The plan refers to the document.
  std::unique_ptr<FilePlan> (*plan)(const Document&, bool binary);
};

/// All formats, in the order of `formats()`.
const std::vector<Codec>& codecs();
/// The one called `name`, which is a name of `formats()`.
const Codec& codec_named(const std::string& name);

}  // namespace tetproof::io
