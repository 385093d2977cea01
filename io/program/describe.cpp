// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/describe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "io/bytes/one_line.hpp"
#include "io/bytes/words.hpp"
#include "io/model/element_types.hpp"
#include "io/model/group_signs.hpp"

namespace tetproof {
namespace {

using Json = nlohmann::ordered_json;

struct OfType {
  int least_nodes = 0, most_nodes = 0;  // of an element; polygons, polyhedra and polylines differ in these
  std::int64_t elements = 0;
};

struct Figures {
  std::map<int, OfType> types;
  std::array<std::int64_t, 4> entities{};  // by dimension
  // Elements by (dimension, group). The sign of Gmsh's groups tells only how their elements are oriented.
  std::map<std::pair<int, std::int64_t>, std::int64_t> groups;
  std::map<std::pair<int, std::int64_t>, std::string> names;
  std::set<std::int64_t> partitions;
  Eigen::Vector3d low, high;
  bool has_box = false;
};

Figures count(const Document& document) {
  Figures figures;
  std::set<std::pair<int, std::int64_t>> entities;
  for (const ElementBlock& block : document.blocks) {
    if (block.count > 0) {
      OfType& of_type = figures.types[block.type];
      of_type.least_nodes =
          of_type.elements == 0 ? block.nodes_each : std::min(of_type.least_nodes, block.nodes_each);
      of_type.most_nodes = std::max(of_type.most_nodes, block.nodes_each);
      of_type.elements += static_cast<std::int64_t>(block.count);
    }
    if (block.entity != 0) entities.insert({block.dim, block.entity});
    for (std::int64_t group : document.tag_sets[block.groups])
      figures.groups[{block.dim, io::unsigned_group(document, group)}] +=
          static_cast<std::int64_t>(block.count);
    const auto& partitions = document.tag_sets[block.partitions];
    figures.partitions.insert(partitions.begin(), partitions.end());
  }
  for (const Entity& entity : document.entities) entities.insert({entity.dim, entity.tag});
  for (const auto& entity : entities) ++figures.entities[entity.first];
  for (const GroupName& name : document.group_names) {
    figures.names[{name.dim, name.group}] = name.name;
    figures.groups[{name.dim, name.group}];
  }
  for (const Eigen::Vector3d& point : document.points) {
    if (!point.allFinite()) continue;
    figures.low = figures.has_box ? figures.low.cwiseMin(point).eval() : point;
    figures.high = figures.has_box ? figures.high.cwiseMax(point).eval() : point;
    figures.has_box = true;
  }
  return figures;
}

std::pair<std::int64_t, std::int64_t> range(const std::vector<std::int64_t>& tags, std::int64_t first,
                                            std::size_t n) {
  if (tags.empty()) return {first, first + static_cast<std::int64_t>(n) - 1};
  const auto [least, most] = std::minmax_element(tags.begin(), tags.end());
  return {*least, *most};
}

std::string shape_of(int type) {
  if (type == io::polygon) return "polygon";
  if (type == io::polyhedron) return "polyhedron";
  if (type == io::polyline) return "polyline";
  const io::ElementType* known = io::element_type(type);
  if (known && io::is_bezier(type))
    return known->dim == 1 ? "Bezier curve" : known->dim == 2 ? "Bezier triangle" : "Bezier tetrahedron";
  return known && known->shape != io::Shape::other ? io::singular(io::name_of_elements(type)) : "other";
}

// " (Gmsh's type 4)", where it is one.
std::string type_in_words(int type) {
  return io::is_of_gmsh(type) ? fmt::format(" (Gmsh's type {})", type) : "";
}

// The start of a line: "         3 nodes".
std::string row(std::integral auto n, const std::string& many) {
  return fmt::format("{:>10} {}", n, n == 1 ? io::singular(many) : many);
}

// Parts of which only the number is printed; those that the document does not have are left out.
std::vector<std::pair<std::string, std::size_t>> parts(const Document& document) {
  const Voronoi& voronoi = document.voronoi;
  std::vector<std::pair<std::string, std::size_t>> all{
      {"entities of ghost elements", document.ghosts.size()},
      {"ghost elements", document.ghost_elements.size()},
      {"periodic links", document.periodic.size()},
      {"facets of several polygons or with holes", document.facets.size()},
      {"holes", document.holes.size()},
      {"regions", document.regions.size()},
      {"bounds of areas", document.area_bounds.size()},
      {"bounds of lengths", document.length_bounds.size()},
      {"points of a Voronoi diagram", voronoi.points.size()},
      {"edges of a Voronoi diagram", voronoi.edges.size()},
      {"faces of a Voronoi diagram", voronoi.faces.size()},
      {"cells of a Voronoi diagram", voronoi.cells.size()},
  };
  std::erase_if(all, [](const auto& part) { return part.second == 0; });
  return all;
}

using ValuesOf = std::pair<const std::vector<Values>*, const char*>;
std::array<ValuesOf, 3> all_values(const Document& document) {
  return {{{&document.node_values, "node"},
           {&document.element_values, "element"},
           {&document.element_node_values, "element_node"}}};
}

}  // namespace

std::string describe_text(const Document& document) {
  const Figures figures = count(document);
  std::string text = fmt::format("{}: {}\n", io::in_one_line(document.path), document.format);
  const std::size_t nodes = document.points.size(), elements = document.elements();
  text += row(nodes, "nodes");
  if (nodes > 0) {
    const auto [least, most] = range(document.node_tags, document.first_node, nodes);
    text += fmt::format(", numbered {} to {}", least, most);
  }
  if (figures.has_box)
    text += fmt::format("\n           in ({}, {}, {}) to ({}, {}, {})", figures.low.x(), figures.low.y(),
                        figures.low.z(), figures.high.x(), figures.high.y(), figures.high.z());
  text += '\n';
  text += row(elements, "elements");
  if (elements > 0) {
    const auto [least, most] = range(document.element_tags, document.first_element, elements);
    text += fmt::format(", numbered {} to {}", least, most);
  }
  text += '\n';
  for (const auto& [type, what] : figures.types)
    text += fmt::format("{:>10} of them {} of {}{}{}\n", what.elements, shape_of(type),
                        what.least_nodes < what.most_nodes ? fmt::format("{} to ", what.least_nodes) : "",
                        io::counted(what.most_nodes, "nodes"), type_in_words(type));
  if (!document.unknown.empty())
    text +=
        fmt::format("{}, the first {}\n", row(document.unknown.size(), "numbers of nodes that do not exist"),
                    document.unknown[0]);
  for (int dim = 0; dim < 4; ++dim)
    if (figures.entities[dim] > 0)
      text += fmt::format("{} of dimension {}\n", row(figures.entities[dim], "entities"), dim);
  for (const auto& [key, elements_in] : figures.groups) {
    const auto name = figures.names.find(key);
    text +=
        fmt::format("{} in group {} of dimension {}{}\n", row(elements_in, "elements"), key.second, key.first,
                    name == figures.names.end() ? "" : fmt::format(" \"{}\"", io::in_one_line(name->second)));
  }
  if (!figures.partitions.empty()) text += row(figures.partitions.size(), "partitions") + "\n";
  for (const auto& [values, of] : all_values(document))
    for (const Values& v : *values)
      text += fmt::format("{} with {} \"{}\" each\n",
                          row(v.items(), std::string_view(of) == "node" ? "nodes" : "elements"),
                          io::counted(v.components, "values"), io::in_one_line(v.name));
  for (const auto& [part, number] : parts(document)) text += row(number, part) + "\n";
  for (const Table& table : document.tables)
    text += fmt::format("{} of {} in table \"{}\"\n", row(table.rows, "rows"),
                        io::counted(table.columns.size(), "columns"), io::in_one_line(table.name));
  for (const Section& section : document.sections)
    text +=
        fmt::format("{} in section ${}\n", row(section.body.size(), "bytes"), io::in_one_line(section.name));
  for (const Loss& loss : document.dropped)
    text += fmt::format("{:>10} {}, not read ({})\n", loss.count, loss.item, loss.example);
  return text;
}

Json describe_json(const Document& document) {
  const Figures figures = count(document);
  Json json{{"file", document.path}, {"format", document.format}};
  const std::size_t nodes = document.points.size(), elements = document.elements();
  json["nodes"]["count"] = nodes;
  if (nodes > 0) {
    const auto [least, most] = range(document.node_tags, document.first_node, nodes);
    json["nodes"]["least"] = least;
    json["nodes"]["largest"] = most;
  }
  if (figures.has_box)
    json["nodes"]["box"] = {{figures.low.x(), figures.low.y(), figures.low.z()},
                            {figures.high.x(), figures.high.y(), figures.high.z()}};
  json["elements"]["count"] = elements;
  if (elements > 0) {
    const auto [least, most] = range(document.element_tags, document.first_element, elements);
    json["elements"]["least"] = least;
    json["elements"]["largest"] = most;
  }
  Json types = Json::array();
  for (const auto& [type, what] : figures.types) {
    Json one{
        {"type", type}, {"shape", shape_of(type)}, {"nodes", what.least_nodes}, {"count", what.elements}};
    if (what.least_nodes < what.most_nodes) one["most_nodes"] = what.most_nodes;
    types.push_back(std::move(one));
  }
  json["elements"]["types"] = types;
  json["unknown_nodes"] = document.unknown.size();
  json["entities"] = figures.entities;
  Json groups = Json::array();
  for (const auto& [key, elements_in] : figures.groups) {
    Json group{{"dimension", key.first}, {"group", key.second}, {"elements", elements_in}};
    if (const auto name = figures.names.find(key); name != figures.names.end()) group["name"] = name->second;
    groups.push_back(group);
  }
  json["groups"] = groups;
  json["partitions"] = figures.partitions.size();
  for (const auto& [values, of] : all_values(document)) {
    Json& list = json[fmt::format("{}_values", of)] = Json::array();
    for (const Values& v : *values)
      list.push_back({{"name", v.name}, {"components", v.components}, {"items", v.items()}});
  }
  Json& others = json["parts"] = Json::object();
  for (const auto& [part, number] : parts(document)) others[part] = number;
  json["tables"] = Json::array();
  for (const Table& table : document.tables)
    json["tables"].push_back({{"name", table.name}, {"rows", table.rows}, {"columns", table.columns.size()}});
  if (!document.title.empty()) json["title"] = document.title;
  json["sections"] = Json::array();
  for (const Section& section : document.sections)
    json["sections"].push_back({{"name", section.name}, {"bytes", section.body.size()}});
  json["warnings"] = document.warnings;
  json["dropped"] = Json::array();
  for (const Loss& loss : document.dropped)
    json["dropped"].push_back({{"item", loss.item}, {"count", loss.count}, {"example", loss.example}});
  return json;
}

}  // namespace tetproof
