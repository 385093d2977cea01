// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats: who reads and who writes each of them.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/loss/holds.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::io {

// A format, and who reads and writes it.
struct Codec {
  Format format;
  Document (*read)(const std::string& path);
  /// `supplement`: lines that the file keeps aside, for formats whose Holds say where.
  void (*write)(const std::string& path, const Document&, bool binary, const std::string& supplement);
  Holds (*holds)(const std::string& path, const Document&, bool binary);
  /// See `write_warning`; null: never any.
  std::string (*warning)(const std::string& path, const Document&, bool binary) = nullptr;
};

/// All formats, in the order of `formats()`.
const std::vector<Codec>& codecs();
/// The one called `name`, which is a name of `formats()`.
const Codec& codec_named(const std::string& name);

}  // namespace tetproof::io
