// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the two sections of .msh files that are always text: $MeshFormat and $PhysicalNames.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/msh/msh_sections.hpp"

namespace tetproof::io {
namespace {

// The number 1 in front of binary sections tells the byte order. Returns whether it is the other one.
bool read_is_swapped(Scanner& in, const std::string& path) {
  in.next_line();
  const Scanner place = in;
  const std::string_view one = in.raw(4, "the number 1 that tells the byte order");
  Numbers as_here(path, one, 0, true, false), swapped(path, one, 0, true, true);
  if (as_here.integer("") == 1) return false;
  if (swapped.integer("") == 1) return true;
  place.fail_at_byte("expected the number 1 that tells the byte order");
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_binary(char c) {
  return (c >= '\0' && c < '\t') || (c > '\r' && c < ' ') || c == '\x7f';
}

}  // namespace

bool may_be_elements(std::string_view bytes) {
  if (std::any_of(bytes.begin(), bytes.end(), is_binary)) return true;
  const std::string no_path;
  for (Scanner in(no_path, bytes); !in.at_end(); in.next_line()) {
    const std::string_view word = in.peek_word();
    const std::size_t first = word.find_first_not_of("+-.");
    if (first != word.npos && is_digit(word[first])) return true;
    while (!in.at_line_end())
      if (const std::string_view name = in.word(); name.size() > 1 && name[0] == '$' && is_letter(name[1]))
        return true;
  }
  return false;
}

MshFormat read_mesh_format(Scanner& in, Document& document) {
  MshFormat format;
  const std::string_view version = in.word();
  double number = 0;
  if (!parse_real(version, number)) in.fail("a version of the format", version);
  if (number != 4.1 && number != 4 && !(number >= 2 && number < 4))
    in.fail_in_line(
        fmt::format("this is a .msh file of version {}; versions 1 to 3, 4.0 and 4.1 are read", version));
  document.format = number == 4.1 ? "msh41" : number == 4 ? "msh40" : number >= 3 ? "msh3" : "msh22";
  format.element_tags = number >= 3 ? ElementTags::v3 : number >= 2.2 ? ElementTags::v22 : ElementTags::v20;
  const std::int64_t kind = in.integer("0 for text or 1 for binary");
  if (kind != 0 && kind != 1)
    in.fail_in_line(fmt::format("expected 0 for text or 1 for binary, found {}", kind));
  format.binary = kind == 1;
  const std::int64_t size = in.integer("the size of a number in bytes");
  if (format.binary && size != 8)
    in.fail_in_line(fmt::format("expected binary numbers of 8 bytes, found {}", size));
  if (size != 8)
    document.warnings.push_back(
        fmt::format("{}:{}: the size of numbers is {} and not 8, which means nothing in text", document.path,
                    in.line(), size));
  if (format.binary) format.swapped = read_is_swapped(in, document.path);
  return format;
}

void read_physical_names(Scanner& in, Document& document) {
  const std::int64_t count = in.count("the number of physical names", 6);
  std::size_t bare = 0;
  std::int64_t first_bare = 0;
  for (std::int64_t i = 0; i < count; ++i) {
    GroupName name;
    const std::int64_t dim = in.integer("the dimension of a physical group");
    in.at_line_end();
    if (in.peek_byte() == '"') {
      name.dim = no_dimension, name.group = dim;
      if (bare++ == 0) first_bare = in.line();
    } else {
      if (dim < 0 || dim > 3)
        in.fail_in_line(fmt::format("expected the dimension of a physical group, 0 to 3, found {}", dim));
      name.dim = static_cast<int>(dim);
      name.group = in.integer("the number of a physical group");
      in.at_line_end();
    }
    const std::string_view line = in.rest_of_line();
    const std::size_t from = line.find('"'), to = line.rfind('"');
    if (from == std::string_view::npos || to == from) in.fail("a name in double quotes", line);
    name.name = line.substr(from + 1, to - from - 1);
    constexpr std::string_view blanks = " \t\v\f";
    if (line.find_first_not_of(blanks) != from || line.find_last_not_of(blanks) != to)
      add_loss(document.dropped, "texts beside the names of physical groups", 1,
               fmt::format("line {}", in.line()));
    document.group_names.push_back(std::move(name));
  }
  if (bare > 0)
    document.warnings.push_back(fmt::format(
        "{}:{}: {} {} no dimension, as in version 2.0; it is that of the elements in the group",
        document.path, first_bare, counted(bare, "names of physical groups"), bare == 1 ? "has" : "have"));
}

void find_dimensions_of_names(Document& document) {
  const auto& names = document.group_names;
  if (std::none_of(names.begin(), names.end(), [](const GroupName& n) { return n.dim == no_dimension; }))
    return;
  int largest = 0;
  std::map<std::int64_t, std::set<int>> dimensions;  // of the elements in a group
  for (const ElementBlock& block : document.blocks) {
    largest = std::max(largest, block.dim);
    for (const std::int64_t group : document.tag_sets[static_cast<std::size_t>(block.groups)])
      dimensions[group < 0 ? -group : group].insert(block.dim);
  }
  std::vector<GroupName> all;
  for (const GroupName& name : names) {
    if (name.dim != no_dimension) {
      all.push_back(name);
      continue;
    }
    const auto found = dimensions.find(name.group);
    for (const int dim : found == dimensions.end() ? std::set{largest} : found->second)
      all.push_back({dim, name.group, name.name});
  }
  document.group_names = std::move(all);
}

}  // namespace tetproof::io
