// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the faults that concern the mesh as a whole, and mends them.
#include "verify/checks/whole_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "io/bytes/words.hpp"
#include "verify/findings_text.hpp"
#include "verify/mesh/copies.hpp"

namespace tetproof::verify {
namespace {

bool nearly_all(std::size_t some, std::int64_t all) {
  return some > 1 && 10 * static_cast<std::int64_t>(some) >= 9 * all;
}

std::vector<OtherOrder> in_the_other_order(const TetMesh& mesh, const Orientations& signs,
                                           const std::vector<std::uint8_t>& excluded,
                                           const Options& options) {
  const std::vector<std::int64_t>& regions = options.regions;
  if (signs.negative.size() < 2) return {};
  const auto without = static_cast<std::int64_t>(std::count(excluded.begin(), excluded.end(), 1)) +
                       static_cast<std::int64_t>(signs.flat.size());
  const auto all = static_cast<std::int64_t>(mesh.tets.size()) - without;
  if (nearly_all(signs.negative.size(), all)) return {{std::nullopt, "", signs.negative, all}};
  if (regions.empty()) return {};
  std::map<std::int64_t, OtherOrder> by_region;
  for (const Index t : signs.negative) by_region[regions[t]].negative.push_back(t);
  for (std::size_t t = 0; t < regions.size(); ++t)
    if (const auto found = by_region.find(regions[t]);
        found != by_region.end() && (excluded.empty() || !excluded[t]))
      ++found->second.tets;
  for (const Index t : signs.flat)
    if (const auto found = by_region.find(regions[t]); found != by_region.end()) --found->second.tets;
  std::vector<OtherOrder> result;
  for (auto& [region, set] : by_region) {
    set.region = region;
    set.of_region = " of " + (options.region_tags.empty()
                                  ? fmt::format("region {}", region)
                                  : region_text(options.region_tags[static_cast<std::size_t>(region)]));
    if (nearly_all(set.negative.size(), set.tets)) result.push_back(std::move(set));
  }
  return result;
}

// Tetrahedra that have no sign, or another one than most.
std::int64_t faulty(const TetMesh& mesh, const Orientations& signs, std::int64_t excluded) {
  const auto negative = static_cast<std::int64_t>(signs.negative.size()),
             flat = static_cast<std::int64_t>(signs.flat.size());
  return excluded + flat +
         std::min(negative, static_cast<std::int64_t>(mesh.tets.size()) - excluded - flat - negative);
}

TetMesh shifted(TetMesh mesh, Index shift) {
  for (auto& tet : mesh.tets)
    for (Index& v : tet) v -= shift;
  return mesh;
}

// Finds a number by which all vertex numbers are too high. Shifted back, they must reach from the first point
// or to the last one, and nine tenths of the faulty tetrahedra must be right. The connectivity does not
// change, so that only the signs of the tetrahedra tell. A wrong shift makes a tetrahedron positive by chance
// in one of two cases: without a point that does not exist, a dozen tetrahedra must agree.
void find_shift(const TetMesh& mesh, const PointEvidence& points, const Orientations& signs,
                const Record& record, WholeMeshEvidence& evidence) {
  if (points.out_of_range.empty() && signs.negative.empty() && signs.flat.empty()) return;
  Index lowest = std::numeric_limits<Index>::max(), highest = std::numeric_limits<Index>::min();
  for (const auto& tet : mesh.tets)
    for (const Index v : tet) lowest = std::min(lowest, v), highest = std::max(highest, v);
  const auto count = static_cast<std::int64_t>(mesh.points.size());
  if (highest - std::int64_t{lowest} >= count) return;
  const auto excluded = [&](const PointEvidence& p) {
    return static_cast<std::int64_t>(std::count(p.excluded.begin(), p.excluded.end(), 1));
  };
  evidence.faulty = faulty(mesh, signs, excluded(points));
  if (evidence.faulty == 0 || (points.out_of_range.empty() && mesh.tets.size() < 12)) return;
  for (const std::int64_t shift : {std::int64_t{lowest}, highest - count + 1}) {
    if (shift == 0 || lowest - shift < 0 || highest - shift >= count) continue;
    const TetMesh back = shifted(mesh, static_cast<Index>(shift));
    const PointEvidence p = examine_points(back, record);
    const std::int64_t after = faulty(back, orientations(back, p.excluded), excluded(p));
    if (10 * after > evidence.faulty) continue;
    evidence.shift = static_cast<Index>(shift);
    evidence.faulty_after = after;
    return;
  }
}

// Exchanges two vertices of each tetrahedron of the mesh or the region. Returns their number.
std::int64_t turn(TetMesh& mesh, const std::vector<std::int64_t>& regions, const OtherOrder& set) {
  std::int64_t count = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (set.region && regions[t] != *set.region) continue;
    std::swap(mesh.tets[t][2], mesh.tets[t][3]);
    ++count;
  }
  return count;
}

// Keeps the items that are not marked.
template <class T>
void keep(std::vector<T>& list, const std::vector<std::uint8_t>& removed) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!removed[i]) list[kept++] = list[i];
  list.resize(kept);
}

