// SPDX-License-Identifier: GPL-3.0-or-later
// The supplement as comments, for TetGen's files.
#include <fmt/format.h>
#include <sys/stat.h>

#include "io/input_file.hpp"
#include "io/supplement.hpp"

namespace tetproof::io {
namespace {

constexpr std::string_view start_of_line = "#: ", first_line = "#: tetproof ";

// Where the first line of the supplement begins; npos if there is none.
std::size_t find_start(std::string_view bytes) {
  std::size_t start = bytes.rfind(first_line);
  while (start != bytes.npos && start > 0 && bytes[start - 1] != '\n')
    start = bytes.rfind(first_line, start - 1);
  return start;
}

bool is_unchanged(const Checksum& checksum, std::string_view this_file, const std::string& stem) {
  if (checksum.ending.empty()) return crc32_of(this_file) == checksum.crc32;
  const std::string path = stem + checksum.ending;
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 && crc32_of(InputFile(path).bytes()) == checksum.crc32;
}

}  // namespace

std::string as_comments(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    text += start_of_line;
    text += lines.substr(0, end);
    text += '\n';
    lines.remove_prefix(end == lines.npos ? lines.size() : end + 1);
  }
  return text;
}

std::string outdated_supplement(const std::string& path) {
  return fmt::format(
      "{}: changed since its supplement (names, groups, ...) was written: the supplement is ignored", path);
}

void take_back_comments(const std::string& file, const std::string& stem, Document& native) {
  const InputFile input(file);
  std::string_view bytes = input.bytes();
  const std::size_t start = find_start(bytes);
  if (start == bytes.npos) return;
  const std::string_view before = bytes.substr(0, start);
  bytes.remove_prefix(start);
  std::string lines;
  while (bytes.starts_with(start_of_line)) {
    const std::size_t end = bytes.find('\n');
    lines += bytes.substr(start_of_line.size(), end == bytes.npos ? end : end + 1 - start_of_line.size());
    bytes.remove_prefix(end == bytes.npos ? bytes.size() : end + 1);
  }
  const std::vector<Checksum> checksums = read_supplement_head(lines, native);
  if (checksums.empty()) return;
  bool unchanged = bytes.empty();
  for (const Checksum& checksum : checksums) unchanged = unchanged && is_unchanged(checksum, before, stem);
  if (unchanged)
    take_back(lines, file, native);
  else
    native.warnings.push_back(outdated_supplement(file));
}

}  // namespace tetproof::io
