// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/program/check_trace.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <optional>
#include <utility>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "io/trace.hpp"
#include "reference/generate.hpp"
#include "verify/surface.hpp"

namespace tetproof::verify {
namespace {

// What a trace says of the run that made it, with the lines.
struct Run {
  trace::Settings settings;
  std::optional<trace::Lattice> lattice;
  std::optional<trace::FirstGrid> first_grid;
  std::int64_t settings_line = 0, lattice_line = 0, first_grid_line = 0;
};

// A trace that asks for what no run can be asked for.
struct OutOfRange {
  std::string what;
  std::int64_t line;
};

Run read_run(const std::string& path) {
  Run run;
  trace::Reader reader(path);
  while (const auto record = reader.next()) {
    if (const auto* settings = std::get_if<trace::Settings>(&*record))
      run.settings = *settings, run.settings_line = reader.line();
    if (const auto* lattice = std::get_if<trace::Lattice>(&*record))
      run.lattice = *lattice, run.lattice_line = reader.line();
    if (const auto* first = std::get_if<trace::FirstGrid>(&*record))
      run.first_grid = *first, run.first_grid_line = reader.line();
  }
  return run;
}

// The options of the run. Throws OutOfRange.
reference::Options options_of(const Run& run, const std::string& path) {
  using reference::AdaptOptions, reference::Criterion, reference::Diagonals, reference::Options;
  const trace::Settings& s = run.settings;
  Options options;
  options.region = s.region == "outside" ? reference::Region::outside : reference::Region::inside;
  options.box_scale = s.box_scale;
  options.on_surface = s.on_surface;
  options.diagonals = s.diagonals == "shortest" ? Diagonals::shortest : Diagonals::lowest;
  options.literal = s.literal;
  options.parametric = s.parametric;
  const auto check = [&](std::int64_t line) {
    try {
      reference::check(options);
    } catch (const InputError& error) {
      throw OutOfRange{error.what(), line};
    }
  };
  check(run.settings_line);
  options.cells = run.lattice->cells;
  check(run.lattice_line);
  options.follow = path;
  if (s.points == "0") return options;
  AdaptOptions adapt;
  if (s.points != "auto") std::from_chars(s.points.data(), s.points.data() + s.points.size(), adapt.points);
  adapt.p = s.p;
  adapt.past_dilution = s.past_dilution;
  adapt.curvature = s.curvature;
  adapt.improve = s.improve == "none"           ? Criterion::none
                  : s.improve == "aspect-ratio" ? Criterion::aspect_ratio
                                                : Criterion::solid_angle;
  adapt.improve_below = s.improve_below;
  options.adapt = adapt;
  check(run.settings_line);
  if (run.first_grid) {
    options.adapt->v0 = {run.first_grid->v0, true};
    options.adapt->v1 = {run.first_grid->v1, true};
    options.adapt->d1 = run.first_grid->d1;
    options.adapt->e_avg = {run.first_grid->e_avg_goal.value_or(0), true};
    check(run.first_grid_line);
  }
  return options;
}

// The surface that the trace names: where the program runs, or beside the trace.
std::string find_surface(const std::string& named, const std::string& trace) {
  std::error_code ignored;
  if (corpus::is_generated(named) || std::filesystem::exists(named, ignored)) return named;
  const auto beside = std::filesystem::path(trace).parent_path() / named;
  return std::filesystem::exists(beside, ignored) ? beside.string() : "";
}

}  // namespace

reference::Options options_of_trace(const std::string& path) {
  try {
    const Run run = read_run(path);
    if (!run.lattice) throw InputError(path + ": it has no lattice record");
    return options_of(run, path);
  } catch (const OutOfRange& asked) {
    throw InputError(fmt::format("{}:{}: {}", path, asked.line, asked.what));
  }
}

std::optional<TriangleSurface> surface_of_trace(const std::string& path, const std::string& surface_given) {
  if (!surface_given.empty()) return corpus::open_surface_file(surface_given).surface;
  if (!std::filesystem::is_regular_file(path)) return std::nullopt;
  trace::Reader reader(path);
  while (const auto record = reader.next())
    if (const auto* settings = std::get_if<trace::Settings>(&*record)) {
      const std::string name = find_surface(settings->surface, path);
      if (name.empty()) return std::nullopt;
      return corpus::open_surface_file(name).surface;
    }
  return std::nullopt;
}

CheckedTrace check_trace(const std::string& path, const std::string& surface_given,
                         const reference::Listener& listener) {
  CheckedTrace checked;
  const auto cannot = [&](std::string why) {
    checked.cannot = std::move(why);
    return checked;
  };
  const Run run = read_run(path);
  try {
    if (!run.lattice) return cannot("it has no lattice record");
    const std::string name = surface_given.empty() ? find_surface(run.settings.surface, path) : surface_given;
    if (name.empty())
      return cannot(fmt::format("its surface, '{}', is not found; --surface FILE says where it is",
                                run.settings.surface));
    SurfaceFile file = corpus::open_surface_file(name);
    const TriangleSurface& surface = file.surface;
    if (const JudgedSurface judged(surface, std::move(file.numbering)); !judged.report().fault.empty())
      return cannot(name + ": " + judged.report().fault);
    if (run.settings.parametric && !surface.evaluate)
      return cannot(
          fmt::format("it follows a parametric surface, and '{}' has no parametric definition", name));
    reference::Options options = options_of(run, path);
    options.listener = listener;
    const reference::Generation made = reference::generate(surface, options);
    checked.admissible = made.follow->admissible;
    checked.line = made.follow->line;
    checked.what = made.follow->what;
    checked.ties = made.follow->ties;
    checked.not_checked = made.follow->not_checked;
  } catch (const OutOfRange& asked) {
    checked.admissible = false;
    checked.line = asked.line;
    checked.what = asked.what;
  } catch (const InputError& error) {
    if (std::string_view(error.what()).starts_with(path + ":")) throw;  // the trace itself is at fault
    return cannot(error.what());
  }
  return checked;
}

}  // namespace tetproof::verify
