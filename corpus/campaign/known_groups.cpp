// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/campaign/known_groups.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "corpus/meshing/outcome.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

// Whether one of the words between colons is an outcome's name. A name or a signature may have colons, too.
bool is_id(const std::string& text) {
  for (std::size_t at = text.find(':'); at != std::string::npos;) {
    const std::size_t next = text.find(':', at + 1);
    if (next == std::string::npos) return false;
    if (outcome_of_name(text.substr(at + 1, next - at - 1))) return true;
    at = next;
  }
  return false;
}

}  // namespace

std::vector<std::string> read_known_groups(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
  std::vector<std::string> ids;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const char* const blank = " \t\r";
    const std::size_t begin = line.find_first_not_of(blank);
    if (begin == std::string::npos || line[begin] == '#') continue;
    line = line.substr(begin, line.find_last_not_of(blank) + 1 - begin);
    if (!is_id(line))
      throw InputError(fmt::format("{}:{}: expected the id of a group, MESHER:OUTCOME:SIGNATURE, found '{}'",
                                   path, number, line));
    ids.push_back(line);
  }
  if (file.bad()) throw InputError(fmt::format("{}: cannot read: {}", path, std::strerror(errno)));
  return ids;
}

std::string group_id(const std::string& name, const char* outcome, const std::string& signature) {
  std::string text = name + ":" + outcome + ":" + signature;
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace tetproof::corpus
