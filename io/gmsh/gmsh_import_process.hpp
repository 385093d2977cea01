// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a program as a process of its own. It shares one file with ours, which it writes, and nothing else.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace tetproof::io {

/// A file without a name, in the folder for temporary files. It disappears with the last process that has it
/// open, whatever ends that process. std::system_error if it cannot be made.
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
  bool too_late = false;  ///< it was ended because its time was over
  std::string said;       ///< its standard output and error; of much only the start
};

/// The path under which the process finds the file that it must write.
inline constexpr const char* shared_file = "/dev/fd/3";

/// Runs `command` (a path, and arguments) in this process's folder and environment. It has nothing to read,
/// and no descriptors except 0, 1, 2 and, as 3, `shared`. When its time is over, it and all that it started
/// are ended. std::system_error if it cannot be started.
ProcessEnd run_process(const std::vector<std::string>& command, int shared,
                       std::chrono::milliseconds allowed);

}  // namespace tetproof::io
