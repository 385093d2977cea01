// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the supplement as comments, and finds it in them: for TetGen's files.
#include <fmt/format.h>
#include <sys/stat.h>

#include "io/bytes/checksum.hpp"
#include "io/bytes/input_file.hpp"
#include "io/loss/loss_list.hpp"
#include "io/supplement/supplement.hpp"

namespace tetproof::io {
namespace {

constexpr std::string_view start_of_line = "#: ", first_line = "#: tetproof ";

// Returns where the first line of the supplement begins; npos: there is none. Only comments come after that
// line, so the search goes backwards from the end and does not look at what comes before.
std::size_t find_start(std::string_view bytes) {
  for (std::size_t end = bytes.size(); end > 0;) {
    const std::size_t feed = bytes.substr(0, end - 1).rfind('\n');
    const std::size_t start = feed == bytes.npos ? 0 : feed + 1;
    const std::string_view line = bytes.substr(start, end - start);
    if (line.starts_with(first_line)) return start;
    if (line.find_first_not_of(" \t\r\n") != line.find('#')) break;
    end = start;
  }
  return bytes.npos;
}

bool is_unchanged(const Checksum& checksum, const InputFile& this_file, std::size_t size,
                  const std::string& stem) {
  if (checksum.ending.empty()) return crc32_of(this_file, size) == checksum.crc32;
  const std::string path = stem + checksum.ending;
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return false;
  const InputFile file(path);
  return crc32_of(file, file.bytes().size()) == checksum.crc32;
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

void drop_outdated_supplement(const std::string& path, Document& native) {
  native.warnings.push_back(fmt::format(
      "{}: changed since its supplement (names, groups, ...) was written: the supplement is ignored", path));
  add_loss(native.dropped, "outdated supplements", 1, path);
}

std::string supplement_in_comments(const InputFile& input, const std::string& stem, Document& native) {
  std::string_view bytes = input.bytes();
  const std::size_t start = find_start(bytes);
  if (start == bytes.npos) return {};
  bytes.remove_prefix(start);
  std::string lines;
  while (bytes.starts_with(start_of_line)) {
    const std::size_t end = bytes.find('\n');
    lines += bytes.substr(start_of_line.size(), end == bytes.npos ? end : end + 1 - start_of_line.size());
    bytes.remove_prefix(end == bytes.npos ? bytes.size() : end + 1);
  }
  const std::vector<Checksum> checksums = read_supplement_head(lines, native);
  if (checksums.empty()) return {};
  bool unchanged = bytes.empty();
  for (const Checksum& checksum : checksums)
    unchanged = unchanged && is_unchanged(checksum, input, start, stem);
  if (unchanged) return lines;
  drop_outdated_supplement(input.path(), native);
  return {};
}

}  // namespace tetproof::io
