// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces for Python: from arrays, files and specifications, random ones; the reference's grids of them; and
// comparisons.
#include <fmt/format.h>

#include <algorithm>

#include "corpus/fuzz_surface.hpp"
#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "io/surface/used_vertices.hpp"
#include "reference/generate.hpp"
#include "verify/compare_grids.hpp"
#include "verify/compare_traces.hpp"
#include "verify/program/check_trace.hpp"
#include "verify/program/compare_inputs.hpp"
#include "verify/python/interface.hpp"

namespace tetproof::python {
namespace {

using SharedSurface = std::shared_ptr<Surface>;

SharedSurface surface_of_arrays(const py::array_t<double>& points, const py::array& triangles,
                                const std::string& name) {
  SurfaceFile file;
  file.surface.vertices = points_of(points);
  std::vector<std::int64_t> unknown;
  file.surface.triangles = rows_of<3>(triangles, file.surface.vertices.size(), unknown);
  if (!unknown.empty())
    throw InputError(fmt::format("{}: triangles name point {}, but there are {} points, numbered from 0",
                                 name, unknown[0], file.surface.vertices.size()));
  return std::make_shared<Surface>(std::move(file), name);
}

SharedSurface surface_of_document(const std::shared_ptr<Document>& document, const std::string& name) {
  return run(0, [&] {
    SurfaceFile file;
    file.surface = surface_of(*document, file.warnings);
    file.dropped = document->dropped;
    return std::make_shared<Surface>(std::move(file), name);
  });
}

SharedSurface open_surface(const std::string& file_or_spec, const std::string& format) {
  if (!format.empty() && corpus::is_generated(file_or_spec))
    throw InputError("a format needs a surface that is a file");
  return run(0, [&] {
    return std::make_shared<Surface>(corpus::open_surface_file(file_or_spec, {format}), file_or_spec);
  });
}

// A random surface, proved once more to be valid.
SharedSurface fuzz_surface(std::uint64_t seed, std::uint64_t index, const corpus::FuzzOptions& options) {
  return run(0, [&] {
    corpus::FuzzSurface made = corpus::fuzz_surface(seed, index, options);
    SurfaceFile file;
    file.surface = std::move(made.surface);
    auto surface = std::make_shared<Surface>(std::move(file), "fuzz:" + corpus::recipe_text(made.recipe));
    if (const std::string& fault = surface->judged().report().fault; !fault.empty())
      throw std::logic_error(fmt::format("seed {}, case {}: {}", seed, index, fault));
    return surface;
  });
}

// The recipe that a surface's name has behind "fuzz:".
corpus::Recipe recipe_of(const std::string& name) {
  if (!name.starts_with("fuzz:")) throw InputError(name + ": expected fuzz:RECIPE");
  return corpus::parse_recipe(std::string_view(name).substr(5));
}

// Names of simpler surfaces, at most so many, the most drastic first; not all of them can be built.
std::vector<std::string> simpler(const std::string& name, std::size_t most) {
  std::vector<std::string> names;
  for (const corpus::Recipe& recipe : corpus::simpler(recipe_of(name))) {
    if (names.size() == most) break;
    names.push_back("fuzz:" + corpus::recipe_text(recipe));
  }
  return names;
}

reference::VolumeSetting volume_of(const std::pair<double, bool>& setting) {
  return {setting.first, setting.second};
}

TetMesh grid_of(const Surface& surface, reference::Options options) {
  return run(0, [&] {
    if (const std::string& fault = surface.judged().report().fault; !fault.empty())
      throw InputError(surface.name() + ": " + fault);
    const std::optional<TriangleSurface> used = io::without_unused_vertices(surface.surface());
    reference::Generation made = reference::generate(used ? *used : surface.surface(), options);
    if (made.mesh().tets.empty())
      throw InputError(fmt::format(
          "{}: the grid is empty: the surface is thinner than the lattice of {} cells everywhere; use more "
          "cells",
          surface.name(), *std::max_element(made.lattice.cells.begin(), made.lattice.cells.end())));
    return made.adaptation ? std::move(made.adaptation->mesh) : std::move(made.grid.mesh);
  });
}

template <class Word>
Word word_of(const std::string& word, std::initializer_list<std::pair<const char*, Word>> known,
             const char* what) {
  std::string names;
  for (const auto& [name, value] : known) {
    if (word == name) return value;
    names += (names.empty() ? "" : " or ") + std::string(name);
  }
  throw InputError(fmt::format("{}: expected {}, found '{}'", what, names, word));
}

py::tuple mesh(const SharedSurface& surface, std::array<int, 3> cells, bool raise_cells,
               const std::string& region, std::int64_t points, const std::string& engine, double box_scale,
               double on_surface, const std::string& diagonals, bool literal, bool parametric,
               std::pair<double, bool> v0, std::pair<double, bool> v1, double d1, double p,
               std::pair<double, bool> e_avg, bool past_dilution, bool curvature, const std::string& improve,
               double improve_below) {
  using namespace reference;
  Options options;
  options.engine = word_of<Engine>(engine, {{"fast", Engine::fast}, {"paper", Engine::paper}}, "engine");
  options.region = word_of<reference::Region>(
      region, {{"inside", reference::Region::inside}, {"outside", reference::Region::outside}}, "region");
  options.cells = cells;
  options.raise_cells = raise_cells;
  options.box_scale = box_scale;
  options.on_surface = on_surface;
  options.diagonals = word_of<Diagonals>(
      diagonals, {{"lowest", Diagonals::lowest}, {"shortest", Diagonals::shortest}}, "diagonals");
  options.literal = literal;
  options.parametric = parametric;
  AdaptOptions adapt;
  adapt.points = points;
  adapt.v0 = volume_of(v0);
  adapt.v1 = volume_of(v1);
  adapt.d1 = d1;
  adapt.p = p;
  adapt.e_avg = volume_of(e_avg);
  adapt.past_dilution = past_dilution;
  adapt.curvature = curvature;
  adapt.improve = word_of<Criterion>(improve,
                                     {{"solid-angle", Criterion::solid_angle},
                                      {"aspect-ratio", Criterion::aspect_ratio},
                                      {"none", Criterion::none}},
                                     "improve");
  adapt.improve_below = improve_below;
  check(adapt);
  if (points != 0) options.adapt = adapt;
  return own(grid_of(*surface, std::move(options)));
}

// A comparison as text for people and as JSON.
using Texts = std::pair<std::string, std::string>;
Texts texts(const auto& result) {
  return {verify::comparison_text(result), verify::comparison_json(result)};
}
py::tuple to_python(const Texts& texts) {
  return py::make_tuple(text(texts.first), text(texts.second));
}

}  // namespace

void bind_surfaces(py::module_& module) {
  py::class_<Surface, SharedSurface>(module, "Surface")
      .def(py::init(&surface_of_arrays), py::arg("points").noconvert(), py::arg("triangles").noconvert(),
           py::arg("name"))
      .def(py::init(&surface_of_document), py::arg("document"), py::arg("name"))
      .def_property_readonly("name", [](const Surface& surface) { return text(surface.name()); })
      .def_property_readonly(
          "points",
          [](const py::object& self) { return view(self.cast<const Surface&>().surface().vertices, self); })
      .def_property_readonly(
          "triangles",
          [](const py::object& self) { return view(self.cast<const Surface&>().surface().triangles, self); })
      .def_property_readonly("warnings", [](const Surface& surface) { return text(surface.file().warnings); })
      .def_property_readonly("dropped", [](const Surface& surface) { return surface.file().dropped; })
      .def_property_readonly("fault",
                             [](const Surface& surface) {
                               return text(run(0, [&] { return surface.judged().report().fault; }));
                             })
      .def_property_readonly("notes", [](const Surface& surface) {
        return text(run(0, [&] { return surface.judged().report().notes; }));
      });
  module.def("open_surface", &open_surface, py::arg("file_or_spec"), py::arg("format"));
  module.def("is_generated", &corpus::is_generated, py::arg("spec"));
  module.def("list_surfaces", &corpus::list_surfaces);

  module.def(
      "fuzz_surface",
      [](std::uint64_t seed, std::uint64_t index, std::vector<std::string> kinds,
         std::vector<std::string> modifiers, int most_triangles, bool extreme_sizes) {
        return fuzz_surface(seed, index,
                            {std::move(kinds), std::move(modifiers), most_triangles, extreme_sizes});
      },
      py::arg("seed"), py::arg("index"), py::kw_only(), py::arg("kinds"), py::arg("modifiers"),
      py::arg("most_triangles"), py::arg("extreme_sizes"));
  module.def("simpler", &simpler, py::arg("name"), py::arg("most"));

  module.def("mesh", &mesh, py::arg("surface"), py::kw_only(), py::arg("cells"), py::arg("raise_cells"),
             py::arg("region"), py::arg("points"), py::arg("engine"), py::arg("box_scale"),
             py::arg("on_surface"), py::arg("diagonals"), py::arg("literal"), py::arg("parametric"),
             py::arg("v0"), py::arg("v1"), py::arg("d1"), py::arg("p"), py::arg("e_avg"),
             py::arg("past_dilution"), py::arg("curvature"), py::arg("improve"), py::arg("improve_below"));

  module.def("is_trace", [](const std::string& path) { return verify::is_trace(path).value_or(false); });
  module.def(
      "compare_grids",
      [](const std::shared_ptr<Document>& other, const std::string& other_name,
         const std::shared_ptr<Document>& reference, const std::string& reference_name, double tolerance) {
        return to_python(run(0, [&] {
          return texts(verify::compare_grids(verify::named_grid(other_name, *other),
                                             verify::named_grid(reference_name, *reference), tolerance));
        }));
      },
      py::arg("other"), py::arg("other_name"), py::arg("reference"), py::arg("reference_name"),
      py::arg("tolerance"));
  module.def(
      "compare_traces",
      [](const std::string& other, const std::string& reference, double tolerance,
         const std::string& surface) {
        return to_python(run(0, [&] {
          return texts(verify::compare_traces(other, reference, tolerance, [&](const std::string& path) {
            return verify::check_trace(path, surface);
          }));
        }));
      },
      py::arg("other"), py::arg("reference"), py::arg("tolerance"), py::arg("surface"));
}

}  // namespace tetproof::python
