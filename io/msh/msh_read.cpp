// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a .msh file section by section, and joins what the sections say.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "io/bytes/checksum.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/element_types.hpp"
#include "io/model/groups_of_values.hpp"
#include "io/model/tag_words.hpp"
#include "io/model/values.hpp"
#include "io/msh/msh.hpp"
#include "io/msh/msh22_ghosts.hpp"
#include "io/msh/msh_data.hpp"
#include "io/msh/msh_sections.hpp"
#include "io/supplement/supplement.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  explicit Reader(const InputFile& file)
      : file_(file), end_of_text_(end_of_text(file.bytes())), in_(file), sets_(document_) {
    document_.path = file.path();
  }

  Document read() {
    while (!in_.at_end()) {
      const std::size_t start = in_.offset();
      if (start >= end_of_text_) {
        document_.warnings.push_back(warning_of_end(file_));
        break;
      }
      const std::string_view word = in_.word();
      if (document_.format.empty() && (word == "$NOD" || word == "$NOE")) document_.format = "msh1";
      if (word.size() < 2 || word[0] != '$') {
        if (!document_.format.empty() && drop_to_next_section(start)) continue;
        if (!has_nodes_ || !has_elements_) in_.fail("a section ($Name)", word);
        add_loss(document_.dropped, "bytes behind the last section", file_.bytes().size() - start,
                 fmt::format("byte {}", start), may_be_elements(file_.bytes().substr(start)));
        break;
      }
      const std::string name(word.substr(1));
      if (!std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; }))
        in_.fail("a section ($Name)", word);
      if (document_.format.empty() && name != "MeshFormat" && name != "Comments")
        in_.fail("$MeshFormat", word);
      behind_the_name(name);
      section(name);
    }
    if (document_.format.empty()) in_.fail("$MeshFormat", {});
    for (const auto& [has, name] : {std::pair(has_nodes_, "$Nodes"), std::pair(has_elements_, "$Elements")})
      if (!has) document_.warnings.push_back(fmt::format("{}: there is no section {}", file_.path(), name));
    finish();
    if (!supplement_.empty()) take_back_supplement();
    return std::move(document_);
  }

 private:
  // Gmsh passes over lines between sections. False: no section follows.
  bool drop_to_next_section(std::size_t start) {
    const std::string_view bytes = file_.bytes();
    std::size_t next = start;
    do {
      next = bytes.find('$', next + 1);
      if (next == std::string_view::npos || next + 1 >= bytes.size()) return false;
    } while ((bytes[next - 1] != '\n' && bytes[next - 1] != '\r') || bytes[next + 1] < 'A' ||
             bytes[next + 1] > 'Z');
    add_loss(document_.dropped, "bytes between sections", next - start, fmt::format("byte {}", start),
             may_be_elements(bytes.substr(start, next - start)));
    go_to(next);
    return true;
  }

  // A section begins in the line after its name.
  void behind_the_name(const std::string& name) {
    if (!in_.at_line_end())
      add_loss(document_.dropped, "texts behind the names of sections", 1,
               fmt::format("line {}: ${}", in_.line(), name));
    in_.next_line();
  }

  void section(const std::string& name) {
    const std::string& format_name = document_.format;
    const bool v4 = format_name == "msh41" || format_name == "msh40";
    if (name == "MeshFormat") {
      if (!format_name.empty()) in_.fail_in_line("a second $MeshFormat");
      format_ = read_mesh_format(in_, document_);
    } else if (name == "PhysicalNames") {
      read_physical_names(in_, document_);
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
      data_.read_periodic(numbers, !v4 || (format_name == "msh40" && !format_.binary));
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
    drop_rows(name);
    const std::string_view word = in_.word();
    if (word == end) return;
    if (!is_data(name) || !word.starts_with("$End")) in_.fail(end, word);
    document_.warnings.push_back(
        fmt::format("{}:{}: section ${} ends with {}", file_.path(), in_.line(), name, word));
  }

  // Gmsh passes over lines behind those that a section announces, and over bytes in binary.
  void drop_rows(const std::string& name) {
    const bool elements = name == "Elements" || name == "ELM";
    if (format_.binary) return drop_bytes(name, elements);
    if (!in_.at_line_end()) return;
    for (; !in_.at_end() && in_.peek_byte() != '$'; in_.next_line())
      add_loss(document_.dropped, fmt::format("lines of ${} behind those that it announces", name), 1,
               fmt::format("line {}", in_.line()), elements);
  }

  void drop_bytes(const std::string& name, bool elements) {
    if (Scanner(in_).word().starts_with("$End")) return;
    const std::size_t start = in_.offset(), end = end_of_section(name, start);
    if (end == std::string_view::npos) return;
    const bool has_line = end > start && file_.bytes()[end - 1] == '\n';  // a line end stands before $End
    add_loss(document_.dropped, fmt::format("bytes of ${} behind those that it announces", name),
             end - start - (has_line ? 1 : 0), fmt::format("byte {}", start), elements);
    go_to(end);
  }

  static bool is_data(const std::string& name) {
    return name == "NodeData" || name == "ElementData" || name == "ElementNodeData";
  }

  // False where the section has tags that are not understood.
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
    const std::int64_t count = in_.count("the number of nodes", format_.binary ? node_bytes22 : 8);
    if (format_.binary) in_.next_line();
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
    if (format_.binary) in_.next_line();
    Numbers numbers = numbers_here();
    read_elements22(numbers, count, document_.format == "msh1" ? ElementTags::v1 : format_.element_tags,
                    document_, *index_, sets_, copies_);
    go_to(numbers.offset());
  }

  // Where the first `$Endname` behind `start` stands: in a text, at the start of a line. npos: nowhere.
  std::size_t end_of_section(const std::string& name, std::size_t start) const {
    const std::string end = "$End" + name;
    const std::string_view bytes = file_.bytes();
    for (std::size_t stop = start; (stop = bytes.find(end, stop)) != std::string_view::npos; ++stop) {
      const std::size_t after = stop + end.size();
      const bool starts_line =
          format_.binary || stop == start || bytes[stop - 1] == '\n' || bytes[stop - 1] == '\r';
      if (starts_line && (after == bytes.size() || static_cast<unsigned char>(bytes[after]) <= ' '))
        return stop;
    }
    return std::string_view::npos;
  }

  // The content of a section that is not read word by word. Continues behind its end.
  std::string_view verbatim(const std::string& name) {
    const std::size_t start = in_.offset(), stop = end_of_section(name, start);
    if (stop == std::string_view::npos)  // the place is the line of the section's name, not the next one
      Scanner(file_.path(), file_.bytes(), start - 1)
          .fail_in_line(fmt::format("section ${} has no $End{}", name, name));
    go_to(stop + name.size() + 4);
    return file_.bytes().substr(start, stop - start);
  }

  void keep(const std::string& name) {
    const std::string_view body = verbatim(name);
    document_.sections.push_back({.name = name,
                                  .body = std::string(body),
                                  .format = document_.format,
                                  .binary = format_.binary,
                                  .swapped = format_.swapped,
                                  .before_nodes = !has_nodes_});
  }

  // The supplement is joined when all else has been read.
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
      drop_outdated_supplement(document_.path, document_);
  }

  void finish() {
    if (document_.format == "msh22" || document_.format == "msh3") take_ghosts_from_partitions(document_);
    if (nodes_came_later_ && !document_.unknown.empty()) find_late_nodes();
    if (!index_) index_.emplace(document_);  // it finds nodes that are given twice
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
    find_dimensions_of_names(document_);
    if (!data_.empty()) {
      data_.look_up(document_, *index_, copies_);
      if (supplement_.empty()) take_groups_from_data();  // a supplement names the values of the file
    }
    // Our own writer repeats an element for each of its groups. That is no oddity in a file with our
    // supplement.
    warn_of_oddities(document_, supplement_.empty() ? copies_ : std::vector<ElementTag>{});
  }

  // meshio writes the references of Medit and the attributes of TetGen as data. Words without a colon may be
  // anybody's data.
  void take_groups_from_data() {
    for (const TagWord& word : tag_words) {
      if (word.tag != Tag::group || word.word.find(':') == word.word.npos) continue;
      const auto found =
          std::find_if(document_.element_values.begin(), document_.element_values.end(),
                       [&](const Values& values) { return values.name == word.word && !has_step(values); });
      if (found == document_.element_values.end()) continue;
      const auto place = found - document_.element_values.begin();
      const std::size_t before = document_.element_values.size();
      const bool of_view = std::exchange(found->of_view, false);
      make_groups_of_values(document_, std::string(word.word));
      if (document_.element_values.size() == before) document_.element_values[place].of_view = of_view;
    }
  }

  // Looks up nodes again: the elements stood before their nodes.
  void find_late_nodes() {
    std::vector<std::int64_t> unknown;
    unknown.swap(document_.unknown);
    index_.emplace(document_);
    for (Index& node : document_.connectivity)
      if (node < 0) node = (*index_)(unknown[-1 - node]);
  }

  Numbers numbers_here(bool text = false) const {
    return {file_, in_.offset(), format_.binary && !text, format_.swapped};
  }
  void go_to(std::size_t offset) { in_ = Scanner(file_.path(), file_.bytes(), offset); }

  const InputFile& file_;
  const std::size_t end_of_text_;
  Scanner in_;
  Document document_;
  TagSets sets_;
  std::optional<NodeIndex> index_;
  std::string_view supplement_, native_part_;
  MshData data_;
  std::vector<ElementTag> copies_;
  MshFormat format_;
  bool has_nodes_ = false, has_elements_ = false, nodes_came_later_ = false;
};

}  // namespace

Document read_msh(const InputFile& file) {
  return Reader(file).read();
}

}  // namespace tetproof::io
