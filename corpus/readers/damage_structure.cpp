// SPDX-License-Identifier: GPL-3.0-or-later
// Damage to lines and sections.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "corpus/readers/damage.hpp"

namespace tetproof::corpus {
namespace {

using Done = std::optional<std::string>;

// Lines with their ends.
std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t end = bytes.find('\n', at);
    const std::size_t next = end == std::string::npos ? bytes.size() : end + 1;
    lines.push_back(bytes.substr(at, next - at));
    at = next;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string bytes;
  for (const std::string& line : lines) bytes += line;
  return bytes;
}

std::size_t one_of(Random& random, std::size_t n) {
  return static_cast<std::size_t>(random.below(static_cast<int>(n)));
}

std::string shown(std::string_view line) {
  std::string text(line.substr(0, 40));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

// A line that begins a section: "$Nodes", "Vertices", "POINTS 8 double", "<Points>".
bool begins_section(const std::string& line) {
  const std::size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos) return false;
  const std::string_view word = std::string_view(line).substr(at);
  if (word.starts_with("$End") || word.starts_with("</")) return false;
  const auto first = static_cast<unsigned char>(word[0]);
  return first == '$' || first == '<' || (std::isupper(first) && word.size() > 2);
}

bool ends_section(const std::string& line) {
  const std::size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos) return false;
  const std::string_view word = std::string_view(line).substr(at);
  return word.starts_with("$End") || word.starts_with("</") || word.starts_with("End") ||
         word.starts_with("end") || word.starts_with("# Generated");
}

// Where the sections begin, the end of the file as the last.
std::vector<std::size_t> section_starts(const std::vector<std::string>& lines) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 1; i < lines.size(); ++i)  // the first line says what file it is
    if (begins_section(lines[i])) starts.push_back(i);
  starts.push_back(lines.size());
  return starts;
}

Done swapped_sections(std::string& bytes, Random& random) {
  const std::vector<std::string> lines = lines_of(bytes);
  std::vector<std::size_t> starts = section_starts(lines);
  if (starts.size() < 3) {  // no sections: runs of lines
    if (lines.size() < 4) return std::nullopt;
    starts = {1, 1 + (lines.size() - 1) / 2, lines.size()};
  }
  const std::size_t k = one_of(random, starts.size() - 2);
  std::vector<std::string> changed = lines;
  const auto at = [&](std::size_t i) { return changed.begin() + static_cast<std::ptrdiff_t>(starts[i]); };
  std::rotate(at(k), at(k + 1), at(k + 2));
  const std::string result = joined(changed);
  if (result == bytes) return std::nullopt;
  bytes = result;
  return fmt::format("the sections at lines {} and {} changed places: '{}' and '{}'", starts[k] + 1,
                     starts[k + 1] + 1, shown(lines[starts[k]]), shown(lines[starts[k + 1]]));
}

Done missing_section(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  const std::vector<std::size_t> starts = section_starts(lines);
  if (starts.size() < 2) return std::nullopt;
  const std::size_t k = one_of(random, starts.size() - 1);
  const std::string said = fmt::format("the section of {} lines at line {} is missing: '{}'",
                                       starts[k + 1] - starts[k], starts[k] + 1, shown(lines[starts[k]]));
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(starts[k]),
              lines.begin() + static_cast<std::ptrdiff_t>(starts[k + 1]));
  bytes = joined(lines);
  return said;
}

Done doubled_section(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  const std::vector<std::size_t> starts = section_starts(lines);
  if (starts.size() < 2) return std::nullopt;
  const std::size_t k = one_of(random, starts.size() - 1);
  const std::string said =
      fmt::format("the section at line {} comes twice: '{}'", starts[k] + 1, shown(lines[starts[k]]));
  const std::vector<std::string> copy(lines.begin() + static_cast<std::ptrdiff_t>(starts[k]),
                                      lines.begin() + static_cast<std::ptrdiff_t>(starts[k + 1]));
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(starts[k + 1]), copy.begin(), copy.end());
  bytes = joined(lines);
  return said;
}

Done missing_end(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (ends_section(lines[i])) ends.push_back(i);
  if (ends.empty()) return std::nullopt;
  const std::size_t i = ends[one_of(random, ends.size())];
  const std::string said = fmt::format("line {} is missing: '{}'", i + 1, shown(lines[i]));
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
  bytes = joined(lines);
  return said;
}

Done missing_line(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  if (lines.size() < 2) return std::nullopt;
  const std::size_t i = one_of(random, lines.size());
  const std::string said = fmt::format("line {} is missing: '{}'", i + 1, shown(lines[i]));
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
  bytes = joined(lines);
  return said;
}

// The same number or name twice: a line takes the first word of the one before, or comes twice.
Done duplicated_id(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  if (lines.size() < 3) return std::nullopt;
  const std::size_t i = 1 + one_of(random, lines.size() - 1);
  const std::size_t mine = lines[i].find_first_of(" \n"), other = lines[i - 1].find_first_of(" \n");
  const bool whole = random.below(2) == 0 || mine == std::string::npos || other == std::string::npos;
  const std::string before = lines[i];
  lines[i] = whole ? lines[i - 1] : lines[i - 1].substr(0, other) + before.substr(mine);
  if (lines[i] == before) return std::nullopt;
  bytes = joined(lines);
  return fmt::format("line {} became '{}'", i + 1, shown(lines[i]));
}

