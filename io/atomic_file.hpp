// SPDX-License-Identifier: GPL-3.0-or-later
// A file that appears whole or not at all: written beside its place, then renamed.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace tetproof {

/// Writes beside `path` and takes its place on `commit`; without it the destructor leaves nothing behind.
/// Every failure is an InputError that names `path` and the system's reason.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::string path_, beside_;
  std::FILE* file_ = nullptr;
};

/// Throws as AtomicFile does when no file can be made at `path`, and leaves nothing there: so that a long job fails before it
/// begins. What is neither a file nor a folder (a pipe, a device) is not touched.
void check_creatable(const std::string& path);

}  // namespace tetproof
