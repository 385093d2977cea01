// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that deliberately hit the lattice, with every combination of options: each grid is certified, and
// a literal one reports its defects.
#include <gtest/gtest.h>

#include "corpus/surfaces.hpp"
#include "reference/generate.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;
using reference::Diagonals;
using reference::generate;
using reference::Generation;
using reference::Region;

struct Aligned {
  const char* name;
  const char* spec;
  std::array<int, 3> cells;
  double box_scale;
};

// A body of m cells in a box scaled by 2 with 2m cells has its faces in lattice planes. They are exact for
// powers of two.
const Aligned surfaces[] = {
    {"CubeFacesEdgesCornersInLatticePlanes", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4", {8, 8, 8}, 2},
    {"CubeWithTrianglesFinerThanTheLattice", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4,n=7", {8, 8, 8}, 2},
    {"CubeWithRoundedPlanes", "box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4", {6, 6, 6}, 1.5},
    {"OctahedronVerticesOnLatticeVertices", "octahedron", {8, 8, 8}, 2},
    {"OctahedronVerticesOnLatticeEdges", "octahedron", {7, 7, 7}, 1.75},
    {"GrooveOneCellWide", "groove:m=4,width=1,depth=2", {8, 8, 8}, 2},
    {"GrooveTwoCellsWide", "groove:m=4,width=2,depth=3", {8, 8, 8}, 2},
    {"TerrainCoplanarFaces", "terrain:m=4,seed=3", {8, 8, 8}, 2},
    {"TerrainFine", "terrain:m=8,seed=11,n=3", {16, 16, 16}, 2},
    {"ShellThinnerThanACell", "hollow:m=4,wall=0.25", {8, 8, 8}, 2},
    {"ShellThinnerThanACellOff", "hollow:m=4,wall=0.3", {9, 9, 9}, 1.7},
    {"TwoBodiesHalfACellApart", "pair:m=2,gap=0.5", {9, 8, 8}, 2},
    {"Bottle", "bottle:m=4,wall=1,neck=0.5", {8, 8, 8}, 2},
};

using Parameter = std::tuple<Aligned, Region, Diagonals, double>;
class LatticeAligned : public testing::TestWithParam<Parameter> {};

TEST_P(LatticeAligned, IsCertified) {
  const auto& [aligned, region, diagonals, on_surface] = GetParam();
  const TriangleSurface surface = corpus::make_surface(aligned.spec);
  const Generation made = generate(surface, {.region = region,
                                             .cells = aligned.cells,
                                             .box_scale = aligned.box_scale,
                                             .on_surface = on_surface,
                                             .diagonals = diagonals});
  EXPECT_EQ(made.not_positive, 0);
  const verify::Report report = verify::verify(made.grid.mesh, {.quality = false});
  const bool empty =
      made.grid.mesh.tets.empty();  // where the shell is thinner than a cell: nothing is certified
  EXPECT_EQ(report.certificate, empty ? std::nullopt : std::optional<bool>(true))
      << verify::report_text(report);
  EXPECT_EQ(verify::sound(report), !empty) << verify::report_text(report);
}

TEST_P(LatticeAligned, LiteralConforms) {
  const auto& [aligned, region, diagonals, on_surface] = GetParam();
  const TriangleSurface surface = corpus::make_surface(aligned.spec);
  const Generation made = generate(surface, {.region = region,
                                             .cells = aligned.cells,
                                             .box_scale = aligned.box_scale,
                                             .diagonals = diagonals,
                                             .literal = true});
  EXPECT_EQ(made.moved_to_surface, 0);
  EXPECT_EQ(made.mended, 0);
  const verify::Report report = verify::verify(made.grid.mesh, {.quality = false});
  using verify::Check;
  for (const Check check :
       {Check::face_shared_thrice, Check::face_orientation, Check::duplicate_tet, Check::repeated_vertex})
    EXPECT_EQ(report[check].verdict, verify::Verdict::pass) << verify::info(check).id;
  EXPECT_EQ(report[Check::inverted].count + report[Check::flat].count, made.not_positive);
}

std::string name_of(const testing::TestParamInfo<Parameter>& each) {
  const auto& [aligned, region, diagonals, on_surface] = each.param;
  return std::string(aligned.name) + (region == Region::inside ? "_inside" : "_outside") +
         (diagonals == Diagonals::lowest ? "_lowest" : "_shortest") +
         (on_surface == 0     ? "_0"
          : on_surface < 1e-3 ? "_1e_6"
                              : "_0_1");
}

INSTANTIATE_TEST_SUITE_P(All, LatticeAligned,
                         testing::Combine(testing::ValuesIn(surfaces),
                                          testing::Values(Region::inside, Region::outside),
                                          testing::Values(Diagonals::lowest, Diagonals::shortest),
                                          testing::Values(0, 1e-6, 0.1)),
                         name_of);

// A cube with faces in lattice planes is reproduced exactly.
TEST(LatticeAlignedVolume, CubeIsExact) {
  const TriangleSurface cube = corpus::make_surface("box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4");
  for (const double on_surface : {1e-6, 0.1}) {
    const Generation inside = generate(cube, {.cells = {8, 8, 8}, .box_scale = 2, .on_surface = on_surface});
    EXPECT_EQ(verify::verify(inside.grid.mesh).mesh.volume, std::optional<double>(64));
    const Generation outside = generate(
        cube, {.region = Region::outside, .cells = {8, 8, 8}, .box_scale = 2, .on_surface = on_surface});
    EXPECT_EQ(verify::verify(outside.grid.mesh).mesh.volume, std::optional<double>(512 - 64));
  }
}

// Reading D10: in the groove, lattice tetrahedra have all four vertices on the surface. By default those
// outside are dropped; with --literal they are kept.
TEST(LatticeAlignedVolume, GrooveIsEmptyUnlessLiteral) {
  const TriangleSurface groove = corpus::make_surface("groove:m=4,width=1,depth=2");
  const double solid = 64 - 1 * 4 * 2;
  const Generation usual = generate(groove, {.cells = {8, 8, 8}, .box_scale = 2});
  EXPECT_EQ(verify::verify(usual.grid.mesh).mesh.volume, std::optional<double>(solid));
  const Generation literal = generate(groove, {.cells = {8, 8, 8}, .box_scale = 2, .literal = true});
  EXPECT_GT(*verify::verify(literal.grid.mesh).mesh.volume, solid);
}

// Reading D4: rounding puts lattice planes 1e-17 beside the faces. This makes cuts close to vertices, and
// inverted tetrahedra.
TEST(Mending, LeavesNoTetrahedronInverted) {
  for (const char* spec :
       {"box:x0=0,x1=4,y0=0,y1=4,z0=0,z1=4", "groove:m=4,width=1,depth=2", "terrain:m=4,seed=3"})
    for (const Region region : {Region::inside, Region::outside}) {
      const TriangleSurface surface = corpus::make_surface(spec);
      const Generation literal =
          generate(surface, {.region = region, .cells = {12, 0, 0}, .box_scale = 1.5, .literal = true});
      EXPECT_GT(literal.not_positive, 0) << spec;
      const Generation mended =
          generate(surface, {.region = region, .cells = {12, 0, 0}, .box_scale = 1.5, .on_surface = 0});
      EXPECT_GT(mended.mended, 0) << spec;
      EXPECT_EQ(mended.not_positive, 0) << spec;
      EXPECT_EQ(verify::verify(mended.grid.mesh).certificate, std::optional<bool>(true)) << spec;
    }
}

}  // namespace
