// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TetGen's files about nodes and elements that other files list: .neigh, .t2f, .t2e, .f2e, .vol, .mtr,
// .var.
#include <fmt/format.h>

#include "io/bytes/words.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"

namespace tetproof::io {
namespace {

void expect_as_many(const Records& in, std::int64_t count, std::size_t expected, const char* many,
                    const std::string& path) {
  if (count != static_cast<std::int64_t>(expected))
    in.fail(fmt::format("expected {} as in {}, found {}", counted(expected, many), path, count));
}

}  // namespace

void read_element_integers(Records& in, const TetgenElements& elements, const char* many, const char* name,
                           int each, bool has_header, Document& document) {
  if (has_header) {
    in.expect_next("the number of tetrahedra");
    expect_as_many(in, in.integer("the number of tetrahedra"), elements.count, many, elements.path);
    const std::int64_t found = in.more() ? in.integer("4 neighbours a tetrahedron") : each;
    if (found != each) in.fail(fmt::format("expected {} neighbours a tetrahedron, found {}", each, found));
    in.end_record();
  }
  in.check_count(static_cast<std::int64_t>(elements.count), many, 2 * (1 + each));
  Values values{
      .name = name, .components = each, .reals = {}, .integers = {}, .labels = {}, .first = elements.first};
  const auto columns = static_cast<std::size_t>(each);
  values.integers.resize(elements.count * columns);
  read_rows(in, elements.count, fmt::format("{} as in {}", many, elements.path), nullptr,
            [&](auto& row, std::size_t i) {
              std::int64_t number;
              const std::int64_t counted = document.first_node + static_cast<std::int64_t>(i);
              if (!row.number(number, counted, "the number of the line")) return false;
              if constexpr (!std::decay_t<decltype(row)>::plain)
                if (number != counted) in.other_number("line", number, counted, "numbers of lines");
              for (std::size_t k = 0; k < columns; ++k)
                if (!row.integer(values.integers[i * columns + k], "a number")) return false;
              return true;
            });
  in.end_file();
  document.element_values.push_back(std::move(values));
}

void read_volume_bounds(Records& in, const TetgenElements& tets, Document& document) {
  in.expect_next("the number of tetrahedra");
  expect_as_many(in, in.integer("the number of tetrahedra"), tets.count, "tetrahedra", tets.path);
  in.end_record();
  in.check_count(static_cast<std::int64_t>(tets.count), "the number of tetrahedra", 2);
  Values values{.name = "volume bounds", .reals = {}, .integers = {}, .labels = {}, .first = tets.first};
  values.reals.assign(tets.count, -1.0);  // none
  read_rows(in, tets.count, "tetrahedra", nullptr, [&](auto& row, std::size_t i) {
    std::int64_t number;
    const std::int64_t counted = document.first_node + static_cast<std::int64_t>(i);
    if (!row.number(number, counted, "the number of a tetrahedron")) return false;
    if constexpr (!std::decay_t<decltype(row)>::plain)
      if (number != counted) in.other_number("tetrahedron", number, counted, "numbers of lines");
    return row.optional_real(values.reals[i], "a volume");
  });
  in.end_file();
  document.element_values.push_back(std::move(values));
}

void read_sizes(Records& in, const std::string& node_path, Document& document) {
  in.expect_next("the number of nodes");
  expect_as_many(in, in.integer("the number of nodes"), document.points.size(), "nodes", node_path);
  const std::int64_t each = in.more() ? in.integer("1, 3 or 6 sizes a node") : 1;
  if (each != 1 && each != 3 && each != 6)
    in.fail(fmt::format("expected 1, 3 or 6 sizes a node, found {}", each));
  in.end_record();
  in.check_count(static_cast<std::int64_t>(document.points.size()), "the number of nodes", 2 * each);
  const auto columns = static_cast<std::size_t>(each);
  Values values{.name = "sizes", .components = static_cast<int>(each), .reals = {}, .integers = {}};
  values.reals.resize(document.points.size() * columns);
  read_rows(in, document.points.size(), "nodes", nullptr, [&](auto& row, std::size_t i) {
    for (std::size_t k = 0; k < columns; ++k)
      if (!row.real(values.reals[i * columns + k], "a size")) return false;
    return true;
  });
  in.end_file();
  document.node_values.push_back(std::move(values));
}

// Each of the two sections may be missing.
void read_bounds(Records& in, NodeIndex& index, Document& document) {
  if (!in.next()) return;
  const std::int64_t areas = in.count("the number of bounds of areas", 6);
  std::int64_t first = 0;
  for (std::int64_t i = 0; i < areas; ++i) {
    in.end_record();
    in.expect_next("a bound of an area");
    in.list_number("the number of a bound", i, first, "numbers of bounds");
    const std::int64_t marker = in.integer("the marker of a facet");
    document.area_bounds.push_back({marker, in.real("an area")});
  }
  in.end_record();
  if (!in.next()) return;
  const std::int64_t lengths = in.count("the number of bounds of lengths", 8);
  for (std::int64_t i = 0; i < lengths; ++i) {
    in.end_record();
    in.expect_next("a bound of a length");
    in.list_number("the number of a bound", i, first, "numbers of bounds");
    LengthBound bound;
    for (Index& node : bound.nodes) node = index(in.integer("the number of a node"));
    bound.length = in.real("a length");
    document.length_bounds.push_back(bound);
  }
  in.end_record();
  in.end_file();
}

}  // namespace tetproof::io
