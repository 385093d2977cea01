// SPDX-License-Identifier: GPL-3.0-or-later
// Writes surfaces for meshers.
#include "corpus/meshing/surface_input.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "corpus/meshing/nesting.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/document.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/surface_files.hpp"

namespace tetproof::corpus {

namespace {

void write_smesh(const std::string& path, const TriangleSurface& surface) {
  Document document = document_of(surface);
  document.element_node_values.clear();  // (u,v), of which .smesh knows nothing
  for (ElementBlock& block : document.blocks) block.of_boundary = true;
  const Nesting parts = nesting(surface);
  for (int part = 0; part < parts.parts(); ++part) {
    if (parts.depth[static_cast<std::size_t>(part)] % 2 == 0) continue;
    const auto point = point_in(surface, parts, part);
    if (!point)
      throw NoPointInCavity(path + ": no point can be named in a cavity, which is too thin for doubles");
    document.holes.push_back(*point);
  }
  write_document(path, document, {.format = "smesh"});
}

/// The parts as Gmsh's surfaces, numbered from 1.
void write_msh(const std::string& path, const TriangleSurface& surface, const Nesting& parts) {
  Document document;
  document.points = surface.vertices;
  for (int part = 0; part < parts.parts(); ++part) {
    ElementBlock block;
    block.type = 2;
    block.dim = 2;
    block.entity = part + 1;
    block.nodes_each = 3;
    block.first = document.connectivity.size() / 3;
    block.nodes = document.connectivity.size();
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      if (parts.part_of_triangle[i] != part) continue;
      document.connectivity.insert(document.connectivity.end(), surface.triangles[i].begin(),
                                   surface.triangles[i].end());
      ++block.count;
    }
    document.blocks.push_back(block);
  }
  write_document(path, document, {.format = "msh22", .binary = false});
}

void write_geo(const std::string& path, const std::string& surface_file, const Nesting& parts) {
  const std::string name = surface_file.substr(surface_file.find_last_of('/') + 1);
  std::string text = fmt::format("Merge \"{}\";\n", name);
  for (int part = 1; part <= parts.parts(); ++part)
    text += fmt::format("Surface Loop({0}) = {{{0}}};\n", part);
  for (int part = 0; part < parts.parts(); ++part) {
    if (parts.depth[static_cast<std::size_t>(part)] % 2 != 0) continue;
    text += fmt::format("Volume({0}) = {{{0}", part + 1);
    for (int k = 0; k < parts.parts(); ++k)
      if (parts.parent[static_cast<std::size_t>(k)] == part) text += fmt::format(", {}", k + 1);
    text += "};\n";
  }
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace

SurfaceInput write_surface_input(const std::string& stem, const std::string& ending,
                                 const TriangleSurface& surface) {
  const std::string path = stem + ending;
  SurfaceInput input{{path}, nullptr};
  if (ending == ".smesh") {
    write_smesh(path, surface);
  } else if (ending == ".msh") {
    write_msh(path, surface, nesting(surface));
  } else if (ending == ".geo") {
    const Nesting parts = nesting(surface);
    input.files.push_back(stem + ".surface.msh");
    write_msh(input.files[1], surface, parts);
    write_geo(path, input.files[1], parts);
  } else if (is_surface_file(path)) {
    write_surface(path, surface);
    if (ending == ".stl") input.given = std::make_shared<const TriangleSurface>(read_surface(path));
  } else {
    Document document = document_of(surface);
    document.element_node_values.clear();
    write_document(path, document);
  }
  return input;
}

}  // namespace tetproof::corpus
