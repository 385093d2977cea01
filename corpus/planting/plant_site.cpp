// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/planting/plant_site.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tetproof::corpus {

Parts::Parts(TetMesh given) : mesh(std::move(given)) {
  neighbours.assign(mesh.tets.size(), {-1, -1, -1, -1});
  tets_at.resize(mesh.points.size());
  on_boundary.assign(mesh.points.size(), 0);
  std::map<Face, std::array<Index, 2>> open;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (int corner = 0; corner < 4; ++corner) {
      tets_at[static_cast<std::size_t>(mesh.tets[t][corner])].push_back(static_cast<Index>(t));
      Face key{mesh.tets[t][tet_faces[corner][0]], mesh.tets[t][tet_faces[corner][1]],
               mesh.tets[t][tet_faces[corner][2]]};
      std::sort(key.begin(), key.end());
      const auto [at, added] = open.try_emplace(key, std::array{static_cast<Index>(t), Index{corner}});
      if (added) continue;
      const auto [other, other_corner] = at->second;
      neighbours[t][corner] = other;
      neighbours[static_cast<std::size_t>(other)][other_corner] = static_cast<Index>(t);
      open.erase(at);
    }
  for (const auto& [key, face] : open) {
    boundary.push_back(face);
    for (const Index v : key) on_boundary[static_cast<std::size_t>(v)] = 1;
  }
  const Truth before = truth(mesh, {});
  for (const char* id :
       {"duplicate-point", "unused-point", "boundary-nonmanifold-edge", "boundary-nonmanifold-vertex"})
    if (before.confirms(id)) warned.push_back(id);
  low = high = mesh.points.empty() ? Point(0, 0, 0) : mesh.points[0];
  for (const Point& p : mesh.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  diagonal = (high - low).norm();
}

bool Site::inner(Index t) const {
  const Tet& beside = parts.neighbours[static_cast<std::size_t>(t)];
  return std::count(beside.begin(), beside.end(), -1) == 0;
}

Face Site::face(Index t, int corner) const {
  const auto& [i, j, k] = tet_faces[static_cast<std::size_t>(corner)];
  return {tet(t)[i], tet(t)[j], tet(t)[k]};
}

Point Site::normal(const Face& f) const {
  return (at(f[1]) - at(f[0])).cross(at(f[2]) - at(f[0]));
}

Point Site::centroid(const Face& f) const {
  return at(f[0]) + ((at(f[1]) - at(f[0])) + (at(f[2]) - at(f[0]))) / 3;
}

Point Site::centroid(Index t) const {
  const auto& [a, b, c, d] = tet(t);
  return at(a) + ((at(b) - at(a)) + (at(c) - at(a)) + (at(d) - at(a))) / 4;
}

double Site::size(Index t) const {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < i; ++k) least = std::min(least, (at(tet(t)[i]) - at(tet(t)[k])).norm());
  return least;
}

std::vector<Index> Site::around(Index a, Index b) const {
  std::vector<Index> found;
  for (const Index t : tets_at(a))
    if (std::count(tet(t).begin(), tet(t).end(), b)) found.push_back(t);
  return found;
}

bool Site::free(Index t) const {
  return std::none_of(tet(t).begin(), tet(t).end(),
                      [&](Index v) { return taken[static_cast<std::size_t>(v)] != 0; });
}

bool Site::free_star(Index v) const {
  return !tets_at(v).empty() &&
         std::all_of(tets_at(v).begin(), tets_at(v).end(), [&](Index t) { return free(t); });
}

double Site::unit() const {
  return std::max(parts.low.cwiseAbs().maxCoeff(), parts.high.cwiseAbs().maxCoeff()) * 0x1p-52;
}

Point Site::within(Index t) {
  std::array<double, 4> weight;
  double sum = 0;
  for (double& w : weight) sum += w = random.between(0.2, 1);
  Point p = at(tet(t)[0]);
  for (int i = 1; i < 4; ++i) p += weight[i] / sum * (at(tet(t)[i]) - at(tet(t)[0]));
  return p;
}

