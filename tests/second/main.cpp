// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-second: the second implementation by hand, with or without a planted mistake.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "tests/second/second.hpp"

int main(int argc, char** argv) {
  using namespace tetproof;
  CLI::App app("The paper a second time, naively. For tests; slow beyond some thousand tetrahedra.");
  std::string surface, region = "inside", diagonals = "lowest", points = "auto", improve = "solid-angle",
                       mistake, file;
  second::Settings settings;
  std::vector<int> cells{6};
  app.add_option("SURFACE", surface, "a file or a specification")->required();
  app.add_option("--cells", cells, "one number, or three")->delimiter(',')->allow_extra_args(false);
  app.add_option("--region", region)->check(CLI::IsMember({"inside", "outside"}));
  app.add_option("--box-scale", settings.box_scale);
  app.add_option("--on-surface", settings.on_surface);
  app.add_option("--diagonals", diagonals)->check(CLI::IsMember({"lowest", "shortest"}));
  app.add_flag("--literal", settings.literal);
  app.add_option("--points", points, "a number, or auto");
  app.add_option("--v0", settings.v0);
  app.add_option("--v1", settings.v1);
  app.add_option("--d1", settings.d1);
  app.add_option("--p", settings.p);
  app.add_flag("--past-dilution", settings.past_dilution);
  app.add_flag("--curvature", settings.curvature);
  app.add_option("--improve", improve)->check(CLI::IsMember({"solid-angle", "aspect-ratio", "none"}));
  app.add_option("--improve-below", settings.improve_below);
  std::vector<std::string> names;
  for (const auto& m : second::mistakes()) names.push_back(m.name);
  app.add_option("--mistake", mistake)->check(CLI::IsMember(names));
  app.add_option("--trace", file)->required();
  CLI11_PARSE(app, argc, argv);

  settings.outside = region == "outside";
  settings.shortest_diagonals = diagonals == "shortest";
  settings.improve = improve == "none"          ? second::Quality::none
                     : improve == "solid-angle" ? second::Quality::solid_angle
                                                : second::Quality::aspect_ratio;
  for (const auto& m : second::mistakes())
    if (mistake == m.name) settings.mistake = m.mistake;
  try {
    if (points != "auto") settings.insertions = std::stoi(points);
    settings.cells =
        cells.size() == 3 ? std::array{cells[0], cells[1], cells[2]} : std::array{cells.at(0), 0, 0};
    const second::Run run = second::run(corpus::open_surface(surface), settings, surface);
    std::ofstream out(file);
    for (const auto& record : run.records) out << trace::to_line(record) << '\n';
    std::cout << trace::to_line(run.records.back()) << '\n';
    return out.flush() ? 0 : 3;
  } catch (const InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "tetproof-second: " << error.what() << '\n';
    return 3;
  }
}
