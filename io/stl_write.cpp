// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "io/byte_order.hpp"
#include "io/element_types.hpp"
#include "io/error.hpp"
#include "io/polygons.hpp"
#include "io/stl.hpp"
#include "io/stl_header.hpp"
#include "io/surface_lines.hpp"

namespace tetproof::io {
namespace {

struct Facet {
  std::array<Index, 3> corners;
  std::size_t element;
};

// The facets of a solid.
struct Solid {
  std::string name;
  std::vector<Facet> facets;
};

// Of length 1, or 0 for a triangle without direction.
Eigen::Vector3f normal(const std::vector<Eigen::Vector3d>& points, const std::array<Index, 3>& t) {
  const Eigen::Vector3d& a = points[static_cast<std::size_t>(t[0])];
  Eigen::Vector3d b = points[static_cast<std::size_t>(t[1])] - a,
                  c = points[static_cast<std::size_t>(t[2])] - a;
  b /= b.cwiseAbs().maxCoeff(), c /= c.cwiseAbs().maxCoeff();  // so that nothing over- or underflows
  const Eigen::Vector3d n = b.cross(c);
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (n / length).cast<float>() + Eigen::Vector3f::Zero();  // without -0
}

// A polygon's triangles, or none if it is not planar and convex.
void add_fan(std::vector<Facet>& facets, const std::vector<Eigen::Vector3d>& points,
             const KeptElement& face) {
  const auto n = static_cast<std::size_t>(face.corners);
  std::size_t start = 0;
  if (n > 3) {
    const Fan fan = fan_of({face.nodes, n}, points);
    if (fan.start < 0) return;
    start = static_cast<std::size_t>(fan.start);
  }
  for (std::size_t i = 1; i + 1 < n; ++i)
    facets.push_back(
        {{face.nodes[start], face.nodes[(start + i) % n], face.nodes[(start + i + 1) % n]}, face.element});
}

std::string name_of(const Document& document, const ElementBlock& block) {
  const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
  if (groups.empty()) return {};
  for (const GroupName& name : document.group_names)
    if (name.dim == block.dim && name.group == groups[0] && !name.name.empty()) return name.name;
  return fmt::format("{}", groups[0]);
}

// In one line, without blanks around it.
std::string line_of(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return stl_title(name);
}

bool new_solid(const ElementBlock& last, const ElementBlock& block) {
  return last.groups != block.groups || last.dim != block.dim;
}

std::vector<Solid> solids_of(const Document& document) {
  std::vector<Solid> solids;
  const ElementBlock* last = nullptr;
  for (const ElementBlock& block : document.blocks) {
    const int corners = corners_kept(block);
    if (corners < 3 || block.count == 0) continue;
    if (!last || new_solid(*last, block)) solids.push_back({name_of(document, block), {}});
    last = &block;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
      if (nodes_exist(node, corners))
        add_fan(solids.back().facets, document.points, {block.first + e, corners, node});
  }
  return solids;
}

// "attribute" of every element, from 0 to 65535, not all 0.
const Values* attributes_of(const Document& document) {
  for (const Values& values : document.element_values)
    if (values.name == "attribute" && values.components == 1 && values.reals.empty() &&
        of_all(values, document.elements()) &&
        std::all_of(values.integers.begin(), values.integers.end(),
                    [](std::int64_t a) { return a >= 0 && a <= 65535; }) &&
        std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t a) { return a != 0; }))
      return &values;
  return nullptr;
}

// A header that starts with "solid" would make others take the file for text.
std::string header_of(const std::string& title) {
  std::string start = title.substr(0, 5);
  for (char& c : start)
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  return start == "solid" ? " " + title : title;
}

bool triangles_only(const ElementBlock& block) {
  return corners_kept(block) == 3;
}

void write_binary(AtomicFile& file, const Document& document, const std::vector<Solid>& solids) {
  std::size_t count = 0;
  for (const Solid& solid : solids) count += solid.facets.size();
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("STL counts at most 4294967295 triangles, found {}", count));
  std::string header = header_of(document.title).substr(0, 80);
  header.resize(stl_header_bytes);
  store(header.data() + 80, static_cast<std::uint32_t>(count), std::endian::little);
  file.write(header);
  const Values* attributes = attributes_of(document);
  for (const Solid& solid : solids)
    write_items(file, solid.facets.size(), stl_facet_bytes, [&](std::size_t i, char* to) {
      const Facet& facet = solid.facets[i];
      const Eigen::Vector3f n = normal(document.points, facet.corners);
      for (int k = 0; k < 3; ++k) to = store(to, n[k], std::endian::little);
      for (const Index corner : facet.corners)
        for (const double x : document.points[static_cast<std::size_t>(corner)])
          to = store(to, static_cast<float>(x), std::endian::little);
      const std::int64_t attribute = attributes ? attributes->integers[facet.element] : 0;
      return store(to, static_cast<std::uint16_t>(attribute), std::endian::little);
    });
}

