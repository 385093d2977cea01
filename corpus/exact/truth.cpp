// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/truth.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "corpus/exact/exact_pairs.hpp"
#include "corpus/exact/truth_shift.hpp"

namespace tetproof::corpus {
namespace {

using Face = std::array<Index, 3>;

Face sorted(Face face) {
  std::sort(face.begin(), face.end());
  return face;
}

bool odd(const Face& face) {
  return ((face[0] > face[1]) + (face[1] > face[2]) + (face[0] > face[2])) % 2 != 0;
}

// Faces by their sorted vertices. Each use has its tetrahedron and the order in which that names the
// vertices.
using Faces = std::map<Face, std::vector<std::pair<Index, Face>>>;

class Brute {
 public:
  Brute(const TetMesh& mesh, std::span<const Index> asked, std::size_t most_pairs)
      : mesh_(mesh), most_(most_pairs), usable_(mesh.tets.size(), 1) {
    numbers_and_points();
    duplicates();
    faces();
    orientations(asked);
    truth.shift = shift_of(mesh);
    pairs(asked);
  }
  Truth truth;

 private:
  const Eigen::Vector3d& point(Index v) const { return mesh_.points[static_cast<std::size_t>(v)]; }
  const std::array<Index, 4>& tet(Index t) const { return mesh_.tets[static_cast<std::size_t>(t)]; }
  bool usable(Index t) const { return usable_[static_cast<std::size_t>(t)] != 0; }
  Index count() const { return static_cast<Index>(mesh_.tets.size()); }

  void numbers_and_points() {
    const auto points = static_cast<Index>(mesh_.points.size());
    std::vector<std::uint8_t> used(mesh_.points.size(), 0);
    for (Index t = 0; t < count(); ++t) {
      bool outside = false, infinite = false;
      for (const Index v : tet(t)) {
        if (v < 0 || v >= points) {
          outside = true;
          continue;
        }
        used[static_cast<std::size_t>(v)] = 1;
        infinite = infinite || !point(v).allFinite();
      }
      if (outside) truth.out_of_range.push_back(t);
      if (infinite) truth.not_finite.push_back(t);
      const bool repeats = std::set<Index>(tet(t).begin(), tet(t).end()).size() < 4;
      if (repeats) truth.repeating.push_back(t);
      usable_[static_cast<std::size_t>(t)] = !outside && !infinite && !repeats;
    }
    const auto place = [&](Index v) { return std::array{point(v).x(), point(v).y(), point(v).z()}; };
    std::map<std::array<double, 3>, Index> first;
    first_.resize(mesh_.points.size());
    for (Index v = 0; v < points; ++v) {
      if (!used[static_cast<std::size_t>(v)]) truth.unused.push_back(v);
      first_[static_cast<std::size_t>(v)] = v;
      if (!point(v).allFinite()) continue;
      const auto [at, added] = first.try_emplace(place(v), v);
      if (added) continue;
      first_[static_cast<std::size_t>(v)] = at->second;
      truth.equal_points.push_back({at->second, v});
    }
  }

  void duplicates() {
    std::map<std::array<Index, 4>, std::vector<Index>> same;
    for (Index t = 0; t < count(); ++t) {
      if (!usable(t)) continue;
      std::array<Index, 4> key = tet(t);
      std::sort(key.begin(), key.end());
      same[key].push_back(t);
    }
    for (const auto& [key, tets] : same)
      if (tets.size() > 1) truth.duplicates.push_back(tets);
    std::map<std::array<Index, 4>, std::vector<Index>> in_place;
    for (const auto& [key, tets] : same) {
      std::array<Index, 4> places = key;
      for (Index& v : places) v = first_[static_cast<std::size_t>(v)];
      std::sort(places.begin(), places.end());
      in_place[places].push_back(tets[0]);
    }
    for (auto& [places, tets] : in_place) {
      if (tets.size() < 2 || std::set<Index>(places.begin(), places.end()).size() < 4) continue;
      std::sort(tets.begin(), tets.end());
      truth.copies.push_back(tets);
    }
    std::sort(truth.copies.begin(), truth.copies.end());
  }

