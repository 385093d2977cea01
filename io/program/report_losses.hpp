// SPDX-License-Identifier: GPL-3.0-or-later
// Says what a reader did not take from a file and what the target of a mesh cannot hold.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "io/losses.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/program.hpp"
#include "io/writing.hpp"

namespace tetproof::program {

/// Lines on standard error, "warning: ..." and "not read: ITEM: COUNT (EXAMPLE)", for `Document::warnings`
/// and `Document::dropped`.
void report_reading(const Common& common, const std::vector<std::string>& warnings,
                    const std::vector<Loss>& dropped);

/// "WHAT: ITEM: COUNT (EXAMPLE)".
std::string loss_line(const std::string& what, const Loss& loss);

/// An array of `item`, `count` and `example`.
nlohmann::ordered_json losses_json(const std::vector<Loss>& losses);

/// A document and the file that it will be written to. The document must outlive this.
class MeshOutput {
 public:
  /// Says on standard error what the file will not hold ("lost: ..."), what only our reader takes back
  /// ("kept in ..."), and warnings: the writer's, and of elements without nodes. Nothing is written yet.
  /// InputError as `FilesInUse::writes_mesh`; `argument` is the path's name in --help.
  MeshOutput(const Common& common, FilesInUse& files, const std::string& argument, const std::string& path,
             const Document& document, const WriteOptions& options = {});

  const Encoding& encoding() const { return file_.encoding(); }
  const std::vector<Loss>& losses() { return file_.losses(); }
  const KeptAside& kept_aside() { return file_.kept_aside(); }
  const std::vector<Loss>& dangling() const { return dangling_; }  ///< see `PlannedFile::dangling`
  void write() { file_.write(); }

 private:
  PlannedFile file_;
  std::vector<Loss> dangling_;
};

}  // namespace tetproof::program
