// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of random surfaces with twisted or sharp sides: prisms, blades, clustered edges, a tube along a knot.
#include <Eigen/Geometry>
#include <cmath>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz/polygon.hpp"
#include "corpus/fuzz/revolved.hpp"
#include "corpus/generators/turns.hpp"

namespace tetproof::corpus {
namespace {

// Storeys of a regular n-gon, each turned against the one below by t turns. Its quadrilaterals are cut by the
// diagonal from corner i below to i + 1 above. At each height between two storeys the section has 2n corners
// in the order of their angles, and each of its sides is parallel to a side of one of the polygons. Each side
// is passed anticlockwise, seen from the axis, if |t + 1 / (2n)| < 1/4: the section is star-shaped.
Shape twisted(int n, int m, double s, double h) {
  const double t = s / 4 - 1.0 / (2 * n);
  std::vector<Ring> rings;
  for (int k = 0; k <= m; ++k) rings.push_back({1, h * k, t * k});
  return one_body(revolved(rings, n, {}, {}));
}

Shape twist(const Numbers& values) {
  return twisted(values.integer("n"), values.integer("m"), values["s"], values["h"]);
}

Shape schoenhardt(const Numbers& values) {
  return twisted(values.integer("n"), 1, 1 - values["e"], values["h"]);
}

// A star of n blades: its outline is star-shaped.
Shape wedge(const Numbers& values) {
  const int n = values.integer("n");
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < 2 * n; ++i) {
    const CosSin at = cos_sin_turns(static_cast<double>(i) / (2 * n));
    const double radius = i % 2 == 0 ? 1 : values["e"];
    outline.emplace_back(radius * at.cos, radius * at.sin);
  }
  return one_body(prism(outline, values["h"]));
}

// The corners have ascending angles around the axis, which the caps' fans have as their tips.
Shape cluster_edges(const Numbers& values) {
  const int k = values.integer("k"), n = values.integer("n");
  const double h = values["h"], e = values["e"] / n;
  TriangleSurface surface;
  for (const double z : {0.0, h})
    for (int i = 0; i < k * n; ++i) {
      const CosSin at = cos_sin_turns((i / n + e * (i % n)) / k);
      surface.vertices.emplace_back(at.cos, at.sin, z);
    }
  const Index sides = k * n, below = 2 * sides, above = below + 1;
  surface.vertices.emplace_back(0, 0, 0);
  surface.vertices.emplace_back(0, 0, h);
  for (Index i = 0; i < sides; ++i) {
    const Index next = (i + 1) % sides;
    surface.triangles.push_back({i, next, sides + next});
    surface.triangles.push_back({i, sides + next, sides + i});
    surface.triangles.push_back({below, next, i});
    surface.triangles.push_back({above, sides + i, sides + next});
  }
  return one_body(std::move(surface));
}

// A tube of radius r along the (2, q) torus knot on the torus of radii 1 and 0.45. Strands of the knot come
// no nearer to each other than the tube's diameter by far, in the ranges below; the judge proves it of each.
Shape knot(const Numbers& values) {
  const int q = 2 * values.integer("q") + 1, n = values.integer("n") * q, m = values.integer("m");
  const double a = 0.45, r = values["r"];
  TriangleSurface surface;
  for (int i = 0; i < n; ++i) {
    const CosSin u = cos_sin_turns(2.0 * i / n), v = cos_sin_turns(static_cast<double>(q) * i / n);
    const Eigen::Vector3d out(v.cos * u.cos, v.cos * u.sin, v.sin);  // normal of the torus
    const Eigen::Vector3d centre(u.cos + a * out[0], u.sin + a * out[1], a * out[2]);
    const double ring = 1 + a * v.cos;
    const Eigen::Vector3d along(-2 * ring * u.sin - q * a * v.sin * u.cos,
                                2 * ring * u.cos - q * a * v.sin * u.sin, q * a * v.cos);
    Eigen::Vector3d beside = along.cross(out);
    beside /= std::sqrt(beside[0] * beside[0] + beside[1] * beside[1] + beside[2] * beside[2]);
    for (int j = 0; j < m; ++j) {
      const CosSin w = cos_sin_turns(static_cast<double>(j) / m);
      surface.vertices.push_back(centre + r * w.cos * out + r * w.sin * beside);
    }
  }
  // out x beside points along the knot.
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j) {
      const Index p = i * m + j, next = i * m + (j + 1) % m, ahead = (i + 1) % n * m + j,
                  both = (i + 1) % n * m + (j + 1) % m;
      surface.triangles.push_back({p, next, both});
      surface.triangles.push_back({p, both, ahead});
    }
  return one_body(std::move(surface), 1);
}

FuzzParameter height() {
  return {"h", Draw::length, 1e-6, 1e4, 1e-2, 10, 1, "height, of a storey"};
}

}  // namespace

std::vector<FuzzKind> twisted_kinds() {
  return {
      {"twist",
       "storeys of a regular polygon, each turned against the one below",
       "skew and nearly flat sides; some have no mesh without points inside",
       {{"n", Draw::integer, 3, 200, 3, 8, 3, "sides"},
        {"m", Draw::integer, 1, 200, 1, 6, 1, "storeys"},
        {"s", Draw::share, -0.999, 0.999, -0.99, 0.99, 0, "at -1 and 1 the sides meet in the axis"},
        height()},
       twist},
      {"schoenhardt",
       "a twisted prism of one storey whose sides nearly meet in the axis; n = 3: Schoenhardt's polyhedron",
       "has no mesh without points inside; edges a hair apart",
       {{"n", Draw::integer, 3, 200, 3, 6, 3, "sides"},
        {"e", Draw::length, 1e-9, 1, 1e-7, 0.5, 0.5, "how far from the axis, about"},
        height()},
       schoenhardt},
      {"wedge",
       "a prism over a star of n blades",
       "sharp dihedral angles",
       {{"n", Draw::integer, 2, 500, 2, 20, 2, "blades"},
        {"e", Draw::length, 1e-9, 1, 1e-7, 0.5, 0.5, "radius between the blades; their tips have 1"},
        height()},
       wedge},
      {"cluster-edges",
       "a prism whose k edges are clusters of n edges each",
       "parallel edges a hair apart, needles",
       {{"k", Draw::integer, 3, 200, 3, 6, 3, "clusters"},
        {"n", Draw::integer, 1, 200, 2, 8, 1, "edges of a cluster"},
        {"e", Draw::length, 1e-11, 0.9, 1e-10, 0.5, 0.5, "width of a cluster, of the way to the next one"},
        height()},
       cluster_edges},
      {"knot",
       "a tube along a torus knot that winds twice around the axis",
       "a handle that is knotted, strands side by side",
       {{"q", Draw::integer, 1, 3, 1, 2, 1, "the knot is (2, 2q + 1); 1: the trefoil"},
        {"n", Draw::integer, 8, 100, 8, 14, 8,
         "sections of the tube for each winding around the tube of the torus"},
        {"m", Draw::integer, 3, 50, 3, 6, 3, "corners of a section"},
        {"r", Draw::share, 1e-3, 0.11, 0.01, 0.1, 0.05, "radius of the tube"}},
       knot},
  };
}

}  // namespace tetproof::corpus
