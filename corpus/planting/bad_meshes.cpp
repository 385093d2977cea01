// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/bad_meshes.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "corpus/block_mesh.hpp"
#include "corpus/planting/ground_meshes.hpp"
#include "io/bytes/atomic_file.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {
namespace {

const Place &here = places()[0], &far = places()[1], &tiny = places()[2];

constexpr std::uint64_t most_seeds = 60;

// The first planting of a kind for which `fits` is true.
std::optional<Planted> first(const PlantKind& kind, const Place& place,
                             const std::function<bool(const Planted&)>& fits) {
  for (const GroundMesh& base : ground_meshes(kind)) {
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
