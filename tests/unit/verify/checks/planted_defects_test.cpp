// SPDX-License-Identifier: GPL-3.0-or-later
// Every check: a defect planted in a sound mesh gives that finding, with its elements, and no other; the
// sound mesh gives none.
#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/meshes.hpp"
#include "verify/triangles/intersections.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

using verify::Check;
using verify::Report;
using verify::Verdict;
using Ids = std::vector<std::string>;

// Ids of the checks that have findings of their own.
Ids roots(const Report& report) {
  Ids ids;
  for (const auto& result : report.checks)
    if (result.count > 0) ids.push_back(info(result.check).id);
  return ids;
}

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

// The base mesh: 3 x 3 x 3 cells, 64 points of which 8 are inside; point (i,j,k) is number 16 i + 4 j + k.
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
       {0},
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
  for (auto& tet : mesh.tets) std::swap(tet[2], tet[3]);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::inverted].count, 384);
  EXPECT_EQ(report[Check::inverted].findings.size(), 100u);
}

TEST(PlantedDefects, ConsequencesStandUnderTheirRoot) {
  TetMesh mesh = lattice_mesh({3, 3, 3});
  std::swap(mesh.tets[80][0],
            mesh.tets[80][1]);  // inside: all four faces now have both tetrahedra on one side
  const Report report = verify::verify(mesh);
  ASSERT_EQ(report[Check::inverted].count, 1);
  const auto& consequences = report[Check::inverted].findings[0].consequences;
  ASSERT_EQ(consequences.size(), 1u);
  EXPECT_EQ(consequences[0].check, Check::face_orientation);
  EXPECT_EQ(consequences[0].count, 4);
  EXPECT_EQ(report[Check::face_orientation].count, 0);
  EXPECT_EQ(report[Check::face_orientation].consequences, 4);
  EXPECT_EQ(report[Check::face_orientation].verdict, Verdict::fail);
}

// What only touches a broken tetrahedron in a vertex does not follow from it.
TEST(PlantedDefects, TwoThatShareAVertexStandSideBySide) {
  const TetMesh sound = lattice_mesh({4, 4, 4});
  const auto at = std::find(sound.points.begin(), sound.points.end(), Eigen::Vector3d(2, 2, 2));
  const auto v = static_cast<Index>(at - sound.points.begin());
  std::vector<Index> around;
  for (std::size_t t = 0; t < sound.tets.size(); ++t)
    if (std::count(sound.tets[t].begin(), sound.tets[t].end(), v)) around.push_back(static_cast<Index>(t));
  const auto& wrong = sound.tets[around[0]];
  const auto other = std::find_if(around.begin(), around.end(), [&](Index t) {
    return std::count_if(sound.tets[t].begin(), sound.tets[t].end(),
                         [&](Index w) { return std::count(wrong.begin(), wrong.end(), w); }) == 1;
  });
  ASSERT_NE(other, around.end());
  TetMesh turned = sound;
  std::swap(turned.tets[around[0]][0], turned.tets[around[0]][1]);

  TetMesh missing = turned;
  missing.tets.erase(missing.tets.begin() + *other);
  EXPECT_EQ(roots(verify::verify(missing)), (Ids{"inverted", "cavity"}));

  // A small one of its own inside that tetrahedron, from the common vertex.
  TetMesh foreign = turned;
  std::array<Index, 4> small = sound.tets[*other];
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Index w : small) centre += sound.points[w] / 4;
  for (Index& w : small) {
    if (w == v) continue;
    foreign.points.push_back(sound.points[w] / 4 + sound.points[v] / 4 + centre / 2);
    w = static_cast<Index>(foreign.points.size() - 1);
  }
  foreign.tets.push_back(small);
  EXPECT_EQ(roots(verify::verify(foreign)), (Ids{"inverted", "overlap"}));
}

// The boundary with one face wound the wrong way encloses nothing that could be a cavity, wherever it lies.
TEST(PlantedDefects, AnInvertedTetrahedronAtTheBoundaryMakesNoCavity) {
  for (const double shift : {0.0, 1e6, -1e6}) {
    TetMesh mesh = lattice_mesh({3, 3, 3}, {}, Eigen::Vector3d::Constant(shift));
    std::swap(mesh.tets[0][0], mesh.tets[0][1]);
    const Report report = verify::verify(mesh);
    EXPECT_EQ(roots(report), Ids{"inverted"});
    EXPECT_EQ(report[Check::cavity].consequences, 0) << report_text(report);
  }
}

