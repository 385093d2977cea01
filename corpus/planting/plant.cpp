// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses places, and decides by exact arithmetic whether the planted defect is what its kind promises.
#include "corpus/plant.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "corpus/planting/plant_outcome.hpp"
#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// Two kinds in one place can have any effect together: only the truth of the mesh tells what it is.
bool is_together(const PlantKind& kind) {
  return kind.id == std::string_view("any-two-together");
}

// Whether the mesh is valid, or not valid, as the planted kinds promise. Sets `planted.expected`.
bool keeps_promise(const std::vector<const PlantKind*>& kinds, bool together, Planted& planted) {
  const bool valid = planted.truth.valid();
  if (together || !kinds[0]->expected) {
    planted.expected = valid ? Expected::sound : Expected::defective;
    return true;
  }
  bool invalid = false, slit = false;
  for (const PlantKind* kind : kinds) {
    planted.expected = std::max(planted.expected, *kind->expected);
    slit = slit || kind->has("slit");
    invalid = invalid || (kind->expected == Expected::defective && !kind->has("slit"));
  }
  // A hanging node must be the only defect of its tetrahedra.
  if (slit && kinds.size() == 1 && !(planted.truth.negative.empty() && planted.truth.flat.empty()))
    return false;
  return invalid ? !valid : slit || valid;
}

// Adds the checks that a kind demands of a report, as far as the truth confirms them. False if it confirms
// none.
bool demand(const PlantKind& kind, Planted& planted, PlantedRoot root) {
  for (const auto* ids : {&kind.needed, &kind.also})
    for (const char* id : *ids) planted.admissible.emplace_back(id);
  for (const char* id : kind.needed)
    if (planted.truth.confirms(id)) root.ids.emplace_back(id);
  if (!kind.expected) {
    if (planted.expected != Expected::defective) return true;
    std::erase_if(root.ids, [](const std::string& id) {
      return id == "cavity" || id == "near-contact" || id.starts_with("boundary-nonmanifold");
    });
  }
  if (root.ids.empty()) return kind.needed.empty();
  planted.needed.push_back(std::move(root));
  return true;
}