  void faces() {
    Faces all;
    for (Index t = 0; t < count(); ++t) {
      if (!usable(t)) continue;
      for (const auto& [i, j, k] : tet_faces) {
        const Face face{tet(t)[i], tet(t)[j], tet(t)[k]};
        all[sorted(face)].emplace_back(t, face);
      }
    }
    Faces in_place;  // boundary faces, by the first points that have the coordinates of their vertices
    std::map<std::array<Index, 2>, std::vector<Face>> at_edge;
    std::map<Index, std::vector<Face>> at_vertex;
    for (const auto& [key, sides] : all) {
      if (sides.size() > 2) {
        truth.thrice.emplace_back();
        for (const auto& [t, face] : sides) truth.thrice.back().push_back(t);
      } else if (sides.size() == 2) {
        if (odd(sides[0].second) == odd(sides[1].second))
          truth.one_sided.push_back({sides[0].first, sides[1].first});
      } else {
        Face places = sides[0].second;
        for (Index& v : places) v = first_[static_cast<std::size_t>(v)];
        in_place[sorted(places)].emplace_back(sides[0].first, places);
        for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}})
          at_edge[{key[i], key[j]}].push_back(key);
        for (const Index v : key) at_vertex[v].push_back(key);
      }
    }
    for (const auto& [key, sides] : in_place)
      for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
          if (odd(sides[i].second) != odd(sides[k].second))
            truth.coinciding_faces.push_back({sides[k].first, sides[i].first});
    for (const auto& [edge, around] : at_edge)
      if (around.size() > 2) truth.nonmanifold_edges.push_back(edge);
    for (const auto& [v, fan] : at_vertex)
      if (fans(v, fan) > 1) truth.nonmanifold_vertices.push_back(v);
  }

  // The number of sets into which faces at a vertex fall, if faces that share an edge at the vertex belong
  // together.
  static std::size_t fans(Index v, const std::vector<Face>& faces) {
    std::vector<std::size_t> parent(faces.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto find = [&](std::size_t i) {
      while (parent[i] != i) i = parent[i];
      return i;
    };
    std::size_t sets = faces.size();
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        for (const Index w : faces[i])
          if (w != v && std::count(faces[k].begin(), faces[k].end(), w) && find(i) != find(k))
            parent[find(i)] = find(k), --sets;
    return sets;
  }

  void orientations(std::span<const Index> asked) {
    flat_.assign(mesh_.tets.size(), 0);
    for (const Index t : asked) {
      if (!usable(t)) continue;
      const auto& [a, b, c, d] = tet(t);
      const int sign = orientation(point(a), point(b), point(c), point(d));
      if (sign < 0) truth.negative.push_back(t);
      if (sign > 0) continue;
      if (sign == 0) truth.flat.push_back(t), flat_[static_cast<std::size_t>(t)] = 1;
    }
    std::sort(truth.negative.begin(), truth.negative.end());
    std::sort(truth.flat.begin(), truth.flat.end());
  }

  void pairs(std::span<const Index> asked) {
    if (most_ == 0) {
      truth.all = false;
      return;
    }
    std::vector<std::array<Eigen::Vector3d, 2>> boxes(mesh_.tets.size());
    for (Index t = 0; t < count(); ++t) {
      if (!usable(t)) continue;
      auto& [low, high] = boxes[static_cast<std::size_t>(t)];
      low = high = point(tet(t)[0]);
      for (const Index v : tet(t)) low = low.cwiseMin(point(v)), high = high.cwiseMax(point(v));
    }
    std::vector<std::uint8_t> is_asked(mesh_.tets.size(), 0);
    for (const Index t : asked) is_asked[static_cast<std::size_t>(t)] = 1;
    std::set<Touch> touches;
    for (Index s = 0; s < count(); ++s) {
      if (!is_asked[static_cast<std::size_t>(s)] || !usable(s) || flat_[static_cast<std::size_t>(s)])
        continue;
      const auto& [low, high] = boxes[static_cast<std::size_t>(s)];
      for (Index t = 0; t < count(); ++t) {
        if (t == s || (t < s && is_asked[static_cast<std::size_t>(t)])) continue;
        if (!usable(t) || flat_[static_cast<std::size_t>(t)]) continue;
        const auto& other = boxes[static_cast<std::size_t>(t)];
        if ((other[0].array() > high.array()).any() || (other[1].array() < low.array()).any()) continue;
        pair(s, t, touches);
        if (truth.overlaps.size() + touches.size() + truth.crossings.size() >= most_) {
          truth.all = false;
          truth.touches.assign(touches.begin(), touches.end());
          return;
        }
      }
    }
    truth.touches.assign(touches.begin(), touches.end());
    std::sort(truth.overlaps.begin(), truth.overlaps.end());
    std::sort(truth.crossings.begin(), truth.crossings.end());
    std::sort(truth.touching_faces.begin(), truth.touching_faces.end());
  }

  void pair(Index s, Index t, std::set<Touch>& touches) {
    const std::array<Index, 4>&one = tet(s), &other = tet(t);
    std::array<Index, 4> a = one, b = other;
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    if (a == b) return;
    Corners p, q;
    for (int i = 0; i < 4; ++i) p[i] = point(one[i]), q[i] = point(other[i]);
    const Meeting found = meeting(p, one, q, other);
    const std::array<Index, 2> key{std::min(s, t), std::max(s, t)};
    if (found.overlap) truth.overlaps.push_back(key);
    if (found.crossing) truth.crossings.push_back(key);
    if (!found.overlap && (found.crossing || !found.one_in_other.empty() || !found.other_in_one.empty()) &&
        faces_touch(one, other))
      truth.touching_faces.push_back(key);
    for (const int i : found.one_in_other) touches.insert({one[i], t});
    for (const int i : found.other_in_one) touches.insert({other[i], s});
  }

  bool faces_touch(const std::array<Index, 4>& one, const std::array<Index, 4>& other) const {
    for (const auto& [i, j, k] : tet_faces)
      for (const auto& [l, m, n] : tet_faces)
        if (partly_on_each_other({point(one[i]), point(one[j]), point(one[k])},
                                 {point(other[l]), point(other[m]), point(other[n])}))
          return true;
    return false;
  }

  const TetMesh& mesh_;
  std::size_t most_;
  std::vector<std::uint8_t> usable_, flat_;
  std::vector<Index> first_;  // for each point, the first point with the same coordinates
};

}  // namespace

