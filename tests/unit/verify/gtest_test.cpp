// SPDX-License-Identifier: GPL-3.0-or-later
// The matchers for users' tests: they match what is right and fail on what is wrong, and the failure message
// says where.
#include "verify/gtest.hpp"

#include <gtest/gtest-spi.h>

#include <fstream>

#include "io/error.hpp"
#include "tests/support/meshes.hpp"

namespace tetproof::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using verify::Fills;
using verify::IsCertified;
using verify::IsSound;

// The text that EXPECT_THAT adds to "Actual: ...".
template <class Matcher, class Value>
std::string explained(const Matcher& matcher, const Value& value, bool expected) {
  testing::StringMatchResultListener listener;
  EXPECT_EQ(testing::SafeMatcherCast<const Value&>(matcher).MatchAndExplain(value, &listener), expected);
  return listener.str();
}

TetMesh inverted(std::size_t tet) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  std::swap(mesh.tets[tet][0], mesh.tets[tet][1]);
  return mesh;
}

// A file with a mesh and one without, both removed at the end.
class Files {
 public:
  Files() {
    write_document(mesh("sound.msh"), document_of(lattice_mesh({2, 2, 2})));
    write_document(mesh("bad.msh"), document_of(inverted(3)));
    write_surface(mesh("cube.off"), boundary_surface(lattice_mesh({2, 2, 2})));
  }
  ~Files() { std::filesystem::remove_all(folder_); }
  std::string mesh(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_ = [] {
    std::string name = (std::filesystem::temp_directory_path() / "tetproof-matchers-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error(name);
    return name;
  }();
};

TEST(Matchers, TakeWhatIsRight) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  EXPECT_THAT(mesh, IsSound());
  EXPECT_THAT(mesh, IsCertified());
  EXPECT_THAT(mesh, IsSound({.strict_topology = true}));
  EXPECT_THAT(mesh, Fills(boundary_surface(mesh), 0));
  EXPECT_THAT(mesh, AllOf(IsCertified(), Fills(boundary_surface(mesh), {.fidelity = 1e-3, .voxels = 0})));
  // A shell of cells around a hole. The mesh fills the outside of the hole's surface.
  const auto around = [](Cell c) { return c != Cell{1, 1, 1}; };
  const TriangleSurface hole = boundary_surface(lattice_mesh({1, 1, 1}, {}, {1, 1, 1}));
  EXPECT_THAT(lattice_mesh({3, 3, 3}, around),
              Fills(hole, {.region = verify::Region::outside, .fidelity = 0, .voxels = 16}));
}

TEST(Matchers, TakeFilesByPathAndByName) {
  const Files files;
  EXPECT_THAT(std::filesystem::path(files.mesh("sound.msh")), IsSound());
  EXPECT_THAT(files.mesh("sound.msh"), Fills(files.mesh("cube.off"), 0));
  EXPECT_THAT(files.mesh("sound.msh").c_str(), IsCertified());
  EXPECT_THAT(files.mesh("bad.msh"), Not(IsSound()));
  // The file numbers its tetrahedra from 1.
  EXPECT_THAT(explained(IsSound(), files.mesh("bad.msh"), false), HasSubstr("  tetrahedron 4: negative"));
}

TEST(Matchers, TheFailureIsTheReportsFirstFindings) {
  EXPECT_EQ(explained(IsSound(), inverted(3), false),
            "which is DEFECTIVE: no certificate, no valid triangulation of a solid (inverted)\n"
            "FAIL inverted: 1\n"
            "  tetrahedron 3: negative: volume -0.166667\n"
            "    from this follows: 3 face-orientation\n"
            "FAIL face-orientation: 3 consequences of what is found above\n");
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  EXPECT_EQ(explained(IsSound(), mesh, true),
            "which is sound: certified: 48 tetrahedra, a valid triangulation of a solid\n");
  EXPECT_EQ(explained(IsSound(), TetMesh{}, false), "which has no tetrahedra");
}

TEST(Matchers, TheFailureStopsAfterTheFirstFindings) {
  TetMesh mesh = lattice_mesh({2, 2, 2});
  for (std::size_t t : {0, 7, 14, 21, 28, 35, 42}) std::swap(mesh.tets[t][0], mesh.tets[t][1]);
  mesh.tets.push_back({0, 0, 1, 2});
  const std::string text = explained(IsSound(), mesh, false);
  EXPECT_THAT(
      text, HasSubstr("FAIL repeated-vertex: 1\n  tetrahedron 48, vertex 0: names a point more than once\n"));
  EXPECT_THAT(text, HasSubstr("FAIL inverted: 7\n  tetrahedron 0: "));
  EXPECT_THAT(text, HasSubstr("  tetrahedron 21: negative"));
  EXPECT_THAT(text, Not(HasSubstr("tetrahedron 28: ")));  // the sixth finding
  EXPECT_THAT(text, HasSubstr("  ... 3 more\n"));
}

TEST(Matchers, WhatGoogleTestPrints) {
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(inverted(3), IsSound()),
                          "Expected: is a sound tetrahedral mesh\n"
                          "  Actual: a mesh of 48 tetrahedra and 27 points");
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(inverted(3), IsSound()),
                          "  tetrahedron 3: negative: volume -0.166667\n");
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(lattice_mesh({1, 1, 1}), Not(IsCertified())),
                          "Expected: is not a sound tetrahedral mesh, certified to be a valid triangulation");
}