// Admits warnings that are true of the mesh, or were true before anything was planted.
void admit_warnings(Planted& planted, const std::vector<const char*>& before) {
  planted.admissible.insert(planted.admissible.end(), before.begin(), before.end());
  for (const char* id :
       {"duplicate-point", "unused-point", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"})
    if (planted.truth.confirms(id)) planted.admissible.emplace_back(id);
  std::sort(planted.admissible.begin(), planted.admissible.end());
  planted.admissible.erase(std::unique(planted.admissible.begin(), planted.admissible.end()),
                           planted.admissible.end());
}

// The tetrahedra and vertices of the first of two plantings, by their positions in the copy.
struct First {
  std::vector<Index> tets, vertices;
};

std::optional<Planted> finished(const Site& site, const std::vector<const PlantKind*>& kinds, bool together,
                                const First& first) {
  Outcome result = outcome(site);
  if (!result.anything) return std::nullopt;
  Planted planted;
  planted.mesh = std::move(result.mesh);
  const bool whole = result.changed.size() * 4 > planted.mesh.tets.size();
  // If many tetrahedra have changed, pairs are examined only if no tetrahedron is negative.
  planted.truth = truth(planted.mesh, result.changed, whole ? 0 : 64);
  if (whole && planted.truth.negative.empty()) planted.truth = truth(planted.mesh, result.changed, 16);
  if (!keeps_promise(kinds, together, planted)) return std::nullopt;
  std::vector<PlantedRoot> places(kinds.size());
  for (std::size_t i = 0; i < result.tets.size(); ++i)
    places[kinds.size() == 2 && !std::binary_search(first.tets.begin(), first.tets.end(), result.origins[i])]
        .tets.push_back(result.tets[i]);
  for (const Index v : result.vertices)
    places[kinds.size() == 2 && !std::binary_search(first.vertices.begin(), first.vertices.end(), v)]
        .vertices.push_back(v);
  planted.tets = std::move(result.tets);
  planted.vertices = std::move(result.vertices);
  if (together) {
    for (const char* id :
         {"index-range", "finite-coordinates", "repeated-vertex", "duplicate-tet", "inverted", "flat",
          "face-shared-thrice", "face-orientation", "crack", "boundary-self-intersection", "overlap",
          "hanging-node", "crossed-diagonal", "non-conforming-interface"})
      planted.admissible.emplace_back(id);
    if (planted.expected == Expected::defective)
      planted.needed = {{planted.admissible, planted.tets, planted.vertices}};
    for (const char* id : {"cavity", "near-contact"}) planted.admissible.emplace_back(id);
  } else {
    if (kinds.size() == 2 && !apart(planted.mesh, places[0], places[1])) return std::nullopt;
    for (std::size_t i = 0; i < kinds.size(); ++i)
      if (!demand(*kinds[i], planted, std::move(places[i]))) return std::nullopt;
  }
  admit_warnings(planted, site.parts.warned);
  // If rounding has also flattened or inverted a tetrahedron, the mesh is an example of another kind. (One of
  // two duplicates may be negative.)
  const auto admitted = [&](const char* id) {
    return together ||
           std::find(planted.admissible.begin(), planted.admissible.end(), id) != planted.admissible.end();
  };
  // With shifted numbers any tetrahedron is flat or negative.
  if (planted.truth.shift != 0) return planted;
  if (!planted.truth.flat.empty() && !admitted("flat")) return std::nullopt;
  if (!planted.truth.negative.empty() && planted.truth.duplicates.empty() && !admitted("inverted"))
    return std::nullopt;
  return planted;
}

// A random kind that changes the mesh locally. If two are planted in one place, only the truth decides, so
// kinds whose effect depends on rounding are left out.
const PlantKind& any_local_kind(Random& random, bool together) {
  const auto& all = plant_kinds();
  for (;;) {
    const PlantKind& kind = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
    if (kind.mutate && kind.expected && !kind.has("whole") &&
        !(together && (kind.has("conformity") || kind.has("rounding"))))
      return kind;
  }
}

}  // namespace

Ground::Ground(TetMesh mesh) : parts_(std::make_unique<const Parts>(std::move(mesh))) {}
Ground::~Ground() = default;
Ground::Ground(Ground&&) noexcept = default;
const TetMesh& Ground::mesh() const {
  return parts_->mesh;
}

std::optional<Planted> plant(const PlantKind& kind, const Ground& ground, std::uint64_t seed) {
  constexpr int tries = 40;
  const Parts& parts = ground.parts();
  if (kind.has("whole") && parts.mesh.tets.size() > most_tets_for_whole) return std::nullopt;
  Random random(seed);
  const std::vector<std::uint8_t> nothing(parts.mesh.points.size(), 0);
  for (int i = 0; i < tries; ++i) {
    std::vector<std::uint8_t> taken = nothing;
    Site site(parts, random, taken);
    if (kind.mutate) {
      if (!kind.mutate(site)) continue;
      if (auto planted = finished(site, {&kind}, false, {})) return planted;
      continue;
    }
    const bool together = is_together(kind);
    const PlantKind& one = kind.first ? plant_kind(kind.first) : any_local_kind(random, together);
    const PlantKind& other = kind.second ? plant_kind(kind.second) : any_local_kind(random, together);
    if (!one.mutate(site) || (!together && !finished(site, {&one}, false, {}))) continue;
    Outcome planted_first = outcome(site);
    const First first{std::move(planted_first.origins), std::move(planted_first.vertices)};
    if (!together) {
      // Each must keep its promise when it is planted alone.
      taken = taken_by(site);
      Random same = random;
      Site alone(parts, same, taken);
      if (!other.mutate(alone) || !finished(alone, {&other}, false, {})) continue;
    }
    if (!other.mutate(site)) continue;
    site.vertices.insert(site.vertices.end(), first.vertices.begin(), first.vertices.end());
    if (auto planted = finished(site, {&one, &other}, together, first)) return planted;
  }
  return std::nullopt;
}

}  // namespace tetproof::corpus
