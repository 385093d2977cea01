// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the Voronoi diagram in TetGen's .v.node, .v.edge, .v.face and .v.cell.
#include <fmt/format.h>

#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"

namespace tetproof::io {
namespace {

// One of these files: a count, then records that begin with their number.
class Part {
 public:
  Part(const std::string& path, Document& document)
      : file_(path), in_(file_, document), first_(document.voronoi.first) {}

  Records& in() { return in_; }
  std::int64_t count(const char* expected, std::int64_t least_bytes_each) {
    in_.expect_next(expected);
    const std::int64_t count = in_.count(expected, least_bytes_each);
    if (in_.more()) in_.integer("0");
    in_.end_record();
    return count;
  }
  // Goes to record `i`.
  void next(const char* number, std::int64_t i, const char* item) {
    in_.expect_next(number);
    in_.list_number(number, i, first_number_, item);
  }
  // Positions count from 0; -1: none.
  Index position(const char* expected, std::size_t most, bool may_be_none) {
    const std::int64_t number = in_.integer(expected);
    if (number == -1 && may_be_none) return -1;
    const std::uint64_t position = static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(first_);
    if (position >= most)
      in_.fail(fmt::format("expected {}, {} to {}{}, found {}", expected, first_,
                           first_ + static_cast<std::int64_t>(most) - 1, may_be_none ? " or -1" : "",
                           number));
    return static_cast<Index>(position);
  }
  std::vector<Index> list(const char* number, const char* one, std::size_t most) {
    std::vector<Index> items(static_cast<std::size_t>(in_.count(number, 2)));
    for (std::size_t k = 0; k < items.size(); ++k) items[k] = position(one, most, k + 1 == items.size());
    in_.end_record();
    return items;
  }

 private:
  InputFile file_;
  Records in_;
  std::int64_t first_, first_number_ = 0;
};

}  // namespace

void read_voronoi(const std::string& stem, Document& document) {
  Voronoi& voronoi = document.voronoi;
  Document nodes;
  read_node_file(stem + ".v.node", nodes);
  document.warnings.insert(document.warnings.end(), nodes.warnings.begin(), nodes.warnings.end());
  for (const Loss& loss : nodes.dropped)
    add_loss(document.dropped, loss.item, static_cast<std::size_t>(loss.count), loss.example);
  for (const Values& values : nodes.node_values)
    add_loss(document.dropped, fmt::format("{} of Voronoi points", values.name), values.size(),
             stem + ".v.node");
  voronoi.points = std::move(nodes.points);
  voronoi.first = voronoi.points.empty() ? document.first_node : nodes.first_node;

  Part edges(stem + ".v.edge", document), faces(stem + ".v.face", document),
      cells(stem + ".v.cell", document);
  const std::int64_t edge_count = edges.count("the number of edges", 6),
                     face_count = faces.count("the number of faces", 8),
                     cell_count = cells.count("the number of cells", 4);
  for (std::int64_t i = 0; i < edge_count; ++i) {
    edges.next("the number of an edge", i, "numbers of Voronoi edges");
    Voronoi::Edge edge;
    edge.points[0] = edges.position("a point", voronoi.points.size(), false);
    edge.points[1] = edges.position("a point", voronoi.points.size(), true);
    if (edge.points[1] < 0)
      for (double& x : edge.direction) x = edges.in().real("a direction");
    edges.in().end_record();
    voronoi.edges.push_back(edge);
  }
  edges.in().end_file();
  for (std::int64_t i = 0; i < face_count; ++i) {
    faces.next("the number of a face", i, "numbers of Voronoi faces");
    Voronoi::Face face;
    for (Index& cell : face.cells) cell = faces.position("a cell", document.points.size(), false);
    face.edges = faces.list("the number of a face's edges", "an edge", voronoi.edges.size());
    voronoi.faces.push_back(std::move(face));
  }
  faces.in().end_file();
  for (std::int64_t i = 0; i < cell_count; ++i) {
    cells.next("the number of a cell", i, "numbers of Voronoi cells");
    voronoi.cells.push_back(cells.list("the number of a cell's faces", "a face", voronoi.faces.size()));
  }
  cells.in().end_file();
}

}  // namespace tetproof::io
