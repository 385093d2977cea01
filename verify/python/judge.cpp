// SPDX-License-Identifier: GPL-3.0-or-later
// The judge for Python: meshes from arrays and documents, options, reports.
#include <chrono>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "io/bytes/large_pages.hpp"
#include "io/error.hpp"
#include "verify/defects.hpp"
#include "verify/findings_text.hpp"
#include "verify/python/interface.hpp"
#include "verify/report_page.hpp"
#include "verify/reports/verdict.hpp"
#include "verify/verify.hpp"

namespace tetproof::python {
namespace {

// A mesh to be judged, and what of its source is not judged.
struct Mesh {
  std::shared_ptr<const TetMesh> mesh;
  Numbering numbering;
  TetRegions regions;
  verify::Unjudged unjudged;
};

// A report, and what it is of.
struct Judged {
  verify::Report report;
  Mesh of;
  std::shared_ptr<const Surface> surface;  // null: none
};

template <std::size_t N, class Number>
void copy_rows(const Number* from, std::size_t points, std::vector<std::array<Index, N>>& rows,
               std::vector<std::int64_t>& unknown) {
  std::unordered_map<std::int64_t, Index> places;
  for (auto& row : rows)
    for (Index& corner : row) {
      const auto index = static_cast<std::int64_t>(*from++);
      if (index >= 0 && index < static_cast<std::int64_t>(points)) {
        corner = static_cast<Index>(index);
        continue;
      }
      const auto [place, is_new] = places.try_emplace(index, -1 - static_cast<Index>(unknown.size()));
      if (is_new) unknown.push_back(index);
      corner = place->second;
    }
}

Mesh mesh_of_arrays(const py::array_t<double>& points, const py::array& tets) {
  auto mesh = std::make_shared<TetMesh>();
  Mesh made;
  mesh->points = points_of(points);
  mesh->tets = rows_of<4>(tets, mesh->points.size(), made.numbering.unknown);
  made.mesh = std::move(mesh);
  return made;
}

Mesh mesh_of_document(const std::shared_ptr<Document>& document) {
  return run(0, [&] {
    return Mesh{std::make_shared<TetMesh>(tet_mesh(*document)), numbering(*document), tet_regions(*document),
                verify::unjudged(*document)};
  });
}

verify::Region region_of(const std::string& word) {
  return word == "inside"    ? verify::Region::inside
         : word == "outside" ? verify::Region::outside
                             : verify::Region::none;
}

Judged judge(const Mesh& mesh, const std::shared_ptr<const Surface>& surface, verify::Options options,
             const std::string& region, std::optional<double> timeout, int threads) {
  return run(threads, [&] {
    using Clock = std::chrono::steady_clock;
    if (timeout) {
      const std::chrono::duration<double> allowed(*timeout);
      options.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(allowed);
    }
    options.region = region_of(region);
    options.unjudged = mesh.unjudged;
    Judged judged{{}, mesh, surface};
    if (surface) {
      verify::add_unread_surface(options.unjudged, surface->file().dropped);
      try {
        judged.report = verify::verify(*mesh.mesh, surface->judged(), options);
      } catch (const InputError& error) {
        throw InputError(surface->name() + ": " + error.what());
      }
    } else {
      judged.report = verify::verify(*mesh.mesh, options);
    }
    return judged;
  });
}

// The positions, among the mesh's tetrahedra, of those that each finding names: check by check.
std::vector<std::vector<std::vector<Index>>> rows(const Judged& judged) {
  std::vector<std::vector<std::vector<Index>>> all;
  for (const verify::CheckResult& result : judged.report.checks) {
    all.emplace_back();
    for (const verify::Finding& finding : result.findings) all.back().push_back(finding.tets);
  }
  return all;
}

Document defects(const Judged& judged) {
  return verify::defects_document(*judged.of.mesh, judged.of.numbering, judged.report);
}

std::string html(const Judged& judged, const std::string& name) {
  return verify::report_page(judged.report, {.mesh = *judged.of.mesh,
                                             .numbering = judged.of.numbering,
                                             .mesh_name = name,
                                             .surface = judged.surface ? &judged.surface->surface() : nullptr,
                                             .surface_name = judged.surface ? judged.surface->name() : "",
                                             .regions = judged.of.regions.of_tet,
                                             .region_tags = judged.of.regions.tags});
}

}  // namespace

std::vector<Eigen::Vector3d> points_of(const py::array_t<double>& table) {
  constexpr auto most = static_cast<py::ssize_t>(std::numeric_limits<Index>::max());
  if (table.shape(0) > most) throw InputError("points: more than can be numbered here");
  std::vector<Eigen::Vector3d> points;
  io::resize_in_large_pages(points, static_cast<std::size_t>(table.shape(0)));
  if (!points.empty()) std::memcpy(points[0].data(), table.data(), points.size() * sizeof(points[0]));
  return points;
}

template <std::size_t N>
std::vector<std::array<Index, N>> rows_of(const py::array& table, std::size_t points,
                                          std::vector<std::int64_t>& unknown) {
  constexpr auto most = static_cast<py::ssize_t>(std::numeric_limits<Index>::max());
  if (table.shape(0) > most) throw InputError("more rows than can be numbered here");
  std::vector<std::array<Index, N>> rows;
  io::resize_in_large_pages(rows, static_cast<std::size_t>(table.shape(0)));
  if (table.itemsize() == sizeof(std::int32_t))
    copy_rows(static_cast<const std::int32_t*>(table.data()), points, rows, unknown);
  else
    copy_rows(static_cast<const std::int64_t*>(table.data()), points, rows, unknown);
  return rows;
}
template std::vector<std::array<Index, 3>> rows_of<3>(const py::array&, std::size_t,
                                                      std::vector<std::int64_t>&);
template std::vector<std::array<Index, 4>> rows_of<4>(const py::array&, std::size_t,
                                                      std::vector<std::int64_t>&);

void bind_judge(py::module_& module) {
  py::class_<Mesh>(module, "Mesh")
      .def(py::init(&mesh_of_arrays), py::arg("points").noconvert(), py::arg("tets").noconvert())
      .def(py::init(&mesh_of_document), py::arg("document"))
      .def(
          "set_regions",
          [](Mesh& mesh, const py::array_t<std::int64_t, py::array::c_style>& regions) {
            mesh.regions = {{regions.data(), regions.data() + regions.size()}, {}};
          },
          py::arg("regions").noconvert())
      .def_property_readonly(
          "points", [](const py::object& self) { return view(self.cast<const Mesh&>().mesh->points, self); })
      .def_property_readonly(
          "tets", [](const py::object& self) { return view(self.cast<const Mesh&>().mesh->tets, self); });

  py::class_<Judged>(module, "Report")
      .def_property_readonly("verdict",
                             [](const Judged& judged) { return verify::verdict_word(judged.report); })
      .def("text", [](const Judged& j) { return text(verify::report_text(j.report, j.of.numbering)); })
      .def("verdict_text", [](const Judged& j) { return text(verify::verdict_text(j.report)); })
      .def(
          "failure_text",
          [](const Judged& j, std::size_t most) {
            return text(verify::failure_text(j.report, j.of.numbering, most));
          },
          py::arg("most"))
      .def("json", [](const Judged& j) { return text(verify::report_json(j.report, j.of.numbering)); })
      .def(
          "junit",
          [](const Judged& j, const std::string& name) {
            return text(verify::report_junit(j.report, name, j.of.numbering));
          },
          py::arg("name"))
      .def(
          "html",
          [](const Judged& judged, const std::string& name) {
            return text(run(0, [&] { return html(judged, name); }));
          },
          py::arg("name"))
      .def("rows", &rows)
      .def("defects", [](const Judged& judged) { return run(0, [&] { return defects(judged); }); });

  module.def(
      "verify",
      [](const Mesh& mesh, const std::shared_ptr<Surface>& surface, const std::string& region,
         double fidelity, bool strict_topology, int voxels, std::vector<std::string> check,
         std::vector<std::string> skip, std::vector<std::string> allow, bool only_tets, bool quality,
         bool decide_only, bool timings, std::optional<double> timeout, int threads) {
        verify::Options options;
        options.fidelity = fidelity;
        options.strict_topology = strict_topology;
        options.voxels = voxels;
        options.check = std::move(check);
        options.skip = std::move(skip);
        options.allow = std::move(allow);
        options.regions = mesh.regions.of_tet;
        options.region_tags = mesh.regions.tags;
        options.only_tets = only_tets;
        options.quality = quality;
        options.decide_only = decide_only;
        options.timings = timings;
        for (const auto* ids : {&options.check, &options.skip, &options.allow})
          for (const std::string& id : *ids) verify::check_of_id(id);
        return judge(mesh, surface, std::move(options), region, timeout, threads);
      },
      py::arg("mesh"), py::arg("surface").none(true), py::kw_only(), py::arg("region"), py::arg("fidelity"),
      py::arg("strict_topology"), py::arg("voxels"), py::arg("check"), py::arg("skip"), py::arg("allow"),
      py::arg("only_tets"), py::arg("quality"), py::arg("decide_only"), py::arg("timings"),
      py::arg("timeout"), py::arg("threads"));
  module.def("list_checks", &verify::list_checks);
}

}  // namespace tetproof::python
