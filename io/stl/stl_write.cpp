// SPDX-License-Identifier: GPL-3.0-or-later
// Writes STL, text and binary.
#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "io/bytes/byte_order.hpp"
#include "io/error.hpp"
#include "io/stl/stl.hpp"
#include "io/stl/stl_plan.hpp"
#include "io/surface/kept_part.hpp"
#include "io/surface/surface_lines.hpp"

namespace tetproof::io {
namespace {

struct WrittenFacet {
  std::array<Index, 3> corners;
  std::size_t element;
};

// Returns the normal of length 1, or 0 for a triangle that has none.
Eigen::Vector3f normal(const std::vector<Eigen::Vector3d>& points, const std::array<Index, 3>& t) {
  const Eigen::Vector3d& a = points[static_cast<std::size_t>(t[0])];
  Eigen::Vector3d b = points[static_cast<std::size_t>(t[1])] - a,
                  c = points[static_cast<std::size_t>(t[2])] - a;
  b /= b.cwiseAbs().maxCoeff(), c /= c.cwiseAbs().maxCoeff();  // avoids overflow and underflow
  const Eigen::Vector3d n = b.cross(c);
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (n / length).cast<float>() + Eigen::Vector3f::Zero();  // without -0
}

std::vector<WrittenFacet> facets_of(const StlSolid& solid, StlCutter& cutter) {
  std::vector<WrittenFacet> facets;
  std::vector<std::array<Index, 3>> triangles;
  for (const ElementBlock* block : solid.blocks)
    for (std::size_t e = 0; e < block->count; ++e) {
      triangles.clear();
      if (!cutter.cut(*block, e, triangles)) continue;
      for (const auto& triangle : triangles) facets.push_back({triangle, block->first + e});
    }
  return facets;
}

// Other programs take a file whose header starts with "solid" for text. A blank before it avoids that, if
// there is room.
std::string header_of(const std::string& title) {
  std::string start = title.substr(0, 5);
  for (char& c : start)
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  std::string header = title.substr(0, 80);
  if (start == "solid" && header.size() < 80) header.insert(header.begin(), ' ');
  return header;
}

void write_binary(AtomicFile& file, const Document& document, const StlPlan& plan) {
  std::vector<std::vector<WrittenFacet>> solids;
  std::size_t count = 0;
  StlCutter cutter(document);
  for (const StlSolid& solid : plan.solids) {
    solids.push_back(facets_of(solid, cutter));
    count += solids.back().size();
  }
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw InputError(fmt::format("STL counts at most 4294967295 triangles, found {}", count));
  std::string header = header_of(document.title);
  header.resize(stl_header_bytes);
  store(header.data() + 80, static_cast<std::uint32_t>(count), std::endian::little);
  file.write(header);
  for (const std::vector<WrittenFacet>& facets : solids)
    write_items(file, facets.size(), stl_facet_bytes, [&](std::size_t i, char* to) {
      const WrittenFacet& facet = facets[i];
      const Eigen::Vector3f n = normal(document.points, facet.corners);
      for (int k = 0; k < 3; ++k) to = store(to, n[k], std::endian::little);
      for (const Index corner : facet.corners)
        for (const double x : document.points[static_cast<std::size_t>(corner)])
          to = store(to, static_cast<float>(x), std::endian::little);
      const std::int64_t attribute = plan.attributes ? plan.attributes->integers[facet.element] : 0;
      return store(to, static_cast<std::uint16_t>(attribute), std::endian::little);
    });
}

void write_solid(AtomicFile& file, const std::vector<Eigen::Vector3d>& points,
                 const std::vector<WrittenFacet>& facets, std::string name) {
  if (!name.empty()) name.insert(name.begin(), ' ');
  file.write(fmt::format("solid{}\n", name));
  write_items(file, facets.size(), 512, [&](std::size_t i, char* to) {
    const auto& corners = facets[i].corners;
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

void write_text(AtomicFile& file, const Document& document, const StlPlan& plan) {
  std::vector<StlSolid> solids = plan.solids;
  if (solids.empty()) solids.emplace_back();
  std::vector<StlGroup> groups;
  for (const StlSolid& solid : solids) groups.push_back(solid.group);
  const std::vector<std::string> lines = lines_of_groups(groups);
  StlCutter cutter(document);
  for (std::size_t s = 0; s < solids.size(); ++s)
    write_solid(file, document.points, facets_of(solids[s], cutter), lines[s]);
}

// The triangles, if these are all that is written. Elements that are cut have no single facet for their
// attribute, so the document stays as it is with them.
std::optional<std::vector<std::size_t>> elements_with_attributes(const Document& document) {
  bool is_cut = !document.facets.empty();
  std::vector<std::size_t> triangles = kept_elements(document, [&](const KeptElement& e) {
    is_cut = is_cut || e.corners > 3;
    return e.corners == 3;
  });
  if (is_cut) return std::nullopt;
  return triangles;
}

class StlFilePlan : public OneFilePlan {
 public:
  StlFilePlan(const Document& document, bool binary)
      : OneFilePlan(document),
        part_(document, elements_with_attributes, KeptPart::Form::lists),
        plan_(stl_plan(part_.document(), binary)),
        binary_(binary) {
    holds_ = part_.holds(stl_holds(part_.document(), plan_, binary));
  }

  std::string warning(const std::string& path) override {
    std::string text = bends();
    if (binary_ && std::any_of(plan_.solids.begin(), plan_.solids.end(),
                               [](const StlSolid& solid) { return solid.group.number != 0; }))
      text += fmt::format("{}only the text form has solids: --ascii keeps the groups and their names",
                          text.empty() ? "" : "; ");
    return text.empty() ? text : path + ": " + text;
  }

 private:
  std::string bends() const {
    StlCutter cutter(part_.document());
    std::vector<std::array<Index, 3>> triangles;
    for (const StlSolid& solid : plan_.solids)
      for (const ElementBlock* block : solid.blocks)
        for (std::size_t e = 0; is_cut(*block) && e < block->count; ++e, triangles.clear())
          cutter.cut(*block, e, triangles);
    return cutter.bends().text();
  }
  // Facets may begin with a triangle.
  bool is_cut(const ElementBlock& block) const {
    return corners_kept(block) > 3 || !part_.document().facets.empty();
  }

  void write_into(AtomicFile& file) override {
    binary_ ? write_binary(file, part_.document(), plan_) : write_text(file, part_.document(), plan_);
  }

  const KeptPart part_;
  const StlPlan plan_;
  const bool binary_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_stl(const Document& document, bool binary) {
  return std::make_unique<StlFilePlan>(document, binary);
}

}  // namespace tetproof::io
