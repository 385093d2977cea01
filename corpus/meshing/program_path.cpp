// SPDX-License-Identifier: GPL-3.0-or-later
// The search for programs.
#include "corpus/meshing/program_path.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace tetproof::corpus {

namespace {

bool can_run(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::string program_path(const std::string& name) {
  std::error_code error;
  if (name.find('/') != std::string::npos) {
    const auto path = std::filesystem::absolute(name, error);
    return !error && can_run(path) ? path.string() : "";
  }
  if (name.empty()) return "";
  const char* variable = std::getenv("PATH");
  std::string rest = variable ? variable : "/usr/local/bin:/usr/bin:/bin";
  for (bool more = true; more;) {
    const std::size_t colon = rest.find(':');
    more = colon != std::string::npos;
    const std::string folder = rest.substr(0, colon);
    const auto path = std::filesystem::absolute((folder.empty() ? "." : folder) + "/" + name, error);
    if (!error && can_run(path)) return path.string();
    if (more) rest.erase(0, colon + 1);
  }
  return "";
}

std::string own_folder() {
  std::error_code error;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "" : path.parent_path().string();
}

}  // namespace tetproof::corpus
