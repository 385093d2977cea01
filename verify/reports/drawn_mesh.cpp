// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/reports/drawn_mesh.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/bytes/words.hpp"
#include "verify/distance/triangle_tree.hpp"
#include "verify/findings_text.hpp"

namespace tetproof::verify {
namespace {

using Eigen::Vector3d;

constexpr std::size_t point_bytes = 24, triangle_bytes = 16, face_bytes = 8, number_bytes = 4;
constexpr std::size_t most_faces = 300'000;      // of a boundary that is drawn as it is
constexpr std::size_t most_triangles = 150'000;  // of a boundary that is drawn by fewer

std::vector<std::uint8_t> undrawable(const TetMesh& mesh, const auto& usable) {
  std::vector<std::uint8_t> all(mesh.tets.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& tet = mesh.tets[t];
    for (std::size_t i = 0; i < 4; ++i) {
      if (!usable(tet[i])) all[t] = 1;
      for (std::size_t j = 0; j < i; ++j)
        if (tet[i] == tet[j]) all[t] = 1;
    }
  }
  return all;
}

// The largest distance of the corners and the middle of each triangle from the surface, to a hundredth: it
// only chooses a colour. In diagonals of the common box: such a number fits into a float, whatever the file's
// unit.
std::vector<float> distances(const TriangleSet& set, const TriangleSurface& surface) {
  const TriangleSet others{surface.vertices, surface.triangles};
  const std::array<TriangleSet, 2> sets{set, others};
  const Units units = units_of(sets);
  if (!units.usable || surface.triangles.empty()) return {};
  const TriangleTree tree(others, units);
  std::vector<float> values(set.triangles.size());
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
    Vector3d middle = Vector3d::Zero();
    double squared = 0;
    Index guess = -1;
    const auto look = [&](const Vector3d& p) {
      const TriangleTree::Nearest nearest = tree.nearest(p, guess, -1, 0.01);
      guess = nearest.triangle;
      squared = std::max(squared, nearest.squared);
    };
    for (const Index v : set.triangles[i]) {
      const Vector3d p = units.to(set.points[static_cast<std::size_t>(v)]);
      look(p);
      middle += p / 3;
    }
    look(middle);
    values[i] = static_cast<float>(std::sqrt(squared) * (units.scale / units.diagonal));
  });
  return values;
}

// What a page needs for the numbers of a file: next to nothing where they count up.
std::size_t bytes_of_numbers(const std::vector<std::int64_t>& numbers) {
  std::size_t runs = 0;
  bool fit = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    runs += i == 0 || numbers[i] != numbers[i - 1] + 1;
    fit = fit && numbers[i] == static_cast<std::int32_t>(numbers[i]);
  }
  return std::min(12 * runs, numbers.size() * (fit ? number_bytes : 2 * number_bytes));
}

}  // namespace

DrawnMesh::DrawnMesh(const PageSubject& subject, io::Scene& scene, std::vector<std::string>& left_out)
    : subject_(subject),
      mesh_(subject.mesh),
      scene_(scene),
      left_out_(left_out),
      undrawable_(undrawable(mesh_, [this](Index v) { return usable(v); })),
      place_of_point_(mesh_.points.size(), -1),
      place_of_tet_(mesh_.tets.size(), -1),
      faces_(match_faces(mesh_, undrawable_).boundary) {
  for (const FaceId face : faces_) triangles_.push_back(vertices_of(mesh_, face));
  for (const RegionTag& tag : subject.region_tags) scene_.regions.push_back(region_text(tag));
  const auto count = std::count(undrawable_.begin(), undrawable_.end(), 1);
  if (count > 0)
    left_out_.push_back(
        fmt::format("{} cannot be drawn, because {} points, repeat them, or have coordinates that are no "
                    "numbers. The points "
                    "that a finding names are marked.",
                    io::counted(count, "tetrahedra"), count == 1 ? "it lacks" : "they lack"));
  const auto is_rounded = [](std::int64_t n) {
    return static_cast<std::int64_t>(static_cast<double>(n)) != n;
  };
  for (const auto* numbers : {&subject.numbering.points, &subject.numbering.tets})
    if (std::any_of(numbers->begin(), numbers->end(), is_rounded)) {
      left_out_.emplace_back(
          "A click shows numbers above 2^53 rounded; the tables and the report have them exactly.");
      break;
    }
}

bool DrawnMesh::usable(Index v) const {
  return v >= 0 && v < static_cast<Index>(mesh_.points.size()) &&
         mesh_.points[static_cast<std::size_t>(v)].allFinite();
}