// A negative winding number at a face: the place is covered by a tetrahedron wound the wrong way, far as it
// may be from the face.
TEST(PlantedDefects, ANegativeCoveringFollowsFromAnInvertedTetrahedron) {
  // A block with a hole in it, and in the hole, sharing nothing, a turned tetrahedron around a smaller good
  // one.
  TetMesh mesh = lattice_mesh({5, 5, 5}, [](Cell c) { return c != Cell{2, 2, 2}; });
  const auto add = [&](double size, bool turned) {
    const auto first = static_cast<Index>(mesh.points.size());
    const Eigen::Vector3d corner = Eigen::Vector3d::Constant(2.5 - size / 4);
    mesh.points.push_back(corner);
    for (int k = 0; k < 3; ++k) mesh.points.push_back(corner + size * Eigen::Vector3d::Unit(k));
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
    if (turned) std::swap(mesh.tets.back()[0], mesh.tets.back()[1]);
  };
  add(0.3, true);
  add(0.1, false);
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report[Check::inverted].count, 1);
  EXPECT_EQ(report[Check::overlap].count, 0) << report_text(report);
  EXPECT_GT(report[Check::overlap].consequences, 0) << report_text(report);
}

TEST(PlantedDefects, TwoOnOneSideOfAFace) {
  // Two positive tetrahedra with the same apex side: their common face is induced twice in the same
  // direction.
  TetMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, 0.2, 0.5}}, {{0, 1, 2, 3}, {0, 1, 2, 4}}};
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"face-orientation"});
  EXPECT_EQ(report[Check::face_orientation].findings[0].tets, (std::vector<Index>{0, 1}));
  EXPECT_EQ(report.certificate, false);
}

TEST(PlantedDefects, NonManifoldEdgeAndVertex) {
  // Two cells that share an edge, or a vertex, and nothing else.
  const auto edge = lattice_mesh({2, 2, 1}, [](Cell c) { return c[0] == c[1]; });
  const Report at_edge = verify::verify(edge);
  EXPECT_EQ(roots(at_edge), Ids{"boundary-nonmanifold-edge"});
  EXPECT_EQ(at_edge[Check::boundary_nonmanifold_edge].verdict, Verdict::warning);
  EXPECT_EQ(at_edge[Check::boundary_nonmanifold_edge].count, 1);
  EXPECT_EQ(at_edge[Check::boundary_nonmanifold_edge].findings[0].faces.size(), 4u);
  EXPECT_EQ(at_edge.certificate, true);
  EXPECT_EQ(at_edge.mesh.components, 2);
  EXPECT_EQ(at_edge.mesh.genus, 0);

  const auto vertex = lattice_mesh({2, 2, 2}, [](Cell c) { return c[0] == c[1] && c[1] == c[2]; });
  const Report at_vertex = verify::verify(vertex);
  EXPECT_EQ(roots(at_vertex), Ids{"boundary-nonmanifold-vertex"});
  EXPECT_EQ(at_vertex[Check::boundary_nonmanifold_vertex].findings[0].vertices,
            (std::vector<Index>{point_at(vertex, {1, 1, 1})}));
  EXPECT_EQ(at_vertex.certificate, true);
  EXPECT_EQ(at_vertex.mesh.components, 2);

  for (const TetMesh& mesh : {edge, vertex}) {
    const Report strict = verify::verify(mesh, {.strict_topology = true});
    EXPECT_FALSE(sound(strict));
    EXPECT_EQ(strict.certificate, true) << "a warning about topology says nothing against the triangulation";
  }
}

TEST(PlantedDefects, OneMaterialAroundANonManifoldEdge) {
  // Four cells around an edge less two opposite ones, joined by a bridge above: one component that touches
  // itself in an edge.
  const auto mesh = lattice_mesh({2, 2, 2}, [](Cell c) { return c[2] == 1 || c[0] == c[1]; });
  const Report report = verify::verify(mesh);
  EXPECT_EQ(roots(report), Ids{"boundary-nonmanifold-edge"});
  EXPECT_EQ(report.mesh.components, 1);
  EXPECT_EQ(report.mesh.genus, 0) << "cut apart at the edge it is a ball";
  EXPECT_EQ(report.certificate, true);
}

