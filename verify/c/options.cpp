// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/c/options.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "io/error.hpp"
#include "verify/c/boundary.hpp"

namespace tetproof::c {
namespace {

template <class Options>
Options zeroed() {
  Options options;
  std::memset(&options, 0, sizeof options);  // padding too, so that copies are equal byte for byte
  options.size = sizeof options;
  return options;
}

tetproof_judge_options judge_defaults() {
  const verify::Options usual;
  auto options = zeroed<tetproof_judge_options>();
  options.region = TETPROOF_REGION_DEFAULT;
  options.voxels = usual.voxels;
  options.fidelity = usual.fidelity;
  options.quality = usual.quality;
  return options;
}

tetproof_mesh_options mesh_defaults() {
  const reference::Options usual;
  const reference::AdaptOptions adapt;
  auto options = zeroed<tetproof_mesh_options>();
  options.region = TETPROOF_REGION_INSIDE;
  options.box_scale = usual.box_scale;
  options.on_surface = usual.on_surface;
  options.parametric = usual.parametric;
  options.points = TETPROOF_POINTS_AUTO;
  options.v0 = adapt.v0.value;
  options.v1 = adapt.v1.value;
  options.e_avg = adapt.e_avg.value;
  options.d1 = adapt.d1;
  options.p = adapt.p;
  options.improve_below = adapt.improve_below;
  return options;
}

tetproof_write_options write_defaults() {
  return zeroed<tetproof_write_options>();
}

void check_size(std::size_t size, std::size_t own, const char* type) {
  if (size != own)
    refuse_argument(fmt::format("the size of {} is {}, expected {}, that of version {}", type, size, own,
                                TETPROOF_VERSION_STRING));
}

template <class Options>
void fill(Options* options, std::size_t size, const char* type, const Options& defaults) {
  check_size(size, sizeof(Options), type);
  needed(options, "options") = defaults;
}

std::int32_t in_range(const char* name, std::int32_t value, std::int32_t least, std::int32_t most) {
  if (value < least || value > most)
    refuse_argument(fmt::format("{} is {}, expected {} to {}", name, value, least, most));
  return value;
}

bool truth(const char* name, std::int32_t value) {
  return in_range(name, value, 0, 1) == 1;
}

std::string text(const char* text) {
  return text ? text : "";
}

// The words between commas.
std::vector<std::string> listed(const char* name, const char* list) {
  std::vector<std::string> ids;
  const std::string all = text(list);
  for (std::size_t at = 0; !all.empty() && at <= all.size();) {
    const std::size_t end = std::min(all.find(',', at), all.size());
    ids.push_back(all.substr(at, end - at));
    at = end + 1;
    try {
      verify::check_of_id(ids.back());
    } catch (const InputError& error) {
      refuse_argument(fmt::format("{}: {}", name, error.what()));
    }
  }
  return ids;
}

verify::Region judged_region(std::int32_t region, bool has_surface) {
  switch (region) {
    case TETPROOF_REGION_DEFAULT:
      return has_surface ? verify::Region::inside : verify::Region::none;
    case TETPROOF_REGION_NONE:
      return verify::Region::none;
    case TETPROOF_REGION_INSIDE:
    case TETPROOF_REGION_OUTSIDE:
      if (!has_surface) refuse_argument("region is inside or outside, which needs a surface");
      return region == TETPROOF_REGION_INSIDE ? verify::Region::inside : verify::Region::outside;
    default:
      refuse_argument(fmt::format("region is {}, expected one of TETPROOF_REGION_...", region));
  }
}

verify::Deadline deadline_in(double seconds) {
  if (!(seconds >= 0) || !std::isfinite(seconds))
    refuse_argument(fmt::format("deadline is {}, expected seconds, 0 or more", seconds));
  if (seconds == 0) return {};
  using Clock = std::chrono::steady_clock;
  const double most = 1e8;  // three years: later times would not fit into the clock's numbers
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, most)));
}

reference::Criterion criterion(std::int32_t improve) {
  switch (in_range("improve", improve, TETPROOF_IMPROVE_SOLID_ANGLE, TETPROOF_IMPROVE_NONE)) {
    case TETPROOF_IMPROVE_SOLID_ANGLE:
      return reference::Criterion::solid_angle;
    case TETPROOF_IMPROVE_ASPECT_RATIO:
      return reference::Criterion::aspect_ratio;
    default:
      return reference::Criterion::none;
  }
}

reference::AdaptOptions adapt_options(const tetproof_mesh_options& given) {
  reference::AdaptOptions adapt;
  adapt.points = given.points == TETPROOF_POINTS_AUTO ? reference::AdaptOptions::automatic : given.points;
  adapt.v0 = {given.v0, truth("v0_is_absolute", given.v0_is_absolute)};
  adapt.v1 = {given.v1, truth("v1_is_absolute", given.v1_is_absolute)};
  adapt.e_avg = {given.e_avg, truth("e_avg_is_absolute", given.e_avg_is_absolute)};
  adapt.d1 = given.d1;
  adapt.p = given.p;
  adapt.past_dilution = truth("past_dilution", given.past_dilution);
  adapt.curvature = truth("curvature", given.curvature);
  adapt.improve = criterion(given.improve);
  adapt.improve_below = given.improve_below;
  return adapt;
}

}  // namespace

