// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/readers/sample_documents.hpp"

#include <algorithm>

#include "corpus/block_mesh.hpp"
#include "corpus/campaign/scratch_folder.hpp"
#include "corpus/generators/random.hpp"
#include "corpus/report/boundary_faces.hpp"
#include "io/bytes/input_file.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "io/writing.hpp"

namespace tetproof::corpus {
namespace {

std::int32_t add_tags(Document& d, std::vector<std::int64_t> tags) {
  d.tag_sets.push_back(std::move(tags));
  return static_cast<std::int32_t>(d.tag_sets.size() - 1);
}

void add_block(Document& d, ElementBlock block, const std::vector<Index>& nodes) {
  block.first = d.elements();
  block.nodes = d.connectivity.size();
  block.count = nodes.size() / static_cast<std::size_t>(block.nodes_each);
  d.connectivity.insert(d.connectivity.end(), nodes.begin(), nodes.end());
  d.blocks.push_back(block);
}

// A value for each node and each element: reals, a vector, and whole numbers.
void add_values(Document& d, Random& random) {
  Values pressure{.name = "pressure"}, velocity{.name = "velocity", .components = 3},
      material{.name = "material"};
  for (std::size_t i = 0; i < d.points.size(); ++i) {
    pressure.reals.push_back(random.between(-1, 1));
    for (int c = 0; c < 3; ++c) velocity.reals.push_back(random.between(-1e3, 1e3));
  }
  for (std::size_t e = 0; e < d.elements(); ++e) material.integers.push_back(random.below(5));
  d.node_values = {pressure, velocity};
  d.element_values = {material};
}

// The tetrahedra in two volumes, the boundary in one surface, each with a named group.
Document tetrahedra(std::uint64_t seed) {
  const TetMesh mesh = block_mesh({2, 1, 1}, 0.1, seed);
  Document d;
  d.title = "a sample";
  d.points = mesh.points;
  std::vector<Index> halves[2], faces;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Index v : mesh.tets[t]) halves[2 * t >= mesh.tets.size()].push_back(v);
  const BoundaryFaces all_faces(mesh);
  for (const auto& face : all_faces.boundary()) faces.insert(faces.end(), face.begin(), face.end());
  add_block(d, {.type = 2, .dim = 2, .entity = 1, .groups = add_tags(d, {7}), .nodes_each = 3}, faces);
  add_block(d, {.type = 4, .dim = 3, .entity = 1, .groups = add_tags(d, {1}), .nodes_each = 4}, halves[0]);
  add_block(d, {.type = 4, .dim = 3, .entity = 2, .groups = add_tags(d, {2}), .nodes_each = 4}, halves[1]);
  d.group_names = {{2, 7, "the wall"}, {3, 1, "left"}, {3, 2, "right"}};
  Random random(seed);
  add_values(d, random);
  return d;
}

Document surface(std::uint64_t seed) {
  const TetMesh mesh = ball_mesh(1, 0.1, seed);
  Document d;
  d.title = "a surface";
  d.points = mesh.points;
  std::vector<Index> faces;
  const BoundaryFaces all_faces(mesh);
  for (const auto& face : all_faces.boundary()) faces.insert(faces.end(), face.begin(), face.end());
  add_block(d, {.type = 2, .dim = 2, .entity = 1, .groups = add_tags(d, {3}), .nodes_each = 3}, faces);
  d.group_names = {{2, 3, "skin"}};
  Random random(seed);
  add_values(d, random);
  return d;
}

// Quadratic tetrahedra, each with middle nodes of its own.
Document second_order(std::uint64_t seed) {
  const TetMesh mesh = block_mesh({1, 1, 1}, 0.1, seed);
  Document d;
  d.points = mesh.points;
  std::vector<Index> nodes;
  for (const auto& tet : mesh.tets) {
    nodes.insert(nodes.end(), tet.begin(), tet.end());
    constexpr int edges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {3, 0}, {2, 3}, {1, 3}};
    for (const auto& [a, b] : edges) {
      const auto at = [&](int k) {
        return mesh.points[static_cast<std::size_t>(tet[static_cast<std::size_t>(k)])];
      };
      nodes.push_back(static_cast<Index>(d.points.size()));
      d.points.push_back((at(a) + at(b)) / 2);
    }
  }
  add_block(d, {.type = 11, .dim = 3, .entity = 1, .nodes_each = 10}, nodes);
  return d;
}

