// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-campaign: plants defects at random places in meshes and counts how often the judge finds them.
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "corpus/block_mesh.hpp"
#include "corpus/generators/random.hpp"
#include "corpus/plant.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"
#include "scaled.hpp"
#include "score.hpp"
#include "verify/verify.hpp"

namespace {

using namespace tetproof;

// Where the meshes are put: as they are, in size 4 around 1e6, in size 1e-9 around 0.
constexpr std::array places{"as it is", "far", "tiny"};

TetMesh placed(const TetMesh& mesh, std::size_t place) {
  if (place == 0 || mesh.points.empty()) return mesh;
  Eigen::Vector3d low = mesh.points.at(0), high = low;
  for (const Eigen::Vector3d& p : mesh.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double diagonal = (high - low).norm();
  return place == 1 ? corpus::moved(mesh, 4 / diagonal, {1e6, -0.9e6, 1.1e6})
                    : corpus::moved(mesh, 1e-9 / diagonal, {0, 0, 0});
}

TetMesh mesh_named(const std::string& name) {
  if (name == "block") return corpus::block_mesh({6, 5, 4});
  if (name == "jittered") return corpus::block_mesh({6, 5, 4}, 0.1);
  if (name == "ball") return corpus::ball_mesh(5, 0.1);
  return tet_mesh(read_document(name));
}

struct Case {
  std::size_t mesh, place, kind;
  std::uint64_t seed;
};

struct Result {
  bool planted = false;
  std::string objection;
};

struct Score {
  int planted = 0, found = 0, discarded = 0;
};

std::string replay(const Case& c, const std::vector<std::string>& names) {
  return fmt::format("--replay {} --place {} --kind {} --mesh {}", c.seed, c.place,
                     corpus::plant_kinds()[c.kind].id, names[c.mesh]);
}

// What is wrong with the verdict on the planted mesh at another scale, along one axis, or without some of the
// checks that the certificate does not need.
std::string objection_elsewhere(const corpus::Planted& planted, std::uint64_t seed) {
  corpus::Random random(seed);
  const auto power = [&] { return random.below(1951) - 1000; };
  const int all = power();
  if (const auto mesh = test::scaled(planted.mesh, {all, all, all}))
    if (const std::string text = test::objection(planted, verify::verify(*mesh, {.quality = false}));
        !text.empty())
      return fmt::format("times 2^{}: {}", all, text);
  std::array<int, 3> axes{};
  axes[static_cast<std::size_t>(random.below(3))] = power();
  verify::Options options{.quality = false};
  for (int c = 0; c < verify::check_count; ++c)
    if (const auto& row = verify::info(static_cast<verify::Check>(c));
        !row.certificate && random.below(2) == 1)
      options.skip.emplace_back(row.id);
  if (const auto mesh = test::scaled(planted.mesh, axes))
    if (const verify::Report report = verify::verify(*mesh, options);
        report.certificate != planted.truth.valid())
      return fmt::format("times 2^{} 2^{} 2^{}, without {}: the certificate is wrong", axes[0], axes[1],
                         axes[2], fmt::join(options.skip, ","));
  return "";
}

struct Options {
  int cases = 1000;
  std::uint64_t seed = 1;
  std::vector<std::string> meshes, kinds;
  std::string write;
  std::optional<std::uint64_t> replay;
  std::size_t place = 0;
  bool scales = false;
};

// One ground for each mesh and place where rounding leaves it valid.
std::vector<std::unique_ptr<corpus::Ground>> grounds(const std::vector<std::string>& names,
                                                     const std::vector<TetMesh>& meshes, int& wrong) {
  std::vector<std::unique_ptr<corpus::Ground>> all(meshes.size() * places.size());
  std::vector<std::string> said(all.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    TetMesh mesh = placed(meshes[i / places.size()], i % places.size());
    if (mesh.tets.size() < 6) {
      said[i] = "not used: hardly a tetrahedron";
      return;
    }
    const corpus::Truth truth = corpus::truth(mesh);
    if (!truth.valid()) {
      said[i] = fmt::format("not used: {} negative, {} flat, {} pairs overlap or touch",
                            truth.negative.size(), truth.flat.size(),
                            truth.overlaps.size() + truth.touches.size() + truth.crossings.size());
      if (sound(verify::verify(mesh, {.quality = false}))) said[i] = "MISSED by the judge: " + said[i];
      return;
    }
    if (const std::string objection =
            test::objection_to_sound(truth, verify::verify(mesh, {.quality = false}));
        !objection.empty())
      said[i] = "FALSE ALARM: " + objection;
    else
      all[i] = std::make_unique<corpus::Ground>(std::move(mesh));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!said[i].empty())
      fmt::print("{}, {}: {}\n", names[i / places.size()], places[i % places.size()], said[i]);
    wrong += said[i].starts_with("FALSE") || said[i].starts_with("MISSED");
  }
  return all;
}

int campaign(const Options& options) {
  std::vector<std::string> names = options.meshes;
  std::vector<TetMesh> meshes;
  for (const std::string& name : names) meshes.push_back(mesh_named(name));
  int wrong = 0;
  const auto ground = grounds(names, meshes, wrong);

  const auto& kinds = corpus::plant_kinds();
  std::vector<std::size_t> asked;
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (options.kinds.empty() || std::count(options.kinds.begin(), options.kinds.end(), kinds[k].id))
      asked.push_back(k);
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < ground.size(); ++i)
    if (ground[i] && (!options.replay || i % places.size() == options.place)) usable.push_back(i);
  if (asked.empty() || usable.empty()) throw InputError("nothing to plant, or nothing to plant it in");