void write_solid(AtomicFile& file, const std::vector<Eigen::Vector3d>& points, const Solid& solid) {
  std::string name = line_of(solid.name);
  if (!name.empty()) name.insert(name.begin(), ' ');
  file.write(fmt::format("solid{}\n", name));
  write_items(file, solid.facets.size(), 512, [&](std::size_t i, char* to) {
    const auto& corners = solid.facets[i].corners;
    const Eigen::Vector3f n = normal(points, corners);
    to = put(to, "facet normal");
    for (int k = 0; k < 3; ++k) to = std::to_chars(put(to, ' '), to + 32, n[k]).ptr;
    to = put(to, "\nouter loop\n");
    for (const Index corner : corners)
      to = put(put_point(put(to, "vertex "), points[static_cast<std::size_t>(corner)]), '\n');
    return put(to, "endloop\nendfacet\n");
  });
  file.write(fmt::format("endsolid{}\n", name));
}

}  // namespace

void write_stl(AtomicFile& file, const Document& document, bool binary) {
  std::vector<Solid> solids = solids_of(document);
  if (binary) return write_binary(file, document, solids);
  if (solids.empty()) solids.emplace_back();
  for (const Solid& solid : solids) write_solid(file, document.points, solid);
}

Holds stl_holds(const Document& document, bool binary) {
  Holds holds;
  holds.which_nodes = Holds::Nodes::of_elements;
  holds.nodes_by_place = true;
  holds.cuts_polygons = true;
  holds.single = binary;
  holds.nodes_each = [](const ElementBlock& block) { return triangles_only(block) ? 3 : 0; };
  holds.title = document.title.empty() || (binary && document.title == stl_title(document.title) &&
                                           header_of(document.title).size() <= 80);
  const bool all = keeps_all_elements(document, holds.nodes_each);
  const Values* attributes = binary && all ? attributes_of(document) : nullptr;
  holds.values = [attributes](const Values& values, Of) { return &values == attributes; };

  std::vector<bool> groups(document.blocks.size(), true), names(document.group_names.size(), false);
  std::vector<std::string> solids{""};
  if (!binary) {
    solids.clear();
    for (const Solid& solid : solids_of(document)) solids.push_back(line_of(solid.name));
  }
  const std::vector<std::int64_t> numbers = groups_of_solids(solids);
  std::size_t s = 0;
  const ElementBlock* last = nullptr;
  for (std::size_t b = 0; b < document.blocks.size(); ++b) {
    const ElementBlock& block = document.blocks[b];
    if (corners_kept(block) < 3 || block.count == 0) continue;
    if (!binary && last && new_solid(*last, block)) ++s;
    last = &block;
    const auto& set = document.tag_sets[static_cast<std::size_t>(block.groups)];
    groups[b] = numbers[s] == 0 ? set.empty() : set == std::vector<std::int64_t>{numbers[s]};
    if (numbers[s] == 0 || group_number(solids[s])) continue;
    for (std::size_t n = 0; n < names.size(); ++n) {
      const GroupName& given = document.group_names[n];
      if (given.dim == 2 && given.group == numbers[s] && given.name == solids[s]) names[n] = true;
    }
  }
  const auto whole = [](const std::vector<bool>& flags) {
    return std::find(flags.begin(), flags.end(), false) == flags.end();
  };
  holds.groups = whole(groups) ? Holds::Groups::all : Holds::Groups::none;
  holds.group_names = whole(names);
  holds.groups_of = [groups, &document](const ElementBlock& block) {
    const auto i = static_cast<std::size_t>(&block - document.blocks.data());
    return i < groups.size() && groups[i];
  };
  holds.name = [names, &document](const GroupName& name) {
    const auto i = static_cast<std::size_t>(&name - document.group_names.data());
    return i < names.size() && names[i];
  };
  return holds;
}

}  // namespace tetproof::io
