// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds in which the boundary touches itself at a vertex, an edge or a face, with shared points or with
// separate ones.
#include <algorithm>

#include "corpus/planting/plant_site.hpp"

namespace tetproof::corpus {
namespace {

// The outward unit normals of the boundary faces at vertex a or, if b is given, at edge a b.
std::vector<Point> normals_at(const Site& s, Index a, Index b = -1) {
  std::vector<Point> found;
  for (const Index t : s.tets_at(a))
    for (int corner = 0; corner < 4; ++corner) {
      if (s.neighbour(t, corner) >= 0) continue;
      const Face face = s.face(t, corner);
      if (!std::count(face.begin(), face.end(), a) || (b >= 0 && !std::count(face.begin(), face.end(), b)))
        continue;
      found.push_back(s.normal(face).normalized());
    }
  return found;
}

Point outwards(const Site& s, Index a, Index b = -1) {
  Point sum(0, 0, 0);
  for (const Point& n : normals_at(s, a, b)) sum += n;
  return sum.normalized();
}

bool at_vertex(Site& s, bool same_number) {
  const Index v =
      s.some_vertex([&](Index w) { return s.parts.on_boundary[static_cast<std::size_t>(w)] != 0; });
  if (v < 0) return false;
  const Point out = outwards(s, v);
  const double size = 0.4 * s.size(s.tets_at(v)[0]);
  Tet tet{same_number ? v : s.add(s.at(v)), -1, -1, -1};
  for (int k = 1; k < 4; ++k) tet[k] = s.add(s.at(v) + size * (out + 0.3 * s.direction()));
  if (s.sign(tet) == 0) return false;
  s.add_positive(tet);
  s.vertices.push_back(v);
  return true;
}

// A random edge a b of a random boundary face, and the tetrahedron t of the face.
bool some_boundary_edge(Site& s, Index& a, Index& b, Index& t) {
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const auto k = static_cast<std::size_t>(s.random.below(3));
  a = face[k], b = face[(k + 1) % 3];
  return true;
}

bool at_edge(Site& s, bool same_numbers) {
  Index a = -1, b = -1, t = -1;
  if (!some_boundary_edge(s, a, b, t)) return false;
  const Point out = outwards(s, a, b), along = (s.at(b) - s.at(a)).normalized(), aside = along.cross(out),
              middle = (s.at(a) + s.at(b)) / 2;
  const double size = 0.3 * s.size(t);
  const Index c = s.add(middle + size * (out + 0.15 * aside)),
              d = s.add(middle + size * (out - 0.15 * aside));
  const Tet tet = same_numbers ? Tet{a, b, c, d} : Tet{s.add(s.at(a)), s.add(s.at(b)), c, d};
  if (s.sign(tet) == 0) return false;
  s.add_positive(tet);
  s.vertices = {a, b};
  return true;
}

// Adds a tetrahedron outside, one of whose edges crosses the middle of a boundary edge.
bool edges_cross(Site& s) {
  Index a = -1, b = -1, t = -1;
  if (!some_boundary_edge(s, a, b, t)) return false;
  const auto normals = normals_at(s, a, b);
  if (normals.size() != 2) return false;
  // The new edge runs across the boundary edge and does not go below the faces beside it.
  const Point out = outwards(s, a, b), along = s.at(b) - s.at(a), middle = (s.at(a) + s.at(b)) / 2;
  Point across = out.cross(along).normalized() * 0.25 * s.size(t);
  for (int k = 0; k < 3; ++k) across[k] = static_cast<double>(static_cast<float>(across[k]));
  const Index c = s.add(middle + across), d = s.add(middle - across);
  const Point high = middle + 0.3 * s.size(t) * out;
  const Index e = s.add(high + 0.1 * along), f = s.add(high - 0.1 * along);
  if (s.sign({c, d, e, f}) == 0) return false;
  s.add_positive({c, d, e, f});
  s.vertices = {a, b};
  return true;
}

bool on_face(Site& s, bool same_numbers) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const Index apex = s.add(s.centroid(face) + 0.2 * s.size(t) * s.normal(face).normalized());
  Tet tet{face[0], face[1], face[2], apex};
  if (!same_numbers)
    for (int k = 0; k < 3; ++k) tet[k] = s.add(s.at(face[k]));
  if (s.sign(tet) <= 0) return false;
  s.add_positive(tet);
  return true;
}

// Adds a tetrahedron outside that has `corners` of its corners exactly inside a boundary face.
bool in_face(Site& s, int corners) {
  Index t = -1;
  int corner = 0;
  if (!s.some_boundary_face(t, corner)) return false;
  const Face face = s.face(t, corner);
  const Point out = s.normal(face).normalized();
  const double size = 0.3 * s.size(t);
  Tet tet;
  for (int k = 0; k < 4; ++k) {
    Point p = s.at(face[k % 3]) / 2 + s.at(face[(k + 1) % 3]) / 4 + s.at(face[(k + 2) % 3]) / 4;
    if (k >= corners) p = s.centroid(face) + size * (out + 0.3 * s.direction());
    if (k < corners && orientation(s.at(face[0]), s.at(face[1]), s.at(face[2]), p) != 0) return false;
    tet[k] = s.add(p);
  }
  if (s.sign(tet) == 0) return false;
  s.add_positive(tet);
  s.vertices.assign(face.begin(), face.end());
  return true;
}

bool copy_face_to_face(Site& s) {
  Point shift(0, 0, 0);
  const int axis = s.random.below(3);
  shift[axis] = s.parts.high[axis] - s.parts.low[axis];
  s.add_copy([&](const Point& p) -> Point { return p + shift; });
  return true;
}

// Adds a copy of the mesh on one of its sides. In the plane of this side it is moved by a part of its size,
// so that the faces do not match. The mesh must end in a plane on both sides.
bool copy_moved_along_side(Site& s) {
  const int axis = s.random.below(3);
  Point shift = (s.parts.high - s.parts.low) / 4;
  if (s.random.below(2)) shift[(axis + 1) % 3] *= -2;
  shift[axis] = s.parts.high[axis] - s.parts.low[axis];
  s.add_copy([&](const Point& p) -> Point {
    Point q = p + shift;
    if (p[axis] == s.parts.low[axis]) q[axis] = s.parts.high[axis];  // rounding may have put it beside
    return q;
  });
  return true;
}

// Adds a chain of two tetrahedra to a boundary vertex. They are connected at vertices only, as happens if
// components are merged too eagerly.
bool merged_vertices(Site& s) {
  const Index v =
      s.some_vertex([&](Index w) { return s.parts.on_boundary[static_cast<std::size_t>(w)] != 0; });
  if (v < 0) return false;
  const Point out = outwards(s, v);
  const double size = 0.5 * s.size(s.tets_at(v)[0]);
  const Tet one{v, s.add(s.at(v) + size * (out + 0.3 * s.direction())),
                s.add(s.at(v) + size * (out + 0.3 * s.direction())),
                s.add(s.at(v) + size * (out + 0.3 * s.direction()))};
  if (s.sign(one) == 0) return false;
  s.add_positive(one);
  const Point tip = s.mesh.points[static_cast<std::size_t>(one[1])];
  const Tet two{one[1], s.add(tip + size * (out + 0.2 * s.direction())),
                s.add(tip + size * (out + 0.2 * s.direction())),
                s.add(tip + size * (out + 0.2 * s.direction()))};
  if (s.sign(two) == 0) return false;
  s.add_positive(two);
  return true;
}

}  // namespace

