// SPDX-License-Identifier: GPL-3.0-or-later
#include "document_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace tetproof::test {
namespace {

std::string place(const Eigen::Vector3d& p) {
  return bits(p.x()) + "," + bits(p.y()) + "," + bits(p.z());
}

template <class Range, class Say>
std::string joined(const Range& range, const Say& say) {
  std::string text;
  for (const auto& one : range) text += say(one) + " ";
  return text;
}

std::string numbers(const std::vector<std::int64_t>& all) {
  return joined(all, [](std::int64_t i) { return std::to_string(i); });
}

std::string reals(const std::vector<double>& all) {
  return joined(all, [](double x) { return bits(x); });
}

// Lists items in the order of their names, so that their order in the file does not matter.
Text text_of(const Values& values, const char* whose, const Names& name) {
  const std::string kind = values.integers.empty() ? "real" : "integer",
                    labels = joined(values.labels, quoted),
                    step = fmt::format("time {} step {} partition {} scheme {}", bits(values.time),
                                       values.step, values.partition, quoted(values.interpolation));
  Text text{
      fmt::format("{} x{} {} labels{} {}\n", quoted(values.name), values.components, kind, labels, step),
      static_cast<std::int64_t>(std::max<std::size_t>(values.size(), 1)),
      fmt::format("values \"{}\" of {}", values.name, whose)};
  std::vector<std::string> items;
  std::size_t from = 0;
  for (std::size_t i = 0; i < values.items(); ++i) {
    const Index at = values.at.empty() ? static_cast<Index>(values.first + i) : values.at[i];
    const std::size_t nodes = values.nodes.empty() ? 1 : static_cast<std::size_t>(values.nodes[i]);
    const std::size_t to = from + nodes * static_cast<std::size_t>(values.components);
    std::string item = name(at);
    if (item.empty()) {
      from = to;
      continue;
    }
    item += values.nodes.empty() ? ":" : fmt::format(" of {} nodes:", nodes);
    Text::Line line{.of = item, .content = {}, .empty = true};
    for (; from < to; ++from) {
      const double number =
          values.integers.empty() ? values.reals[from] : static_cast<double>(values.integers[from]);
      line.empty = line.empty && (std::isnan(number) || number == 0);
      line.content.append(" ").append(values.integers.empty() ? bits(values.reals[from])
                                                              : std::to_string(values.integers[from]));
    }
    items.push_back(item + line.content);
    text.lines.push_back(std::move(line));
  }
  text.name = values.name, text.components = values.components;
  text.kind = kind, text.labels = labels, text.step = step;
  text.gone = items.empty() && values.items() > 0;
  std::stable_sort(items.begin(), items.end());
  for (const std::string& item : items) text.text += item + "\n";
  return text;
}

std::string text_of(const Column& column) {
  return fmt::format("{} {}\nx{} {} {} {} {}\n", quoted(column.name), quoted(column.type), column.components,
                     reals(column.reals), numbers(column.integers), joined(column.texts, quoted),
                     joined(column.lengths, [](std::int32_t n) { return std::to_string(n); }));
}

std::string indices(const auto& all) {
  return joined(all, [](Index i) { return std::to_string(i); });
}

}  // namespace

std::string bits(double x) {
  if (std::isnan(x)) return "nan";
  return fmt::format("{}{}", std::signbit(x) && x == 0 ? "-0/" : "", x);  // the shortest exact text
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c >= ' ' && c <= '~' && c != '\'' ? std::string(1, c)
                                             : fmt::format("\\{:02x}", static_cast<unsigned char>(c));
  return out + "'";
}

std::vector<Text> texts_of_values(const std::vector<Values>& all, const char* whose, const Names& name) {
  std::vector<Text> texts;
  for (const Values& values : all) texts.push_back(text_of(values, whose, name));
  return texts;
}

std::vector<Text> texts_of_links(const Document& document, const Names& node) {
  std::vector<Text> texts;
  for (const PeriodicLink& link : document.periodic) {
    std::string text =
        fmt::format("{}/{} to {} affine {}", link.dim, link.entity, link.master, reals(link.affine));
    for (const auto& [slave, master] : link.nodes) text += node(slave) + "=" + node(master) + " ";
    texts.push_back({text, 1, "periodic links"});
  }
  return texts;
}