  std::vector<Case> cases;
  corpus::Random random(options.seed);
  for (int i = 0; i < (options.replay ? 1 : options.cases); ++i) {
    const std::size_t where = usable[static_cast<std::size_t>(random.below(static_cast<int>(usable.size())))];
    cases.push_back(
        {where / places.size(), where % places.size(), asked[static_cast<std::size_t>(i) % asked.size()],
         options.replay
             ? *options.replay
             : static_cast<std::uint64_t>(options.seed * 1000003 + static_cast<std::uint64_t>(i))});
  }
  std::vector<Result> results(cases.size());
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    const Case& c = cases[i];
    const auto planted = corpus::plant(kinds[c.kind], *ground[c.mesh * places.size() + c.place], c.seed);
    if (!planted) return;
    const verify::Report report = verify::verify(planted->mesh, {.quality = false});
    results[i] = {true, test::objection(*planted, report)};
    if (options.scales && results[i].objection.empty())
      results[i].objection = objection_elsewhere(*planted, c.seed);
    if (!options.write.empty()) write_document(options.write, document_of(planted->mesh));
    if (options.replay) fmt::print("{}\nplanted tetrahedra:", report_text(report));
    if (options.replay) {
      for (const Index t : planted->tets) fmt::print(" {}", t);
      fmt::print("\nvertices:");
      for (const Index v : planted->vertices) fmt::print(" {}", v);
      fmt::print("\n");
    }
  });

  std::map<std::size_t, Score> scores;
  int failures = 0, planted = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Score& score = scores[cases[i].kind];
    score.planted += results[i].planted;
    score.discarded += !results[i].planted;
    score.found += results[i].planted && results[i].objection.empty();
    planted += results[i].planted;
    if (results[i].objection.empty()) continue;
    if (++failures <= 200) fmt::print("FAILED {}: {}\n", replay(cases[i], names), results[i].objection);
  }
  for (const std::size_t kind : asked) {
    const Score& score = scores[kind];
    fmt::print("{:40} {:5} of {:5}{}{}\n", kinds[kind].id, score.found, score.planted,
               score.found < score.planted ? "  MISSED" : "",
               score.discarded ? fmt::format("  ({} found no place)", score.discarded) : "");
  }
  fmt::print(
      "{} of {} right, {:.3f} %; {} kinds, {} meshes in up to {} places, {} sound ones judged wrongly; seed "
      "{}\n",
      planted - failures, planted, planted ? 100.0 * (planted - failures) / planted : 0.0, asked.size(),
      meshes.size(), places.size(), wrong, options.seed);
  return failures + wrong > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  int threads = 0;
  CLI::App app(
      "Plants defects in sound meshes at random places, and counts how often the judge finds them with a "
      "right root cause");
  app.add_option("--cases", options.cases, "how many")->capture_default_str();
  app.add_option("--seed", options.seed, "same seed, same cases")->capture_default_str();
  app.add_option("--mesh", options.meshes, "files, or: block, jittered, ball")->required();
  app.add_option("--kind", options.kinds, "only these");
  app.add_option("--replay", options.replay, "one case, as a failure's line gives it");
  app.add_option("--place", options.place, "of that case");
  app.add_option("--write", options.write, "a file for its mesh");
  app.add_flag("--scales", options.scales,
               "judge each mesh once more at a random power of two, and along one axis without some checks");
  app.add_option("--threads", threads, "default: all");
  CLI11_PARSE(app, argc, argv);
  std::unique_ptr<tbb::global_control> limit;
  if (threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, threads);
  try {
    return campaign(options);
  } catch (const InputError& error) {
    fmt::print(stderr, "tetproof-campaign: {}\n", error.what());
    return 2;
  }
}
