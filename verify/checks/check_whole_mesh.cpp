// SPDX-License-Identifier: GPL-3.0-or-later
// Reports the faults that concern the mesh as a whole, once each, and names them as causes.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include "io/bytes/words.hpp"
#include "verify/checks/root_causes.hpp"
#include "verify/checks/whole_mesh.hpp"

namespace tetproof::verify {
namespace {

// Runs of an ascending list.
void add_runs(const std::vector<Index>& tets, std::vector<std::array<Index, 2>>& runs) {
  for (std::size_t i = 0; i < tets.size(); ++i)
    if (i > 0 && tets[i] == tets[i - 1] + 1)
      runs.back()[1] = tets[i];
    else
      runs.push_back({tets[i], tets[i]});
}

// Shortens the list of tetrahedra, if it is long, to the first ones.
void shorten(Finding& finding) {
  if (finding.tets.size() > most_findings) finding.tets.resize(most_findings);
}

void report_shift(const TetMesh& mesh, const PointEvidence& points, const TetrahedraEvidence& tetrahedra,
                  const WholeMeshEvidence& whole, Record& record) {
  Finding finding{.tets = points.out_of_range};
  finding.tets.insert(finding.tets.end(), tetrahedra.signs.negative.begin(), tetrahedra.signs.negative.end());
  finding.tets.insert(finding.tets.end(), tetrahedra.signs.flat.begin(), tetrahedra.signs.flat.end());
  shorten(finding);
  finding.tet_runs = {{0, static_cast<Index>(mesh.tets.size()) - 1}};
  const Index shift = whole.shift;
  const std::size_t no_sign = tetrahedra.signs.negative.size() + tetrahedra.signs.flat.size();
  finding.what = fmt::format(
      "all vertex numbers are {} too {}{}: {} that do not exist, {} negative or flat; with numbers {} {}: {}",
      std::abs(shift), shift > 0 ? "high" : "low",
      shift == 1    ? ", as if numbers from 1 were read as numbers from 0"
      : shift == -1 ? ", as if numbers from 0 were read as numbers from 1"
                    : "",
      points.out_of_range.size() == 1 ? "1 tetrahedron names points"
                                      : fmt::format("{} tetrahedra name points", points.out_of_range.size()),
      no_sign == 1 ? "1 is" : fmt::format("{} are", no_sign), std::abs(shift), shift > 0 ? "lower" : "higher",
      whole.faulty_after == 0 ? "none" : fmt::format("{} of them", whole.faulty_after));
  record[Check::index_range] = Suspects::complete({std::move(finding)});
  record.blame({Check::index_range, 0}, {Check::finite_coordinates, Check::duplicate_point});
}

void report_other_order(const TetrahedraEvidence& tetrahedra, const WholeMeshEvidence& whole,
                        Record& record) {
  const std::vector<OtherOrder>& sets = whole.other_order;
  std::vector<Index> single = tetrahedra.signs.negative;
  for (const OtherOrder& set : sets)
    std::erase_if(single,
                  [&](Index t) { return std::binary_search(set.negative.begin(), set.negative.end(), t); });
  const std::size_t singles = single.size();
  record[Check::inverted] = {
      .count = sets.size() + singles,
      .finding =
          [&sets, single = std::move(single)](std::size_t i) {
            return i < sets.size() ? Finding{.tets = sets[i].negative}
                                   : Finding{.tets = {single[i - sets.size()]}};
          },
      .describe =
          [&sets, one_by_one = record[Check::inverted].describe](std::size_t i, Finding& finding) {
            if (i >= sets.size()) return one_by_one(i, finding);
            const OtherOrder& set = sets[i];
            const auto negative = static_cast<std::int64_t>(set.negative.size());
            add_runs(set.negative, finding.tet_runs);
            shorten(finding);
            finding.what = fmt::format("{}{}{} are negative: their vertices are in the other order{}",
                                       negative == set.tets ? "all " : fmt::format("{} of ", negative),
                                       io::counted(set.tets, "tetrahedra"), set.of_region,
                                       set.region ? "" : ", or the mesh is mirrored");
          }};
  if (sets[0].region) return;
  const auto other_order = [](std::size_t) { return Cause{Check::inverted, 0}; };
  for (const Check check : {Check::volume_surface, Check::volume_voxel, Check::normals, Check::topology})
    record[check].add_cause(other_order);
}

void report_copies(const TetMesh& mesh, const PointEvidence& points, const WholeMeshEvidence& whole,
                   Record& record) {
  const std::vector<std::vector<Index>>& copies = whole.copies;
  Finding finding;
  std::vector<Index> first, later;
  for (const std::vector<Index>& same : copies) {
    finding.tets.insert(finding.tets.end(), same.begin(), same.end());
    first.push_back(same[0]);
    later.insert(later.end(), same.begin() + 1, same.end());
  }
  std::sort(later.begin(), later.end());
  std::vector<std::uint8_t> copied(mesh.points.size(), 0);
  for (const Index t : finding.tets)
    for (const Index v : mesh.tets[t]) copied[v] = 1;

  Suspects& suspects = record[Check::duplicate_tet];
  const std::size_t before = suspects.count;
  const auto describe_copies = [&mesh, first = std::move(first), later = std::move(later)](Finding& found) {
    const std::size_t all = mesh.tets.size();
    if (found.tets.size() > 2) add_runs(first, found.tet_runs), add_runs(later, found.tet_runs);
    shorten(found);
    const char* how = "with equal coordinates and other vertex numbers";
    found.what = first.size() + later.size() == all && first.size() == later.size() && all > 2
                     ? fmt::format("the mesh stands twice: {} of {}, {}", later.size(),
                                   io::counted(all, "tetrahedra"), how)
                     : fmt::format("{} again, {}",
                                   later.size() == 1 ? "1 tetrahedron stands there"
                                                     : fmt::format("{} tetrahedra stand there", later.size()),
                                   how);
  };
  record[Check::duplicate_tet] = {
      .count = before + 1,
      .finding = [numbered = suspects.finding, before,
                  copies = std::move(finding)](std::size_t i) { return i < before ? numbered(i) : copies; },
      .describe =
          [numbered = suspects.describe, before, describe_copies](std::size_t i, Finding& found) {
            if (i >= before)
              describe_copies(found);
            else if (numbered)
              numbered(i, found);
          }};
  record[Check::duplicate_point].add_cause(
      [&points, copied = std::move(copied), before](std::size_t i) -> std::optional<Cause> {
        const std::vector<Index>& same = points.same_place[i];
        if (!std::all_of(same.begin(), same.end(), [&](Index v) { return copied[v] != 0; }))
          return std::nullopt;
        return Cause{Check::duplicate_tet, before};
      });
}

}  // namespace

void check_whole_mesh(const TetMesh& mesh, const PointEvidence& points, const TetrahedraEvidence& tetrahedra,
                      const WholeMeshEvidence& whole, Record& record) {
  if (whole.shift != 0) return report_shift(mesh, points, tetrahedra, whole, record);
  if (!whole.other_order.empty()) report_other_order(tetrahedra, whole, record);
  if (!whole.copies.empty()) report_copies(mesh, points, whole, record);
}

}  // namespace tetproof::verify
