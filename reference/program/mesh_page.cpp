// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/program/mesh_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/error.hpp"
#include "io/page/plots.hpp"
#include "reference/engine/adaptation/weighting.hpp"
#include "reference/figure/figure.hpp"
#include "reference/program/mesh_report.hpp"
#include "verify/reports/report_parts.hpp"

namespace tetproof::reference {
namespace {

constexpr std::size_t most_figure_bytes = 1'000'000, most_dots = 4000, chosen_tets = 60,
                      most_drawn_tets = 200'000;

std::array<Eigen::Vector3d, 4> corners_of(const TetMesh& mesh, std::size_t t) {
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.points[static_cast<std::size_t>(mesh.tets[t][k])];
  return corners;
}

// Some tetrahedra with their distance of eq. (3.2), evenly chosen by number, the nearest first.
struct Sample {
  std::size_t tet;
  double d, volume, weighted;
};
std::vector<Sample> sample_of(const MeshPage& page) {
  const TetMesh& mesh = page.made.mesh();
  const bool curvature = page.made.adaptation && page.made.adaptation->with_curvature;
  const Weighting weighting(page.surface, curvature);
  const std::size_t count = std::min(mesh.tets.size(), most_dots);
  std::vector<Sample> all;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t t = i * mesh.tets.size() / count;
    const auto corners = corners_of(mesh, t);
    const Weight weight = weighting.weigh(corners, weighting.distance(corners));
    all.push_back({t, weight.d, weight.volume, weight.omega * weight.d});
  }
  std::sort(all.begin(), all.end(),
            [](const Sample& a, const Sample& b) { return std::pair(a.d, a.tet) < std::pair(b.d, b.tet); });
  return all;
}

void add_volumes(io::Page& page, const MeshPage& subject, const std::vector<Sample>& sample) {
  io::Plot plot{
      .id = "volumes",
      .title = "volume over distance to the surface",
      .across = "distance d of eq. (3.2) [length]",
      .up = "volume [length\u00b3]",
      .curves = {{.name = fmt::format("{} of {} tetrahedra", sample.size(), subject.made.mesh().tets.size()),
                  .points = {},
                  .dots = true}}};
  plot.logarithmic = true;
  for (const Sample& s : sample) plot.curves[0].points.emplace_back(s.weighted, s.volume);
  if (subject.made.adaptation) {
    if (subject.made.adaptation->with_curvature) plot.across = "distance, weighted by eq. (3.6) [length]";
    io::Curve law{.name = "eq. (3.1)", .points = {}, .colour = "#c8102e"};
    double largest = 0;
    for (const Sample& s : sample) largest = std::max(largest, s.weighted);
    for (int i = 0; i <= 200; ++i) {
      const double d = largest * i / 200;
      law.points.emplace_back(d, desired_volume(d, subject.made.adaptation->law));
    }
    plot.curves.push_back(std::move(law));
  }
  page.svg(io::plot_svg(plot));
}

template <class Table, class Counts>
void add_rows(io::Page& page, const char* id, const char* title, const Table& table, const Counts& counts) {
  std::vector<io::PageRow> rows;
  for (std::size_t r = 0; r < counts.size(); ++r)
    rows.push_back(
        {{.text = std::string(table[r].name)}, {.text = fmt::format("{}", counts[r]), .number = true}});
  page.part(std::string(id) + "-part", title);
  page.table(id, {"row", "times used"}, rows);
}

// A figure, unless it is too large for a page or cannot be drawn, which is said.
void add_figure(io::Page& page, const MeshPage& subject, const FigureOptions& options,
                const std::string& command) {
  std::string svg;
  try {
    svg = figure(subject.made.mesh(), subject.surface, options);
  } catch (const InputError& error) {
    page.paragraph(fmt::format("Not drawn: {}: {}", options.title, error.what()));
    return;
  }
  if (svg.size() <= most_figure_bytes)
    page.svg(svg);
  else
    page.paragraph(fmt::format("Not in this page, because it has {:.1f} MB: {}; {} draws it.",
                               static_cast<double>(svg.size()) / 1e6, options.title, command));
}

// The grid cut open, and the cut of a plane across each axis.
void add_figures(io::Page& page, const MeshPage& subject) {
  page.part("figures", "Figures, as the paper's 3 to 6");
  if (subject.made.mesh().tets.size() <= most_drawn_tets) {
    const Eigen::Vector3d view = parse_view("3d");
    add_figure(page, subject,
               {.plane = plane_for_view(view, subject.surface), .view = view, .title = "The grid cut open"},
               "--figure FILE.svg --view 3d");
    for (const char* const axis : {"x", "y", "z"})
      add_figure(page, subject,
                 {.plane = parse_plane(axis, subject.surface), .title = fmt::format("Cut across {}", axis)},
                 fmt::format("--figure FILE.svg --plane {}", axis));
  } else {
    page.paragraph(fmt::format("Grids of more than {} tetrahedra are not drawn here; --figure draws them.",
                               most_drawn_tets));
  }
}

}  // namespace

std::string mesh_page(const verify::Report& report, const MeshPage& subject) {
  const TetMesh& mesh = subject.made.mesh();
  const std::vector<Sample> sample = mesh.tets.empty() ? std::vector<Sample>() : sample_of(subject);
  // Their sizes grow and shrink with the distance: what the paper's figures show with a few tetrahedra.
  std::vector<Index> chosen;
  for (std::size_t i = 0; i < std::min(chosen_tets, sample.size()); ++i)
    chosen.push_back(
        static_cast<Index>(sample[i * sample.size() / std::min(chosen_tets, sample.size())].tet));
  const Numbering numbering;
  const std::vector<std::int64_t> regions;
  const std::vector<RegionTag> tags;
  io::Page page = verify::report_page_parts(
      report, {.mesh = mesh,
               .numbering = numbering,
               .mesh_name = subject.grid_name.empty() ? "the grid" : subject.grid_name,
               .surface = &subject.surface,
               .surface_name = subject.surface_name,
               .regions = regions,
               .region_tags = tags,
               .chosen = chosen,
               .chosen_name = "some tetrahedra, from the surface inwards"});
  page.part("generation", "How the grid was made");
  page.lines(generation_text(subject.made));
  if (!sample.empty()) {
    add_volumes(page, subject, sample);
    if (!subject.e_avg.empty()) {
      io::Plot plot{.id = "e-avg",
                    .title = "average error of eq. (3.4)",
                    .across = "insertions",
                    .up = "E_avg [length\u00b3]",
                    .curves = {{.name = "E_avg", .points = {}}}};
      plot.curves[0].points.emplace_back(0, subject.made.adaptation->e_avg_first);
      for (std::size_t i = 0; i < subject.e_avg.size(); ++i)
        plot.curves[0].points.emplace_back(static_cast<double>(i + 1), subject.e_avg[i]);
      page.svg(io::plot_svg(plot));
    }
    add_figures(page, subject);
  }
  add_rows(page, "table2", "Table 2: how tetrahedra of the lattice were cut", tables::table2,
           subject.made.grid.rows);
  add_rows(page, "table3", "Table 3: how indicators were changed", tables::table3, subject.made.table3);
  if (subject.made.adaptation)
    add_rows(page, "table4", "Table 4: how tetrahedra were split", tables::table4,
             subject.made.adaptation->rows);
  return page.text();
}

}  // namespace tetproof::reference
