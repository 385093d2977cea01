// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/bad_meshes.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "corpus/block_mesh.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {
namespace {

struct Base {
  const char* name;
  TetMesh mesh;
};

// The meshes in which a kind may be planted; the first one that has a place for it is used. Between points
// with integer coordinates midpoints are exact; in jittered meshes they are rounded.
std::vector<Base> bases(const PlantKind& kind) {
  const Base cell{"cell", block_mesh({2, 1, 1})}, block{"block", block_mesh({2, 2, 2})},
      jittered{"jittered", block_mesh({2, 2, 2}, 0.1, 3)}, ball{"ball", ball_mesh(2, 0.1, 3)},
      onion{"onion", ball_mesh(3, 0.1, 3)};
  if (kind.second)
    return {{"bar", block_mesh({10, 1, 1})},
            {"beam", block_mesh({7, 2, 2})},
            {"jittered beam", block_mesh({8, 3, 3}, 0.1)}};
  if (kind.has("whole")) return {cell, {"octahedron", ball_mesh(1, 0.1, 3)}, ball, block};
  if (kind.has("rounding") || kind.has("random")) return {jittered, ball, onion, block};
  return {block, ball, onion, jittered};
}

struct Place {
  const char* name;
  double scale;
  Eigen::Vector3d shift;
};
const Place here{"", 1, {0, 0, 0}}, far{"far", 1, {1e6, -0.9e6, 1.1e6}}, tiny{"tiny", 1e-9, {0, 0, 0}};

constexpr std::uint64_t most_seeds = 60;

// The first planting of a kind for which `fits` is true.
std::optional<Planted> first(const PlantKind& kind, const Place& place,
                             const std::function<bool(const Planted&)>& fits) {
  for (const Base& base : bases(kind)) {
    const Ground ground(moved(base.mesh, place.scale, place.shift));
    for (std::uint64_t seed = 1; seed <= most_seeds; ++seed)
      if (auto planted = plant(kind, ground, seed); planted && fits(*planted)) return planted;
  }
  return std::nullopt;
}

void add(std::vector<BadMesh>& all, const PlantKind& kind, const Place& place, const std::string& suffix,
         const std::function<bool(const Planted&)>& fits) {
  auto planted = first(kind, place, fits);
  if (!planted) return;
  BadMesh mesh{.name = kind.id + suffix,
               .kind = &kind,
               .flags = {kind.flags.begin(), kind.flags.end()},
               .planted = std::move(*planted)};
  if (*place.name) mesh.name += std::string("-") + place.name, mesh.flags.emplace_back(place.name);
  all.push_back(std::move(mesh));
}

void add_sound(std::vector<BadMesh>& all, const char* name, TetMesh mesh) {
  Planted nothing;
  nothing.mesh = std::move(mesh);
  nothing.truth = truth(nothing.mesh);
  if (!nothing.truth.valid()) throw std::logic_error(std::string(name) + " is not sound");
  all.push_back({.name = name, .kind = nullptr, .flags = {"control"}, .planted = std::move(nothing)});
}

std::vector<std::int64_t> numbers(const std::vector<Index>& positions) {
  std::vector<std::int64_t> result;
  for (const Index i : positions) result.push_back(std::int64_t{i} + 1);
  return result;
}

}  // namespace

std::vector<BadMesh> bad_meshes() {
  std::vector<BadMesh> all;
  add_sound(all, "sound-block", block_mesh({2, 2, 2}));
  add_sound(all, "sound-jittered", block_mesh({2, 2, 2}, 0.1, 3));
  add_sound(all, "sound-ball", ball_mesh(3, 0.1, 3));
  add_sound(all, "sound-far", moved(ball_mesh(2, 0.1, 3), far.scale, far.shift));
  add_sound(all, "sound-tiny", moved(ball_mesh(2, 0.1, 3), tiny.scale, tiny.shift));
  for (const PlantKind& kind : plant_kinds()) {
    if (kind.has("campaign")) continue;
    if (kind.has("rounding") && kind.has("slit")) {
      // Rounding decides what becomes of these kinds. One file shows a slit, another one an overlap.
      add(all, kind, here, "-slit", [](const Planted& p) { return p.truth.valid(); });
      add(all, kind, here, "-overlap", [](const Planted& p) { return !p.truth.valid(); });
    } else {
      add(all, kind, here, "",
          [&](const Planted& p) { return kind.expected || p.expected == Expected::defective; });
    }
    if (!kind.has("rounding")) continue;
    for (const Place& place : {far, tiny})
      add(all, kind, place, "",
          [&](const Planted& p) { return kind.expected || p.expected == Expected::defective; });
  }
  return all;
}

std::string bad_meshes_index(const std::vector<BadMesh>& meshes) {
  std::string text = "[\n";
  for (const BadMesh& mesh : meshes) {
    std::vector<std::vector<std::string>> needed;
    for (const PlantedRoot& root : mesh.planted.needed) needed.push_back(root.ids);
    const nlohmann::ordered_json entry{
        {"id", mesh.name},
        {"kind", mesh.kind ? mesh.kind->id : "sound"},
        {"flags", mesh.flags},
        {"comment", mesh.kind ? mesh.kind->comment : "a sound mesh, in which nothing is planted"},
        {"verdict", name_of(mesh.planted.expected)},
        {"valid", mesh.planted.truth.valid()},
        {"needed", needed},
        {"admissible", mesh.planted.admissible},
        {"tets", numbers(mesh.planted.tets)},
        {"vertices", numbers(mesh.planted.vertices)},
        {"size", {{"points", mesh.planted.mesh.points.size()}, {"tets", mesh.planted.mesh.tets.size()}}}};
    text += entry.dump() + (&mesh == &meshes.back() ? "\n" : ",\n");
  }
  return text + "]\n";
}

void write_bad_meshes(const std::string& folder, const std::vector<BadMesh>& meshes) {
  for (const BadMesh& mesh : meshes) {
    const Document document = document_of(mesh.planted.mesh);
    write_document(folder + "/" + mesh.name + ".msh", document, {.format = "msh22", .binary = false});
    write_document(folder + "/" + mesh.name + ".node", document, {.format = "tetgen"});
  }
  AtomicFile index(folder + "/index.json");
  index.write(bad_meshes_index(meshes));
  index.commit();
}

}  // namespace tetproof::corpus
