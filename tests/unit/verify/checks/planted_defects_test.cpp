// SPDX-License-Identifier: GPL-3.0-or-later
// Plants a defect into a sound mesh: the report has the expected finding, with its elements, and no other
// one. The sound mesh has none. Signs of nearly flat tetrahedra are exact.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/meshes.hpp"
#include "tests/support/root_checks.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;

struct Case {
  std::string name;
  std::function<void(TetMesh&)> plant;
  Ids roots;                // in the order of the list of checks
  std::vector<Index> tets;  // of the first finding of the first root
  std::vector<Index> vertices;
  bool sound = false;
  bool certificate = false;
};

constexpr Index last_tet = 3 * 3 * 3 * 6 - 1;

// The sound mesh has 3 x 3 x 3 cells and 64 points, of which 8 are inside. Point (i,j,k) has the number 16 i
// + 4 j + k.
constexpr Index inner = 21;  // (1,1,1)

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"sound", [](TetMesh&) {}, {}, {}, {}, true, true},
      {"index beyond the points", [](TetMesh& m) { m.tets[7][2] = 64; }, {"index-range"}, {7}, {64}},
      {"negative index", [](TetMesh& m) { m.tets[7][2] = -1; }, {"index-range"}, {7}, {-1}},
      {"huge index",
       [](TetMesh& m) { m.tets[80][0] = std::numeric_limits<Index>::max(); },
       {"index-range"},
       {80},
       {std::numeric_limits<Index>::max()}},
      {"NaN at an inner point",
       [](TetMesh& m) { m.points[inner].y() = std::nan(""); },
       {"finite-coordinates"},
       {},
       {inner}},
      {"infinity at a corner",
       [](TetMesh& m) { m.points[63].x() = -INFINITY; },
       {"finite-coordinates"},
       {},
       {63}},
      {"vertex named twice",
       [](TetMesh& m) { m.tets[100][3] = m.tets[100][0]; },
       {"repeated-vertex"},
       {100},
       {}},
      {"vertex named four times",
       [](TetMesh& m) {
         m.tets.push_back({5, 5, 5, 5});
       },
       {"repeated-vertex"},
       {last_tet + 1},
       {5}},
      {"point twice, the second unused",
       [](TetMesh& m) { m.points.push_back(m.points[3]); },
       {"duplicate-point", "unused-point"},
       {},
       {3, 64},
       true,
       true},
      {"minus zero equals zero",
       [](TetMesh& m) {
         m.points.push_back({-0.0, 0, 3});
       },
       {"duplicate-point", "unused-point"},
       {},
       {3, 64},
       true,
       true},
      {"unused point",
       [](TetMesh& m) {
         m.points.push_back({7, 7, 7});
       },
       {"unused-point"},
       {},
       {64},
       true,
       true},
      {"NaN at an unused point",
       [](TetMesh& m) {
         m.points.push_back({7, std::nan(""), 7});
       },
       {"unused-point"},
       {},
       {64},
       true,
       true},
      {"tetrahedron twice",
       [](TetMesh& m) { m.tets.push_back(m.tets[50]); },
       {"duplicate-tet"},
       {50, last_tet + 1},
       {}},
      {"tetrahedron twice, turned",
       [](TetMesh& m) {
         auto [a, b, c, d] = m.tets[50];
         m.tets.push_back({b, c, a, d});
       },
       {"duplicate-tet"},
       {50, last_tet + 1},
       {}},
      {"tetrahedron twice, mirrored",
       [](TetMesh& m) {
         auto [a, b, c, d] = m.tets[50];
         m.tets.push_back({b, a, c, d});
       },
       {"duplicate-tet"},
       {50, last_tet + 1},
       {}},
      {"tetrahedron three times",
       [](TetMesh& m) { m.tets.push_back(m.tets[0]), m.tets.push_back(m.tets[0]); },
       {"duplicate-tet"},
       {0, last_tet + 1, last_tet + 2},
       {}},
      {"inner tetrahedron wound the other way",
       [](TetMesh& m) { std::swap(m.tets[80][0], m.tets[80][1]); },
       {"inverted"},
       {80},
       {}},
      {"boundary tetrahedron wound the other way",
       [](TetMesh& m) { std::swap(m.tets[0][0], m.tets[0][1]); },
       {"inverted"},
       {0},
       {}},
      {"all wound the other way",
       [](TetMesh& m) {
         for (auto& t : m.tets) std::swap(t[0], t[1]);
       },
       {"inverted"},
       {},  // of all of them: see whole_mesh_test.cpp
       {}},
      {"inner point pushed through a face",
       [](TetMesh& m) {
         m.points[inner] = {2.2, 1.1, 1.15};
       },
       {"inverted"},
       {},
       {}},
      {"inner point in the plane of a face",
       [](TetMesh& m) {
         m.points[inner] = {2, 1, 1};
       },
       {"duplicate-point", "flat"},
       {},
       {21, 37}},
      {"foreign tetrahedron on an inner face",
       [](TetMesh& m) {
         const auto [a, b, c, d] = m.tets[80];
         m.points.push_back((m.points[a] + m.points[b] + m.points[c] + m.points[d]) / 4);
         m.tets.push_back({64, b, c, d});
       },
       {"face-shared-thrice"},
       {},
       {}},
      {"missing inner tetrahedron",
       [](TetMesh& m) { m.tets.erase(m.tets.begin() + 13 * 6); },
       {"cavity"},
       {},
       {},
       true,
       true},
      {"missing boundary tetrahedron",
       [](TetMesh& m) { m.tets.erase(m.tets.begin()); },
       {},
       {},
       {},
       true,
       true},
  };
  return all;
}

