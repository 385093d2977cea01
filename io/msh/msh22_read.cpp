// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the nodes of .msh 1 and 2 and the elements of .msh 1 to 3.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/plain_lines.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/element_types.hpp"
#include "io/msh/msh22_elements.hpp"
#include "io/msh/msh_sections.hpp"

namespace tetproof::io {
namespace {

class ElementReader {
 public:
  ElementReader(Numbers& in, ElementTags kind, Document& document, NodeIndex& index, TagSets& sets,
                std::vector<ElementTag>& copies)
      : in_(in), document_(document), index_(index), elements_(kind, document, sets, copies) {}

  // A line: tag, type, number of tags, tags, nodes. Polygons and polyhedra have the number of nodes before
  // them.
  void read_text(std::int64_t count) {
    make_room(count);
    if (read_plain(static_cast<std::size_t>(count), [&](const auto& take) {
          return read_plain_elements22(in_, static_cast<std::size_t>(count), index_, take);
        }))
      return elements_.finish();
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      const std::int64_t tags = in_.integer("the number of tags");
      in_.check_count(tags, "the number of tags", 2);
      read_element_tags(tags);
      const std::int64_t each = type_                                          ? type_->nodes
                                : has_counted_nodes(static_cast<int>(number_)) ? read_node_count()
                                                                               : in_.words_in_line();
      if (each == 0) in_.fail(fmt::format("expected the nodes of an element of type {}", number_));
      elements_.add(tag, read_nodes(each));
    }
    elements_.finish();
  }

  // A line: tag, type, physical and elementary tag, number of nodes, nodes.
  void read_1(std::int64_t count) {
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      read_element_tags(2);
      elements_.add(tag, read_nodes(read_node_count()));
    }
    elements_.finish();
  }

  // A line: tag, type, entity, how many numbers follow. These are the nodes and, if there are more, the
  // number of partitions and the partitions. For a type that is not known all of them are nodes.
  void read_3(std::int64_t count) {
    for (std::int64_t e = 0; e < count; ++e) {
      const std::int64_t tag = in_.integer("the tag of an element");
      set_type(in_.integer("an element type"));
      const std::int64_t entity = in_.integer("the tag of an entity");
      const std::int64_t numbers = in_.integer("how many numbers follow");
      in_.check_count(numbers, "how many numbers follow", in_.binary() ? 4 : 2);
      if (numbers == 0 || (type_ && numbers < type_->nodes))
        in_.fail(fmt::format("expected the nodes of an element of type {}, found {}", number_,
                             counted(numbers, "numbers")));
      const std::span<const Index> nodes = read_nodes(type_ ? type_->nodes : numbers);
      std::vector<std::int64_t> partitions(static_cast<std::size_t>(type_ ? numbers - type_->nodes : 0));
      for (std::int64_t& partition : partitions)
        partition = in_.integer("a partition, or how many there are");
      if (!partitions.empty()) {
        if (partitions[0] == static_cast<std::int64_t>(partitions.size()) - 1) {
          partitions.erase(partitions.begin());
        } else {  // the parent of a sub-element: a document has no place for it
          add_loss(document_.dropped, "numbers behind the nodes of elements that are no partitions",
                   partitions.size(), fmt::format("element {}", tag));
          partitions.clear();
        }
      }
      elements_.set_entity(entity, partitions);
      elements_.add(tag, nodes);
    }
    elements_.finish();
  }

  // Headers (type, number of elements, number of tags), each followed by its elements (tag, tags, nodes). As
  // in Gmsh, a header may have more elements than are left of those that the section announces.
  void read_binary(std::int64_t count) {
    make_room(count);
    const std::size_t start = in_.offset();
    for (std::int64_t left = count; left > 0;) {
      set_type(in_.integer("an element type"));
      if (!type_) in_.fail(fmt::format("unknown element type {}", number_));
      const std::int64_t here = in_.integer("the number of elements that follow");
      if (here < 1)
        in_.fail(fmt::format("expected the number of elements that follow, 1 or more, found {}", here));
      const std::int64_t tags = in_.integer("the number of tags");
      in_.check_count(tags, "the number of tags", 4);
      in_.check_count(here, "the number of elements that follow", 4 * (1 + tags + type_->nodes));
      const bool plain = read_plain(static_cast<std::size_t>(here), [&](const auto& take) {
        return read_plain_records22(in_, *type_, static_cast<std::size_t>(here),
                                    static_cast<std::size_t>(tags), index_, take);
      });
      for (std::int64_t e = 0; e < here && !plain; ++e) {
        const std::int64_t tag = in_.integer("the tag of an element");
        read_element_tags(tags);
        elements_.add(tag, read_nodes(type_->nodes));
      }
      left -= here;
      if (left < 0)
        document_.warnings.push_back(fmt::format("{}: byte {}: {} {} announced, and {} are there",
                                                 document_.path, start, counted(count, "elements"),
                                                 count == 1 ? "is" : "are", count - left));
    }
    elements_.finish();
  }

