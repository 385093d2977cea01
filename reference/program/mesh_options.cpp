// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/program/mesh_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "io/error.hpp"
#include "io/program/mesh_formats.hpp"

namespace tetproof::reference {
namespace {

void declare_adaptation(CLI::App& app, Arguments& a) {
  const std::map<std::string, Criterion> criteria{{"solid-angle", Criterion::solid_angle},
                                                  {"aspect-ratio", Criterion::aspect_ratio},
                                                  {"none", Criterion::none}};
  const std::map<std::string, bool> on_off{{"on", true}, {"off", false}};
  app.add_option("--points", a.points,
                 "the largest number of points to insert; auto: insert until no split lowers E_avg; 0: only "
                 "the first grid")
      ->type_name("N|auto|0");
  app.add_option("--v0", a.v0,
                 "eq. (3.1): the volume at distance 0, in mean volumes of the first grid, or abs:X")
      ->type_name("F");
  app.add_option("--v1", a.v1, "eq. (3.1): the volume at distance d1, in the same unit")->type_name("F");
  app.add_option("--d1", a.adapt.d1,
                 "eq. (3.1): a distance; if not given, the largest distance in the first grid")
      ->check(CLI::PositiveNumber)
      ->type_name("L")
      ->always_capture_default(false);
  app.add_option("--p", a.adapt.p, "eq. (3.1): the exponent")->type_name("P");
  app.add_option("--e-avg", a.e_avg, "stop when E_avg is not larger than this, in the unit of --v0")
      ->type_name("F");
  app.add_flag("--past-dilution", a.adapt.past_dilution,
               "go on even if the chosen tetrahedron is not larger than it should be; needs --points N");
  app.add_option("--parametric", a.options.parametric,
                 "follow the surface's parametric definition, if it has one")
      ->transform(CLI::CheckedTransformer(on_off))
      ->option_text("on|off [on]");
  app.add_flag("--curvature", a.adapt.curvature, "weight the distance by the surface's curvature, eq. (3.6)");
  app.add_option("--improve", a.adapt.improve, "the measure that flips raise, section 4")
      ->transform(CLI::CheckedTransformer(criteria))
      ->option_text("solid-angle|aspect-ratio|none [solid-angle]");
  app.add_option("--improve-below", a.adapt.improve_below,
                 "improve after an insertion that made a solid angle smaller than this part of 4 pi")
      ->type_name("S");
  app.add_option(
         "--follow", a.options.follow,
         "replay another implementation's decisions and check each; stop at the first that is not admissible")
      ->type_name("OTHER.jsonl")
      ->check(CLI::ExistingFile)
      ->always_capture_default(false);
  app.add_option("--trace", a.trace,
                 "write every decision as a line of JSON, for tetproof-compare; - is standard output")
      ->type_name("FILE.jsonl");
}

void declare_figure(CLI::App& app, Arguments& a) {
  const std::map<std::string, FigureColour> colours{{"volume", FigureColour::volume},
                                                    {"quality", FigureColour::quality}};
  CLI::Option* const figure =
      app.add_option(
             "--figure", a.figure,
             "draw the grid as in the paper's figures 3 to 6: a plane's cut, or, with --view, the grid cut "
             "open; - is standard output")
          ->type_name("FILE.svg")
          ->always_capture_default(false);
  app.add_option(
         "--view", a.view,
         "draw the whole tetrahedra behind the plane, seen from the direction X,Y,Z or from 3d, a view of "
         "three sides")
      ->type_name("3d|X,Y,Z")
      ->always_capture_default(false)
      ->needs(figure);
  app.add_option(
         "--plane", a.plane,
         "the figure's plane: x=0; x alone for the middle of the axis; a,b,c,d for ax + by + cz = d; if not "
         "given, x, or with --view the axis nearest to it")
      ->type_name("PLANE")
      ->always_capture_default(false)
      ->needs(figure);
  app.add_option("--title", a.title, "the figure's title; if not given, it names the surface")
      ->type_name("TEXT")
      ->always_capture_default(false)
      ->needs(figure);
  app.add_option("--colour", a.colour, "what the figure's colours show: volumes or the smallest solid angles")
      ->transform(CLI::CheckedTransformer(colours))
      ->option_text("volume|quality [volume]")
      ->needs(figure);
}

// Parses "24" or "24,12,12".
std::array<int, 3> parse_cells(const std::string& text) {
  std::array<int, 3> cells{};
  std::size_t n = 0, at = 0;
  for (; n < 3; ++n) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string word = text.substr(at, comma - at);
    if (word.empty() || word.size() > 8 || word.find_first_not_of("0123456789") != std::string::npos) break;
    cells[n] = std::stoi(word);
    at = comma + 1;
    if (comma == text.size()) {
      ++n;
      break;
    }
  }
  if (at != text.size() + 1 || n == 2 || std::count(cells.begin(), cells.begin() + n, 0) > 0)
    throw InputError(fmt::format(
        "--cells: expected one positive number or three, as in 24 or 24,12,12, found '{}'", text));
  return cells;
}

// Parses "0.2" or "abs:0.001".
VolumeSetting parse_volume(std::string_view option, std::string_view text) {
  VolumeSetting setting{0};
  std::string_view number = text;
  if (number.starts_with("abs:")) {
    setting.absolute = true;
    number.remove_prefix(4);
  }
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), setting.value);
  if (error != std::errc() || end != number.data() + number.size())
    throw InputError(fmt::format("{}: expected a number, as in 0.2, or abs:0.001, found '{}'", option, text));
  return setting;
}

