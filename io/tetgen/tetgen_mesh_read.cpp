// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TetGen's .node, .ele, .face and .edge.
#include <fmt/format.h>

#include <limits>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/model/node_order.hpp"
#include "io/tetgen/tetgen.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"

namespace tetproof::io {
namespace {

// Lines may lack attributes. But a header with far more attributes than the file has room for is an error.
void check_attributes(const Records& in, std::int64_t items, std::int64_t each) {
  if (each > 0 && items > 0 && each > static_cast<std::int64_t>(in.remaining()) / items + 4)
    in.fail(fmt::format("expected the number of attributes, found {}, more than the {} left can hold for {}",
                        each, counted(in.remaining(), "bytes"), counted(items, "lines")));
}

// The number of words in the first record: it shows the columns that the header does not mention. The header
// has been read.
int words_of_first(Records& in) {
  const std::size_t behind = in.next_line();
  const int words = in.next() ? in.words() : 0;
  in.go_to(behind);
  return words;
}

TetgenElementFile read_simplex_header(Records& in, TetgenElementFile file, const char* expected) {
  in.expect_next(expected);
  const std::int64_t count = in.count(expected, 2 * (1 + file.corners));
  file.count = static_cast<std::size_t>(count);
  file.marked = in.more() && in.integer("0 or 1 for boundary markers") != 0;
  in.end_record();
  return file;
}

int type_of(const TetgenElementFile& file) {
  switch (file.nodes_each) {
    case 10:
      return tetrahedron10;
    case 4:
      return tetrahedron4;
    case 6:
      return triangle6;
    case 3:
      return file.corners == 3 ? triangle3 : line3;
    default:
      return line2;
  }
}

// Numbers the elements of a further file behind those before, where these have numbers of their own.
void number_on(Document& document, std::size_t first, std::size_t count) {
  std::vector<std::int64_t>& tags = document.element_tags;
  if (tags.empty()) return;
  std::int64_t most = std::numeric_limits<std::int64_t>::min();
  for (std::size_t i = 0; i < first; ++i) most = std::max(most, tags[i]);
  for (std::size_t i = 0; i < count; ++i)
    tags.push_back(static_cast<std::int64_t>(static_cast<std::uint64_t>(most) + 1 + i));
}

}  // namespace

TetgenNodeHeader read_node_header(Records& in) {
  if (!in.next()) in.fail("expected the number of nodes, found the end of the file");
  TetgenNodeHeader header;
  header.count = in.integer("the number of nodes");
  const std::int64_t dimension = in.more() ? in.integer("the dimension 3") : 3;
  header.attributes = in.more() ? in.integer("the number of attributes") : 0;
  header.marked = in.more() && in.integer("0 or 1 for boundary markers") != 0;
  if (dimension != 3) in.fail(fmt::format("expected the dimension 3, found {}", dimension));
  in.check_count(header.count, "the number of nodes", 8);
  in.check_count(header.attributes, "the number of attributes", 1);
  if (header.count > std::numeric_limits<Index>::max())
    in.fail(fmt::format("{} nodes are more than the {} that can be numbered here", header.count,
                        std::numeric_limits<Index>::max()));
  in.end_record();
  return header;
}

void read_nodes(Records& in, const TetgenNodeHeader& header, Document& document) {
  const auto count = static_cast<std::size_t>(header.count),
             each = static_cast<std::size_t>(header.attributes);
  check_attributes(in, header.count, header.attributes);
  Values attributes{.name = "attributes", .components = static_cast<int>(each), .reals = {}, .integers = {}};
  resize_in_large_pages(attributes.reals, count * each);
  Values markers{.name = "markers", .components = 1, .reals = {}, .integers = {}};
  if (header.marked) resize_in_large_pages(markers.integers, count);
  resize_in_large_pages(document.points, count);

  std::int64_t& base = document.first_node;
  const std::size_t start = in.next_line();
  if (count > 0 &&
      PlainLine(in.bytes().data() + start, in.bytes().data() + in.bytes().size()).integer(base) && base != 0)
    base = 1;
  read_rows(in, count, "nodes", nullptr, [&](auto& row, std::size_t i) {
    std::int64_t number;
    if (!row.number(number, base + static_cast<std::int64_t>(i), "the number of a node")) return false;
    if constexpr (!std::decay_t<decltype(row)>::plain) {
      if (i == 0) {
        if (number != 0 && number != 1)
          in.fail(fmt::format("expected 0 or 1 as the first node's number, found {}", number));
        base = number;
      }
      if (number != base + static_cast<std::int64_t>(i))
        in.fail(fmt::format("expected node {}, found {}: nodes must stand in order",
                            base + static_cast<std::int64_t>(i), number));
    }
    for (double& x : document.points[i])
      if (!row.real(x, "a coordinate")) return false;
    for (std::size_t k = 0; k < each; ++k)
      if (!row.optional_real(attributes.reals[i * each + k], "an attribute")) return false;
    return !header.marked || row.optional_integer(markers.integers[i], "a boundary marker");
  });
  if (each > 0) document.node_values.push_back(std::move(attributes));
  if (header.marked) document.node_values.push_back(std::move(markers));
}

void read_node_file(const std::string& path, Document& document) {
  const InputFile file(path);
  Records in(file, document);
  read_nodes(in, read_node_header(in), document);
  in.end_file();
}

TetgenElementFile read_ele_header(Records& in) {
  TetgenElementFile file{.one = "tetrahedron", .many = "tetrahedra", .number = "the number of a tetrahedron"};
  if (!in.next()) in.fail("expected the number of tetrahedra, found the end of the file");
  const std::int64_t count = in.integer("the number of tetrahedra");
  const std::int64_t each = in.more() ? in.integer("4 or 10 nodes a tetrahedron") : 4;
  const std::int64_t attributes = in.more() ? in.integer("the number of attributes") : 0;
  if (each != 4 && each != 10) in.fail(fmt::format("expected 4 or 10 nodes a tetrahedron, found {}", each));
  in.check_count(count, "the number of tetrahedra", 2 * (1 + each));
  in.check_count(attributes, "the number of attributes", 1);
  in.end_record();
  check_attributes(in, count, attributes);
  file.count = static_cast<std::size_t>(count);
  file.nodes_each = static_cast<int>(each);
  file.attributes = static_cast<int>(attributes);
  return file;
}

// Behind the corners of a face there may be its 3 nodes of second order, its marker, and two tetrahedra.
TetgenElementFile read_face_header(Records& in, int tets) {
  TetgenElementFile file = read_simplex_header(
      in, {.one = "face", .many = "faces", .number = "the number of a face", .corners = 3, .nodes_each = 3},
      "the number of faces");
  int more = words_of_first(in) - 4;
  if (tets == 10 ? more >= 3 : tets == 0 && (more == 3 + file.marked || more == 5 + file.marked)) {
    file.nodes_each = 6;
    more -= 3;
  }
  if (more >= 2 + file.marked) file.tets = 2;
  return file;
}

// Behind the ends of an edge there may be its middle node, its marker, and a tetrahedron.
TetgenElementFile read_edge_header(Records& in, int others) {
  TetgenElementFile file = read_simplex_header(
      in, {.one = "edge", .many = "edges", .number = "the number of an edge", .corners = 2, .nodes_each = 2},
      "the number of edges");
  int more = words_of_first(in) - 3;
  if (others == 10 && more > file.marked) {
    file.nodes_each = 3;
    --more;
  }
  if (more >= 1 + file.marked) file.tets = 1;
  return file;
}

TetgenElements read_elements(Records& in, const TetgenElementFile& file, NodeIndex& index,
                             Document& document) {
  const std::size_t first = document.elements(), nodes = document.connectivity.size();
  const auto each = static_cast<std::size_t>(file.nodes_each),
             attributes_each = static_cast<std::size_t>(file.attributes),
             tets_each = static_cast<std::size_t>(file.tets);
  resize_in_large_pages(document.connectivity, nodes + file.count * each);
  const auto values = [&](const char* name, int components) {
    return Values{
        .name = name, .components = components, .reals = {}, .integers = {}, .labels = {}, .first = first};
  };
  Values attributes = values("attributes", file.attributes), markers = values("markers", 1),
         tets = values("neighbours", file.tets);
  const bool attributed = file.attributes > 0 && file.with_values, marked = file.marked && file.with_values;
  if (attributed) resize_in_large_pages(attributes.reals, file.count * attributes_each);
  if (marked) resize_in_large_pages(markers.integers, file.count);
  resize_in_large_pages(tets.integers, file.count * tets_each);

  const std::int64_t base = document.first_node;
  const bool names = file.corners == 4;  // only numbers of tetrahedra are kept
  Tags tags(document.element_tags, document.first_element);
  if (first == 0) document.first_element = base;
  // TetGen lists the nodes of second-order tetrahedra in an order of its own.
  const std::span<const int> order =
      each == 10 ? node_order(tetrahedron10, NodeOrder::tetgen) : std::span<const int>{};
  read_rows(in, file.count, file.many, &index, [&](auto& row, std::size_t i) {
    std::int64_t number;
    const std::int64_t counted = base + static_cast<std::int64_t>(i);
    if (!row.number(number, counted, file.number)) return false;
    if constexpr (!std::decay_t<decltype(row)>::plain) {
      if (number != counted)
        in.other_number(file.one, number, counted,
                        names              ? nullptr
                        : file.corners > 2 ? "numbers of faces"
                                           : "numbers of edges");
      if (names) tags.add(i, number);
    }
    Index* const mine = document.connectivity.data() + nodes + i * each;
    for (std::size_t k = 0; k < each; ++k)
      if (!row.node(mine[order.empty() ? k : static_cast<std::size_t>(order[k])])) return false;
    for (std::size_t k = 0; k < attributes_each; ++k) {
      double attribute = 0;
      if (!row.optional_real(attribute, "an attribute")) return false;
      if (attributed) attributes.reals[i * attributes_each + k] = attribute;
    }
    if (std::int64_t marker = 0; file.marked) {
      if (!row.optional_integer(marker, "a boundary marker")) return false;
      if (marked) markers.integers[i] = marker;
    }
    for (std::size_t k = 0; k < tets_each; ++k)
      if (!row.integer(tets.integers[i * tets_each + k], "the number of a tetrahedron")) return false;
    return true;
  });
  in.end_file(names);
  if (!names) number_on(document, first, file.count);
  if (file.count > 0)
    document.blocks.push_back({.type = type_of(file),
                               .dim = file.corners - 1,
                               .nodes_each = file.nodes_each,
                               .count = file.count,
                               .first = first,
                               .nodes = nodes});
  if (attributed) document.element_values.push_back(std::move(attributes));
  if (marked) document.element_values.push_back(std::move(markers));
  if (file.tets > 0) document.element_values.push_back(std::move(tets));
  return {in.path(), first, file.count, nodes, file.nodes_each};
}

}  // namespace tetproof::io
