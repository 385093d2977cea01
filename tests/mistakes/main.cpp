// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-mistaken: writes the trace of an implementation that makes a mistake.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <map>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "tests/mistakes/mistaken.hpp"

int main(int argc, char** argv) {
  using namespace tetproof;
  using reference::AdaptOptions, reference::Criterion, reference::Diagonals, reference::Options,
      reference::Region;
  CLI::App app(
      "The page (reference/paper) with a planted mistake. For tests; slow beyond some thousand "
      "tetrahedra.");
  std::string surface, points = "auto", file;
  Options options;
  AdaptOptions adapt;
  auto mistake = mistakes::Mistake::none;
  std::vector<int> cells{6};
  const std::map<std::string, Region> regions{{"inside", Region::inside}, {"outside", Region::outside}};
  const std::map<std::string, Diagonals> diagonals{{"lowest", Diagonals::lowest},
                                                   {"shortest", Diagonals::shortest}};
  const std::map<std::string, Criterion> criteria{{"solid-angle", Criterion::solid_angle},
                                                  {"aspect-ratio", Criterion::aspect_ratio},
                                                  {"none", Criterion::none}};
  const std::map<std::string, bool> on_off{{"on", true}, {"off", false}};
  std::map<std::string, mistakes::Mistake> names;
  for (const auto& [which, name] : mistakes::mistakes()) names[name] = which;
  app.add_option("SURFACE", surface, "a file or a specification")->required();
  app.add_option("--mistake", mistake, "none if not given")->transform(CLI::CheckedTransformer(names));
  app.add_option("--trace", file, "the trace to write")->required();
  app.add_option("--cells", cells, "one number, or three")->delimiter(',')->allow_extra_args(false);
  app.add_option("--region", options.region)->transform(CLI::CheckedTransformer(regions));
  app.add_option("--box-scale", options.box_scale);
  app.add_option("--on-surface", options.on_surface);
  app.add_option("--diagonals", options.diagonals)->transform(CLI::CheckedTransformer(diagonals));
  app.add_flag("--literal", options.literal);
  app.add_option("--parametric", options.parametric)->transform(CLI::CheckedTransformer(on_off));
  app.add_option("--points", points, "a number, or auto");
  app.add_option("--v0", adapt.v0.value);
  app.add_option("--v1", adapt.v1.value);
  app.add_option("--d1", adapt.d1);
  app.add_option("--p", adapt.p);
  app.add_option("--e-avg", adapt.e_avg.value);
  app.add_flag("--past-dilution", adapt.past_dilution);
  app.add_flag("--curvature", adapt.curvature);
  app.add_option("--improve", adapt.improve)->transform(CLI::CheckedTransformer(criteria));
  app.add_option("--improve-below", adapt.improve_below);
  CLI11_PARSE(app, argc, argv);

  try {
    if (points != "auto") adapt.points = std::stoll(points);
    if (adapt.points != 0) options.adapt = adapt;
    options.cells =
        cells.size() == 3 ? std::array{cells[0], cells[1], cells[2]} : std::array{cells.at(0), 0, 0};
    auto records = mistakes::run(corpus::open_surface(surface), options, mistake);
    auto& settings = std::get<trace::Settings>(records.front());
    settings.program = "tetproof-mistaken";
    settings.surface = surface;
    std::ofstream out(file);
    for (const trace::Record& record : records) out << trace::to_line(record) << '\n';
    std::cout << trace::to_line(records.back()) << '\n';
    return out.flush() ? 0 : 3;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "tetproof-mistaken: " << error.what() << '\n';
    return 3;
  }
}
