// SPDX-License-Identifier: GPL-3.0-or-later
// The conversion of one document to one file: the questions that can be asked before writing, and the
// writing.
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
struct Holds;
}  // namespace io

/// A document that is going to be written to `path`. Each answer is computed when it is first asked for, and
/// only once. `losses`, `kept_aside`, `write_warning` and `write_document` each make a PlannedFile of their
/// own, so a program that needs several of these answers saves time with one PlannedFile.
///
/// The document is referred to, not copied: it must outlive the PlannedFile and must not change until then.
class PlannedFile {
 public:
  /// InputError as `encoding_of` throws it. Touches no file.
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
  /// Elements that stand in the file, but name nodes that do not: the format's own programs refuse the file
  /// or read something else. One item, or none.
  std::vector<Loss> dangling();
  /// See `write_warning` in io/mesh_files.hpp. The first call looks for old files.
  const std::string& warning();

  /// The paths of all files that `write` creates: several for a set of TetGen's.
  std::vector<std::string> files();

  /// Writes the document whole or not at all, as `write_document` in io/mesh_files.hpp does.
  void write();

 private:
  io::FilePlan& plan();
  /// The document that the format gets: `document_`, or one in which its polylines are cut into lines and its
  /// groups have no signs.
  const Document& written() const { return changed_ ? *changed_ : document_; }
  void find_losses();
  void find_lost_signs(const io::Holds& holds);

  std::string path_;
  const Document& document_;
  Encoding encoding_;
  std::unique_ptr<Document> changed_;  // set with `plan_`, as the next two
  std::vector<Loss> lost_by_cutting_;
  bool unsigned_groups_ = false;
  std::unique_ptr<io::FilePlan> plan_;
  std::optional<std::vector<Loss>> losses_;
  KeptAside kept_aside_;  // set with `losses_`
  std::optional<std::string> warning_;
};

}  // namespace tetproof
