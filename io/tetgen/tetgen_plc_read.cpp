// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TetGen's .poly and .smesh: facets of polygons, holes and regions.
#include <fmt/format.h>

#include <limits>

#include "io/bytes/words.hpp"
#include "io/model/element_types.hpp"
#include "io/tetgen/tetgen_read_parts.hpp"

namespace tetproof::io {
namespace {

class PlcReader {
 public:
  PlcReader(Records& in, bool smesh, Document& document, std::vector<std::size_t>* places)
      : in_(in), smesh_(smesh), document_(document), index_(document), places_(places) {
    markers_.name = "markers";
    markers_.first = document.elements();
  }

  void read() {
    in_.expect_next("the number of facets");
    const std::int64_t count = in_.count("the number of facets", 2);
    marked_ = in_.more() && in_.integer("0 or 1 for boundary markers") != 0;
    in_.end_record();
    for (std::int64_t i = 0; i < count; ++i) {
      if (!in_.next())
        in_.fail(fmt::format("expected {}, found {} and the end of the file", counted(count, "facets"), i));
      if (smesh_)
        polygon(true);
      else
        facet();
    }
    if (marked_) document_.element_values.push_back(std::move(markers_));
    if (!in_.next()) {  // TetGen takes it for an error
      document_.warnings.push_back(fmt::format("{}: there is no number of holes", in_.path()));
      return;
    }
    holes(in_.count("the number of holes", 8), "a hole", document_.holes);
    if (!in_.next()) return;
    regions(in_.count("the number of regions", 10));
    in_.end_file();
  }

 private:
  void facet() {
    Facet facet{.first = document_.elements(), .polygons = 1, .holes = {}};
    const std::int64_t polygons = in_.count("the number of a facet's polygons", 4);
    if (polygons == 0) in_.fail("expected at least one polygon in a facet, found 0");
    const std::int64_t holes_in_it = in_.more() ? in_.count("the number of a facet's holes", 8) : 0;
    if (marked_ && in_.more()) marker_ = in_.integer("a boundary marker");
    in_.end_record();
    for (std::int64_t p = 0; p < polygons; ++p) {
      in_.expect_next("a polygon");
      polygon(false);
    }
    facet.polygons = static_cast<std::size_t>(polygons);
    holes(holes_in_it, "a facet's hole", facet.holes);
    if (polygons > 1 || holes_in_it > 0) document_.facets.push_back(std::move(facet));
    marker_ = 0;
  }

  void polygon(bool marker_follows) {
    if (places_) places_->push_back(in_.offset());
    const std::int64_t corners = in_.count("the number of a polygon's corners", 2);
    if (corners == 0) in_.fail("expected at least one corner of a polygon, found 0");
    if (corners > std::numeric_limits<std::int32_t>::max())
      in_.fail(fmt::format("{} corners of a polygon are more than 2147483647", corners));
    add_to_block(static_cast<std::int32_t>(corners));
    for (std::int64_t k = 0; k < corners; ++k) {
      if (!in_.more()) in_.expect_next("a corner of the polygon");  // in the next line
      document_.connectivity.push_back(index_(in_.integer("the number of a node")));
    }
    std::int64_t marker = marker_;
    if (marker_follows && marked_ && in_.more()) marker = in_.integer("a boundary marker");
    if (marked_) markers_.integers.push_back(marker);
    in_.end_record();
  }

  void add_to_block(std::int32_t corners) {
    std::vector<ElementBlock>& blocks = document_.blocks;
    if (blocks.empty() || !blocks.back().of_boundary || blocks.back().nodes_each != corners) {
      constexpr int types[] = {point1, line2, triangle3, quadrangle4};
      blocks.push_back({.type = corners <= 4 ? types[corners - 1] : polygon_type,
                        .dim = corners < 3 ? corners - 1 : 2,
                        .nodes_each = corners,
                        .first = document_.elements(),
                        .nodes = document_.connectivity.size(),
                        .of_boundary = true});
    }
    ++blocks.back().count;
  }

  void holes(std::int64_t count, const char* expected, std::vector<Eigen::Vector3d>& to) {
    std::int64_t first = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      in_.end_record();
      in_.expect_next(expected);
      in_.list_number("the number of a hole", i, first, "numbers of holes");
      Eigen::Vector3d& point = to.emplace_back();
      for (double& x : point) x = in_.real("a coordinate");
    }
    in_.end_record();
  }

  void regions(std::int64_t count) {
    std::int64_t first = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      in_.end_record();
      in_.expect_next("a region");
      in_.list_number("the number of a region", i, first, "numbers of regions");
      Region& region = document_.regions.emplace_back();
      for (double& x : region.point) x = in_.real("a coordinate");
      // A single number is both.
      region.attribute = region.max_volume = in_.real("the attribute of a region");
      if (in_.more()) region.max_volume = in_.real("a volume");
    }
    in_.end_record();
  }

  static constexpr int polygon_type = io::polygon;

  Records& in_;
  const bool smesh_;
  Document& document_;
  NodeIndex index_;
  std::vector<std::size_t>* places_;
  Values markers_;
  bool marked_ = false;
  std::int64_t marker_ = 0;
};

}  // namespace

bool read_plc(Records& in, const std::string& node_path, bool smesh, Document& document,
              std::vector<std::size_t>* places) {
  const TetgenNodeHeader header = read_node_header(in);
  if (header.count > 0)
    read_nodes(in, header, document);
  else if (node_path.empty())
    in.fail("expected points here, found none; a .node file beside it cannot come through " + in.path());
  else
    read_node_file(node_path, document);
  document.first_element = document.first_node;
  PlcReader(in, smesh, document, places).read();
  return header.count == 0;
}

}  // namespace tetproof::io