std::vector<PlantKind> contact_kinds() {
  constexpr auto defective = Expected::defective, sound = Expected::sound, debatable = Expected::debatable;
  const std::vector<const char*> points{"duplicate-point"};
  return {
      {.id = "pinched-vertex",
       .expected = debatable,
       .flags = {"boundary"},
       .needed = {"boundary-nonmanifold-vertex"},
       .comment = "the boundary touches itself at a vertex, and both sides use the same point",
       .mutate = [](Site& s) { return at_vertex(s, true); }},
      {.id = "touching-vertex",
       .expected = defective,
       .flags = {"boundary", "points"},
       .needed = {"boundary-self-intersection"},
       .also = points,
       .comment = "the boundary touches itself at a vertex, and each side has its own point",
       .mutate = [](Site& s) { return at_vertex(s, false); }},
      {.id = "pinched-edge",
       .expected = debatable,
       .flags = {"boundary"},
       .needed = {"boundary-nonmanifold-edge"},
       .also = {"boundary-nonmanifold-vertex"},
       .comment = "the boundary touches itself along an edge, and both sides use the same points",
       .mutate = [](Site& s) { return at_edge(s, true); }},
      {.id = "touching-edge",
       .expected = defective,
       .flags = {"boundary", "points"},
       .needed = {"boundary-self-intersection"},
       .also = points,
       .comment = "the boundary touches itself along an edge, and each side has its own points",
       .mutate = [](Site& s) { return at_edge(s, false); }},
      {.id = "crossing-edges",
       .expected = defective,
       .flags = {"boundary"},
       .needed = {"boundary-self-intersection"},
       .also = {"near-contact"},
       .comment = "two edges of the boundary cross in a point",
       .mutate = edges_cross},
      {.id = "grown-face",
       .expected = sound,
       .flags = {"control", "boundary"},
       .comment = "an additional tetrahedron on a boundary face: nothing is wrong",
       .mutate = [](Site& s) { return on_face(s, true); }},
      {.id = "touching-face",
       .expected = defective,
       .flags = {"boundary", "cracks", "points"},
       .needed = {"crack"},
       .also = points,
       .comment = "the boundary touches itself at a face, and each side has its own points",
       .mutate = [](Site& s) { return on_face(s, false); }},
      {.id = "tip-on-face",
       .expected = defective,
       .flags = {"boundary"},
       .needed = {"boundary-self-intersection"},
       .comment = "a tetrahedron outside, whose tip lies exactly in a boundary face",
       .mutate = [](Site& s) { return in_face(s, 1); }},
      {.id = "edge-on-face",
       .expected = defective,
       .flags = {"boundary"},
       .needed = {"boundary-self-intersection"},
       .comment = "a tetrahedron outside, one of whose edges lies exactly in a boundary face",
       .mutate = [](Site& s) { return in_face(s, 2); }},
      {.id = "face-on-face",
       .expected = defective,
       .flags = {"boundary"},
       .needed = {"non-conforming-interface"},
       .comment = "a tetrahedron outside, one of whose faces lies exactly in a larger boundary face",
       .mutate = [](Site& s) { return in_face(s, 3); }},
      {.id = "blocks-face-to-face",
       .expected = defective,
       .flags = {"boundary", "whole", "points"},
       .needed = {"crack", "boundary-self-intersection"},
       .also = {"crack", "boundary-self-intersection", "duplicate-point", "near-contact", "overlap",
                "hanging-node", "crossed-diagonal"},
       .comment = "a second copy of the mesh that touches it, with its own points",
       .mutate = copy_face_to_face},
      {.id = "blocks-side-by-side",
       .expected = defective,
       .flags = {"boundary", "whole", "points"},
       .needed = {"non-conforming-interface"},
       .comment = "a second copy of the mesh that touches it along faces that do not match",
       .mutate = copy_moved_along_side},
      {.id = "pinched-chain",
       .expected = debatable,
       .flags = {"boundary"},
       .needed = {"boundary-nonmanifold-vertex"},
       .comment = "a chain of tetrahedra that are connected only at vertices",
       .mutate = merged_vertices},
  };
}

}  // namespace tetproof::corpus
