// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/bytes/words.hpp"
#include "io/loss/loss_finder.hpp"
#include "io/model/tag_words.hpp"
#include "io/model/values.hpp"

namespace tetproof::io {
namespace {

// Losses of values, of the description of what to mesh, of tables, of the title and of sections.
class ValueLosses : LossFinder {
 public:
  using LossFinder::LossFinder;

  void find() {
    values(document_.node_values, Of::node, "nodes");
    values(document_.element_values, Of::element, "elements");
    values(document_.element_node_values, Of::element_node, "elements' nodes");
    boundary();
    rest();
  }

 private:
  void values(const std::vector<Values>& all, Of of, const char* whose) {
    for (const Values& values : all) {
      if (holds_.values(values, of)) {
        roles(values, of);
        continue;
      }
      if (holds_.as_reals(values, of)) {
        add(fmt::format("that values of {} are integers, not reals", whose), 1,
            fmt::format("\"{}\"", values.name));
        roles(values, of);
        continue;
      }
      if (const auto held = holds_.numbers ? holds_.numbers(values, of) : std::nullopt) {
        all_but_numbers(values, *held, of, whose);
        roles(values, of);
      } else
        add(fmt::format("values \"{}\" of {}", values.name, whose), std::max<std::size_t>(values.size(), 1),
            !values.reals.empty()      ? fmt::format("{}", values.reals[0])
            : !values.integers.empty() ? fmt::format("{}", values.integers[0])
                                       : "");
    }
  }

  void roles(const Values& values, Of of) {
    if (!holds_.roles(values, of))
      add("roles of values", values.roles.size(), fmt::format("\"{}\" as {}", values.name, values.roles[0]));
  }

  void all_but_numbers(const Values& values, const HeldNumbers& held, Of of, const char* whose) {
    const std::string name = fmt::format("\"{}\"", values.name);
    const auto is_tag = [](const std::string& word) {
      return std::find(node_tag_words.begin(), node_tag_words.end(), word) != node_tag_words.end();
    };
    // Words of different tools for the same thing are no names.
    if (held.name != values.name && !(of == Of::node && is_tag(held.name) && is_tag(values.name)))
      add(fmt::format("names of values of {}", whose), 1, fmt::format("{} becomes \"{}\"", name, held.name));
    if (held.gaps > 0)
      add(fmt::format("gaps in values of {}", whose), held.gaps,
          fmt::format(
              "{} {} has no {}", of == Of::node ? "node" : "element",
              of == Of::node ? document_.node_tag(held.first_gap) : document_.element_tag(held.first_gap),
              name));
    if (!values.labels.empty())
      add(fmt::format("labels of values of {}", whose), 1,
          fmt::format("{} of {}", counted(values.labels.size(), "labels"), name));
    if (has_step(values))
      add(fmt::format("times and steps of values of {}", whose), 1,
          fmt::format("{} of time {}, step {}", name, values.time, values.step));
  }

  // Whether the faces bound the body of the facets and holes of a .poly, or of the facets that they become.
  bool same_body() {
    if (!same_body_) same_body_ = facets_are_surface(document_);
    return *same_body_;
  }

  bool are_all_faces_written() const {
    std::size_t faces = 0, written = 0;
    for (const ElementBlock& block : document_.blocks) faces += block.dim == 2 ? block.count : 0;
    each_written([&](const ElementBlock& block, std::size_t count, const std::string&) {
      written += block.dim == 2 ? count : 0;
    });
    return written == faces;
  }

  // What tells the facets of a body to mesh from the faces of a mesh. Nothing does, and nothing is lost, if
  // the faces bound the same body.
  void facets() {
    each_written([&](const ElementBlock& block, std::size_t count, const std::string& name) {
      if (!block.of_boundary) return;
      if (block.dim < 2)
        add("that lines and points belong to TetGen's facets", count, name);
      else if (!same_body())
        add("that faces are TetGen's facets, which have no direction and may lie inside of the body", count,
            name);
    });
  }

  // The description of the body to mesh, as TetGen's .poly has it.
  void boundary() {
    if (!holds_.boundary) facets();
    if (holds_.makes_boundary)
      for (const Written& written : written_.blocks())
        if (!written.block->of_boundary && written.block->dim == 2 && !same_body())
          add("that faces are of a mesh, not facets of a body to mesh", written.count,
              element(*written.block));
    if (!holds_.facets && !document_.facets.empty())
      add("facets of several polygons or with holes", document_.facets.size(),
          fmt::format("element {}", document_.element_tag(document_.facets[0].first)));
    const auto point = [](const Eigen::Vector3d& p) {
      return fmt::format("({}, {}, {})", p.x(), p.y(), p.z());
    };
    // Walls of cavities that are wound so say what the points in holes say. Where these can be kept aside,
    // they are, for TetGen.
    if (!holds_.holes && !document_.holes.empty() &&
        !(holds_.kept_in.empty() && are_all_faces_written() && same_body()))
      add("holes", document_.holes.size(), point(document_.holes[0]));
    if (!holds_.regions && !document_.regions.empty())
      add("regions", document_.regions.size(), point(document_.regions[0].point));
    if (holds_.bounds) return;
    if (!document_.area_bounds.empty())
      add("bounds of areas", document_.area_bounds.size(),
          fmt::format("{} for marker {}", document_.area_bounds[0].area, document_.area_bounds[0].marker));
    if (!document_.length_bounds.empty())
      add("bounds of lengths", document_.length_bounds.size(),
          fmt::format("{}", document_.length_bounds[0].length));
  }

  void rest() {
    const Voronoi& voronoi = document_.voronoi;
    if (!holds_.voronoi)
      add("parts of a Voronoi diagram",
          voronoi.points.size() + voronoi.edges.size() + voronoi.faces.size() + voronoi.cells.size(),
          counted(voronoi.points.size(), "points"));
    for (const Table& table : document_.tables)
      if (!holds_.table(table)) add(fmt::format("table \"{}\"", table.name), 1, counted(table.rows, "rows"));
    if (!holds_.title && !document_.title.empty()) add("title", 1, document_.title);
    for (const Section& section : document_.sections)
      if (!holds_.section(section))
        add(fmt::format("section ${}", section.name), 1, counted(section.body.size(), "bytes"));
  }

  std::optional<bool> same_body_;
};

}  // namespace

void find_losses_of_values(const Document& document, const Holds& holds, const WrittenPart& written,
                           std::vector<Loss>& losses) {
  ValueLosses(document, holds, written, losses).find();
}

}  // namespace tetproof::io
