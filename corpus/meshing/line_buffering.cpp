// SPDX-License-Identifier: GPL-3.0-or-later
// Line-buffered output of programs that write into a pipe.
//
// A program that aborts loses what its C library has not written yet, and that is the line which says why:
// Debian's TetGen loses all. A terminal would make the C library write line by line too, but then programs
// colour their output, draw progress bars and shorten lines. coreutils' stdbuf changes the buffers and
// nothing else: it preloads a small library. It is asked once where that library is; starting commands
// through it would cost one more exec each, and hide whether the command exists.
#include "corpus/meshing/line_buffering.hpp"

#include <stdio.h>
#include <unistd.h>

#include <string>
#include <string_view>
#include <vector>

namespace tetproof::corpus {

namespace {

const std::string* find(const std::vector<std::string>& environment, std::string_view name) {
  for (const std::string& variable : environment)
    if (std::string_view(variable).substr(0, name.size()) == name) return &variable;
  return nullptr;
}

std::string preloaded_by_stdbuf() {
  FILE* pipe = ::popen("LD_PRELOAD= stdbuf -oL -eL env 2>/dev/null", "re");
  if (!pipe) return "";
  std::string text(1, '\n');
  char buffer[4096];
  while (const std::size_t got = ::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, got);
  ::pclose(pipe);
  const std::string_view name = "\nLD_PRELOAD=";
  const std::size_t at = text.find(name);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + name.size();
  std::string path = text.substr(begin, text.find('\n', begin) - begin);
  while (!path.empty() && path.front() == ':') path.erase(0, 1);
  return ::access(path.c_str(), R_OK) == 0 ? path : "";
}

}  // namespace

std::vector<std::string> line_buffering(const std::vector<std::string>& environment) {
  static const std::string library = preloaded_by_stdbuf();
  if (library.empty()) return {};
  const auto joined = [&](const std::string& name, const std::string& more) {
    const std::string* present = find(environment, name);
    return present && present->size() > name.size() ? *present + ":" + more : name + more;
  };
  // AddressSanitizer refuses to start when something is preloaded before it. stdbuf's library replaces none
  // of the functions that it wants to be first for.
  return {"_STDBUF_O=L", "_STDBUF_E=L", joined("LD_PRELOAD=", library),
          joined("ASAN_OPTIONS=", "verify_asan_link_order=0")};
}

}  // namespace tetproof::corpus
