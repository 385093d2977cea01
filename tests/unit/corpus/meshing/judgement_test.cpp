// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on what a mesher wrote: passes, tolerances, deadline.
#include "corpus/meshing/judgement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/meshes.hpp"

namespace tetproof::corpus {
namespace {

class FakeMesher : public Mesher {
 public:
  explicit FakeMesher(double fidelity = 0) : fidelity_(fidelity) {}
  MesherRun run(const TriangleSurface&, const std::string&, const Limits&) const override { return {}; }
  std::string name() const override { return "fake"; }
  std::string command() const override { return "fake"; }
  std::string version() const override { return ""; }
  std::string surface_ending() const override { return ""; }
  bool may_change_boundary() const override { return fidelity_ > 0; }
  double fidelity() const override { return fidelity_; }
  int repeats() const override { return 1; }

 private:
  double fidelity_;
};

// A block of 3 x 3 x 3 cells, with or without its middle one.
TetMesh block(bool cavity = false, const Eigen::Vector3d& origin = {0, 0, 0}) {
  return test::lattice_mesh(
      {3, 3, 3},
      [=](test::Cell c) {
        return !cavity || c != test::Cell{1, 1, 1};
      },
      origin);
}

Judgement judge(const TetMesh& mesh, const TriangleSurface& surface, const JudgeOptions& options = {},
                int digits = 0, double fidelity = 0) {
  const verify::JudgedSurface judged(surface);
  return judge_run({.mesh = mesh, .digits = digits}, FakeMesher(fidelity), judged, options);
}

void expect(const Judgement& judgement, Outcome outcome, const std::string& signature) {
  EXPECT_EQ(judgement.outcome, outcome) << judgement.what;
  EXPECT_EQ(judgement.signature, signature) << judgement.what;
}

// The block with a vertex of its top side moved upwards.
TetMesh raised(double by, const Eigen::Vector3d& origin = {0, 0, 0}) {
  TetMesh mesh = block(false, origin);
  const Index v = test::point_at(mesh, origin + Eigen::Vector3d(1, 1, 3));
  mesh.points[static_cast<std::size_t>(v)].z() += by;
  return mesh;
}

TEST(JudgeRun, CallsAMeshOfTheSurfaceSound) {
  expect(judge(block(), test::boundary_surface(block())), Outcome::sound, "");
  expect(judge(block(true), test::boundary_surface(block(true))), Outcome::sound, "");
}

TEST(JudgeRun, GivesThePassedFailureBack) {
  const TriangleSurface surface = test::boundary_surface(block());
  const verify::JudgedSurface judged(surface);
  const Judgement judgement = judge_run(
      {.failure = Outcome::crashed, .signature = "SIGSEGV in f", .message = "f: oh"}, FakeMesher(), judged);
  expect(judgement, Outcome::crashed, "SIGSEGV in f");
  EXPECT_EQ(judgement.what, "f: oh");
  EXPECT_FALSE(judgement.report);
}

TEST(JudgeRun, NamesTheRootCheckOfADefect) {
  TetMesh inverted = block();
  std::swap(inverted.tets[7][0], inverted.tets[7][1]);
  expect(judge(inverted, test::boundary_surface(block())), Outcome::wrong, "inverted");
}

TEST(JudgeRun, NamesTheRegionThatIsMissingOrInExcess) {
  expect(judge(block(), test::boundary_surface(block(true))), Outcome::wrong_against_surface,
         "excess-region");
  const TetMesh without_corner = test::lattice_mesh({3, 3, 3}, [](test::Cell c) {
    return c != test::Cell{0, 0, 0};
  });
  expect(judge(without_corner, test::boundary_surface(block())), Outcome::wrong_against_surface,
         "missing-region");
}

TEST(JudgeRun, TakesACavityThatTheSurfaceDoesNotHaveForAFault) {
  expect(judge(block(true), test::boundary_surface(block())), Outcome::wrong_against_surface, "cavity");
}

// A boundary that moved by a millionth is found, by 1e-12 is rounding.
TEST(JudgeRun, AllowsRoundingOnly) {
  const TriangleSurface surface = test::boundary_surface(block());
  expect(judge(raised(1e-6), surface), Outcome::wrong_against_surface, "off-surface-vertex");
  expect(judge(raised(1e-12), surface), Outcome::sound, "");
}

// Far from the origin doubles are coarse: there, eight units in the last place are allowed.
TEST(JudgeRun, AllowsEightUnitsInTheLastPlace) {
  const Eigen::Vector3d far(1e12, 0, 0);
  const double ulp = std::nextafter(1e12 + 3, 2e12) - (1e12 + 3);  // 1.2e-4
  const auto moved = [&](double units) {
    TetMesh mesh = block(false, far);
    const Index v = test::point_at(mesh, far + Eigen::Vector3d(3, 1, 1));
    mesh.points[static_cast<std::size_t>(v)].x() += units * ulp;
    return mesh;
  };
  const TriangleSurface surface = test::boundary_surface(block(false, far));
  expect(judge(moved(4), surface), Outcome::sound, "");
  expect(judge(moved(40), surface), Outcome::wrong_against_surface, "off-surface-vertex");
}

// A file with six digits moves a coordinate of 3 by up to 5e-6: that is its rounding, and said as such.
TEST(JudgeRun, AllowsTheRoundingOfTextWithFewDigits) {
  const TriangleSurface surface = test::boundary_surface(block());
  expect(judge(raised(4e-6), surface, {}, 6), Outcome::sound, "");
  EXPECT_NEAR(judge(raised(4e-6), surface, {}, 6).allowed, 5e-6, 1e-8);
  expect(judge(raised(2e-5), surface, {}, 6), Outcome::wrong_against_surface, "off-surface-vertex");
}

// An STL file has floats: what the mesher got is the surface, and may be none any more.
TEST(JudgeRun, ComparesWithTheSurfaceAsItsFileRoundedIt) {
  const Eigen::Vector3d place(0.1, 1000.7, 0);
  const auto in_floats = [](std::vector<Eigen::Vector3d> points) {
    for (Eigen::Vector3d& p : points) p = p.cast<float>().cast<double>();
    return points;
  };
  const TriangleSurface surface = test::boundary_surface(block(false, place));
  auto rounded = std::make_shared<TriangleSurface>(surface);
  rounded->vertices = in_floats(surface.vertices);
  TetMesh mesh = block(false, place);
  mesh.points = in_floats(mesh.points);
  expect(judge(mesh, surface), Outcome::wrong_against_surface, "bounding-box");  // all of it is moved
  const verify::JudgedSurface judged(surface);
  expect(judge_run({.mesh = mesh, .given = rounded}, FakeMesher(), judged), Outcome::sound, "");

  rounded->vertices[0] = rounded->vertices[1];
  const Judgement refused =
      judge_run({.failure = Outcome::refused_valid, .signature = "self-intersection", .given = rounded},
                FakeMesher(), judged);
  expect(refused, Outcome::not_judged, "the file rounds the surface to an invalid one");
}

TEST(JudgeRun, LetsARemeshedBoundaryBeAsFarAsTheMesherSays) {
  const TriangleSurface surface = test::boundary_surface(block());
  expect(judge(raised(1e-2), surface, {}, 0, 1e-2), Outcome::sound, "");  // the diagonal is 5.2
  expect(judge(raised(1e-1), surface, {}, 0, 1e-2), Outcome::wrong_against_surface, "excess-region");
}

// A lattice that is too coarse for a cell of the solid loses it, and says so; it may not add one.
TEST(JudgeRun, LetsACoarseLatticeLoseWhatIsThin) {
  class Lattice : public FakeMesher {
   public:
    Lattice() : FakeMesher(0.2) {}  // a cell: the diagonal is 5.2
    bool coarse() const override { return true; }
  };
  const auto judge_lattice = [](const TetMesh& mesh, const TetMesh& solid) {
    const TriangleSurface surface = test::boundary_surface(solid);
    const verify::JudgedSurface judged(surface);
    return judge_run({.mesh = mesh}, Lattice(), judged, {});
  };
  const TetMesh with_horn = test::lattice_mesh({3, 3, 6}, [](test::Cell c) {
    return c[2] < 3 || c == test::Cell{1, 1, 3} || c == test::Cell{1, 1, 4} || c == test::Cell{1, 1, 5};
  });
  expect(judge_lattice(block(), with_horn), Outcome::sound, "");
  EXPECT_EQ(judge_lattice(with_horn, block()).outcome, Outcome::wrong_against_surface);
  expect(judge(block(), test::boundary_surface(with_horn), {}, 0, 0.2), Outcome::wrong_against_surface,
         "missing-region");
}

TEST(JudgeRun, MakesOnlyThePassThatTheChecksAskFor) {
  TetMesh inverted = block();
  std::swap(inverted.tets[7][0], inverted.tets[7][1]);
  const TriangleSurface surface = test::boundary_surface(block());
  expect(judge(inverted, surface, {.check = {"flat"}}), Outcome::sound, "");
  expect(judge(raised(1e-2), surface, {.check = {"inverted"}}), Outcome::sound, "");
  expect(judge(raised(1e-2), surface, {.check = {"mesh-to-surface"}}), Outcome::wrong_against_surface,
         "mesh-to-surface");
}

// Elements that are no tetrahedra leave the verdict open, and it is never called sound.
TEST(JudgeRun, LeavesAMeshWithOtherElementsUnjudged) {
  const auto document = std::make_shared<Document>();
  document->points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 0, 0},
                      {6, 0, 0}, {5, 1, 0}, {5, 0, 1}, {6, 0, 1}, {5, 1, 1}};
  document->blocks = {{.type = 4, .nodes_each = 4, .count = 1, .first = 0, .nodes = 0},
                      {.type = 6, .nodes_each = 6, .count = 1, .first = 1, .nodes = 4}};
  document->connectivity = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const TriangleSurface surface = test::boundary_surface(tet_mesh(*document));
  const verify::JudgedSurface judged(surface);
  const Judgement judgement =
      judge_run({.document = document, .mesh = tet_mesh(*document)}, FakeMesher(), judged);
  EXPECT_EQ(judgement.outcome, Outcome::not_judged);
  EXPECT_NE(judgement.what.find("prism"), std::string::npos) << judgement.what;
}

TEST(JudgeRun, GivesUpAfterItsTime) {
  const TetMesh mesh = test::lattice_mesh({20, 20, 20});
  const Judgement judgement = judge(mesh, test::boundary_surface(mesh), {.seconds = 1e-6});
  expect(judgement, Outcome::not_judged, "the verdict took longer than allowed");
  EXPECT_LT(judgement.seconds, 5);
}

}  // namespace
}  // namespace tetproof::corpus