void DrawnMesh::choose(std::size_t most_bytes) {
  const auto drawable =
      static_cast<std::size_t>(std::count(undrawable_.begin(), undrawable_.end(), std::uint8_t{0}));
  const std::size_t numbers =
      bytes_of_numbers(subject_.numbering.tets) + bytes_of_numbers(subject_.numbering.points);
  const std::size_t points = std::min(mesh_.points.size(), 4 * drawable);
  if (faces_.size() <= most_faces &&
      drawable * tet_bytes() + points * point_bytes + faces_.size() * face_bytes + numbers <= most_bytes) {
    // The points in their order, so that their numbers count up and take no space.
    std::vector<std::uint8_t> used(mesh_.points.size(), 0);
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      if (!undrawable_[t])
        for (const Index v : mesh_.tets[t]) used[static_cast<std::size_t>(v)] = 1;
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v]) point(static_cast<Index>(v));
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
      if (!undrawable_[t]) tet(static_cast<Index>(t));
  } else {
    // A triangle, and the tetrahedron and the point that it brings, with their numbers.
    const std::size_t each = triangle_bytes + tet_bytes() + point_bytes + 2 * number_bytes;
    fewer_ = io::reduced(mesh_.points, triangles_, std::min(most_triangles, most_bytes / 2 / each));
    hold_middle(most_bytes - std::min(most_bytes, fewer_.triangles.size() * each));
  }
  scene_.cut_tets = scene_.tets.size();
}

// Holds the tetrahedra that planes through the middle of the box meet, for as many axes as fit.
void DrawnMesh::hold_middle(std::size_t most_bytes) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& triangle : triangles_)
    for (const Index v : triangle) {
      low = low.cwiseMin(mesh_.points[static_cast<std::size_t>(v)]);
      high = high.cwiseMax(mesh_.points[static_cast<std::size_t>(v)]);
    }
  scene_.cut_middle = low / 2 + high / 2;
  scene_.cut_anywhere = false;
  scene_.cut_axes.clear();
  std::vector<std::uint8_t> met(mesh_.tets.size(), 0);
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::size_t> more;
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      if (undrawable_[t] || met[t]) continue;
      double least = std::numeric_limits<double>::infinity(), most = -least;
      for (const Index v : mesh_.tets[t]) {
        least = std::min(least, mesh_.points[static_cast<std::size_t>(v)][axis]);
        most = std::max(most, mesh_.points[static_cast<std::size_t>(v)][axis]);
      }
      if (least <= scene_.cut_middle[axis] && most >= scene_.cut_middle[axis]) more.push_back(t);
    }
    // A layer of tetrahedra has fewer points than tetrahedra.
    if ((count + more.size()) * (tet_bytes() + point_bytes + 2 * number_bytes) > most_bytes) continue;
    for (const std::size_t t : more) met[t] = 1;
    count += more.size();
    scene_.cut_axes += "xyz"[axis];
  }
  for (std::size_t t = 0; t < mesh_.tets.size(); ++t)
    if (met[t]) tet(static_cast<Index>(t));
  left_out_.push_back(
      scene_.cut_axes.empty()
          ? "The mesh is too large to be cut in a page of 20 MB."
          : fmt::format(
                "The mesh is too large to be cut anywhere in a page of 20 MB. The page holds the {} of {} "
                "tetrahedra that planes through the middle of the box meet, across {}.",
                count, mesh_.tets.size(), fmt::join(scene_.cut_axes, ", ")));
}

Index DrawnMesh::point(Index v) {
  Index& place = place_of_point_[static_cast<std::size_t>(v)];
  if (place < 0) {
    place = static_cast<Index>(scene_.points.size());
    scene_.points.push_back(mesh_.points[static_cast<std::size_t>(v)]);
    scene_.point_numbers.push_back(subject_.numbering.point(v));
  }
  return place;
}

Index DrawnMesh::tet(Index t) {
  Index& place = place_of_tet_[static_cast<std::size_t>(t)];
  if (place < 0) {
    place = static_cast<Index>(scene_.tets.size());
    std::array<Index, 4> corners = mesh_.tets[static_cast<std::size_t>(t)];
    for (Index& v : corners) v = point(v);
    scene_.tets.push_back(corners);
    scene_.tet_numbers.push_back(subject_.numbering.tet(t));
    if (!subject_.regions.empty())
      scene_.tet_regions.push_back(static_cast<std::int32_t>(subject_.regions[static_cast<std::size_t>(t)]));
  }
  return place;
}

io::SceneLayer DrawnMesh::boundary(bool with_distances) {
  io::SceneLayer layer{.id = "boundary", .name = "boundary of the tetrahedra"};
  layer.boundary = true;
  const bool whole = fewer_.triangles.empty();
  if (whole)
    for (const FaceId face : faces_)
      layer.faces.push_back(static_cast<std::uint32_t>(tet(tet_of(face))) << 2 | (face & 3));
  for (std::size_t i = 0; i < fewer_.triangles.size(); ++i) {
    std::array<Index, 3> t = fewer_.triangles[i];
    for (Index& v : t) v = point(v);
    layer.triangles.push_back(t);
    layer.tets.push_back(tet(tet_of(faces_[fewer_.from[i]])));
  }
  if (fewer_.cell > 0)
    left_out_.push_back(fmt::format(
        "The boundary of {} is drawn by {}: points within {:.3g} of each other may be joined. A click on one "
        "tells "
        "about one of the tetrahedra behind it.",
        io::counted(faces_.size(), "faces"), io::counted(fewer_.triangles.size(), "triangles"), fewer_.cell));
  if (with_distances) {
    layer.values = distances({mesh_.points, whole ? triangles_ : fewer_.triangles}, *subject_.surface);
    scene_.value_name = "distance to the surface / diagonal of the box";
  }
  return layer;
}

}  // namespace tetproof::verify
