// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/scratch_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "io/error.hpp"

namespace tetproof::corpus {

ScratchFolder::ScratchFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  if (path_.empty()) {
    path_ = (std::filesystem::temp_directory_path() / "tetproof-fuzz-XXXXXX").string();
    if (::mkdtemp(path_.data())) return;
    error = {errno, std::generic_category()};
  } else {
    path_ = std::filesystem::absolute(path_).string();
    std::filesystem::remove_all(path_, error);
    if (!error) std::filesystem::create_directories(path_, error);
  }
  if (error) throw InputError(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tetproof::corpus
