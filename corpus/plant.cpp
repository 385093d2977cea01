// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses places, and decides by exact arithmetic whether what was planted is what its kind promises.
#include "corpus/plant.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "corpus/plant_site.hpp"
#include "io/error.hpp"

namespace tetproof::corpus {
namespace {

std::vector<PlantKind> two_at_once() {
  constexpr auto defective = Expected::defective;
  const auto both = [](const char* id, const char* first, const char* second, const char* comment) {
    return PlantKind{id, defective, {"two"}, {}, {}, comment, nullptr, first, second};
  };
  return {both("inverted-and-hanging", "inverted-inside", "hanging-on-edge",
               "two independent defects: an inverted tetrahedron, a hanging node"),
          both("inverted-and-inside", "inverted-inside", "inside-another",
               "two independent defects: an inverted tetrahedron, one inside another"),
          both("nan-and-crack", "nan-inside", "crack-around-tet",
               "two independent defects: a coordinate that is not a number, a crack"),
          both("duplicate-and-thrice", "duplicate-tet", "face-shared-thrice",
               "two independent defects: a duplicate, a face of three tetrahedra"),
          both("crossed-and-overlap", "crossed-diagonals", "overlap-1e-12",
               "two independent defects: crossed diagonals, an overlap by 1e-12"),
          both("missing-and-touching", "missing-inside", "touching-edge",
               "a missing tetrahedron, and far from it a boundary that touches itself"),
          both("index-and-flat", "index-too-high", "flat",
               "two independent defects: a number that no point has, a flat tetrahedron"),
          both("crack-and-inside-at-vertex", "crack-around-tet", "inside-another-at-vertex",
               "two independent defects: a crack, a tetrahedron inside another at a vertex of it"),
          both("hanging-and-hanging", "hanging-off-edge", "hanging-off-face",
               "two nodes that hang far from each other, both rounded off")};
}

bool same_bits(const Point& p, const Point& q) {
  for (int k = 0; k < 3; ++k)
    if (std::bit_cast<std::uint64_t>(p[k]) != std::bit_cast<std::uint64_t>(q[k])) return false;
  return true;
}

// What differs from the sound mesh; the copy's removed tetrahedra are taken out.
struct Outcome {
  TetMesh mesh;
  std::vector<Index> changed;         // tetrahedra that are new, name other vertices or have moved ones
  std::vector<Index> tets, vertices;  // as in Planted
  bool anything = false;
};

Outcome outcome(const Site& s) {
  Outcome result;
  const TetMesh& before = s.parts.mesh;
  result.mesh.points = s.mesh.points;
  std::vector<std::uint8_t> moved(s.mesh.points.size(), 0);
  std::set<Index> vertices(s.vertices.begin(), s.vertices.end()), tets;
  for (std::size_t v = 0; v < s.mesh.points.size(); ++v)
    if (v >= before.points.size() || !same_bits(s.mesh.points[v], before.points[v]))
      moved[v] = 1, vertices.insert(static_cast<Index>(v));
  result.anything = !vertices.empty() || s.mesh.points.size() != before.points.size();
  std::set<Index> beside_removed;
  for (std::size_t t = 0; t < s.removed.size(); ++t)
    if (s.removed[t] && t < before.tets.size())
      for (const Index u : s.parts.neighbours[t])
        if (u >= 0) beside_removed.insert(u);
  for (std::size_t t = 0; t < s.mesh.tets.size(); ++t) {
    if (s.removed[t]) {
      result.anything = true;
      continue;
    }
    const auto now = static_cast<Index>(result.mesh.tets.size());
    result.mesh.tets.push_back(s.mesh.tets[t]);
    const bool changed =
        t >= before.tets.size() || s.mesh.tets[t] != before.tets[t] ||
        std::any_of(s.mesh.tets[t].begin(), s.mesh.tets[t].end(), [&](Index v) {
          return v >= 0 && v < static_cast<Index>(moved.size()) && moved[static_cast<std::size_t>(v)];
        });
    if (changed) result.changed.push_back(now), tets.insert(now), result.anything = true;
    if (beside_removed.contains(static_cast<Index>(t))) tets.insert(now);
  }
  result.tets.assign(tets.begin(), tets.end());
  result.vertices.assign(vertices.begin(), vertices.end());
  return result;
}

// Whether the truth is what the kind promises; narrows what is needed to what is true.
bool keeps_promise(const PlantKind& kind, bool alone, Planted& planted) {
  const Truth& truth = planted.truth;
  const bool valid = truth.valid(), slit = kind.has("slit");
  planted.expected = kind.expected.value_or(valid ? Expected::sound : Expected::defective);
  if (planted.expected == Expected::defective && valid && !slit) return false;
  if (planted.expected != Expected::defective && !valid) return false;
  if (slit && alone && !(truth.negative.empty() && truth.flat.empty())) return false;
  std::vector<std::string> needed;
  for (const char* id : kind.needed)
    if (truth.confirms(id)) needed.emplace_back(id);
  if (!kind.expected) {
    // Of what may be wrong, what is.
    const auto is_about_holes = [](const std::string& id) {
      return id == "cavity" || id == "near-contact" || id.starts_with("boundary-nonmanifold");
    };
    std::erase_if(needed, [&](const std::string& id) { return is_about_holes(id) != valid; });
    if (valid) needed.clear();
  }
  if (needed.empty() && !kind.needed.empty() && !(valid && !kind.expected)) return false;
  if (!needed.empty()) planted.needed.push_back(needed);
  return true;
}

void admit(Planted& planted, const PlantKind& kind) {
  for (const auto* ids : {&kind.needed, &kind.also})
    for (const char* id : *ids) planted.admissible.emplace_back(id);
}

// What is worth a warning wherever it is true.
void admit_warnings(Planted& planted) {
  for (const char* id :
       {"duplicate-point", "unused-point", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"})
    if (planted.truth.confirms(id)) planted.admissible.emplace_back(id);
  std::sort(planted.admissible.begin(), planted.admissible.end());
  planted.admissible.erase(std::unique(planted.admissible.begin(), planted.admissible.end()),
                           planted.admissible.end());
}

// All vertices of tetrahedra that touch what a first planting concerned, and one ring more.
std::vector<std::uint8_t> taken_by(const Site& s) {
  const Outcome first = outcome(s);
  std::vector<std::uint8_t> taken(s.parts.mesh.points.size(), 0);
  const auto take = [&](Index v) {
    if (v >= 0 && v < static_cast<Index>(taken.size())) taken[static_cast<std::size_t>(v)] = 1;
  };
  for (const Index v : first.vertices) take(v);
  for (const Index t : first.tets)
    for (const Index v : first.mesh.tets[static_cast<std::size_t>(t)]) take(v);
  for (std::size_t t = 0; t < s.parts.mesh.tets.size(); ++t)
    if (s.removed[t] || s.mesh.tets[t] != s.parts.mesh.tets[t])
      for (const Index v : s.parts.mesh.tets[t]) take(v);
  for (int ring = 0; ring < 2; ++ring) {
    const std::vector<std::uint8_t> before = taken;
    for (const Tet& tet : s.parts.mesh.tets)
      if (std::any_of(tet.begin(), tet.end(),
                      [&](Index v) { return before[static_cast<std::size_t>(v)] != 0; }))
        for (const Index v : tet) take(v);
  }
  return taken;
}

std::optional<Planted> finished(const Site& site, const std::vector<const PlantKind*>& kinds) {
  Outcome result = outcome(site);
  if (!result.anything) return std::nullopt;
  Planted planted{.mesh = std::move(result.mesh),
                  .expected = Expected::sound,
                  .tets = std::move(result.tets),
                  .vertices = std::move(result.vertices),
                  .needed = {},
                  .admissible = {},
                  .truth = {}};
  const bool whole = result.changed.size() * 4 > planted.mesh.tets.size();
  planted.truth = truth(planted.mesh, result.changed, whole ? 16 : 64);
  bool defective = false, debatable = false;
  for (const PlantKind* kind : kinds) {
    // Of two, the first may be sound where the second is not.
    PlantKind promised = *kind;
    if (kinds.size() > 1 && promised.expected != Expected::defective) promised.expected = Expected::defective;
    if (!keeps_promise(promised, kinds.size() == 1, planted)) return std::nullopt;
    const Expected own = kinds.size() > 1 ? *kind->expected : planted.expected;
    defective = defective || own == Expected::defective;
    debatable = debatable || own == Expected::debatable;
    admit(planted, *kind);
  }
  planted.expected = defective ? Expected::defective : debatable ? Expected::debatable : Expected::sound;
  admit_warnings(planted);
  return planted;
}

}  // namespace

const char* name_of(Expected expected) {
  return expected == Expected::sound ? "sound" : expected == Expected::debatable ? "debatable" : "defective";
}

bool PlantKind::has(std::string_view flag) const {
  return std::any_of(flags.begin(), flags.end(), [&](const char* own) { return flag == own; });
}

const std::vector<PlantKind>& plant_kinds() {
  static const std::vector<PlantKind> all = [] {
    std::vector<PlantKind> kinds;
    for (const auto& theme : {number_kinds(), orientation_kinds(), overlap_kinds(), contact_kinds(),
                              conformity_kinds(), crack_kinds(), missing_kinds(), two_at_once()})
      kinds.insert(kinds.end(), theme.begin(), theme.end());
    return kinds;
  }();
  return all;
}

const PlantKind& plant_kind(std::string_view id) {
  for (const PlantKind& kind : plant_kinds())
    if (id == kind.id) return kind;
  throw InputError(fmt::format("unknown kind of defect '{}'", id));
}

Ground::Ground(TetMesh mesh) : parts_(std::make_unique<const Parts>(std::move(mesh))) {}
Ground::~Ground() = default;
Ground::Ground(Ground&&) noexcept = default;
const TetMesh& Ground::mesh() const {
  return parts_->mesh;
}

std::optional<Planted> plant(const PlantKind& kind, const Ground& ground, std::uint64_t seed) {
  constexpr int tries = 40;
  const Parts& parts = ground.parts();
  Random random(seed);
  const std::vector<std::uint8_t> nothing(parts.mesh.points.size(), 0);
  for (int i = 0; i < tries; ++i) {
    std::vector<std::uint8_t> taken = nothing;
    Site site(parts, random, taken);
    std::vector<const PlantKind*> kinds{&kind};
    if (kind.second) {
      kinds = {&plant_kind(kind.first), &plant_kind(kind.second)};
      if (!kinds[0]->mutate(site)) continue;
      taken = taken_by(site);
      std::vector<Index> first = std::exchange(site.vertices, {});
      if (!kinds[1]->mutate(site)) continue;
      site.vertices.insert(site.vertices.end(), first.begin(), first.end());
    } else if (!kind.mutate(site)) {
      continue;
    }
    if (auto planted = finished(site, kinds)) return planted;
  }
  return std::nullopt;
}

}  // namespace tetproof::corpus
