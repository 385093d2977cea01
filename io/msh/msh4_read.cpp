// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sections of .msh 4.0 and 4.1, which differ in the order of a few numbers.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/words.hpp"
#include "io/model/element_types.hpp"
#include "io/msh/msh4_plain.hpp"
#include "io/msh/msh_sections.hpp"

namespace tetproof::io {
namespace {

// Reads the tag of a node or an element. In binary 4.0 it is an int.
std::int64_t read_tag(Numbers& in, bool v40, const char* expected) {
  return v40 ? in.integer(expected) : in.size(expected);
}

int read_dim(Numbers& in) {
  const std::int64_t dim = in.integer("the dimension of an entity");
  if (dim < 0 || dim > 3) in.fail(fmt::format("expected the dimension of an entity, 0 to 3, found {}", dim));
  return static_cast<int>(dim);
}

std::vector<std::int64_t> read_tags(Numbers& in, const char* how_many, const char* one) {
  std::vector<std::int64_t> tags(in.count(how_many, 2, 4));
  for (std::int64_t& tag : tags) tag = in.integer(one);
  return tags;
}

void read_entity(Numbers& in, int dim, bool partitioned, bool v40, TagSets& sets, Entity& entity) {
  entity.dim = dim;
  entity.tag = in.integer("the tag of an entity");
  if (partitioned) {
    const std::int64_t parent = in.integer("the dimension of the parent entity");
    if (parent < -1 || parent > 3)
      in.fail(fmt::format("expected the dimension of the parent entity, 0 to 3, found {}", parent));
    entity.parent_dim = static_cast<int>(parent);
    entity.parent = in.integer("the tag of the parent entity");
    entity.partitions = sets(read_tags(in, "the number of partitions", "a partition"));
  }
  const int values = dim == 0 && !v40 ? 3 : 6;
  for (int k = 0; k < values; ++k) entity.box[k] = in.real("a coordinate of an entity's box");
  if (values == 3) std::copy_n(entity.box.begin(), 3, entity.box.begin() + 3);
  entity.groups = sets(read_tags(in, "the number of physical groups", "a physical group"));
  if (dim > 0)
    entity.boundary = read_tags(in, "the number of bounding entities", "the tag of a bounding entity");
}

void read_all_entities(Numbers& in, bool partitioned, bool v40, Document& document, TagSets& sets) {
  std::size_t counts[4];
  for (std::size_t& count : counts)
    count = in.count("the number of entities", partitioned ? 14 : 10, partitioned ? 52 : 36);
  for (int dim = 0; dim < 4; ++dim) {
    in.check_count(static_cast<std::int64_t>(counts[dim]), "the number of entities", in.binary() ? 36 : 10);
    const std::size_t start = append(document.entities, counts[dim]);
    for (std::size_t i = 0; i < counts[dim]; ++i)
      read_entity(in, dim, partitioned, v40, sets, document.entities[start + i]);
  }
}

// Reads the entity of a block of nodes or elements. 4.0 has its tag first, 4.1 its dimension.
template <class Block>
void read_entity_of(Numbers& in, bool v40, Block& block) {
  if (!v40) block.dim = read_dim(in);
  block.entity = in.integer("the tag of an entity");
  if (v40) block.dim = read_dim(in);
}

// Reads the elements of `document.blocks.back()`, which have `each` nodes.
void read_block(Numbers& in, bool v40, std::size_t count, int each, Document& document, NodeIndex& index,
                Tags& tags) {
  const std::size_t first = document.blocks.back().first;
  const std::size_t start = append(document.connectivity, count * each);
  Index* node = document.connectivity.data() + start;
  if (!v40 && read_plain_elements(in, count, each, node, index, tags, first)) return;
  Numbers here = in;  // a copy that the compiler can keep in registers
  for (std::size_t e = 0; e < count; ++e) {
    tags.add(first + e, read_tag(here, v40, "the tag of an element"));
    for (int k = 0; k < each; ++k) *node++ = index(read_tag(here, v40, "the tag of a node"));
  }
  in = here;
}

// What the first line of $Nodes or $Elements announces: the number of blocks and of nodes or elements in all
// of them. As in Gmsh the number of blocks holds, and each block has a count of its own; the total means
// nothing.
class Announced {
 public:
  Announced(Numbers& in, const char* of, Document& document)
      : in_(in), of_(of), document_(document), place_(in.offset()) {
    blocks_ = in.size("the number of blocks"), total_ = in.size("the number of nodes or elements");
    if (blocks_ < 0 || total_ < 0)
      in.fail(fmt::format("expected the number of blocks and of {}, found {} and {}", of, blocks_, total_));
    if (in.binary()) in.check_count(blocks_, "the number of blocks", 20);
  }

  // How many there can be at most, of so many bytes each.
  std::size_t likely(std::size_t bytes_each) const {
    return std::min(static_cast<std::size_t>(total_), in_.remaining() / bytes_each + 1);
  }
  bool next_block() {
    if (found_ == blocks_) return false;
    if (!in_.binary() && in_.at_section_end())
      in_.fail(fmt::format("expected {} of {}, found {} and the end of {}", counted(blocks_, "blocks"), of_,
                           found_, in_.remaining() == 0 ? "the file" : "the section"));
    ++found_;
    return true;
  }
  void compare(std::size_t total) {
    if (static_cast<std::size_t>(total_) == total) return;
    const std::string place =
        in_.binary() ? fmt::format("byte {}", place_) : fmt::format("{}", in_.line(place_));
    document_.warnings.push_back(fmt::format("{}:{}{}: {} {} announced, and {} {} in the {}", document_.path,
                                             in_.binary() ? " " : "", place, counted(total_, of_),
                                             total_ == 1 ? "is" : "are", counted(total, of_),
                                             total == 1 ? "is" : "are", counted(blocks_, "blocks")));
  }