std::int64_t parse_points(std::string_view text) {
  if (text == "auto") return AdaptOptions::automatic;
  std::int64_t points = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), points);
  if (error != std::errc() || end != text.data() + text.size() || points < 0)
    throw InputError(fmt::format("--points: expected a number or auto, found '{}'", text));
  return points;
}

}  // namespace

void declare_options(CLI::App& app, Arguments& a) {
  const std::map<std::string, Region> regions{{"inside", Region::inside}, {"outside", Region::outside}};
  const std::map<std::string, Engine> engines{{"paper", Engine::paper}, {"fast", Engine::fast}};
  const std::map<std::string, Diagonals> diagonals{{"lowest", Diagonals::lowest},
                                                   {"shortest", Diagonals::shortest}};
  app.add_option("SURFACE", a.surface,
                 fmt::format("a closed surface: a file, or a generated one (--list-surfaces); - is standard "
                             "input. Endings: {}",
                             fmt::join(known_endings(), " ")));
  app.add_option("-o,--output", a.grid,
                 "the grid to write, in the format that its ending says; never an input. Endings: " +
                     program::grid_endings_written())
      ->type_name("GRID")
      ->always_capture_default(false);
  app.add_option(
         "--from", a.read.format,
         "read SURFACE as this format, whatever its ending and content say: " + program::format_names())
      ->type_name("FORMAT");
  app.add_option(
         "--reduce", a.reduce,
         "first reduce the surface to at most N triangles; the reduced surface is judged as any other")
      ->check(CLI::Range(4, std::numeric_limits<int>::max()))
      ->type_name("N")
      ->option_text("N");
  app.add_option(
         "--save-surface", a.save_surface,
         "write the surface as used: generated, reduced or read; .obj holds its (u,v), too. Endings: " +
             fmt::format("{}", fmt::join(known_endings(), " ")))
      ->type_name("FILE")
      ->always_capture_default(false);
  app.add_option(
         "--engine", a.options.engine,
         "fast; or paper: the method as the paper's text has it, by brute force, with the same decisions")
      ->transform(CLI::CheckedTransformer(engines))
      ->option_text("paper|fast [fast]");
  app.add_option("--region", a.options.region, "fill the inside, or the outside up to the scaled box")
      ->transform(CLI::CheckedTransformer(regions))
      ->option_text("inside|outside [inside]");
  app.add_option(
         "--cells", a.cells,
         fmt::format(
             "lattice cells along the longest side, or along each; if not given, 24, or twice as many "
             "up to {} until the grid of a thin surface is not empty",
             Options::most_cells))
      ->type_name("N|NX,NY,NZ")
      ->always_capture_default(false);
  app.add_option("--box-scale", a.options.box_scale,
                 "the size of the lattice's box over that of the surface's box, more than 1")
      ->type_name("S");
  app.add_option("--on-surface", a.options.on_surface,
                 "lattice vertices that are closer to the surface than this move onto it; in shortest cell "
                 "edges, 0 to "
                 "0.15")
      ->type_name("T");
  app.add_option("--diagonals", a.options.diagonals,
                 "which diagonal cuts a quadrilateral that two tetrahedra share")
      ->transform(CLI::CheckedTransformer(diagonals))
      ->option_text("lowest|shortest [lowest]");
  app.add_flag("--literal", a.options.literal,
               "as printed in the paper: case 5 always kept, --on-surface 0, rounding reported and not "
               "mended, a mean over L+3 "
               "tetrahedra in eq. (3.5)");
  declare_adaptation(app, a);
  declare_figure(app, a);
  app.add_option(
         "--html", a.html,
         "write a page for any browser, without a network: the grid in three dimensions, what the judge "
         "says of it, and how it was made; - is standard output")
      ->type_name("FILE.html")
      ->always_capture_default(false);
  app.add_option(
         "--voxels", a.voxels,
         "voxels along the longest side for the second, independent measurement of the volume; 0: none")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  app.add_flag("--ascii", a.ascii, "write text, if the format has both");
  app.add_flag("--binary", a.binary, "write binary, if the format has both")->excludes("--ascii");
  app.add_flag("--timings", a.timings,
               "print the seconds that each phase took, on standard error and in the JSON");
  app.add_flag("--list-surfaces", a.list_surfaces, "print the generated surfaces with their parameters");
}

Options generate_options(const Arguments& a) {
  Options options = a.options;
  options.raise_cells = a.cells.empty();
  if (!a.cells.empty()) options.cells = parse_cells(a.cells);
  AdaptOptions adapt = a.adapt;
  adapt.points = parse_points(a.points);
  adapt.v0 = parse_volume("--v0", a.v0);
  adapt.v1 = parse_volume("--v1", a.v1);
  adapt.e_avg = parse_volume("--e-avg", a.e_avg);
  check(adapt);
  if (adapt.points != 0) options.adapt = adapt;
  return options;
}

FigureOptions figure_options(const Arguments& a, const TriangleSurface& surface) {
  FigureOptions options{.colour = a.colour};
  if (a.view) options.view = parse_view(*a.view);
  options.plane = !a.plane && options.view ? plane_for_view(*options.view, surface)
                                           : parse_plane(a.plane.value_or("x"), surface);
  const std::string name = a.surface.substr(a.surface.find_last_of('/') + 1);
  const char* const where = a.options.region == Region::inside ? "inside" : "around";
  options.title = a.title.value_or(fmt::format("Unstructured grid {} {}", where, name));
  return options;
}

}  // namespace tetproof::reference