Point Site::direction() {
  for (;;) {
    const Point p(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (const double length = p.norm(); length > 0.1 && length <= 1) return p / length;
  }
}

double Site::magnitude(int low, int high) {
  return std::ldexp(random.between(1, 2), low + random.below(high - low));
}

namespace {

Index some(Random& random, std::size_t count, const std::function<bool(Index)>& fits) {
  if (count == 0) return -1;
  const int first = random.below(static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const auto candidate = static_cast<Index>((static_cast<std::size_t>(first) + i) % count);
    if (fits(candidate)) return candidate;
  }
  return -1;
}

}  // namespace

Index Site::some_tet(const std::function<bool(Index)>& fits) {
  return some(random, parts.mesh.tets.size(), [&](Index t) { return free(t) && (!fits || fits(t)); });
}

Index Site::some_vertex(const std::function<bool(Index)>& fits) {
  return some(random, parts.mesh.points.size(), [&](Index v) { return free_star(v) && (!fits || fits(v)); });
}

bool Site::some_boundary_face(Index& t, int& corner) {
  const Index i = some(random, parts.boundary.size(),
                       [&](Index f) { return free(parts.boundary[static_cast<std::size_t>(f)][0]); });
  if (i < 0) return false;
  t = parts.boundary[static_cast<std::size_t>(i)][0];
  corner = parts.boundary[static_cast<std::size_t>(i)][1];
  return true;
}

bool Site::some_inner_face(Index& t, int& corner) {
  const int turn = random.below(4);
  t = some_tet([&](Index s) {
    for (int k = 0; k < 4; ++k) {
      corner = (turn + k) % 4;
      if (neighbour(s, corner) >= 0 && free(neighbour(s, corner))) return true;
    }
    return false;
  });
  return t >= 0;
}

Index Site::add(const Point& p) {
  mesh.points.push_back(p);
  return static_cast<Index>(mesh.points.size() - 1);
}

Index Site::add_positive(Tet tet) {
  if (sign(tet) < 0) std::swap(tet[2], tet[3]);
  mesh.tets.push_back(tet);
  removed.push_back(0);
  return static_cast<Index>(mesh.tets.size() - 1);
}

int Site::sign(const Tet& tet) const {
  std::array<Point, 4> p;
  for (std::size_t i = 0; i < 4; ++i) {
    if (tet[i] < 0 || tet[i] >= static_cast<Index>(mesh.points.size())) return 0;
    p[i] = mesh.points[static_cast<std::size_t>(tet[i])];
    if (!p[i].allFinite()) return 0;
  }
  return orientation(p[0], p[1], p[2], p[3]);
}

void Site::remove(Index t) {
  removed[static_cast<std::size_t>(t)] = 1;
  for (const Index v : mesh.tets[static_cast<std::size_t>(t)]) vertices.push_back(v);
}

bool Site::step_through(const Face& face, Point& p, int wanted) const {
  const auto side = [&] {
    return orientation(at(face[0]), at(face[1]), at(face[2]), p);  // negative: inside
  };
  int axis = 0;
  const Point n = normal(face);
  n.cwiseAbs().maxCoeff(&axis);
  const auto step = [&](int way) {
    p[axis] = std::nextafter(p[axis], way * n[axis] > 0 ? INFINITY : -INFINITY);
  };
  for (int i = 0; i < 64 && side() >= 0; ++i) step(-1);
  if (side() >= 0) return false;
  if (wanted < 0) {
    for (int i = 0; i < 64; ++i) {
      const Point last = p;
      step(1);
      if (side() >= 0) return p = last, true;
    }
    return false;
  }
  for (int i = 0; i < 128 && side() < wanted; ++i) step(1);
  return side() == wanted;
}

bool Site::split_edge(const std::vector<Index>& which, Index a, Index b, Index node) {
  for (const Index t : which) {
    Tet& one = mesh.tets[static_cast<std::size_t>(t)];
    Tet other = one;
    std::replace(one.begin(), one.end(), a, node);
    std::replace(other.begin(), other.end(), b, node);
    if (sign(one) <= 0 || sign(other) <= 0) return false;
    mesh.tets.push_back(other);
    removed.push_back(0);
  }
  return true;
}

void Site::add_copy(const std::function<Point(const Point&)>& place, bool wound_negative) {
  const auto shift = static_cast<Index>(mesh.points.size());
  for (const Point& p : parts.mesh.points) mesh.points.push_back(place(p));
  for (Tet t : parts.mesh.tets) {
    for (Index& v : t) v += shift;
    if (wound_negative) std::swap(t[2], t[3]);
    mesh.tets.push_back(t);
    removed.push_back(0);
  }
}

}  // namespace tetproof::corpus