std::vector<Text> texts_of_ghosts(const Document& document, const Names& element) {
  std::vector<Text> texts;
  for (const GhostEntity& ghost : document.ghosts)
    texts.push_back(
        {fmt::format("ghost {} of {}", ghost.tag, ghost.partition), 1, "entities of ghost elements"});
  for (const GhostElement& ghost : document.ghost_elements)
    texts.push_back(
        {fmt::format("{} of {}: {}", element(ghost.element), ghost.partition, numbers(ghost.ghosts)), 1,
         "ghost elements"});
  return texts;
}

std::vector<Text> texts_of_names(const Document& document) {
  std::vector<Text> texts;
  for (const GroupName& name : document.group_names) {
    texts.push_back(
        {fmt::format("{}/{} {}", name.dim, name.group, quoted(name.name)), 1, "names of physical groups"});
    texts.back().subject = name.name;
  }
  return texts;
}

std::vector<Text> texts_of_boundary(const Document& document, const Names& node, const Names& element) {
  std::vector<Text> texts;
  for (const Facet& facet : document.facets) {
    std::string text = "facet";
    for (std::size_t k = 0; k < facet.polygons; ++k)
      text.append(" ").append(element(static_cast<Index>(facet.first + k)));
    for (const Eigen::Vector3d& hole : facet.holes) text.append(" ").append(place(hole));
    texts.push_back({text, 1, "facets of several polygons or with holes"});
  }
  for (const Eigen::Vector3d& hole : document.holes)
    texts.push_back({fmt::format("hole {}", place(hole)), 1, "holes"});
  for (const Region& region : document.regions)
    texts.push_back({fmt::format("region {} {} {}", place(region.point), bits(region.attribute),
                                 region.max_volume > 0 ? bits(region.max_volume) : "none"),
                     1, "regions"});
  for (const AreaBound& bound : document.area_bounds)
    texts.push_back({fmt::format("area {} {}", bound.marker, bits(bound.area)), 1, "bounds of areas"});
  for (const LengthBound& bound : document.length_bounds)
    texts.push_back(
        {fmt::format("length {} {} {}", node(bound.nodes[0]), node(bound.nodes[1]), bits(bound.length)), 1,
         "bounds of lengths"});
  return texts;
}

std::vector<Text> texts_of_voronoi(const Document& document) {
  const Voronoi& v = document.voronoi;
  const std::size_t parts = v.points.size() + v.edges.size() + v.faces.size() + v.cells.size();
  if (parts == 0) return {};
  std::string text = fmt::format("from {}\n", v.first);
  for (const Eigen::Vector3d& point : v.points) text += place(point) + "\n";
  for (const Voronoi::Edge& edge : v.edges)
    text += fmt::format("{}{}\n", indices(edge.points), edge.points[1] < 0 ? place(edge.direction) : "");
  for (const Voronoi::Face& face : v.faces)
    text += fmt::format("{}: {}\n", indices(face.cells), indices(face.edges));
  for (const auto& cell : v.cells) text += indices(cell) + "\n";
  return {{text, static_cast<std::int64_t>(parts), "parts of a Voronoi diagram"}};
}

std::vector<Text> texts_of_rest(const Document& document) {
  std::vector<Text> texts;
  for (const Table& table : document.tables) {
    std::string text = fmt::format("{} of {}\n", quoted(table.name), table.rows);
    for (const Column& column : table.columns) text += text_of(column);
    texts.push_back({text, 1, fmt::format("table \"{}\"", table.name)});
    texts.back().name = table.name;
    for (const Column& column : table.columns) texts.back().lines.push_back({column.name, text_of(column)});
  }
  // If a section is text in both files, it does not matter whether the files are binary.
  for (const Section& section : document.sections)
    texts.push_back({fmt::format("{}{} {}", quoted(section.name), section.before_nodes ? " before" : "",
                                 quoted(section.body)),
                     1, fmt::format("section ${}", section.name)});
  if (!document.title.empty()) {
    texts.push_back({quoted(document.title), 1, "title"});
    texts.back().name = texts.back().subject = document.title;
  }
  return texts;
}

std::string text_of_entity(const Document& document, const Entity& entity) {
  std::string text = fmt::format("{}/{} groups {}boundary {}", entity.dim, entity.tag,
                                 numbers(document.tag_sets.at(static_cast<std::size_t>(entity.groups))),
                                 numbers(entity.boundary));
  for (const double x : entity.box) text.append(" ").append(bits(x));
  if (entity.parent_dim >= 0)
    text += fmt::format(" of {}/{} partitions {}", entity.parent_dim, entity.parent,
                        numbers(document.tag_sets.at(static_cast<std::size_t>(entity.partitions))));
  return text;
}

}  // namespace tetproof::test
