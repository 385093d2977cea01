// SPDX-License-Identifier: GPL-3.0-or-later
// Memory runs out at any moment of a call: the call says so, leaves nothing behind, and the next one works.
// Texts of JSON are left out: nlohmann's JSON needs memory to free itself, and ends the process without.
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

#include "tests/c/handles.hpp"
#include "tests/support/meshes.hpp"

namespace {

// How many allocations are left before all fail; negative: they do not fail. Allocations that are alive.
std::atomic<std::int64_t> left{-1}, alive{0};

void* allocated(std::size_t bytes, std::size_t alignment) {
  if (left >= 0 && left.fetch_sub(1) <= 0) {
    left = 0;
    throw std::bad_alloc();
  }
  void* memory = nullptr;
  if (::posix_memalign(&memory, alignment, bytes > 0 ? bytes : 1) != 0) throw std::bad_alloc();
  ++alive;
  return memory;
}

void freed(void* memory) {
  if (memory) --alive;
  std::free(memory);
}

}  // namespace

// The library's operator new is the program's, so that its allocations fail and count here.
void* operator new(std::size_t bytes) {
  return allocated(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return allocated(bytes, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  try {
    return operator new(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  freed(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  freed(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  freed(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  freed(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  freed(memory);
}

namespace tetproof::test {
namespace {

// A call of the interface that makes something and frees it.
using Call = std::function<tetproof_status(tetproof_error*)>;

// Lets memory run out after 0, 1, 2, ... allocations, or at `samples` moments if there are more.
void exhaust(const Call& call, std::int64_t samples) {
  tetproof_error error;
  ASSERT_EQ(call(&error), TETPROOF_OK) << error.message;  // what is made once is made
  left = std::int64_t{1} << 40;
  ASSERT_EQ(call(&error), TETPROOF_OK) << error.message;
  const std::int64_t needed = (std::int64_t{1} << 40) - left.exchange(-1);
  ASSERT_GT(needed, 3);
  const std::int64_t before = alive;
  std::int64_t exhausted = 0, leaked = 0;
  for (std::int64_t sample = 0; sample < std::min(samples, needed); ++sample) {
    left = needed <= samples ? sample : sample * needed / samples;
    const tetproof_status status = call(&error);
    left = -1;
    if (status == TETPROOF_OUT_OF_MEMORY)
      ++exhausted;
    else
      EXPECT_EQ(status, TETPROOF_OK) << error.message;
    leaked = std::max(leaked, alive - before);
  }
  EXPECT_GT(exhausted, std::min(samples, needed) / 2);  // threads may need less in another order
  EXPECT_EQ(call(&error), TETPROOF_OK) << error.message;
  EXPECT_LT(leaked, 100);  // oneTBB and the threads keep a few for themselves
}

TEST(CMemory, RunsOutInTheJudge) {
  TetMesh mesh = lattice_mesh({2, 1, 1});
  std::swap(mesh.tets[3][0], mesh.tets[3][1]);
  const Arrays arrays(mesh);
  exhaust(
      [&](tetproof_error* error) {
        tetproof_report* report = nullptr;
        const tetproof_status status =
            tetproof_judge(&arrays.points, &arrays.tets, nullptr, nullptr, nullptr, &report, error);
        if (status != TETPROOF_OK) {
          EXPECT_EQ(report, nullptr);
        }
        tetproof_report_free(report);
        return status;
      },
      400);
}

TEST(CMemory, RunsOutInTheComparisonWithASurface) {
  const TetMesh mesh = lattice_mesh({2, 1, 1});
  const Arrays arrays(mesh);
  tetproof_judge_options options = judge_options();
  options.voxels = 0;  // OpenVDB's tree loses nodes when it gets no memory for more
  exhaust(
      [&](tetproof_error* error) {
        tetproof_surface* surface = nullptr;
        tetproof_report* report = nullptr;
        tetproof_status status = tetproof_surface_open("octahedron", nullptr, &surface, error);
        if (status == TETPROOF_OK)
          status = tetproof_judge(&arrays.points, &arrays.tets, nullptr, surface, &options, &report, error);
        tetproof_report_free(report);
        tetproof_surface_free(surface);
        return status;
      },
      300);
}

TEST(CMemory, RunsOutInFilesAndGrids) {
  exhaust(
      [](tetproof_error* error) {
        tetproof_surface* surface = nullptr;
        tetproof_document *grid = nullptr, *read = nullptr;
        const char off[] = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
        tetproof_mesh_options options;
        tetproof_mesh_options_init(&options, sizeof options, nullptr);
        options.cells[0] = 4;
        options.points = 3;
        tetproof_status status = tetproof_document_read_memory(off, sizeof off - 1, nullptr, &read, error);
        if (status == TETPROOF_OK) status = tetproof_surface_from_document(read, &surface, error);
        if (status == TETPROOF_OK) status = tetproof_mesh(surface, &options, &grid, error);
        tetproof_surface_free(surface);
        tetproof_document_free(grid);
        tetproof_document_free(read);
        return status;
      },
      300);
}

}  // namespace
}  // namespace tetproof::test