 private:
  Numbers& in_;
  const char* const of_;
  Document& document_;
  const std::size_t place_;
  std::int64_t blocks_ = 0, total_ = 0, found_ = 0;
};

}  // namespace

void check_node_count(const Numbers& in, std::size_t nodes) {
  if (nodes > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    in.fail(fmt::format("{} nodes are more than the {} that can be numbered here", nodes,
                        std::numeric_limits<Index>::max()));
}

void read_entities4(Numbers& in, bool v40, Document& document, TagSets& sets) {
  read_all_entities(in, false, v40, document, sets);
}

void read_partitioned_entities4(Numbers& in, bool v40, Document& document, TagSets& sets) {
  document.partitions = in.size("the number of partitions");
  const std::int64_t ghosts = in.count("the number of ghost entities", 4, 8);
  for (std::int64_t g = 0; g < ghosts; ++g) {
    const std::int64_t tag = in.integer("the tag of a ghost entity");
    document.ghosts.push_back({tag, in.integer("the partition of a ghost entity")});
  }
  read_all_entities(in, true, v40, document, sets);
}

void read_nodes4(Numbers& in, bool v40, Document& document) {
  const std::size_t least_binary = v40 ? 28 : 32;  // bytes a node
  Announced announced(in, "nodes", document);
  if (!v40) {
    in.size("the least node tag");
    in.size("the largest node tag");
  }
  Tags tags(document.node_tags, document.first_node);
  const std::size_t before = document.points.size();
  reserve_in_large_pages(document.points, before + announced.likely(in.binary() ? least_binary : 8));
  while (announced.next_block()) {
    NodeBlock block;
    read_entity_of(in, v40, block);
    const std::int64_t parametric = in.integer("0 or 1 for parametric coordinates");
    if (parametric != 0 && parametric != 1)
      in.fail(fmt::format("expected 0 or 1 for parametric coordinates, found {}", parametric));
    block.parameters_each = parametric ? block.dim : 0;
    block.first = document.points.size();
    block.count = in.count("the number of nodes in a block", 8, least_binary);
    check_node_count(in, block.first + block.count);
    if (v40) {
      // Each node's tag stands in front of its coordinates.
    } else if (!read_plain_tags(in, block.count, tags, block.first)) {
      for (std::size_t i = 0; i < block.count; ++i) tags.add(block.first + i, in.size("the tag of a node"));
    }
    block.parameters = append(document.parameters, block.count * block.parameters_each);
    double* parameter = document.parameters.data() + block.parameters;
    const bool plain = !v40 && read_plain_points(in, block, document);
    for (std::size_t i = 0; i < block.count && !plain; ++i) {
      if (v40) tags.add(block.first + i, in.integer("the tag of a node"));
      const double x = in.real("a coordinate"), y = in.real("a coordinate"), z = in.real("a coordinate");
      document.points.emplace_back(x, y, z);
      for (int k = 0; k < block.parameters_each; ++k) *parameter++ = in.real("a parametric coordinate");
    }
    if (block.count > 0) document.node_blocks.push_back(block);
  }
  announced.compare(document.points.size() - before);
}

void read_elements4(Numbers& in, bool v40, Document& document, NodeIndex& index) {
  Announced announced(in, "elements", document);
  if (!v40) {
    in.size("the least element tag");
    in.size("the largest element tag");
  }
  Tags tags(document.element_tags, document.first_element);
  const std::size_t before = document.elements();
  // In most files most elements are tetrahedra. There are no more nodes than the bytes can hold.
  reserve_in_large_pages(document.connectivity, document.connectivity.size() +
                                                    std::min(4 * announced.likely(4), in.remaining() / 2));
  while (announced.next_block()) {
    ElementBlock block;
    read_entity_of(in, v40, block);
    const std::int64_t number = in.integer("an element type");
    block.type = static_cast<int>(std::clamp<std::int64_t>(number, 0, std::numeric_limits<int>::max()));
    const ElementType* type = element_type(block.type);
    if (block.type != number || (!type && in.binary()))
      in.fail(fmt::format("unknown element type {}", number));
    const std::size_t count = in.count("the number of elements in a block", 4, v40 ? 8 : 16);
    block.first = document.elements();
    block.nodes = document.connectivity.size();
    if (count == 0) continue;
    if (type) {
      block.nodes_each = type->nodes;
      block.count = count;
      in.check_count(static_cast<std::int64_t>(count), "the number of elements in a block",
                     (1 + block.nodes_each) * (in.binary() ? (v40 ? 4 : 8) : 2));
      document.blocks.push_back(block);
      read_block(in, v40, count, block.nodes_each, document, index, tags);
      continue;
    }
    // Only the line of such an element shows how many nodes it has.
    for (std::size_t e = 0; e < count; ++e) {
      in.skip_blanks();
      block.nodes_each = in.words_in_line() - 1;
      if (block.nodes_each < 1)
        in.fail(fmt::format("expected an element of type {}: its tag and its nodes", number));
      block.first = document.elements();
      block.nodes = document.connectivity.size();
      block.count = 1;
      document.blocks.push_back(block);
      read_block(in, v40, 1, block.nodes_each, document, index, tags);
      if (e == 0) continue;
      ElementBlock& last = document.blocks[document.blocks.size() - 2];
      if (last.nodes_each != block.nodes_each) continue;
      ++last.count;
      document.blocks.pop_back();
    }
  }
  announced.compare(document.elements() - before);
}

}  // namespace tetproof::io
