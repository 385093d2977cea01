// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a fuzz campaign alone, in CPU time: making and certifying surfaces, cases with a mesher that
// does nothing, verdicts. Prints JSON. usage: fuzz_rates SURFACES FOLDER
#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "corpus/block_mesh.hpp"
#include "corpus/fuzz_campaign.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/meshing/judgement.hpp"
#include "corpus/meshing/mesher.hpp"
#include "tests/support/meshes.hpp"
#include "verify/surface.hpp"

namespace {

using namespace tetproof;
using namespace tetproof::corpus;

// CPU time of this process [s]: no other load of the machine counts.
double cpu() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

template <class Work>
double timed(const Work& work) {
  const double start = cpu();
  work();
  return cpu() - start;
}

// Makes the surfaces; judges each once more, as a campaign does.
std::pair<double, double> surfaces(std::uint64_t count) {
  std::pair<double, double> seconds{0, 0};
  for (std::uint64_t k = 0; k < count; ++k) {
    FuzzSurface made;
    seconds.first += timed([&] { made = fuzz_surface(1, k); });
    seconds.second += timed([&] {
      if (!verify::judge_surface(made.surface).fault.empty())
        throw std::logic_error("a surface is not valid");
    });
  }
  return seconds;
}

// A campaign with a mesher that refuses at once: what a case costs beside its mesher and its verdict.
double empty_mesher(std::uint64_t count, const std::string& folder) {
  const MeshFunction refuses = [](const TriangleSurface&) -> TetMesh { throw std::runtime_error("no"); };
  const auto mesher = function_mesher(refuses);
  return timed([&] { run_campaign({mesher.get()}, {.cases = count, .threads = 1, .folder = folder}); });
}

// Verdicts on a sound mesh of 1,080 tetrahedra, with its surface.
double verdicts(int count, std::size_t& tets) {
  const TetMesh mesh = block_mesh({6, 6, 5});
  tets = mesh.tets.size();
  const TriangleSurface surface = test::boundary_surface(mesh);
  const verify::JudgedSurface judged(surface);
  const MeshFunction given = [&](const TriangleSurface&) { return mesh; };
  const auto mesher = function_mesher(given);
  const MesherRun run = mesher->run(surface, "", {});
  return timed([&] {
    for (int k = 0; k < count; ++k)
      if (judge_run(run, *mesher, judged).outcome != Outcome::sound)
        throw std::logic_error("the block is not sound");
  });
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: fuzz_rates SURFACES FOLDER");
  const auto count = static_cast<std::uint64_t>(std::stoull(argv[1]));
  const auto [making, judging] = surfaces(count);
  const double cases = empty_mesher(count, argv[2]);
  constexpr int repeats = 200;
  std::size_t tets = 0;
  const double verdict = verdicts(repeats, tets);
  std::cout
      << fmt::format(
             R"({{"surfaces": {}, "making_s": {}, "judging_s": {}, "empty_cases_s": {}, "verdicts": {}, "tets": {}, "verdicts_s": {}}})",
             count, making, judging, cases, repeats, tets, verdict)
      << "\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "fuzz_rates: " << error.what() << "\n";
  return 2;
}
