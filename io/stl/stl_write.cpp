// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "io/bytes/byte_order.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"
#include "io/stl/stl.hpp"
#include "io/stl/stl_solids.hpp"
#include "io/surface/polygons.hpp"
#include "io/surface/surface_lines.hpp"

namespace tetproof::io {
namespace {

struct Facet {
  std::array<Index, 3> corners;
  std::size_t element;
};

// The facets of a solid.
struct Solid {
  StlGroup group;
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

// Where the fan of triangles starts; -1 for a polygon that is not planar and convex.
std::ptrdiff_t start_of_fan(const std::vector<Eigen::Vector3d>& points, const Index* nodes, std::size_t n) {
  return n == 3 ? 0 : fan_of({nodes, n}, points).start;
}

// A polygon's triangles, or none.
void add_fan(std::vector<Facet>& facets, const std::vector<Eigen::Vector3d>& points,
             const KeptElement& face) {
  const auto n = static_cast<std::size_t>(face.corners);
  const std::ptrdiff_t begin = start_of_fan(points, face.nodes, n);
  if (begin < 0) return;
  const auto start = static_cast<std::size_t>(begin);
  for (std::size_t i = 1; i + 1 < n; ++i)
    facets.push_back(
        {{face.nodes[start], face.nodes[(start + i) % n], face.nodes[(start + i + 1) % n]}, face.element});
}

StlGroup group_of(const Document& document, const ElementBlock& block) {
  const auto& groups = document.tag_sets[static_cast<std::size_t>(block.groups)];
  if (groups.empty()) return {};
  for (const GroupName& name : document.group_names)
    if (name.dim == block.dim && name.group == groups[0]) return {name.name, groups[0]};
  return {"", groups[0]};
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
    if (!last || new_solid(*last, block)) solids.push_back({group_of(document, block), {}});
    last = &block;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
      if (nodes_exist(node, block.nodes_each))
        add_fan(solids.back().facets, document.points, {block.first + e, corners, node});
  }
  // Groups that no element is in, but that have a name.
  for (const GroupName& name : document.group_names) {
    const bool used = std::any_of(solids.begin(), solids.end(),
                                  [&](const Solid& solid) { return solid.group.number == name.group; });
    if (name.dim == 2 && name.group != 0 && !name.name.empty() && !used)
      solids.push_back({{name.name, name.group}, {}});
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

// A header that starts with "solid" would make others take the file for text, if there is room to avoid it.
std::string header_of(const std::string& title) {
  std::string start = title.substr(0, 5);
  for (char& c : start)
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  std::string header = title.substr(0, 80);
  if (start == "solid" && header.size() < 80) header.insert(header.begin(), ' ');
  return header;
}

bool triangles_only(const ElementBlock& block) {
  return corners_kept(block) == 3;
}

void write_binary(AtomicFile& file, const Document& document, const std::vector<Solid>& solids) {
  std::size_t count = 0;
  for (const Solid& solid : solids) count += solid.facets.size();
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("STL counts at most 4294967295 triangles, found {}", count));
  std::string header = header_of(document.title);
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

void write_solid(AtomicFile& file, const std::vector<Eigen::Vector3d>& points, const Solid& solid,
                 std::string name) {
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
  std::vector<StlGroup> groups;
  for (const Solid& solid : solids) groups.push_back(solid.group);
  const std::vector<std::string> lines = lines_of_groups(groups);
  for (std::size_t s = 0; s < solids.size(); ++s) write_solid(file, document.points, solids[s], lines[s]);
}

Holds stl_holds(const Document& document, bool binary) {
  Holds holds;
  holds.which_nodes = Holds::Nodes::of_elements;
  holds.nodes_by_place = true;
  holds.single = binary;
  holds.nodes_each = [](const ElementBlock& block) { return triangles_only(block) ? 3 : 0; };
  holds.cut_at = [&document](const ElementBlock& block, const Index* nodes) -> std::ptrdiff_t {
    const int corners = corners_kept(block);
    if (corners < 4 || !nodes_exist(nodes, block.nodes_each)) return -1;
    return start_of_fan(document.points, nodes, static_cast<std::size_t>(corners));
  };
  holds.title = document.title.empty() ||
                (binary && document.title == stl_title(document.title) && document.title.size() <= 80);
  const bool all = keeps_all_elements(document, holds.nodes_each);
  const Values* attributes = binary && all ? attributes_of(document) : nullptr;
  holds.values = [attributes](const Values& values, Of) { return &values == attributes; };

  if (binary) return holds;
  holds.groups = Holds::Groups::first;
  std::set<std::pair<std::int64_t, std::string>> names;
  for (const Solid& solid : solids_of(document))
    if (!solid.group.name.empty()) names.insert({solid.group.number, solid.group.name});
  holds.name = [names](const GroupName& name) {
    return name.dim == 2 && names.count({name.group, name.name}) > 0;
  };
  return holds;
}

}  // namespace tetproof::io
