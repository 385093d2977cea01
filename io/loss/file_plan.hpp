// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a conversion, which each format makes for a document: what the format holds of it, what to warn
// of, and how to write it.
#pragma once

#include <string>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// Refers to the document, which must outlive the plan and stay as it is. Made by a format's `plan_FORMAT`
/// for one document and one encoding; whatever the format finds out about the document is found out once.
class FilePlan {
 public:
  explicit FilePlan(const Document& document) : document_(document) {}
  virtual ~FilePlan() = default;
  FilePlan(const FilePlan&) = delete;
  FilePlan& operator=(const FilePlan&) = delete;

  const Holds& holds() const { return holds_; }

  /// The paths of all files that `write` creates.
  virtual std::vector<std::string> files(const std::string& path) { return {path}; }

  /// See `write_warning` in io/mesh_files.hpp. Empty: nothing to warn of.
  virtual std::string warning([[maybe_unused]] const std::string& path) { return {}; }

  /// Writes the file, or the set of files, that `path` names. `supplement`: the lines that go where
  /// `holds().kept_in` says; empty: none. InputError if it cannot be written.
  virtual void write(const std::string& path, const std::string& supplement) = 0;

 protected:
  const Document& document_;
  Holds holds_;  ///< set by the constructors of derived classes
};

/// The plan of a format that writes one file and keeps nothing aside.
class OneFilePlan : public FilePlan {
 public:
  using FilePlan::FilePlan;

  void write(const std::string& path, const std::string&) final {
    AtomicFile file(path);
    write_into(file);
    file.commit();
  }

 private:
  virtual void write_into(AtomicFile& file) = 0;
};

}  // namespace tetproof::io
