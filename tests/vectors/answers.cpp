// SPDX-License-Identifier: GPL-3.0-or-later
#include "answers.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "reference/engine/adaptation/curvature.hpp"
#include "reference/engine/adaptation/table4.hpp"
#include "reference/engine/adaptation/vertex_tree.hpp"
#include "reference/engine/first_grid/extract.hpp"
#include "reference/engine/first_grid/row_choice.hpp"
#include "reference/equations.hpp"

namespace tetproof::test {
namespace {

using Json = nlohmann::json;
using namespace reference;

constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

Eigen::Vector3d point(const Json& p) {
  return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()};
}
Json json(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}
std::vector<Eigen::Vector3d> points(const Json& list) {
  std::vector<Eigen::Vector3d> all;
  for (const Json& p : list) all.push_back(point(p));
  return all;
}

Json table1(const Json& input, const std::string& mistake) {
  const std::array<std::int8_t, 4> s = input["indicators"];
  const SortedVertices sorted = sort_vertices(s);
  const auto& indicators = tables::table2[sorted.first_row].indicators;
  const auto row = std::find_if(tables::table1.begin(), tables::table1.end(),
                                [&](const tables::Table1Row& r) { return r.indicators == indicators; });
  if (mistake == "14-cases" && row->name == "E8") return {{"case", "9"}, {"edges", Json::array()}};
  Json possible = Json::array();
  for (int e = 0; e < 6; ++e)
    if (row->possible[e] == tables::y)
      possible.push_back({sorted.order[edges[e][0]], sorted.order[edges[e][1]]});
  return {{"case", std::string(row->name)}, {"edges", possible}};
}

// A lattice of one cell, from the coordinates of some of its vertices, each given by its number 0 .. 7.
Lattice one_cell(const Json& vertices) {
  Lattice lattice{{1, 1, 1}, {{{0, 1}, {0, 1}, {0, 1}}}, 1};
  for (const Json& v : vertices)
    for (int axis = 0; axis < 3; ++axis)
      lattice.planes[axis][v["number"].get<int>() >> axis & 1] = v["point"][axis];
  return lattice;
}

Edge edge_between(const Json& ends) {
  const int a = ends[0], b = ends[1];
  return Edge{std::min(a, b)} * 8 + (a ^ b);
}

// The other corners of the cell are outside, their cuts anywhere: only one of its six tetrahedra is looked
// at.
Json table2(const Json& input, const std::string& mistake) {
  const Lattice lattice = one_cell(input["vertices"]);
  Indicators indicators;
  indicators.initial.assign(8, -1);
  indicators.sign.assign(8, -1);
  std::vector<int> corners;
  for (const Json& v : input["vertices"]) {
    const int number = v["number"];
    corners.push_back(number);
    indicators.initial[number] = v["before"];
    indicators.sign[number] = v["after"];
  }
  std::sort(corners.begin(), corners.end());
  std::map<Edge, Eigen::Vector3d> cuts;
  for (int a = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b)
      if ((a & b) == a && indicators.sign[a] * indicators.sign[b] < 0)
        cuts[edge_between({a, b})] = 0.5 * (lattice.point(a) + lattice.point(b));
  for (const Json& cut : input["cuts"]) cuts[edge_between(cut["edge"])] = point(cut["point"]);
  indicators.cuts.directions.assign(8, 0);
  for (const auto& [edge, at] : cuts) {
    if (indicators.initial[lattice.low(edge)] == 0 || indicators.initial[lattice.high(edge)] == 0) continue;
    indicators.cuts.directions[edge >> 3] |= static_cast<std::uint8_t>(1 << (edge & 7));
    indicators.cuts.edges.push_back(edge);
    indicators.cuts.points.push_back(at);
  }
  for (Vertex v = 0, next = 0; v < 8; ++v) {
    indicators.cuts.first.push_back(next);
    next += __builtin_popcount(indicators.cuts.directions[v]);
  }
  const bool keep = input.value("centroid_inside", false);
  const Grid grid = extract(lattice, indicators, {},
                            input["diagonals"] == "lowest" ? Diagonals::lowest : Diagonals::shortest,
                            [=](const Eigen::Vector3d&) { return keep; });
  const auto tet = std::find_if(kuhn_tets.begin(), kuhn_tets.end(), [&](const std::array<int, 4>& each) {
    return std::equal(each.begin(), each.end(), corners.begin());
  });
  const auto number = static_cast<std::uint32_t>(tet - kuhn_tets.begin());
  const std::uint8_t row = grid.lattice_rows.at(number);
  Json made = Json::array();
  for (std::size_t t = 0; t < grid.mesh.tets.size(); ++t) {
    if (grid.lattice_tet[t] != number) continue;
    Json each = Json::array();
    for (const Index p : grid.mesh.tets[t]) each.push_back(json(grid.mesh.points[p]));
    const int place = static_cast<int>(made.size());
    if (mistake == "orientation" && listed_orientation(row, place) < 0) std::swap(each[2], each[3]);
    made.push_back(each);
  }
  return {{"row", row == Grid::case_5_dropped ? "5-" : std::string(tables::table2[row].name)},
          {"tetrahedra", made}};
}

Json table3(const Json& input) {
  const Lattice lattice = one_cell(input["vertices"]);
  std::vector<std::int8_t> initial(8);
  for (const Json& v : input["vertices"]) initial[v["number"].get<int>()] = v["indicator"];
  SurfaceVertices settled;
  for (const int v : input["settled"]) settled.add({{v, 0, lattice.point(v)}});
  std::vector<EdgeIntersections> met;
  for (const Json& edge : input["edges"])
    met.push_back({edge_between(edge["edge"]), static_cast<int>(edge["points"].size()),
                   point(edge["points"].front()), point(edge["points"].back())});
  std::sort(met.begin(), met.end(), [](const auto& a, const auto& b) { return a.edge < b.edge; });
  const Indicators result = characterize(lattice, initial, met, settled);
  Json cuts = Json::array(), applied = Json::object();
  for (std::size_t c = 0; c < result.cuts.edges.size(); ++c)
    cuts.push_back({{"edge", {lattice.low(result.cuts.edges[c]), lattice.high(result.cuts.edges[c])}},
                    {"point", json(result.cuts.points[c])}});
  for (int a = 0; a < 8; ++a)  // a cut at an end is not stored
    for (int b = a + 1; b < 8; ++b) {
      if ((a & b) != a || result.sign[a] * result.sign[b] >= 0) continue;
      if (result.cuts.find(edge_between({a, b})) >= 0) continue;
      const int outer = result.sign[a] < 0 ? a : b, at = result.initial[outer] == 0 ? outer : a + b - outer;
      cuts.push_back({{"edge", {a, b}}, {"point", json(lattice.point(at))}});
    }
  for (std::size_t r = 0; r < tables::table3.size(); ++r)
    if (result.table3[r]) applied[std::string(tables::table3[r].name)] = result.table3[r];
  return {{"indicators", result.sign}, {"cuts", cuts}, {"applied", applied}};
}

Json table4(const Json& input) {
  const std::vector<std::array<Index, 4>> tets = input["tetrahedra"];
  std::vector<std::uint8_t> on_surface;
  for (const bool on : input["surface_point"]) on_surface.push_back(on);
  const Triangulation grid({.points = points(input["points"]), .tets = tets}, on_surface);
  const Index tet = input["split"];
  const Split split = split_by_table4(grid, tet);
  const auto pieces = pieces_of(grid.corners(tet), split, grid.points());
  Json replaced = Json::array(), made = Json::array();
  for (int k = 0; k < split.pieces; ++k) {
    replaced.push_back(grid.corners(tet)[split.replaced[k]]);
    made.push_back(pieces[k]);
  }
  return {{"row", std::string(tables::table4[split.row].name)},
          {"replaced", replaced},
          {"point", json(split.point)},
          {"pieces", made}};
}

Json volume_law(const Json& input) {
  return {{"volume", desired_volume(input["d"], {input["v0"], input["v1"], input["d1"], input["p"]})}};
}

Json weights(const Json& input) {
  const auto at = points(input["points"]), surface = points(input["surface"]);
  const VertexTree tree(surface);
  const std::vector<double> kappa =
      input["kappa"].is_null() ? std::vector<double>{} : input["kappa"].get<std::vector<double>>();
  struct One {
    double d;
    Index nearest;
    double volume;
  };
  std::vector<One> all;
  double volumes = 0, d1 = 0, sum = 0;
  for (const std::array<int, 4> t : input["tetrahedra"]) {
    const auto &a = at[t[0]], &b = at[t[1]], &c = at[t[2]], &d = at[t[3]];
    const Eigen::Vector3d centre = centroid(a, b, c, d);
    const double distance = tree.distance(centre);
    all.push_back({distance, tree.nearest(centre, distance), volume(a, b, c, d)});
    volumes += all.back().volume;
    d1 = std::max(d1, distance);
  }
  const Json& given = input["law"];
  const double unit = given["unit"] == "absolute" ? 1 : volumes / static_cast<double>(all.size());
  const VolumeLaw law{given["v0"].get<double>() * unit, given["v1"].get<double>() * unit,
                      given["d1"].is_null() ? d1 : given["d1"].get<double>(), given["p"]};
  Json tets = Json::array();
  for (const One& one : all) {
    double omega = 1;
    if (!kappa.empty())
      omega = curvature_weight(kappa[one.nearest], *std::min_element(kappa.begin(), kappa.end()),
                               *std::max_element(kappa.begin(), kappa.end()));
    const double desired = desired_volume(omega * one.d, law), error = volume_error(one.volume, desired);
    sum += error;
    tets.push_back({{"nearest", one.nearest},
                    {"d", one.d},
                    {"omega", omega},
                    {"volume", one.volume},
                    {"desired", desired},
                    {"error", error}});
  }
  return {{"tetrahedra", tets}, {"e_avg", average_error(sum, static_cast<std::int64_t>(all.size()))}};
}

Json choice(const Json& input, const std::string& mistake) {
  const std::vector<double> errors = input["errors"];
  const auto tets = static_cast<std::int64_t>(errors.size());
  double sum = 0;
  for (const double e : errors) sum += e;
  const double before = average_error(sum, tets);
  Json after = Json::array();
  double best = std::numeric_limits<double>::infinity(), best_after = best;
  int chosen = -1;
  for (const Json& candidate : input["candidates"]) {
    const int tet = candidate["tet"];
    const std::vector<double> pieces = candidate["pieces"];
    double change = 0;
    for (const double e : pieces) change += e;
    change -= errors[tet];
    const double e_avg = average_error_after_split(sum, change, tets, static_cast<int>(pieces.size()));
    const double compared = mistake == "l-plus-3" ? average_error_after_split(sum, change, tets, 4) : e_avg;
    after.push_back(e_avg);
    if (compared < best || (compared == best && tet < chosen)) {
      best = compared;
      best_after = e_avg;
      chosen = tet;
    }
  }
  return {{"before", before}, {"after_each", after}, {"tet", best_after < before ? Json(chosen) : Json()}};
}

Json curvature_weight_of(const Json& input) {
  return {{"weight", curvature_weight(input["kappa"], input["kappa_min"], input["kappa_max"])}};
}

Json curvature(const Json& input) {
  TriangleSurface surface;
  surface.vertices = points(input["points"]);
  surface.triangles = input["triangles"].get<std::vector<std::array<Index, 3>>>();
  return {{"curvature", absolute_curvatures(surface)[input["vertex"].get<int>()]}};
}

}  // namespace

Json answer(const std::string& kind, const Json& input, const std::string& mistake) {
  if (kind == "table1") return table1(input, mistake);
  if (kind == "table2") return table2(input, mistake);
  if (kind == "table3") return table3(input);
  if (kind == "table4") return table4(input);
  if (kind == "volume_law") return volume_law(input);
  if (kind == "weights") return weights(input);
  if (kind == "choice") return choice(input, mistake);
  if (kind == "curvature_weight") return curvature_weight_of(input);
  if (kind == "curvature") return curvature(input);
  return geometry_answer(kind, input, mistake);
}

}  // namespace tetproof::test
