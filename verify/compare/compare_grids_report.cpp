// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the result of comparing two grids, as text for people and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/compare_grids.hpp"

namespace tetproof::verify {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t shown_to_people = 3;

std::string counted(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string text(const GridSide::Point& point) {
  return std::isnan(point.at.x()) ? fmt::format("{} (no point)", point.number)
                                  : fmt::format("({}, {}, {})", point.at.x(), point.at.y(), point.at.z());
}

std::string text(const GridSide& side) {
  if (side.points_only + side.tets_only == 0) return fmt::format("only in {}: nothing\n", side.file);
  std::string all = fmt::format("only in {}: {} of {}, {} of {}\n", side.file, side.tets_only,
                                counted(side.tets, "tetrahedron", "tetrahedra"), side.points_only,
                                counted(side.points, "point", "points"));
  for (std::size_t i = 0; i < std::min(shown_to_people, side.first_tets.size()); ++i) {
    const auto& [number, corners] = side.first_tets[i];
    all += fmt::format("  tetrahedron {}: {} {} {} {}\n", number, text(corners[0]), text(corners[1]),
                       text(corners[2]), text(corners[3]));
  }
  for (std::size_t i = 0; i < std::min(shown_to_people, side.first_points.size()); ++i)
    all += fmt::format("  point {}: {}\n", side.first_points[i].number, text(side.first_points[i]));
  return all;
}

Json coordinates(const Eigen::Vector3d& at) {
  return at.allFinite() ? Json{at.x(), at.y(), at.z()} : Json();
}

Json json(const std::vector<Loss>& losses) {
  Json list = Json::array();
  for (const Loss& loss : losses)
    list.push_back({{"item", loss.item}, {"count", loss.count}, {"example", loss.example}});
  return list;
}

Json json(const GridSide& side) {
  Json points = Json::array(), tets = Json::array();
  for (const GridSide::Point& point : side.first_points)
    points.push_back({{"number", point.number}, {"point", coordinates(point.at)}});
  for (const GridSide::Tet& tet : side.first_tets) {
    Json numbers = Json::array(), corners = Json::array();
    for (const GridSide::Point& corner : tet.corners) {
      numbers.push_back(corner.number);
      corners.push_back(coordinates(corner.at));
    }
    tets.push_back({{"number", tet.number}, {"vertices", numbers}, {"points", corners}});
  }
  return {{"file", side.file},
          {"points", side.points},
          {"tets", side.tets},
          {"points_only_here", side.points_only},
          {"tets_only_here", side.tets_only},
          {"first_points", points},
          {"first_tets", tets},
          {"not_compared", json(side.not_compared)}};
}

}  // namespace

bool GridComparison::complete() const {
  const auto all_elements = [](const GridSide& side) {
    return std::none_of(side.not_compared.begin(), side.not_compared.end(),
                        [](const Loss& loss) { return loss.elements; });
  };
  return all_elements(reference) && all_elements(other);
}

std::string comparison_text(const GridComparison& result) {
  std::string all = result.equal() ? fmt::format("{}: {}, {}; matched points are at most {:.3g} apart\n",
                                                 result.complete() ? "equal up to numbering"
                                                                   : "incomplete, equal in what was compared",
                                                 counted(result.reference.tets, "tetrahedron", "tetrahedra"),
                                                 counted(result.reference.points, "point", "points"),
                                                 result.largest_distance)
                                   : "the grids differ:\n" + text(result.reference) + text(result.other);
  for (const GridSide* side : {&result.reference, &result.other})
    for (const Loss& loss : side->not_compared)
      all +=
          fmt::format("not compared, of {}: {}: {} ({})\n", side->file, loss.item, loss.count, loss.example);
  if (result.shared_places)
    all += fmt::format(
        "  note: at {} both have several points; which of them a tetrahedron names is not compared\n",
        counted(result.shared_places, "place", "places"));
  return all;
}

std::string comparison_json(const GridComparison& result) {
  const Json all{{"compared", "grids"},
                 {"verdict", !result.equal()     ? "diverges"
                             : result.complete() ? "equal"
                                                 : "incomplete"},
                 {"tolerance", result.tolerance},
                 {"largest_distance", result.largest_distance},
                 {"shared_places", result.shared_places},
                 {"reference", json(result.reference)},
                 {"other", json(result.other)}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tetproof::verify
