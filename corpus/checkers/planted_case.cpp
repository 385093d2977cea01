// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/checkers/planted_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "corpus/block_mesh.hpp"
#include "corpus/planting/ground_meshes.hpp"
#include "corpus/report/boundary_faces.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

constexpr const char* sound_kind = "sound";

// A place for what is rounded, and for sound meshes; all other kinds stay where midpoints are exact.
const Place& place_for(bool everywhere, std::uint64_t round, std::size_t grounds) {
  return places()[everywhere ? round / grounds % places().size() : 0];
}

std::string name_of(const GroundMesh& ground, const Place& place) {
  return *place.name ? fmt::format("{} {}", ground.name, place.name) : ground.name;
}

PlantedCase sound_case(std::uint64_t seed, std::uint64_t round) {
  // Jittered meshes: another one in each round.
  std::vector<GroundMesh> grounds = ground_meshes({.mutate = [](Site&) { return false; }});
  grounds.push_back({"random block", block_mesh({3, 2, 2}, 0.1, seed + round)});
  grounds.push_back({"random ball", ball_mesh(3, 0.1, seed + round)});
  const GroundMesh& ground = grounds[round % grounds.size()];
  const Place& place = place_for(true, round, grounds.size());
  PlantedCase made{.kind = sound_kind, .ground = name_of(ground, place)};
  made.mesh = moved(ground.mesh, place.scale, place.shift);
  made.before = made.mesh;
  if (!truth(made.mesh).valid()) made.planted = false;  // rounding broke it: it is no sound mesh
  return made;
}

// The oriented triangles of the boundary by coordinates, each from its smallest corner on.
std::vector<std::array<std::array<double, 3>, 3>> boundary_points(const TetMesh& mesh) {
  std::vector<std::array<std::array<double, 3>, 3>> all;
  const BoundaryFaces all_faces(mesh);
  for (const auto& face : all_faces.boundary()) {
    std::array<std::array<double, 3>, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& p = mesh.points[static_cast<std::size_t>(face[k])];
      corners[k] = {p.x(), p.y(), p.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

std::vector<std::string> checked_kinds(const std::vector<std::string>& wanted) {
  if (!wanted.empty()) {
    for (const std::string& id : wanted)
      if (id != sound_kind) plant_kind(id);
    return wanted;
  }
  std::vector<std::string> all{sound_kind};
  for (const PlantKind& kind : plant_kinds()) all.emplace_back(kind.id);
  return all;
}

PlantedCase planted_case(const std::vector<std::string>& kinds, std::uint64_t seed, std::uint64_t index) {
  const std::uint64_t round = index / kinds.size();
  const std::string& id = kinds[index % kinds.size()];
  PlantedCase made;
  if (id == sound_kind) {
    made = sound_case(seed, round);
  } else {
    const PlantKind& kind = plant_kind(id);
    const std::vector<GroundMesh> grounds = ground_meshes(kind);
    const Place& place = place_for(kind.has("rounding"), round, grounds.size());
    made.kind = id;
    made.planted = false;
    // Not every kind has a place in every mesh: then the next mesh, then another seed.
    for (std::uint64_t attempt = 0; attempt < 4 * grounds.size() && !made.planted; ++attempt) {
      const GroundMesh& base = grounds[(round + attempt) % grounds.size()];
      const Ground ground(moved(base.mesh, place.scale, place.shift));
      auto planted = plant(kind, ground, seed * 0x9e3779b97f4a7c15 + index + (attempt << 32));
      if (!planted) continue;
      made.planted = true;
      made.ground = name_of(base, place);
      made.mesh = std::move(planted->mesh);
      made.expected = planted->expected;
      made.before = ground.mesh();
    }
  }
  made.index = index;
  return made;
}

TriangleSurface boundary_of(const TetMesh& mesh) {
  TriangleSurface surface;
  std::map<Index, Index> numbers;
  const BoundaryFaces all_faces(mesh);
  for (const auto& face : all_faces.boundary()) {
    std::array<Index, 3>& triangle = surface.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, fresh] = numbers.emplace(face[k], static_cast<Index>(surface.vertices.size()));
      if (fresh) surface.vertices.push_back(mesh.points[static_cast<std::size_t>(face[k])]);
      triangle[k] = at->second;
    }
  }
  return surface;
}

bool same_boundary(const TetMesh& a, const TetMesh& b) {
  return boundary_points(a) == boundary_points(b);
}

}  // namespace tetproof::corpus
