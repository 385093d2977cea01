// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/msh_write.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/element_types.hpp"

namespace tetproof::io {
namespace {

// Sections that Gmsh gives a meaning, beyond those that the document holds in parts.
constexpr std::array<std::string_view, 10> gmsh_sections{
    "Periodic",        "GhostElements",       "Parametrizations", "NodeData",      "ElementData",
    "ElementNodeData", "InterpolationScheme", "ElementCuts",      "BoundaryLayer", "PartitionedEntities"};
// Those that are written the same way as text in 2.2 and 4.1.
constexpr std::array<std::string_view, 4> alike{"NodeData", "ElementData", "ElementNodeData",
                                                "InterpolationScheme"};

bool contains(const auto& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool keeps_section(const Section& section, const std::string& format, bool binary) {
  if (!contains(gmsh_sections, section.name)) return true;  // nobody reads anything into it
  if (section.binary != binary || section.swapped) return false;
  return section.format == format || (!binary && contains(alike, section.name));
}

bool msh_holds(const Document& document, const ElementBlock& block, const std::string& format, bool binary) {
  return element_type(block.type) || (!binary && document.format == format);
}

std::string msh_header(const char* version, bool binary) {
  std::string text = fmt::format("$MeshFormat\n{} {} 8\n", version, binary ? 1 : 0);
  if (binary) {
    char one[4];
    put_raw(one, std::int32_t{1});
    text.append(one, 4);
    text += '\n';
  }
  return text + "$EndMeshFormat\n";
}

std::string msh_names(const Document& document) {
  if (document.group_names.empty()) return {};
  std::string text = fmt::format("$PhysicalNames\n{}\n", document.group_names.size());
  for (const GroupName& name : document.group_names)
    text += fmt::format("{} {} \"{}\"\n", name.dim, name.group, name.name);
  return text + "$EndPhysicalNames\n";
}

std::string msh_kept_sections(const Document& document, const std::string& format, bool binary,
                              bool before_nodes) {
  std::string text;
  for (const Section& section : document.sections) {
    if (section.before_nodes != before_nodes || !keeps_section(section, format, binary)) continue;
    text += fmt::format("${}\n{}", section.name, section.body);
    if (!section.body.empty() && section.body.back() != '\n') text += '\n';
    text += fmt::format("$End{}\n", section.name);
  }
  return text;
}

}  // namespace tetproof::io