// A hexahedron, a prism on it, quadrangles, a line and a point; numbers with gaps.
Document mixed(std::uint64_t seed) {
  Random random(seed);
  Document d;
  for (int k = 0; k < 10; ++k) d.points.emplace_back(k & 1, (k >> 1) & 1, (k >> 2) & 1);
  d.points[8] = {0.5, 0, 2 + random.unit()};
  d.points[9] = {0.5, 1, 2 + random.unit()};
  add_block(d, {.type = 15, .dim = 0, .entity = 1, .nodes_each = 1}, {8});
  add_block(d, {.type = 1, .dim = 1, .entity = 1, .nodes_each = 2}, {8, 9});
  add_block(d, {.type = 3, .dim = 2, .entity = 2, .nodes_each = 4}, {0, 1, 3, 2, 0, 1, 5, 4});
  add_block(d, {.type = 5, .dim = 3, .entity = 1, .nodes_each = 8}, {0, 1, 3, 2, 4, 5, 7, 6});
  add_block(d, {.type = 6, .dim = 3, .entity = 1, .nodes_each = 6}, {4, 5, 8, 6, 7, 9});
  for (std::size_t i = 0; i < d.points.size(); ++i)
    d.node_tags.push_back(1 + 3 * static_cast<std::int64_t>(i) + random.below(3));
  return d;
}

std::string bytes_of(const std::string& path) {
  return std::string(InputFile(path).bytes());
}

}  // namespace

std::vector<SampleDocument> sample_documents(std::uint64_t seed) {
  return {{"tetrahedra", tetrahedra(seed)},
          {"surface", surface(seed)},
          {"second order", second_order(seed)},
          {"mixed", mixed(seed)}};
}

std::string SampleFile::form() const {
  return format + (binary ? " binary" : "");
}

std::int64_t SampleFile::size() const {
  std::int64_t bytes = 0;
  for (const Part& part : parts) bytes += static_cast<std::int64_t>(part.bytes.size());
  return bytes;
}

std::vector<SampleFile> sample_files(std::uint64_t seed, const std::vector<std::string>& names) {
  std::vector<const Format*> wanted;
  for (const std::string& name : names) wanted.push_back(&format_named(name));
  if (names.empty())
    for (const Format& format : formats()) wanted.push_back(&format);
  const ScratchFolder scratch("");
  std::vector<SampleFile> all;
  for (const Format* format : wanted)
    for (const bool binary : {false, true}) {
      if (!(binary ? format->binary : format->ascii)) continue;
      for (const SampleDocument& sample : sample_documents(seed)) {
        const bool own_ending = binary && !format->binary_ending.empty();
        std::string ending = own_ending ? format->binary_ending : format->endings.front();
        if (!own_ending && ending == format->binary_ending) ending = format->endings.back();
        const std::string path = scratch / ("sample" + ending);
        SampleFile file{
            .document = sample.name, .format = format->name, .binary = binary, .ending = ending, .parts = {}};
        try {
          PlannedFile planned(path, sample.document, {.format = format->name, .binary = binary});
          planned.write();
          std::vector<std::string> paths = planned.files();
          std::stable_partition(paths.begin(), paths.end(), [&](const std::string& p) { return p == path; });
          for (const std::string& part : paths)
            file.parts.push_back({part.substr((scratch / "sample").size()), bytes_of(part)});
          file.content = std::make_shared<const Document>(read_document(path));
        } catch (const InputError&) {
          continue;  // the format has no place for this document
        }
        if (!file.parts.empty() && file.parts.front().ending == ending) all.push_back(std::move(file));
      }
    }
  return all;
}

}  // namespace tetproof::corpus