  void list_dropped() { elements_.list_dropped(); }

 private:
  // In most files most elements are tetrahedra.
  void make_room(std::int64_t count) {
    reserve_in_large_pages(document_.connectivity,
                           document_.connectivity.size() + 4 * static_cast<std::size_t>(count));
  }

  // `read` passes plain elements to its argument. Where it returns false, nothing was read.
  template <class Read>
  bool read_plain(std::size_t count, const Read& read) {
    if (count < least_plain_lines) return false;
    const Elements22::Mark before = elements_.mark();
    std::size_t left = count;
    const auto take = [&](const PlainElements22& piece) {
      elements_.add(piece, left);
      left -= piece.tags.size();
    };
    if (read(take)) return true;
    elements_.back_to(before);
    return false;
  }

  void set_type(std::int64_t number) {
    elements_.set_type(number);
    if (number == number_) return;
    number_ = number;
    type_ = element_type(number);
    if (number < 0 || number > std::numeric_limits<int>::max())
      in_.fail(fmt::format("expected an element type, found {}", number));
  }

  std::int64_t read_node_count() {
    const std::int64_t each = in_.integer("the number of nodes of an element");
    in_.check_count(each, "the number of nodes of an element", 2);
    if (each == 0 || (type_ && each != type_->nodes))
      in_.fail(fmt::format("expected {} of an element of type {}, found {}",
                           type_ ? counted(type_->nodes, "nodes") : "the nodes", number_, each));
    return each;
  }

  std::span<const Index> read_nodes(std::int64_t each) {
    nodes_.resize(static_cast<std::size_t>(each));
    for (Index& node : nodes_) node = index_(in_.integer("the tag of a node"));
    return nodes_;
  }

  void read_element_tags(std::int64_t count) {
    tags_.resize(static_cast<std::size_t>(count));
    for (std::int64_t& tag : tags_) tag = in_.integer("an element's physical, elementary or partition tag");
    elements_.set_tags(tags_);
  }

  Numbers& in_;
  Document& document_;
  NodeIndex& index_;
  Elements22 elements_;
  std::int64_t number_ = -1;
  const ElementType* type_ = nullptr;
  std::vector<std::int64_t> tags_;
  std::vector<Index> nodes_;
};

}  // namespace

void read_nodes22(Numbers& in, std::int64_t count, bool parametric, Document& document) {
  Tags tags(document.node_tags, document.first_node);
  check_node_count(in, document.points.size() + count);
  if (!parametric && read_plain_nodes22(in, static_cast<std::size_t>(count), document, tags)) return;
  document.points.reserve(document.points.size() + count);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::size_t position = document.points.size();
    tags.add(position, in.integer("the tag of a node"));
    const double x = in.real("a coordinate"), y = in.real("a coordinate"), z = in.real("a coordinate");
    document.points.emplace_back(x, y, z);
    if (!parametric) continue;
    const std::int64_t dim = in.integer("the dimension of a node's entity");
    if (dim < 0 || dim > 3)
      in.fail(fmt::format("expected the dimension of a node's entity, 0 to 3, found {}", dim));
    const std::int64_t entity = in.integer("the tag of a node's entity");
    const int each = dim == 1 || dim == 2 ? static_cast<int>(dim) : 0;
    if (document.node_blocks.empty() || document.node_blocks.back().dim != dim ||
        document.node_blocks.back().entity != entity)
      document.node_blocks.push_back({.dim = static_cast<int>(dim),
                                      .entity = entity,
                                      .first = position,
                                      .parameters_each = each,
                                      .parameters = document.parameters.size()});
    ++document.node_blocks.back().count;
    for (int k = 0; k < each; ++k) document.parameters.push_back(in.real("a parametric coordinate"));
  }
}

void read_elements22(Numbers& in, std::int64_t count, ElementTags tags, Document& document, NodeIndex& index,
                     TagSets& sets, std::vector<ElementTag>& copies) {
  ElementReader reader(in, tags, document, index, sets, copies);
  if (tags == ElementTags::v3)
    reader.read_3(count);
  else if (tags == ElementTags::v1)
    reader.read_1(count);
  else
    in.binary() ? reader.read_binary(count) : reader.read_text(count);
  reader.list_dropped();
}

}  // namespace tetproof::io
