// SPDX-License-Identifier: GPL-3.0-or-later
// The tests of a user's mesher: what it makes is sound and fills its surface; and a mesh that is not fails,
// with a text that says where.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include <tetproof/corpus/surfaces.hpp>
#include <tetproof/io/mesh_files.hpp>
#include <tetproof/io/surface_files.hpp>
#include <tetproof/reference/generate.hpp>
#include <tetproof/verify/gtest.hpp>

namespace {

using tetproof::TetMesh;
using tetproof::TriangleSurface;
using tetproof::verify::Fills;
using tetproof::verify::IsCertified;
using tetproof::verify::IsSound;

// Stands for the user's own mesher.
TetMesh mesh_of(const TriangleSurface& surface) {
  return tetproof::reference::generate(surface, {.cells = {16, 0, 0}}).grid.mesh;
}

TEST(MyMesher, FillsASphere) {
  const TriangleSurface surface = tetproof::corpus::make_surface("sphere:r=1,n=500");
  const TetMesh mesh = mesh_of(surface);
  EXPECT_THAT(mesh, IsSound());
  EXPECT_THAT(mesh, IsCertified());
  EXPECT_THAT(mesh, Fills(surface, {.fidelity = 0.1, .voxels = 32}));
}

TEST(MyMesher, WritesWhatItMade) {
  const TriangleSurface surface = tetproof::corpus::make_surface("sphere:r=1,n=500");
  tetproof::write_surface("sphere.off", surface);
  tetproof::write_document("sphere.msh", tetproof::document_of(mesh_of(surface)));
  EXPECT_THAT(std::filesystem::path("sphere.msh"), Fills("sphere.off", {.fidelity = 0.1, .voxels = 32}));
}

TEST(MyMesher, AFailureNamesTheTetrahedron) {
  TetMesh mesh = mesh_of(tetproof::corpus::make_surface("sphere:r=1,n=500"));
  std::swap(mesh.tets[17][0], mesh.tets[17][1]);
  EXPECT_NONFATAL_FAILURE(EXPECT_THAT(mesh, IsSound()),
                          "FAIL inverted: 1\n  tetrahedron 17: negative: volume -");
}

}  // namespace
