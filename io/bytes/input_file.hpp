// SPDX-License-Identifier: GPL-3.0-or-later
// An input file in memory: mapped, or read from a pipe.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "io/progress.hpp"

namespace tetproof {

/// A whole file, memory-mapped for reading. A pipe is read into memory. Throws InputError with the path if
/// the file cannot be read.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  /// All of standard input, read into memory. `path()` is "standard input", for messages.
  static InputFile standard_input();
  /// A file that is in memory already, and stays there as long as this is used. `name`: for messages.
  static InputFile in_memory(std::string_view bytes, const std::string& name);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }
  /// Whether `path()` names a file, so that there can be others beside it; false for standard input and for
  /// memory.
  bool is_named() const { return named_; }
  std::string_view bytes() const { return bytes_; }
  /// Copies bytes of the file into memory. Several threads may do so at once.
  void copy(std::size_t offset, std::size_t size, char* to) const;
  /// From now on `copy` reports to `listener`, as the stage "reading", how many bytes it has copied of all.
  void report_to(ProgressListener listener) { listener_ = std::move(listener); }
  /// Whether `copy` reads from the file and not from a copy in memory.
  bool in_file() const { return file_ >= 0; }

 private:
  struct StandardInput {};
  explicit InputFile(StandardInput);
  InputFile(std::string_view bytes, const std::string& name) : path_(name), bytes_(bytes), named_(false) {}
  void read_all(int descriptor);  // into copy_

  std::string path_, copy_;
  std::string_view bytes_;
  void* map_ = nullptr;
  ProgressListener listener_;
  mutable std::atomic<std::uint64_t> copied_ = 0;
  int file_ = -1;
  bool named_ = true;
};

/// Bytes of which long runs are wanted. It is better to copy a file piece by piece, into memory that is used
/// again, than to look at it in the map: the map costs a page fault for every few pages, which takes longer
/// than the copy, and it counts as resident memory.
struct Source {
  Source(std::string_view all) : bytes(all) {}
  Source(const InputFile& all) : bytes(all.bytes()), file(all.in_file() ? &all : nullptr) {}

  std::string_view bytes;
  const InputFile* file = nullptr;  ///< null: the bytes are in memory
};

}  // namespace tetproof