bool Truth::valid() const {
  return out_of_range.empty() && not_finite.empty() && repeating.empty() && duplicates.empty() &&
         negative.empty() && flat.empty() && thrice.empty() && one_sided.empty() && overlaps.empty() &&
         touches.empty() && crossings.empty();
}

bool Truth::confirms(std::string_view id) const {
  if (id == "index-range") return !out_of_range.empty() || shift != 0;
  if (id == "finite-coordinates") return !not_finite.empty();
  if (id == "repeated-vertex") return !repeating.empty();
  if (id == "duplicate-point") return !equal_points.empty();
  if (id == "unused-point") return !unused.empty();
  if (id == "duplicate-tet") return !duplicates.empty() || !copies.empty();
  if (id == "inverted") return !negative.empty();
  if (id == "flat") return !flat.empty();
  if (id == "face-shared-thrice") return !thrice.empty();
  if (id == "face-orientation") return !one_sided.empty();
  if (id == "non-conforming-interface") return !touching_faces.empty();
  if (id == "crack") return !coinciding_faces.empty();
  if (id == "boundary-nonmanifold-edge") return !nonmanifold_edges.empty();
  if (id == "boundary-nonmanifold-vertex") return !nonmanifold_vertices.empty();
  if (id == "boundary-self-intersection" || id == "overlap")
    return !overlaps.empty() || !touches.empty() || !crossings.empty();
  return true;
}

Truth truth(const TetMesh& mesh, std::span<const Index> asked, std::size_t most_pairs) {
  return Brute(mesh, asked, most_pairs).truth;
}

Truth truth(const TetMesh& mesh) {
  std::vector<Index> all(mesh.tets.size());
  std::iota(all.begin(), all.end(), 0);
  return truth(mesh, all, mesh.tets.size() * mesh.tets.size() + 1);
}

}  // namespace tetproof::corpus
