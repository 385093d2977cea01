// SPDX-License-Identifier: GPL-3.0-or-later
// The zoo in corpus/bad-meshes: its files are what the planting tool makes, what they promise is true of them
// by brute force over all pairs, and the judge says of each what is true.
#include "corpus/bad_meshes.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "io/mesh_files.hpp"
#include "score.hpp"
#include "verify/verify.hpp"

namespace tetproof::test {
namespace {

namespace fs = std::filesystem;

const fs::path zoo = fs::path(TETPROOF_SOURCE_DIR) / "corpus" / "bad-meshes";

std::string bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::vector<corpus::BadMesh>& meshes() {
  static const std::vector<corpus::BadMesh> all = corpus::bad_meshes();
  return all;
}

TEST(BadMeshes, FilesAreWhatTheGeneratorWrites) {
  const fs::path scratch = fs::path(testing::TempDir()) / "tetproof-bad-meshes";
  fs::create_directories(scratch);
  corpus::write_bad_meshes(scratch.string(), meshes());
  std::set<std::string> written, committed;
  for (const auto& entry : fs::directory_iterator(scratch)) written.insert(entry.path().filename());
  for (const auto& entry : fs::directory_iterator(zoo))
    if (const auto ending = entry.path().extension();
        ending == ".msh" || ending == ".node" || ending == ".ele" || ending == ".json")
      committed.insert(entry.path().filename());
  EXPECT_EQ(written, committed);
  for (const std::string& name : written) EXPECT_EQ(bytes(scratch / name), bytes(zoo / name)) << name;
  fs::remove_all(scratch);
}

TEST(BadMeshes, EveryKindIsThere) {
  std::set<std::string> kinds, names;
  for (const corpus::BadMesh& mesh : meshes()) {
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name;
    if (mesh.kind) kinds.insert(mesh.kind->id);
  }
  for (const corpus::PlantKind& kind : corpus::plant_kinds())
    EXPECT_EQ(kinds.contains(kind.id), !kind.has("campaign")) << kind.id;
  EXPECT_GE(kinds.size(), 40u);
}

TEST(BadMeshes, TruthAndVerdictOnEveryFile) {
  int valid = 0, invalid = 0;
  for (const corpus::BadMesh& mesh : meshes())
    for (const char* ending : {".msh", ".node"}) {
      SCOPED_TRACE(mesh.name + ending);
      const TetMesh read = tet_mesh(read_document((zoo / (mesh.name + ending)).string()));
      ASSERT_EQ(read.tets.size(), mesh.planted.mesh.tets.size());
      ASSERT_EQ(read.points.size(), mesh.planted.mesh.points.size());
      corpus::Planted planted = mesh.planted;
      planted.truth = corpus::truth(read);
      EXPECT_EQ(planted.truth.valid(), mesh.planted.truth.valid());
      (planted.truth.valid() ? valid : invalid) += 1;
      const verify::Report report = verify::verify(read);
      if (mesh.kind)
        EXPECT_EQ(objection(planted, report), "") << report_text(report);
      else
        EXPECT_EQ(objection_to_sound(planted.truth, report), "") << report_text(report);
    }
  EXPECT_GT(valid, 60);
  EXPECT_GT(invalid, 150);
}

}  // namespace
}  // namespace tetproof::test