TEST(Matchers, CertifiedNeedsEveryCheckOfTheProof) {
  const TetMesh mesh = lattice_mesh({2, 2, 2});
  EXPECT_THAT(mesh, IsSound({.skip = {"overlap"}}));
  EXPECT_THAT(explained(IsSound({.skip = {"overlap"}}), mesh, true),
              HasSubstr("sound: only as far as asked: 48 tetrahedra without a certificate; left out: check "
                        "overlap\n"));
  EXPECT_THAT(inverted(3), Not(IsCertified()));
  // A check that was not asked for cannot fail, and proves nothing.
  EXPECT_THAT(inverted(3), IsSound({.check = {"duplicate-point"}}));
}

TEST(Matchers, FillsTellsWhatIsMissing) {
  const TetMesh mesh = lattice_mesh({2, 2, 2}), less = lattice_mesh({2, 2, 2}, [](Cell c) {
                                                  return c != Cell{1, 1, 1};
                                                });
  const TriangleSurface surface = boundary_surface(mesh);
  EXPECT_THAT(less, IsCertified());
  const std::string text = explained(Fills(surface, 1e-3), less, false);
  EXPECT_THAT(text, AllOf(StartsWith("which is DEFECTIVE: the mesh does not fill the surface ("),
                          HasSubstr("(certified: 42 tetrahedra)"), HasSubstr("FAIL volume-surface")));
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(less, Fills(surface, 1e-3)),
                          "Expected: is a sound tetrahedral mesh that fills the inside of a surface of 48 "
                          "triangles within 0.001");
  // The gap that one cell leaves is smaller than half the diagonal.
  EXPECT_THAT(less, Fills(surface, {.fidelity = 0.5, .voxels = 0}));
}

TEST(Matchers, WhatCannotBeJudgedIsAnErrorAndNoMismatch) {
  const Files files;
  EXPECT_THROW((void)explained(IsSound(), files.mesh("none.msh"), false), InputError);
  EXPECT_THROW((void)explained(Not(IsSound()), files.mesh("none.msh"), true), InputError);
  EXPECT_THROW((void)Fills(files.mesh("none.off"), 1e-3), InputError);
  TriangleSurface open = boundary_surface(lattice_mesh({1, 1, 1}));
  open.triangles.pop_back();
  EXPECT_THROW((void)Fills(open, 1e-3), InputError);
  EXPECT_THROW((void)explained(IsSound({.check = {"no-such"}}), lattice_mesh({1, 1, 1}), false), InputError);
}

}  // namespace
}  // namespace tetproof::test
