// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of a .msh file: its header, its sections, and what holds for all of it.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "io/bytes/checksum.hpp"
#include "io/bytes/scanner.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/msh/msh.hpp"
#include "io/msh/msh_data.hpp"
#include "io/msh/msh_sections.hpp"
#include "io/supplement/supplement.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  explicit Reader(const InputFile& file) : file_(file), in_(file), sets_(document_) {
    document_.path = file.path();
  }

  Document read() {
    while (!in_.at_end()) {
      const std::size_t start = in_.offset();
      const std::string_view word = in_.word();
      if (document_.format.empty() && (word == "$NOD" || word == "$NOE")) document_.format = "msh1";
      if (word.size() < 2 || word[0] != '$') {
        if (!has_nodes_ || !has_elements_) in_.fail("a section ($Name)", word);
        document_.warnings.push_back(fmt::format("{}: byte {}: {} bytes after the last section are ignored",
                                                 file_.path(), start, file_.bytes().size() - start));
        break;
      }
      const std::string name(word.substr(1));
      if (!std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; }))
        in_.fail("a section ($Name)", word);
      if (document_.format.empty() && name != "MeshFormat" && name != "Comments")
        in_.fail("$MeshFormat", word);
      in_.next_line();
      section(name);
    }
    if (document_.format.empty()) in_.fail("$MeshFormat", {});
    if (!has_nodes_) in_.fail("a section $Nodes", {});
    if (!has_elements_) in_.fail("a section $Elements", {});
    finish();
    if (!supplement_.empty()) take_back_supplement();
    return std::move(document_);
  }

 private:
  void section(const std::string& name) {
    const std::string& format_name = document_.format;
    const bool v4 = format_name == "msh41" || format_name == "msh40";
    if (name == "MeshFormat") {
      format();
    } else if (name == "PhysicalNames") {
      physical_names();
    } else if (name == "Nodes" || (name == "ParametricNodes" && format_name == "msh22") ||
               ((name == "NOD" || name == "NOE") && format_name == "msh1")) {
      nodes(name == "ParametricNodes");
    } else if (name == "Elements" || (name == "ELM" && format_name == "msh1")) {
      elements();
    } else if (name == "Entities" && (v4 || format_name == "msh3")) {
      Numbers numbers = numbers_here(format_name == "msh3");
      v4 ? read_entities4(numbers, format_name == "msh40", document_, sets_)
         : read_entities3(numbers, document_, sets_);
      go_to(numbers.offset());
    } else if (name == "PartitionedEntities" && v4) {
      Numbers numbers = numbers_here();
      read_partitioned_entities4(numbers, format_name == "msh40", document_, sets_);
      go_to(numbers.offset());
    } else if (name == "TetproofSupplement") {
      supplement();
      return;
    } else if (name == "Periodic") {
      Numbers numbers = numbers_here(!v4);
      data_.read_periodic(numbers, !v4 || (format_name == "msh40" && !binary_));
      go_to(numbers.offset());
    } else if (name == "GhostElements" && v4) {
      Numbers numbers = numbers_here();
      data_.read_ghosts(numbers);
      go_to(numbers.offset());
    } else if (!is_data(name) || !data(name)) {
      keep(name);
      return;
    }
    end(name);
  }

  void end(const std::string& name) {
    const std::string end = (name == "NOD" || name == "NOE" || name == "ELM" ? "$END" : "$End") + name;
    const std::string_view word = in_.word();
    if (word == end) return;
    if (!is_data(name) || !word.starts_with("$End")) in_.fail(end, word);
    document_.warnings.push_back(
        fmt::format("{}:{}: section ${} ends with {}", file_.path(), in_.line(), name, word));
  }

  static bool is_data(const std::string& name) {
    return name == "NodeData" || name == "ElementData" || name == "ElementNodeData";
  }

  // False where it has tags that are not understood.
  bool data(const std::string& name) {
    Scanner in = in_;
    auto header = MshData::read_header(in);
    if (!header) return false;
    in_ = in;
    Numbers numbers = numbers_here();
    data_.read_rows(numbers, std::move(*header),
                    name == "NodeData"      ? Of::node
                    : name == "ElementData" ? Of::element
                                            : Of::element_node);
    go_to(numbers.offset());
    return true;
  }

  void format() {
    if (!document_.format.empty()) in_.fail_in_line("a second $MeshFormat");
    const std::string_view version = in_.word();
    double number = 0;
    if (!parse_real(version, number)) in_.fail("a version of the format", version);
    if (number != 4.1 && number != 4 && !(number >= 2 && number < 4)) refuse_version(version);
    document_.format = number == 4.1 ? "msh41" : number == 4 ? "msh40" : number >= 3 ? "msh3" : "msh22";
    element_tags_ = number >= 3 ? ElementTags::v3 : number >= 2.2 ? ElementTags::v22 : ElementTags::v20;
    const std::int64_t kind = in_.integer("0 for text or 1 for binary");
    if (kind != 0 && kind != 1)
      in_.fail_in_line(fmt::format("expected 0 for text or 1 for binary, found {}", kind));
    binary_ = kind == 1;
    const std::int64_t size = in_.integer("the size of a number in bytes");
    if (!binary_ && size != 8)
      document_.warnings.push_back(
          fmt::format("{}:{}: the size of numbers is {} and not 8, which means nothing in text", file_.path(),
                      in_.line(), size));
    if (!binary_) return;
    if (size != 8) in_.fail_in_line(fmt::format("expected binary numbers of 8 bytes, found {}", size));
    in_.next_line();
    const std::size_t place = in_.offset();
    const std::string_view one = in_.raw(4, "the number 1 that tells the byte order");
    Numbers as_here(file_.path(), one, 0, true, false), swapped(file_.path(), one, 0, true, true);
    if (as_here.integer("") == 1) return;
    swapped_ = swapped.integer("") == 1;
    if (!swapped_) {
      go_to(place);
      in_.fail_at_byte("expected the number 1 that tells the byte order");
    }
  }

  [[noreturn]] void refuse_version(std::string_view version) {
    in_.fail_in_line(
        fmt::format("this is a .msh file of version {}; versions 1 to 3, 4.0 and 4.1 are read", version));
  }

  void physical_names() {
    const std::int64_t count = in_.count("the number of physical names", 6);
    for (std::int64_t i = 0; i < count; ++i) {
      GroupName name;
      const std::int64_t dim = in_.integer("the dimension of a physical group");
      if (dim < 0 || dim > 3)
        in_.fail_in_line(fmt::format("expected the dimension of a physical group, 0 to 3, found {}", dim));
      name.dim = static_cast<int>(dim);
      name.group = in_.integer("the number of a physical group");
      in_.at_line_end();
      const std::string_view line = in_.rest_of_line();
      const std::size_t from = line.find('"'), to = line.rfind('"');
      if (from == std::string_view::npos || to == from) in_.fail("a name in double quotes", line);
      name.name = line.substr(from + 1, to - from - 1);
      document_.group_names.push_back(std::move(name));
    }
  }

  void nodes(bool parametric) {
    has_nodes_ = true;
    nodes_came_later_ = has_elements_;
    index_.reset();
    if (document_.format == "msh41" || document_.format == "msh40") {
      Numbers numbers = numbers_here();
      read_nodes4(numbers, document_.format == "msh40", document_);
      go_to(numbers.offset());
      return;
    }
    const std::int64_t count = in_.count("the number of nodes", binary_ ? 28 : 8);
    if (binary_) in_.next_line();
    Numbers numbers = numbers_here();
    if (document_.format == "msh3")
      read_nodes3(numbers, count, document_);
    else
      read_nodes22(numbers, count, parametric, document_);
    go_to(numbers.offset());
  }

  void elements() {
    has_elements_ = true;
    if (!index_) index_.emplace(document_);
    if (document_.format == "msh41" || document_.format == "msh40") {
      Numbers numbers = numbers_here();
      read_elements4(numbers, document_.format == "msh40", document_, *index_);
      go_to(numbers.offset());
      return;
    }
    const std::int64_t count = in_.count("the number of elements", 8);
    if (binary_) in_.next_line();
    Numbers numbers = numbers_here();
    read_elements22(numbers, count, document_.format == "msh1" ? ElementTags::v1 : element_tags_, document_,
                    *index_, sets_, copies_);
    go_to(numbers.offset());
  }

  // The content of a section that is not read word by word; goes on behind its end.
  std::string_view verbatim(const std::string& name) {
    const std::string end = "$End" + name;
    const std::size_t start = in_.offset();
    const std::string_view bytes = file_.bytes();
    std::size_t stop = start;
    for (;; ++stop) {
      stop = bytes.find(end, stop);
      if (stop == std::string_view::npos)  // the place: the section's first line, not the one after it
        Scanner(file_.path(), bytes, start - 1).fail_in_line(fmt::format("section ${} has no {}", name, end));
      const std::size_t after = stop + end.size();
      const bool starts_line = binary_ || stop == start || bytes[stop - 1] == '\n' || bytes[stop - 1] == '\r';
      if (starts_line && (after == bytes.size() || static_cast<unsigned char>(bytes[after]) <= ' ')) break;
    }
    go_to(stop + end.size());
    return bytes.substr(start, stop - start);
  }

  void keep(const std::string& name) {
    const std::string_view body = verbatim(name);
    document_.sections.push_back({.name = name,
                                  .body = std::string(body),
                                  .format = document_.format,
                                  .binary = binary_,
                                  .swapped = swapped_,
                                  .before_nodes = !has_nodes_});
  }

  // Lines that are taken back when all else is read.
  void supplement() {
    if (!supplement_.empty()) in_.fail_in_line("a second supplement");
    native_part_ = file_.bytes().substr(0, file_.bytes().rfind('$', in_.offset() - 1));
    supplement_ = verbatim("TetproofSupplement");
  }

  void take_back_supplement() {
    const std::vector<Checksum> checksums = read_supplement_head(supplement_, document_);
    if (checksums.empty()) return;
    if (checksums.size() == 1 && crc32_of(file_, native_part_.size()) == checksums[0].crc32)
      take_back(supplement_, document_.path + ": section $TetproofSupplement", document_);
    else
      document_.warnings.push_back(outdated_supplement(document_.path));
  }

  void finish() {
    if (nodes_came_later_ && !document_.unknown.empty()) find_late_nodes();
    if (document_.format != "msh1" && document_.format != "msh22") {
      std::map<std::pair<int, std::int64_t>, const Entity*> entities;
      for (const Entity& entity : document_.entities) entities.try_emplace({entity.dim, entity.tag}, &entity);
      for (ElementBlock& block : document_.blocks) {
        const auto found = entities.find({block.dim, block.entity});
        if (found == entities.end()) continue;
        block.groups = found->second->groups;
        if (document_.format != "msh3") block.partitions = found->second->partitions;
      }
    }
    if (!data_.empty()) {
      if (!index_) index_.emplace(document_);
      data_.look_up(document_, *index_, copies_);
    }
    // In a file of our own that keeps something aside, it is no oddity that elements stand once for each
    // group.
    warn_of_oddities(document_, supplement_.empty() ? copies_ : std::vector<ElementTag>{});
  }

  // Elements stood before their nodes.
  void find_late_nodes() {
    std::vector<std::int64_t> unknown;
    unknown.swap(document_.unknown);
    index_.emplace(document_);
    for (Index& node : document_.connectivity)
      if (node < 0) node = (*index_)(unknown[-1 - node]);
  }

  Numbers numbers_here(bool text = false) const { return {file_, in_.offset(), binary_ && !text, swapped_}; }
  void go_to(std::size_t offset) { in_ = Scanner(file_.path(), file_.bytes(), offset); }

  const InputFile& file_;
  Scanner in_;
  Document document_;
  TagSets sets_;
  std::optional<NodeIndex> index_;
  std::string_view supplement_, native_part_;
  MshData data_;
  std::vector<ElementTag> copies_;
  bool binary_ = false, swapped_ = false;
  ElementTags element_tags_ = ElementTags::v22;
  bool has_nodes_ = false, has_elements_ = false, nodes_came_later_ = false;
};

}  // namespace

Document read_msh(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