// Removes all copies except for the first of each set, with the points that are then of no use. Returns the
// number of tetrahedra.
std::int64_t remove_copies(MendedMesh& mended, const std::vector<std::vector<Index>>& copies) {
  TetMesh& mesh = mended.mesh;
  const auto in_range = [&](Index v) { return v >= 0 && v < static_cast<Index>(mesh.points.size()); };
  std::vector<std::uint8_t> tet(mesh.tets.size(), 0), point(mesh.points.size(), 0);
  std::int64_t removed = 0;
  for (const auto& same : copies)
    for (std::size_t i = 1; i < same.size(); ++i) {
      tet[same[i]] = 1;
      ++removed;
      for (const Index v : mesh.tets[same[i]]) point[v] = 1;
    }
  keep(mesh.tets, tet);
  keep(mended.tets, tet);
  if (!mended.options.regions.empty()) keep(mended.options.regions, tet);
  for (const auto& other : mesh.tets)
    for (const Index v : other)
      if (in_range(v)) point[v] = 0;
  for (const Index v : mended.options.unjudged.points)
    if (in_range(v)) point[v] = 0;

  std::vector<Index> place(mesh.points.size(), 0);  // of a point that is kept
  for (std::size_t v = 0, kept = 0; v < place.size(); ++v)
    if (!point[v]) place[v] = static_cast<Index>(kept++);
  const Index dropped = static_cast<Index>(std::count(point.begin(), point.end(), 1));
  const auto move = [&](Index& v) {
    if (in_range(v))
      v = place[v];
    else if (v > 0)
      v -= dropped;  // it stays as far out of range
  };
  for (auto& other : mesh.tets) std::for_each(other.begin(), other.end(), move);
  std::for_each(mended.options.unjudged.points.begin(), mended.options.unjudged.points.end(), move);
  keep(mesh.points, point);
  keep(mended.vertices, point);
  return removed;
}

}  // namespace

WholeMeshEvidence examine_whole_mesh(const TetMesh& mesh, const PointEvidence& points,
                                     const TetrahedraEvidence& tetrahedra, const Options& options,
                                     const Record& record) {
  WholeMeshEvidence evidence;
  if (record.wants(Check::index_range)) find_shift(mesh, points, tetrahedra.signs, record, evidence);
  if (record.wants(Check::inverted) && evidence.shift == 0)
    evidence.other_order = in_the_other_order(mesh, tetrahedra.signs, points.excluded, options);
  if (record.wants(Check::duplicate_tet) && evidence.shift == 0)
    evidence.copies = find_copies(mesh, points.excluded, points.same_place);
  return evidence;
}

std::optional<MendedMesh> mend(const TetMesh& mesh, const PointEvidence& points,
                               const WholeMeshEvidence& whole, const Options& options, const Record& record) {
  if (whole.shift == 0 && whole.other_order.empty() && whole.copies.empty()) return std::nullopt;
  MendedMesh mended{.mesh = mesh, .options = options, .tets = {}, .vertices = {}, .how = {}};
  mended.options.timings = mended.options.quality = false;
  mended.tets.resize(mesh.tets.size());
  mended.vertices.resize(mesh.points.size());
  std::iota(mended.tets.begin(), mended.tets.end(), 0);
  std::iota(mended.vertices.begin(), mended.vertices.end(), 0);
  const auto say = [&](const std::string& step) { mended.how += (mended.how.empty() ? "" : ", ") + step; };
  std::vector<OtherOrder> other_order = whole.other_order;
  std::vector<std::vector<Index>> copies = whole.copies;
  if (whole.shift != 0) {
    mended.mesh = shifted(std::move(mended.mesh), whole.shift);
    say(fmt::format("all vertex numbers {} {}", std::abs(whole.shift), whole.shift > 0 ? "lower" : "higher"));
    const PointEvidence right = examine_points(mended.mesh, record);
    other_order = in_the_other_order(mended.mesh, orientations(mended.mesh, right.excluded), right.excluded,
                                     mended.options);
    copies = find_copies(mended.mesh, right.excluded, points.same_place);
  }
  for (const OtherOrder& set : other_order)
    say(fmt::format("{}{} in the other vertex order",
                    io::counted(turn(mended.mesh, mended.options.regions, set), "tetrahedra"),
                    set.of_region));
  if (!copies.empty())
    say(fmt::format("one of each set of equal tetrahedra ({} left out)", remove_copies(mended, copies)));
  return mended;
}

}  // namespace tetproof::verify
