// SPDX-License-Identifier: GPL-3.0-or-later
// Statements about tetrahedra and points: volumes, order, numbers, overlaps.
#include <map>
#include <optional>
#include <set>

#include "corpus/report/statement_maker.hpp"
#include "corpus/truth.hpp"
#include "io/bytes/words.hpp"
#include "verify/findings_text.hpp"

namespace tetproof::corpus {

using nlohmann::json;

void StatementMaker::tet_volume() {
  const Index t = finding_.tets.front();
  if (!usable(t)) return no_such_point();
  const auto [a, b, c, d] = tet(t);
  const Rational volume = exact_volume(point(a), point(b), point(c), point(d));
  mark_tet(t);
  add("tet_volume", fmt::format("{} has volume {}", name(t), value_text(volume)),
      {{"tet", number(t)}, {"vertices", vertices_of(t)}, {"volume", text_of(volume)}});
  signs();
}

void StatementMaker::duplicates() {
  const auto& tets = finding_.tets;
  const auto same = [&](auto key) {
    std::map<decltype(key(Index{})), Index> first;
    for (const Index t : tets)
      if (const auto [found, fresh] = first.emplace(key(t), t); !fresh)
        return std::optional(std::array{found->second, t});
    return std::optional<std::array<Index, 2>>();
  };
  const auto by_vertices = [&](Index t) {
    auto v = tet(t);
    std::sort(v.begin(), v.end());
    return v;
  };
  const auto by_places = [&](Index t) {
    std::array<std::array<double, 3>, 4> places;
    for (std::size_t k = 0; k < 4; ++k)
      places[k] = {point(tet(t)[k])[0], point(tet(t)[k])[1], point(tet(t)[k])[2]};
    std::sort(places.begin(), places.end());
    return places;
  };
  if (const auto pair = same(by_vertices)) {
    mark_tet((*pair)[0]);
    add("same_vertices",
        fmt::format("{} have the same four vertices ({})", names(*pair), list(vertices_of((*pair)[0]))),
        {{"tets", numbers(*pair)}, {"vertices", vertices_of((*pair)[0])}});
  } else if (const auto place = same(by_places)) {
    mark_tet((*place)[0]);
    add("same_places", fmt::format("the corners of {} have the same coordinates", names(*place)),
        {{"tets", numbers(*place)}});
  }
}

void StatementMaker::face_orientation() {
  const Face face = finding_.faces.front();
  if (finding_.tets.size() != 2) return;
  std::vector<Index> apexes;
  int product = 1;
  for (const Index t : finding_.tets) {
    mark_tet(t);
    for (const Index v : tet(t))
      if (std::find(face.begin(), face.end(), v) == face.end()) {
        apexes.push_back(v);
        product *= orientation(point(face[0]), point(face[1]), point(face[2]), point(v));
      }
  }
  marks.faces.push_back(face);
  const json values{{"face", vertex_numbers(face)}, {"tets", numbers(finding_.tets)}};
  if (product > 0 && apexes.size() == 2) {
    json with_apexes = values;
    with_apexes["apexes"] = vertex_numbers(apexes);
    add("same_side",
        fmt::format("{} share {} and lie on the same side of it (their fourth vertices {} and {} do)",
                    names(finding_.tets), name(face), vertex(apexes[0]), vertex(apexes[1])),
        with_apexes);
  }
  add("same_order",
      fmt::format("{} name {} in the same direction: the orders of their vertices contradict each other",
                  names(finding_.tets), name(face)),
      values);
  signs();
}

void StatementMaker::overlap() {
  if (finding_.tets.size() != 2 || !finding_.point) return;
  for (const Index t : finding_.tets) mark_tet(t);
  marks.points.push_back(*finding_.point);
  json values{{"tets", numbers(finding_.tets)}, {"point", json::array()}};
  const bool exact = !finding_.point_exact[0].empty();
  for (std::size_t k = 0; k < 3; ++k)
    values["point"].push_back(exact ? finding_.point_exact[k]
                                    : text_of(Rational((*finding_.point)[static_cast<int>(k)])));
  add("tets_overlap",
      fmt::format("{} overlap: a point near ({:.6g}, {:.6g}, {:.6g}) is strictly inside both",
                  names(finding_.tets), finding_.point->x(), finding_.point->y(), finding_.point->z()),
      values);
}

void StatementMaker::no_such_point() {
  for (const Index t : finding_.tets) {
    std::set<std::int64_t> missing;
    for (const Index v : tet(t))
      if (v < 0 || v >= static_cast<Index>(mesh_.points.size())) missing.insert(judged_.numbering.point(v));
    if (missing.empty()) continue;
    return add("no_such_point",
               fmt::format("{} names {}, which the file does not have", name(t),
                           missing.size() == 1 ? fmt::format("vertex {}", *missing.begin())
                                               : fmt::format("vertices {}", fmt::join(missing, " "))),
               {{"tet", number(t)}, {"vertices", missing}});
  }
  if (usable(finding_.tets.front())) tet_volume();  // all numbers are shifted: some tetrahedra are negative
}

void StatementMaker::not_finite() {
  const Index v = finding_.vertices.front();
  const Eigen::Vector3d& p = point(v);
  for (const Index t : finding_.tets) mark_tet(t);
  add("not_finite",
      fmt::format("vertex {}, which tetrahedra use, has the coordinates ({}, {}, {})", vertex(v), p.x(),
                  p.y(), p.z()),
      {{"vertex", vertex(v)}});
}

void StatementMaker::repeated_vertex() {
  const Index t = finding_.tets.front();
  mark_tet(t);
  add("repeated_vertex", fmt::format("{} names a vertex twice", name(t)), {{"tet", number(t)}});
}

void StatementMaker::same_place() {
  marks.vertices = finding_.vertices;
  add("same_place",
      fmt::format("vertices {} have the same coordinates", list(vertex_numbers(finding_.vertices))),
      {{"vertices", vertex_numbers(finding_.vertices)}});
}

void StatementMaker::unused_point() {
  marks.vertices = finding_.vertices;
  add("unused_point", fmt::format("vertex {} belongs to no tetrahedron", vertex(finding_.vertices.front())),
      {{"vertex", vertex(finding_.vertices.front())}});
}

void StatementMaker::quote() {
  for (const Index t : finding_.tets) mark_tet(t);
  mark_faces();
  const std::string said = verify::finding_text(finding_, judged_.numbering);
  add("report", fmt::format("the judge says: {}", said.substr(0, said.find('\n'))),
      {{"why", "these are the judge's words"}});
}

void StatementMaker::signs() {
  if (!all_usable()) return;
  std::array<std::int64_t, 3> count{};  // negative, flat, positive
  for (const auto& [a, b, c, d] : mesh_.tets)
    ++count[static_cast<std::size_t>(1 + orientation(point(a), point(b), point(c), point(d)))];
  add("signs",
      fmt::format("of the {}, {} have positive, {} negative and {} zero volume",
                  io::counted(mesh_.tets.size(), "tetrahedra"), count[2], count[0], count[1]),
      {{"positive", count[2]}, {"negative", count[0]}, {"flat", count[1]}});
}

}  // namespace tetproof::corpus
