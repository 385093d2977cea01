// SPDX-License-Identifier: GPL-3.0-or-later
// The conversion of one document to one file: everything that can be asked before it is written, and the
// writing itself.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/losses.hpp"
#include "io/mesh_files.hpp"

namespace tetproof {

namespace io {
class FilePlan;
}

/// A document that is going to be written to `path`. Answers are computed when they are first asked for, and
/// once: whoever asks several questions about one conversion saves time against `losses`, `kept_aside`,
/// `write_warning` and `write_document`, each of which makes a PlannedFile of its own.
///
/// The document is referred to, not copied: it must outlive the PlannedFile and must not change meanwhile.
class PlannedFile {
 public:
  /// InputError as `encoding_of` throws it; touches no file.
  PlannedFile(std::string path, const Document& document, const WriteOptions& options = {});
  PlannedFile(std::string path, const Document&& document, const WriteOptions& options = {}) = delete;
  ~PlannedFile();
  PlannedFile(PlannedFile&&) noexcept;
  PlannedFile& operator=(PlannedFile&&) = delete;

  const Encoding& encoding() const { return encoding_; }

  /// See `losses` in io/losses.hpp.
  const std::vector<Loss>& losses();
  /// See `kept_aside` in io/losses.hpp.
  const KeptAside& kept_aside();
  /// See `write_warning` in io/mesh_files.hpp. Looks for files that are there when it is first called.
  const std::string& warning();

  /// Writes the document whole or not at all, as `write_document` in io/mesh_files.hpp does.
  void write();

 private:
  io::FilePlan& plan();
  void find_losses();

  std::string path_;
  const Document& document_;
  Encoding encoding_;
  std::unique_ptr<io::FilePlan> plan_;
  std::optional<std::vector<Loss>> losses_;
  KeptAside kept_aside_;  // set with `losses_`
  std::optional<std::string> warning_;
};

}  // namespace tetproof