TEST(PlantedDefects, AreFoundAndNothingElse) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    TetMesh mesh = lattice_mesh({3, 3, 3});
    ASSERT_EQ(mesh.points[inner], Eigen::Vector3d(1, 1, 1));
    c.plant(mesh);
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), c.roots) << report_text(report);
    EXPECT_EQ(sound(report), c.sound);
    EXPECT_EQ(report.certificate, c.certificate);
    if (c.roots.empty()) continue;
    const auto& findings = report[verify::check_of_id(c.roots[0])].findings;
    ASSERT_FALSE(findings.empty());
    if (!c.tets.empty()) {
      EXPECT_EQ(findings[0].tets, c.tets);
    }
    if (!c.vertices.empty()) {
      EXPECT_EQ(findings[0].vertices, c.vertices);
    }
    EXPECT_FALSE(findings[0].what.empty());
  }
}

TEST(PlantedDefects, CountsAreFull) {
  TetMesh mesh = lattice_mesh({4, 4, 4});
  for (std::size_t t = 0; t < 300; ++t) std::swap(mesh.tets[t][2], mesh.tets[t][3]);  // of 384
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::inverted].count, 300);
  EXPECT_EQ(report[Check::inverted].findings.size(), 100u);
}

TEST(PlantedDefects, TwoOnOneSideOfAFace) {
  // Two positive tetrahedra lie on the same side of their common face, so both induce the same direction on
  // it.
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.5}}, {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"face-orientation"});
  EXPECT_EQ(report[Check::face_orientation].findings[0].tets, (std::vector<Index>{0, 1}));
  EXPECT_EQ(report.certificate, false);
}

TEST(PlantedDefects, OneUnitInTheLastPlace) {
  // The apex of the tetrahedron is just above the plane of its base, in it, or just below it, at every scale
  // and place.
  struct Place {
    double scale, shift;
  };
  for (const Place& p : {Place{1, 0}, {1e-9, 0}, {1e-9, 1}, {1, 1e6}, {1e6, 0}, {1e150, 0}, {1e-150, 0}}) {
    SCOPED_TRACE(testing::Message() << p.scale << " at " << p.shift);
    const double a = p.shift, b = p.shift + p.scale;
    for (const int direction : {-1, 0, 1}) {
      const double z = direction == 0 ? a : std::nextafter(a, direction * INFINITY);
      const TetMesh mesh{{{a, a, a}, {b, a, a}, {a, b, a}, {a, a, z}}, {{0, 1, 2, 3}}};
      if (direction == 0) {
        EXPECT_EQ(verify::verify(mesh)[Check::flat].count, 1);
      } else {
        EXPECT_EQ(verify::verify(mesh)[Check::inverted].count, direction < 0);
        EXPECT_EQ(verify::verify(mesh)[Check::flat].count, 0);
      }
    }
  }
}

TEST(PlantedDefects, PushedThroughByOneUnitInTheLastPlace) {
  // The tetrahedra around an inner point have far faces in the plane x = 2. The point moves up to this plane,
  // into it, and beyond it.
  for (const double shift : {0.0, 1e6}) {
    SCOPED_TRACE(shift);
    TetMesh mesh = lattice_mesh({3, 3, 3}, {}, {shift, shift, shift});
    const double x = shift + 2;
    mesh.points[inner] = {std::nextafter(x, -INFINITY), shift + 1.5, shift + 1.25};
    EXPECT_EQ(verify::verify(mesh).certificate, true);
    mesh.points[inner].x() = x;
    const Report in = verify::verify(mesh);
    EXPECT_EQ(roots(in), Ids{"flat"});
    mesh.points[inner].x() = std::nextafter(x, INFINITY);
    const Report beyond = verify::verify(mesh);
    EXPECT_EQ(roots(beyond), Ids{"inverted"});
    EXPECT_EQ(beyond[Check::inverted].count, in[Check::flat].count);
    EXPECT_EQ(beyond.certificate, false);
  }
}

}  // namespace
}  // namespace tetproof::test
