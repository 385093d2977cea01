// SPDX-License-Identifier: GPL-3.0-or-later
// How many runs of a mesher, and how many seconds, the shrinker takes until a finding has at most so many
// triangles. Prints a line of JSON for each finding.
// usage: shrink_rates TRIANGLES SECONDS FOLDER [PRESET,VARIANT SEED:CASE]...
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "corpus/campaign/case_run.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/meshing/judgement.hpp"
#include "corpus/meshing/mesher.hpp"
#include "corpus/shrink/shrink_recipe.hpp"
#include "corpus/shrink/shrink_surface.hpp"
#include "verify/surface.hpp"

namespace {

using namespace tetproof;
using namespace tetproof::corpus;
using Clock = std::chrono::steady_clock;

struct Small {};  // thrown when the surface is small enough

class Finding {
 public:
  Finding(const std::string& mesher, std::size_t most, std::string folder)
      : mesher_(preset_mesher(mesher)), most_(most), folder_(std::move(folder)) {}

  nlohmann::ordered_json shrink(std::uint64_t seed, std::uint64_t index, double seconds) {
    const FuzzSurface original = fuzz_surface(seed, index);
    const Judgement judgement = run(original.surface);
    nlohmann::ordered_json row{{"mesher", mesher_->name()},
                               {"version", mesher_->version()},
                               {"case", fmt::format("{}:{}", seed, index)},
                               {"outcome", name_of(judgement.outcome)},
                               {"signature", judgement.signature},
                               {"triangles", original.surface.triangles.size()}};
    smallest_ = original.surface.triangles.size();
    const StillFails fails = [&](const TriangleSurface& surface) {
      const Judgement one = run(surface);
      if (one.outcome != judgement.outcome || one.signature != judgement.signature) return false;
      std::size_t smallest = smallest_;
      while (surface.triangles.size() < smallest &&
             !smallest_.compare_exchange_weak(smallest, surface.triangles.size())) {
      }
      if (surface.triangles.size() <= most_) throw Small();
      return true;
    };
    calls_ = 0;
    const auto start = Clock::now();
    const auto used = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    bool small = false;
    try {
      const RecipeShrinkResult simpler = shrink_recipe(original, fails, {.seconds = seconds / 2});
      shrink_surface(simpler.surface.surface, fails, {.seconds = std::max(0.0, seconds - used())});
    } catch (const Small&) {
      small = true;
    }
    row["reached"] = small;
    row["left"] = smallest_.load();
    row["calls"] = calls_.load();
    row["seconds"] = used();
    return row;
  }

 private:
  Judgement run(const TriangleSurface& surface) {
    const std::string folder = fmt::format("{}/{}", folder_, calls_.fetch_add(1));
    std::filesystem::create_directories(folder);
    const verify::JudgedSurface judged(surface);
    Judgement judgement = run_and_judge(*mesher_, judged, folder, {.cpu_s = 5}, {}).judgement;
    std::filesystem::remove_all(folder);
    return judgement;
  }

  std::unique_ptr<Mesher> mesher_;
  std::size_t most_;
  std::string folder_;
  std::atomic<std::size_t> smallest_{0};
  std::atomic<std::int64_t> calls_{0};
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 6 || argc % 2 != 0)
    throw std::invalid_argument("usage: shrink_rates TRIANGLES SECONDS FOLDER [PRESET,VARIANT SEED:CASE]...");
  for (int i = 4; i + 1 < argc; i += 2) {
    const std::string which = argv[i + 1];
    const std::size_t colon = which.find(':');
    if (colon == which.npos) throw std::invalid_argument(which + ": expected SEED:CASE");
    Finding finding(argv[i], std::stoull(argv[1]), argv[3]);
    std::cout << finding
                     .shrink(std::stoull(which.substr(0, colon)), std::stoull(which.substr(colon + 1)),
                             std::stod(argv[2]))
                     .dump()
              << std::endl;
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "shrink_rates: " << error.what() << "\n";
  return 2;
}
