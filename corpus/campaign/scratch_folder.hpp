// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that lives as long as an object. Not installed.
#pragma once

#include <string>

namespace tetproof::corpus {

/// A folder that is removed with all that is in it.
class ScratchFolder {
 public:
  /// Makes the folder `path`, empty, or one in the system's folder for temporary files if `path` is empty.
  /// InputError if that is not possible.
  explicit ScratchFolder(std::string path);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::string& path() const { return path_; }  ///< absolute
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

}  // namespace tetproof::corpus
