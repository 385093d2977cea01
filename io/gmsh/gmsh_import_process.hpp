// SPDX-License-Identifier: GPL-3.0-or-later
// A program run as a process of its own, that shares nothing with ours but one file which it writes.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace tetproof::io {

/// A file without a name, in the folder for temporary files: gone with the last process that has it open,
/// whatever ends it. std::system_error when there can be none.
class NamelessFile {
 public:
  NamelessFile();
  ~NamelessFile();
  NamelessFile(const NamelessFile&) = delete;
  NamelessFile& operator=(const NamelessFile&) = delete;

  int descriptor() const { return descriptor_; }
  /// A path by which this process can open it.
  std::string path() const;

 private:
  int descriptor_;
};

/// How a process ended.
struct ProcessEnd {
  int exit_code = -1;     ///< -1: a signal ended it
  int signal = 0;         ///< that signal
  bool too_late = false;  ///< it was ended since its time was over
  std::string said;       ///< on standard output and error; of much only the start
};

/// Where the process finds the file that it shall write.
inline constexpr const char* shared_file = "/dev/fd/3";

/// Runs `command` (a path, and arguments) in this process's folder and environment, with nothing to read and
/// no descriptor but 0, 1, 2 and, as 3, `shared`. When its time is over it is ended, and what it started too.
/// std::system_error when it cannot be started.
ProcessEnd run_process(const std::vector<std::string>& command, int shared,
                       std::chrono::milliseconds allowed);

}  // namespace tetproof::io