Done long_line(std::string& bytes, Random& random) {
  constexpr std::size_t length = std::size_t{1} << 20;
  if (random.below(2) == 0) {
    const std::vector<std::string> lines = lines_of(bytes);
    std::string all = joined(lines);
    const std::size_t first = all.find('\n');
    if (first == std::string::npos) return std::nullopt;
    std::replace(all.begin() + static_cast<std::ptrdiff_t>(first) + 1, all.end(), '\n', ' ');
    if (all == bytes) return std::nullopt;
    bytes = std::move(all);
    return "all lines but the first became one";
  }
  std::vector<std::string> lines = lines_of(bytes);
  if (lines.empty()) return std::nullopt;
  const std::size_t i = one_of(random, lines.size());
  const char filler = std::array{' ', '1', 'x', '#'}[one_of(random, 4)];
  const std::size_t end = lines[i].ends_with('\n') ? lines[i].size() - 1 : lines[i].size();
  lines[i].insert(end, length, filler);
  bytes = joined(lines);
  return fmt::format("line {} ends with 2^20 times '{}'", i + 1, filler);
}

// The words and numbers by which formats say in which order their bytes are.
Done byte_order_flag(std::string& bytes, Random&) {
  constexpr std::array<std::array<std::string_view, 2>, 6> pairs{
      {{"LittleEndian", "BigEndian"},
       {"BigEndian", "LittleEndian"},
       {"binary_little_endian", "binary_big_endian"},
       {"binary_big_endian", "binary_little_endian"},
       {"\"UInt64\"", "\"UInt32\""},
       {"\"UInt32\"", "\"UInt64\""}}};
  for (const auto& [from, to] : pairs)
    if (const std::size_t at = bytes.find(from); at != std::string::npos) {
      bytes.replace(at, from.size(), to);
      return fmt::format("'{}' became '{}'", from, to);
    }
  for (const std::string_view one : {std::string_view("\x01\0\0\0", 4), std::string_view("\0\0\0\x01", 4)})
    if (const std::size_t at = bytes.find(one); at != std::string::npos && at < 64) {
      std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                   bytes.begin() + static_cast<std::ptrdiff_t>(at) + 4);
      return fmt::format("the number 1 at byte {} has the other byte order", at);
    }
  return std::nullopt;
}

// Text became binary in name, or the other way round.
Done form_flag(std::string& bytes, Random&) {
  constexpr std::array<std::array<std::string_view, 2>, 8> pairs{
      {{"2.2 0 8", "2.2 1 8"},
       {"2.2 1 8", "2.2 0 8"},
       {"4.1 0 8", "4.1 1 8"},
       {"4.1 1 8", "4.1 0 8"},
       {"4.1 0 8", "4.1 0 4"},
       {"ASCII\n", "BINARY\n"},
       {"BINARY\n", "ASCII\n"},
       {"format ascii", "format binary_little_endian"}}};
  for (const auto& [from, to] : pairs)
    if (const std::size_t at = bytes.find(from); at != std::string::npos) {
      bytes.replace(at, from.size(), to);
      return fmt::format("'{}' became '{}'", shown(from), shown(to));
    }
  return std::nullopt;
}

Done deep_nesting(std::string& bytes, Random& random) {
  if (bytes.find("<?xml") == std::string::npos && bytes.find("<VTKFile") == std::string::npos)
    return std::nullopt;
  const std::size_t at = bytes.find('>', bytes.find("<VTKFile"));
  if (at == std::string::npos) return std::nullopt;
  const int depth = random.below(2) ? 1000 : 100000;
  std::string open, close;
  for (int k = 0; k < depth; ++k) open += "<a>", close += "</a>";
  bytes.insert(at + 1, random.below(2) ? open + close : open);
  return fmt::format("{} elements inside each other at byte {}", depth, at + 1);
}

Done comment(std::string& bytes, Random& random) {
  std::vector<std::string> lines = lines_of(bytes);
  if (lines.empty()) return std::nullopt;
  const std::array<const char*, 6> words{"# a comment",        "// a comment", "$Comments\nx\n$EndComments",
                                         "<!-- a comment -->", "! a comment",  ""};
  const std::string word = words[one_of(random, words.size())];
  const std::size_t i = one_of(random, lines.size() + 1);
  if (random.below(2) == 0 && i < lines.size()) {
    const std::size_t end = lines[i].ends_with('\n') ? lines[i].size() - 1 : lines[i].size();
    lines[i].insert(end, " " + word);
  } else {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(i), word + "\n");
  }
  bytes = joined(lines);
  return fmt::format("'{}' at line {}", shown(word), i + 1);
}

}  // namespace

std::vector<DamageKind> damage_to_structure() {
  return {{"swapped-sections", "two sections, or halves, changed places", swapped_sections},
          {"missing-section", "a section is missing", missing_section},
          {"doubled-section", "a section comes twice", doubled_section},
          {"missing-end", "the line that ends a section is missing", missing_end},
          {"missing-line", "a line is missing", missing_line},
          {"duplicated-id", "two lines have the same number, or are the same", duplicated_id},
          {"long-line", "a line of a million bytes", long_line},
          {"byte-order", "the wrong byte order, or the wrong width, is announced", byte_order_flag},
          {"form", "binary is announced as text, or text as binary", form_flag},
          {"deep-nesting", "XML elements inside each other, up to 100000", deep_nesting},
          {"comment", "a comment or a blank line at an odd place", comment}};
}

}  // namespace tetproof::corpus
