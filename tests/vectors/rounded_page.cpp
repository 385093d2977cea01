// SPDX-License-Identifier: GPL-3.0-or-later
// rounded_page SEED ARGUMENTS: the page with other rounding errors, for a trace of corpus/vectors/traces. It
// takes the arguments of tetproof-mesh that make the trace, and writes its own to the file of --trace.
//
// Distances, errors, gains of flips and the points of a parametric surface get errors of up to 1e-13, drawn
// from SEED. With --rounded-surface, the coordinates of the surface get them, too. Where no decision is a
// tie, the trace stays the same.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <random>

#include "corpus/surfaces.hpp"
#include "io/error.hpp"
#include "reference/paper/page.hpp"
#include "reference/program/mesh_options.hpp"

namespace {

using namespace tetproof;
using namespace tetproof::reference;

class Errors {
 public:
  explicit Errors(unsigned seed) : engine_(seed) {}
  /// From -1e-13 to 1e-13.
  double next() { return (static_cast<double>(engine_()) / 2147483647.5 - 1) * 1e-13; }

 private:
  std::mt19937 engine_;
};

class RoundedPage : public paper::Page {
 public:
  RoundedPage(const TriangleSurface& surface, const Options& options, Errors& errors)
      : Page(surface, options), errors_(errors) {}
  double distance(const paper::Point& centroid) const override {
    return Page::distance(centroid) * (1 + errors_.next());
  }
  double error(double volume, double desired) const override {
    return Page::error(volume, desired) + (volume + desired) * errors_.next();
  }
  double gain(const paper::Flip& flip) const override { return Page::gain(flip) + errors_.next(); }

 private:
  Errors& errors_;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app;
    Arguments a;
    declare_options(app, a);
    bool surface_too = false;
    app.add_flag("--rounded-surface", surface_too);
    Errors errors(static_cast<unsigned>(std::stoul(argv[1])));
    app.parse(argc - 1, argv + 1);
    Options options = generate_options(a);
    TriangleSurface surface = corpus::make_surface(a.surface);
    for (Eigen::Vector3d& v : surface.vertices)
      for (int x = 0; x < 3 && surface_too; ++x) v[x] *= 1 + errors.next();
    if (surface.evaluate)
      surface.evaluate = [exact = surface.evaluate, &errors](const Eigen::Vector2d& uv) {
        Eigen::Vector3d p = exact(uv);
        for (double& x : p) x *= 1 + errors.next();
        return p;
      };
    std::ofstream trace(a.trace);
    options.listener.record = [&](const trace::Record& record) { trace << trace::to_line(record) << '\n'; };
    trace::Settings settings = settings_of(options, static_cast<bool>(surface.evaluate));
    settings.program = "rounded_page";
    settings.surface = a.surface;
    options.listener.record(settings);
    RoundedPage(surface, options, errors).run();
    return trace.flush() ? 0 : 1;
  } catch (const std::exception& fault) {
    std::cerr << "rounded_page: " << fault.what() << '\n';
    return 2;
  }
}
