// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare_grids.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <limits>

#include "verify/compare/point_index.hpp"

namespace tetproof::verify {
namespace {

// A tetrahedron as the places of its points, ascending.
struct PlacedTet {
  std::array<int, 4> places;
  Index tet;
  auto operator<=>(const PlacedTet&) const = default;
};

std::vector<PlacedTet> placed(const TetMesh& mesh, const std::vector<int>& place_of, int nowhere) {
  std::vector<PlacedTet> tets(mesh.tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    tets[t].tet = static_cast<Index>(t);
    for (int i = 0; i < 4; ++i) {
      const Index point = mesh.tets[t][i];
      // A point that does not exist has no place and matches no other.
      const bool exists = point >= 0 && static_cast<std::size_t>(point) < place_of.size();
      tets[t].places[i] = exists ? place_of[point] : nowhere;
    }
    std::sort(tets[t].places.begin(), tets[t].places.end());
  }
  tbb::parallel_sort(tets.begin(), tets.end());
  return tets;
}

double diagonal(const TetMesh& mesh) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& tet : mesh.tets)
    for (const Index i : tet)
      if (i >= 0 && static_cast<std::size_t>(i) < mesh.points.size() && mesh.points[i].allFinite()) {
        low = low.cwiseMin(mesh.points[i]);
        high = high.cwiseMax(mesh.points[i]);
      }
  const double length = (high - low).stableNorm();
  return low.x() <= high.x() ? std::min(length, std::numeric_limits<double>::max()) : 0;
}

// Fills in one side with the points and tetrahedra that have no partner.
void tell(GridSide& side, const NamedGrid& grid, std::vector<Index> points, std::vector<Index> tets) {
  side.file = grid.file;
  side.not_compared = grid.not_compared;
  side.points = static_cast<std::int64_t>(grid.mesh.points.size());
  side.tets = static_cast<std::int64_t>(grid.mesh.tets.size());
  side.points_only = static_cast<std::int64_t>(points.size());
  side.tets_only = static_cast<std::int64_t>(tets.size());
  std::sort(points.begin(), points.end());
  std::sort(tets.begin(), tets.end());
  points.resize(std::min(points.size(), GridComparison::shown));
  tets.resize(std::min(tets.size(), GridComparison::shown));
  const auto point = [&](Index i) {
    const bool exists = i >= 0 && static_cast<std::size_t>(i) < grid.mesh.points.size();
    return GridSide::Point{
        grid.numbering.point(i),
        exists ? grid.mesh.points[i] : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())};
  };
  for (const Index i : points) side.first_points.push_back(point(i));
  for (const Index t : tets) {
    const auto& [a, b, c, d] = grid.mesh.tets[t];
    side.first_tets.push_back({grid.numbering.tet(t), {point(a), point(b), point(c), point(d)}});
  }
}

}  // namespace

GridComparison compare_grids(const NamedGrid& other, const NamedGrid& reference, double tolerance) {
  GridComparison result;
  result.tolerance = tolerance * diagonal(reference.mesh);

  // Points with equal coordinates are one place. A point that is not finite has no place: it gets -2 in the
  // reference and -1 in the other, so nothing matches it.
  PointIndex index(result.tolerance);
  std::vector<int> place_of_reference(reference.mesh.points.size(), -2),
      place_of_other(other.mesh.points.size(), -1);
  for (std::size_t i = 0; i < place_of_reference.size(); ++i)
    if (reference.mesh.points[i].allFinite()) place_of_reference[i] = index.add(reference.mesh.points[i]);
  const std::size_t places = index.points().size();
  std::vector<Index> only_in_reference, only_in_other;
  std::vector<int> of_reference(places, 0), of_other(places, 0);
  for (const int place : place_of_reference)
    if (place >= 0) ++of_reference[place];
  for (std::size_t i = 0; i < place_of_other.size(); ++i) {
    const Eigen::Vector3d& point = other.mesh.points[i];
    const int place = point.allFinite() ? index.find(point) : -1;
    place_of_other[i] = place;
    if (place < 0 || ++of_other[place] > of_reference[place])
      only_in_other.push_back(static_cast<Index>(i));
    else
      result.largest_distance = std::max(result.largest_distance, (point - index.points()[place]).norm());
  }
  std::vector<int> seen(places, 0);
  for (std::size_t i = 0; i < place_of_reference.size(); ++i) {
    const int place = place_of_reference[i];
    if (place < 0 || ++seen[place] > of_other[place]) only_in_reference.push_back(static_cast<Index>(i));
  }
  for (std::size_t i = 0; i < places; ++i) result.shared_places += of_reference[i] > 1 && of_other[i] > 1;

  const std::vector<PlacedTet> in_reference = placed(reference.mesh, place_of_reference, -2),
                               in_other = placed(other.mesh, place_of_other, -1);
  std::vector<Index> tets_only_in_reference, tets_only_in_other;
  auto a = in_reference.begin(), b = in_other.begin();
  while (a != in_reference.end() || b != in_other.end()) {
    if (b == in_other.end() || (a != in_reference.end() && a->places < b->places))
      tets_only_in_reference.push_back(a++->tet);
    else if (a == in_reference.end() || b->places < a->places)
      tets_only_in_other.push_back(b++->tet);
    else
      ++a, ++b;
  }
  tell(result.reference, reference, std::move(only_in_reference), std::move(tets_only_in_reference));
  tell(result.other, other, std::move(only_in_other), std::move(tets_only_in_other));
  return result;
}

}  // namespace tetproof::verify
