// SPDX-License-Identifier: GPL-3.0-or-later
// Checks, before a program starts to work, that no output takes the place of an input or of another output.
#pragma once

#include <string>
#include <vector>

#include "io/mesh_files.hpp"
#include "io/program/program.hpp"
#include "io/writing.hpp"

namespace tetproof::program {

/// The files that one run reads and writes. A program names all of them here before it starts to work.
///
/// Two paths are the same file if they lead to the same device and inode, also through symbolic and hard
/// links. Where there is no file yet, they are the same if they have the same name in the same folder. A
/// device such as /dev/null, or a terminal, can be named more than once.
///
/// Each function throws an InputError if its file is used already and one of the two uses is an output, and
/// if standard input or standard output is asked for twice.
class FilesInUse {
 public:
  /// Begins with the output of --json.
  explicit FilesInUse(const Common& common);

  /// An input. `argument` is its name in --help, as in "MESH"; the path "-" is standard input.
  void reads(const std::string& argument, const std::string& path);
  /// A mesh or a surface. A file of TetGen's brings the other files of its set.
  void reads_mesh(const std::string& argument, const std::string& path, const ReadOptions& options = {});

  /// An output, if `path` is not empty; the path "-" is standard output. Throws an InputError also if no file
  /// can be created there.
  void writes(const std::string& argument, const std::string& path);
  /// A mesh or a surface, if `path` is not empty. InputError for "-" and where `encoding_of` throws.
  void writes_mesh(const std::string& argument, const std::string& path, const WriteOptions& options);
  /// All files of a planned output: a set of TetGen's is known only with its document.
  void writes_mesh(const std::string& argument, PlannedFile& output);

  /// Whether an output is standard output, which then has room for nothing else.
  bool standard_output_is_taken() const;

 private:
  struct Use {
    std::string argument, path;
    bool output;
    std::string identity;  // empty: the same as no other
  };
  void add(Use use);

  std::vector<Use> uses_;
};

}  // namespace tetproof::program