TEST(PlantedDefects, GenusAndCavities) {
  struct Shape {
    std::string name;
    std::function<bool(Cell)> keep;
    std::int64_t components, cavities, genus;
  };
  const std::vector<Shape> shapes{
      {"block", {}, 1, 0, 0},
      {"ring", [](Cell c) { return !(c[0] == 1 && c[1] == 1); }, 1, 0, 1},
      {"two holes crossing", [](Cell c) { return !((c[0] == 1 && c[1] == 1) || (c[1] == 1 && c[2] == 1)); },
       1, 0, 3},
      {"all three holes", [](Cell c) { return (c[0] == 1) + (c[1] == 1) + (c[2] == 1) < 2; }, 1, 0, 5},
      {"cavity", [](Cell c) { return !(c[0] == 1 && c[1] == 1 && c[2] == 1); }, 2, 1, 0},
      {"two blocks", [](Cell c) { return c[0] != 1; }, 2, 0, 0},
  };
  for (const Shape& s : shapes) {
    SCOPED_TRACE(s.name);
    const Report report = verify::verify(lattice_mesh({3, 3, 3}, s.keep));
    EXPECT_EQ(report.mesh.components, s.components);
    EXPECT_EQ(report.mesh.cavities, s.cavities);
    EXPECT_EQ(report.mesh.genus, s.genus);
    EXPECT_EQ(report.certificate, true);
  }
}

TEST(PlantedDefects, OneUnitInTheLastPlace) {
  // The apex of the first tetrahedron just above, in, and just below the plane of its base, whatever the
  // scale and place.
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
  // Around an inner point lie tetrahedra whose far faces are in the plane x = 2 cells: up to it, in it, and
  // beyond.
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

TEST(PlantedDefects, NothingOfItCrashes) {
  // Every tetrahedron unusable, in every way at once.
  TetMesh mesh = lattice_mesh({2, 2, 2});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (t % 3 == 0) mesh.tets[t] = {-5, 1000, 3, 3};
    if (t % 3 == 1) mesh.tets[t][0] = mesh.tets[t][1];
  }
  for (std::size_t i = 0; i < mesh.points.size(); i += 2) mesh.points[i].z() = std::nan("");
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.certificate, false);
  EXPECT_FALSE(report_json(report).empty());
  EXPECT_EQ(verify::verify(TetMesh{}).mesh.tets, 0);
  EXPECT_EQ(verify::verify(TetMesh{{}, {{0, 1, 2, 3}}})[Check::index_range].count, 1);
}

// Random numbers: quadratically many faces meet. The search ends, says so, and says the same on any number of
// threads; asked for overlaps alone it has no less to say.
TEST(PlantedDefects, ManyThousandRandomTetrahedra) {
  TetMesh mesh = lattice_mesh({8, 8, 8});
  std::mt19937 random(3);
  const auto points = static_cast<Index>(mesh.points.size());
  for (auto& tet : mesh.tets)
    for (Index& v : tet) v = static_cast<Index>(random() % static_cast<unsigned>(points));
  const Report report = verify::verify(mesh);
  EXPECT_EQ(report.certificate, false);
  const auto& meeting = report[Check::boundary_self_intersection];
  EXPECT_EQ(meeting.count + meeting.consequences, verify::most_counted_pairs);
  EXPECT_EQ(report[Check::hanging_node].verdict, Verdict::skipped);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_NE(report.notes[0].find("more than 1000000 pairs of boundary faces meet"), std::string::npos);
  const Report alone = verify::verify(mesh, {.check = {"overlap"}});
  EXPECT_EQ(alone[Check::overlap].verdict, Verdict::fail);
  ASSERT_FALSE(alone[Check::overlap].findings.empty());
  EXPECT_TRUE(alone[Check::overlap].findings[0].point);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(report_json(verify::verify(mesh)), report_json(report));
}

TEST(PlantedDefects, SkippedChecksLeaveTheCertificateOpen) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  EXPECT_EQ(verify::verify(mesh, {.skip = {"overlap"}}).certificate, std::nullopt);
  EXPECT_EQ(verify::verify(mesh, {.skip = {"unused-point"}}).certificate, true);
  const Report some = verify::verify(mesh, {.check = {"inverted", "flat"}});
  EXPECT_EQ(some.certificate, std::nullopt);
  EXPECT_EQ(some[Check::inverted].verdict, Verdict::pass);
  EXPECT_EQ(some[Check::duplicate_tet].verdict, Verdict::skipped);
  TetMesh bad = mesh;
  std::swap(bad.tets[0][0], bad.tets[0][1]);
  EXPECT_EQ(verify::verify(bad, {.skip = {"overlap"}}).certificate, false) << "one failure suffices";
  EXPECT_THROW(verify::verify(mesh, {.check = {"no-such-check"}}), std::runtime_error);
}

}  // namespace
}  // namespace tetproof::test