JudgeOptions checked(const tetproof_judge_options* options, bool has_surface) {
  const tetproof_judge_options given = options ? *options : judge_defaults();
  check_size(given.size, sizeof given, "tetproof_judge_options");
  JudgeOptions result;
  verify::Options& judge = result.options;
  judge.region = judged_region(given.region, has_surface);
  if (!(given.fidelity >= 0) || !std::isfinite(given.fidelity))
    refuse_argument(fmt::format("fidelity is {}, expected a number, 0 or more", given.fidelity));
  judge.fidelity = given.fidelity;
  judge.voxels = in_range("voxels", given.voxels, 0, 1024);
  judge.strict_topology = truth("strict_topology", given.strict_topology);
  judge.coarse = truth("coarse", given.coarse);
  judge.decide_only = truth("decide_only", given.decide_only);
  judge.only_tets = truth("only_tets", given.only_tets);
  judge.quality = truth("quality", given.quality);
  judge.timings = truth("timings", given.timings);
  judge.check = listed("check", given.check);
  judge.skip = listed("skip", given.skip);
  judge.allow = listed("allow", given.allow);
  for (const std::string& id : judge.allow)
    if (id != "crack" && id != "non-conforming-interface")
      refuse_argument(
          fmt::format("allow: findings of {} cannot be meant, only those of crack and "
                      "non-conforming-interface",
                      id));
  result.region_kind = text(given.region_kind);
  const std::initializer_list<std::string_view> kinds{"", "physical", "entity", "attribute", "reference"};
  if (std::find(kinds.begin(), kinds.end(), result.region_kind) == kinds.end())
    refuse_argument(fmt::format("region_kind is '{}', expected physical, entity, attribute or reference",
                                result.region_kind));
  result.threads = in_range("threads", given.threads, 0, 4096);
  judge.deadline = deadline_in(given.deadline);  // last, since its time begins here
  return result;
}

MeshOptions checked(const tetproof_mesh_options* options) {
  const tetproof_mesh_options given = options ? *options : mesh_defaults();
  check_size(given.size, sizeof given, "tetproof_mesh_options");
  MeshOptions result;
  reference::Options& mesh = result.options;
  if (given.region != TETPROOF_REGION_INSIDE && given.region != TETPROOF_REGION_OUTSIDE)
    refuse_argument(fmt::format("region is {}, expected TETPROOF_REGION_INSIDE or _OUTSIDE", given.region));
  mesh.region =
      given.region == TETPROOF_REGION_INSIDE ? reference::Region::inside : reference::Region::outside;
  mesh.raise_cells = given.cells[0] == 0 && given.cells[1] == 0 && given.cells[2] == 0;
  if (!mesh.raise_cells) mesh.cells = {given.cells[0], given.cells[1], given.cells[2]};
  mesh.box_scale = given.box_scale;
  mesh.on_surface = given.on_surface;
  mesh.diagonals = in_range("diagonals", given.diagonals, TETPROOF_DIAGONALS_LOWEST,
                            TETPROOF_DIAGONALS_SHORTEST) == TETPROOF_DIAGONALS_LOWEST
                       ? reference::Diagonals::lowest
                       : reference::Diagonals::shortest;
  mesh.literal = truth("literal", given.literal);
  mesh.parametric = truth("parametric", given.parametric);
  result.threads = in_range("threads", given.threads, 0, 4096);
  const verify::Deadline deadline = deadline_in(given.deadline);
  if (deadline) {
    mesh.listener.phase = [deadline](std::string_view) { verify::keep(deadline); };
    mesh.listener.after_step = [deadline](const reference::WeightedGrid&) { verify::keep(deadline); };
  }
  const reference::AdaptOptions adapt = adapt_options(given);
  try {
    reference::check(adapt);
    if (adapt.points != 0) mesh.adapt = adapt;
    reference::check(mesh);
  } catch (const InputError& error) {
    refuse_argument(error.what());
  }
  return result;
}

StrictWriteOptions checked(const tetproof_write_options* options) {
  const tetproof_write_options given = options ? *options : write_defaults();
  check_size(given.size, sizeof given, "tetproof_write_options");
  StrictWriteOptions result;
  result.options.format = text(given.format);
  if (!result.options.format.empty()) format_named(result.options.format);
  in_range("encoding", given.encoding, TETPROOF_ENCODING_DEFAULT, TETPROOF_ENCODING_BINARY);
  if (given.encoding != TETPROOF_ENCODING_DEFAULT)
    result.options.binary = given.encoding == TETPROOF_ENCODING_BINARY;
  result.strict = in_range("strict", given.strict, TETPROOF_STRICT_OFF, TETPROOF_STRICT_NATIVE);
  return result;
}

ReadOptions read_options(const char* format) {
  ReadOptions options{text(format)};
  if (!options.format.empty()) format_named(options.format);
  return options;
}

}  // namespace tetproof::c

using namespace tetproof::c;

tetproof_status tetproof_judge_options_init(tetproof_judge_options* options, size_t size,
                                            tetproof_error* error) {
  return guarded(error, [&] { fill(options, size, "tetproof_judge_options", judge_defaults()); });
}

tetproof_status tetproof_mesh_options_init(tetproof_mesh_options* options, size_t size,
                                           tetproof_error* error) {
  return guarded(error, [&] { fill(options, size, "tetproof_mesh_options", mesh_defaults()); });
}

tetproof_status tetproof_write_options_init(tetproof_write_options* options, size_t size,
                                            tetproof_error* error) {
  return guarded(error, [&] { fill(options, size, "tetproof_write_options", write_defaults()); });
}
