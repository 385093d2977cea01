// SPDX-License-Identifier: GPL-3.0-or-later
// Many threads use the C interface at once, also in odd floating-point environments, and nothing is printed.
#include <cfenv>
#include <thread>

#include "corpus/bad_meshes.hpp"
#include "tests/c/handles.hpp"
#include "tests/support/test_files.hpp"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace tetproof::test {
namespace {

// As a program does that was linked with -ffast-math.
void flush_to_zero() {
#ifdef __SSE2__
  _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}

FileDocument grid_of(const Surface& surface) {
  tetproof_mesh_options cut = mesh_options();
  cut.cells[0] = 6;
  cut.points = 10;
  return made<tetproof_document>(
      [&](auto** out, auto* error) { return tetproof_mesh(surface.get(), &cut, out, error); });
}

std::string judged_json(const FileDocument& grid, const Surface& surface, std::int32_t threads) {
  tetproof_judge_options options = judge_options();
  options.voxels = 16;
  options.threads = threads;
  return json_of(made<tetproof_report>([&](auto** out, auto* error) {
    return tetproof_judge_document(grid.get(), surface.get(), &options, out, error);
  }));
}

TEST(CThreads, ShareSurfacesAndDocuments) {
  const Surface ball = opened("sphere:r=1,n=300");
  const FileDocument grid = grid_of(ball);
  const std::string expected = judged_json(grid, ball, 1);
  const Surface fresh = opened("sphere:r=1,n=300");  // judged first by whoever comes first
  std::vector<std::string> found(6);
  std::vector<const double*> points(6);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i)
    threads.emplace_back([&, i] {
      found[i] = judged_json(grid, fresh, static_cast<std::int32_t>(i));
      const tetproof_document_arrays* arrays = nullptr;
      tetproof_document_view(grid.get(), &arrays, nullptr);
      points[i] = arrays->points;
      const Surface own = opened("torus:R=1,r=0.4,n=300");
      EXPECT_GT(tetproof_surface_view(own.get())->triangle_count, 100);
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i], expected) << i;
    EXPECT_EQ(points[i], points[0]);
  }
}

TEST(CThreads, KeepErrorsApart) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([i] {
      for (int k = 0; k < 50; ++k) {
        const std::string spec = "nothing-" + std::to_string(i);
        const std::string message =
            refused<tetproof_surface>(TETPROOF_BAD_INPUT, [&](auto** out, auto* error) {
              return tetproof_surface_open(spec.c_str(), nullptr, out, error);
            });
        EXPECT_EQ(message.substr(0, spec.size() + 1), spec + ":");
      }
    });
  for (std::thread& thread : threads) thread.join();
}

TEST(CThreads, WriteTheSameFile) {
  const TestFiles files;
  const Surface ball = opened("sphere:r=1,n=300");
  const FileDocument grid = grid_of(ball);
  ASSERT_EQ(tetproof_document_write(grid.get(), files.path("one.msh").c_str(), nullptr, nullptr),
            TETPROOF_OK);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 10; ++k)
        EXPECT_EQ(tetproof_document_write(grid.get(), files.path("same.msh").c_str(), nullptr, nullptr),
                  TETPROOF_OK);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(TestFiles::read(files.path("same.msh")), TestFiles::read(files.path("one.msh")));
}

TEST(CThreads, AnswerTheSameInEveryFloatingPointEnvironment) {
  std::vector<std::unique_ptr<const Arrays>> meshes;  // made here, where nothing is flushed
  for (const corpus::BadMesh& bad : corpus::bad_meshes()) {
    if (!bad.name.ends_with("-tiny") && !bad.name.starts_with("sound")) continue;
    TetMesh mesh = bad.planted.mesh;
    for (auto& point : mesh.points) point *= 0x1p-1000;  // products of coordinates underflow
    meshes.push_back(std::make_unique<const Arrays>(mesh));
  }
  ASSERT_GT(meshes.size(), 8u);
  const auto all_judged = [&] {
    std::vector<std::string> found;
    for (const auto& mesh : meshes) found.push_back(json_of(judged(mesh->points, mesh->tets)));
    return found;
  };
  const Surface ball = opened("sphere:r=1,n=300");
  const FileDocument grid = grid_of(ball);
  const std::vector<std::string> expected = all_judged();
  const std::string of_grid = judged_json(grid, ball, 0);
  for (const int direction : {FE_UPWARD, FE_TOWARDZERO}) {
    std::thread([&] {
      flush_to_zero();
      std::fesetround(direction);
      const std::vector<std::string> found = all_judged();
      const Surface again = opened("sphere:r=1,n=300");
      const std::string again_of_grid = judged_json(grid_of(again), again, 0);
      std::fesetenv(FE_DFL_ENV);
      EXPECT_EQ(found, expected);
      EXPECT_EQ(again_of_grid, of_grid);
    }).join();
  }
}

}  // namespace
}  // namespace tetproof::test
