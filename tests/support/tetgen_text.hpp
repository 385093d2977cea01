// SPDX-License-Identifier: GPL-3.0-or-later
// What TetGen's files say beyond nodes and elements, as lines of text.
#pragma once

#include <vector>

#include "tests/support/document_text.hpp"
#include "tests/support/test_files.hpp"

namespace tetproof::test {

inline std::string text_of(const Eigen::Vector3d& p) {
  return fmt::format("{}", fmt::join(p.data(), p.data() + 3, " "));
}

/// Blocks as "b TYPE NODES_EACH COUNT (boundary) (group NUMBER)", values as "v OF NAME COMPONENTS from FIRST:
/// ..." or "... at POSITIONS: ...", and the rest by their names.
inline std::string tetgen_text(const Document& d) {
  std::string text;
  for (std::size_t i = 0; i < d.points.size(); ++i)
    text += fmt::format("n {} {}\n", d.node_tag(i), text_of(d.points[i]));
  for (const ElementBlock& block : d.blocks) {
    const auto& groups = d.tag_sets.at(static_cast<std::size_t>(block.groups));
    text += fmt::format("b {} {} {}{}{}{}\n", block.type, block.nodes_each, block.count,
                        block.of_boundary ? " boundary" : "", groups.empty() ? "" : " group ",
                        fmt::join(groups, " "));
    for (std::size_t e = 0; e < block.count; ++e) {
      text += fmt::format("e {}:", d.element_tag(block.first + e));
      for (int k = 0; k < block.nodes_each; ++k) {
        const Index node = d.connectivity.at(block.nodes + e * block.nodes_each + k);
        text += fmt::format(" {}{}", node < 0 ? "?" : "", d.named(node));
      }
      text += "\n";
    }
  }
  for (const auto& [values, of] : {std::pair{&d.node_values, "node"}, {&d.element_values, "element"}})
    for (const Values& v : *values)
      text += fmt::format(
          "v {} {} {} {}: {}{}\n", of, v.name, v.components,
          v.at.empty() ? fmt::format("from {}", v.first) : fmt::format("at {}", fmt::join(v.at, " ")),
          fmt::join(v.reals, " "), fmt::join(v.integers, " "));
  for (const Facet& facet : d.facets) {
    text += fmt::format("facet {} {}\n", facet.first, facet.polygons);
    for (const auto& hole : facet.holes) text += "  hole " + text_of(hole) + "\n";
  }
  for (const auto& hole : d.holes) text += "hole " + text_of(hole) + "\n";
  for (const Region& region : d.regions)
    text += fmt::format("region {} {} {}\n", text_of(region.point), region.attribute, region.max_volume);
  for (const AreaBound& bound : d.area_bounds) text += fmt::format("area {} {}\n", bound.marker, bound.area);
  for (const LengthBound& bound : d.length_bounds)
    text += fmt::format("length {} {} {}\n", d.named(bound.nodes[0]), d.named(bound.nodes[1]), bound.length);
  for (const auto& point : d.voronoi.points) text += "vn " + text_of(point) + "\n";
  for (const auto& edge : d.voronoi.edges)
    text += fmt::format("ve {} {} {}\n", edge.points[0], edge.points[1], text_of(edge.direction));
  for (const auto& face : d.voronoi.faces)
    text += fmt::format("vf {} {}: {}\n", face.cells[0], face.cells[1], fmt::join(face.edges, " "));
  for (const auto& cell : d.voronoi.cells) text += fmt::format("vc {}\n", fmt::join(cell, " "));
  return text;
}

/// Warnings without the folder's name.
inline std::vector<std::string> warnings_of(const Document& document, const TestFiles& files) {
  std::vector<std::string> warnings;
  const std::string folder = files.path("");
  for (std::string warning : document.warnings) {
    for (std::size_t at; (at = warning.find(folder)) != warning.npos;) warning.erase(at, folder.size());
    warnings.push_back(warning);
  }
  return warnings;
}

}  // namespace tetproof::test
