// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/second/testimony.hpp"

#include "tests/support/test_files.hpp"

namespace tetproof::second {
namespace {

std::string write(const test::TestFiles& files, const std::string& name,
                  const std::vector<trace::Record>& records) {
  std::string text;
  for (const trace::Record& record : records) text += trace::to_line(record) + '\n';
  return files.write(name, text);
}

}  // namespace

reference::Options reference_options(const Settings& s) {
  reference::Options options;
  options.region = s.outside ? reference::Region::outside : reference::Region::inside;
  options.cells = s.cells;
  options.box_scale = s.box_scale;
  options.on_surface = s.on_surface;
  options.diagonals = s.shortest_diagonals ? reference::Diagonals::shortest : reference::Diagonals::lowest;
  options.literal = s.literal;
  options.parametric = false;
  if (s.insertions == 0) return options;
  reference::AdaptOptions adapt;
  if (s.insertions > 0) adapt.points = s.insertions;
  adapt.v0 = {s.v0_absolute.value_or(s.v0), s.v0_absolute.has_value()};
  adapt.v1 = {s.v1_absolute.value_or(s.v1), s.v1_absolute.has_value()};
  adapt.d1 = s.d1.value_or(0);
  adapt.p = s.p;
  adapt.past_dilution = s.past_dilution;
  adapt.curvature = s.curvature;
  adapt.improve = s.improve == Quality::none          ? reference::Criterion::none
                  : s.improve == Quality::solid_angle ? reference::Criterion::solid_angle
                                                      : reference::Criterion::aspect_ratio;
  adapt.improve_below = s.improve_below;
  options.adapt = adapt;
  return options;
}

Testimony testify(const TriangleSurface& surface, const Settings& settings) {
  Testimony result;
  result.second = run(surface, settings, "test");
  reference::Options options = reference_options(settings);
  const trace::Settings asked = reference::settings_of(options, static_cast<bool>(surface.evaluate));
  result.reference.push_back(asked);
  options.listener.record = [&](const trace::Record& record) { result.reference.push_back(record); };
  const reference::Generation made = reference::generate(surface, options);

  const test::TestFiles files;
  const std::string second = write(files, "second.jsonl", result.second.records);
  const std::string reference = write(files, "reference.jsonl", result.reference);
  result.comparison = verify::compare_traces(second, reference);
  result.followed = made.adaptation.has_value();
  if (result.followed)
    reference::follow(made.grid, surface, *options.adapt, nullptr, asked, second, {}, result.follow);
  return result;
}

}  // namespace tetproof::second
