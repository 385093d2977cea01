// SPDX-License-Identifier: GPL-3.0-or-later
// The judge's report: a verdict for each check, findings with their places, counts and measures.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/tet_mesh.hpp"

namespace tetproof::verify {

/// The checks, in the order in which they are reported: causes before their consequences.
enum class Check {
  index_range,
  finite_coordinates,
  repeated_vertex,
  duplicate_point,
  unused_point,
  duplicate_tet,
  inverted,
  flat,
  face_shared_thrice,
  face_orientation,
  hanging_node,
  crossed_diagonal,
  crack,
  non_conforming_interface,
  near_contact,
  cavity,
  boundary_nonmanifold_edge,
  boundary_nonmanifold_vertex,
  boundary_self_intersection,
  overlap,
  bounding_box,
  missing_region,
  excess_region,
  off_surface_vertex,
  topology,
  volume_surface,
  volume_voxel,
  mesh_to_surface,
  surface_to_mesh,
  normals,
};
/// The number of checks. The table of checks asserts that it has a row for each.
inline constexpr int check_count = static_cast<int>(Check::normals) + 1;

/// How a finding of a check affects the verdict.
enum class Severity {
  fail,      ///< the mesh is defective
  warning,   ///< a warning, which never makes the mesh defective
  topology,  ///< a warning that becomes a failure under strict topology
};

/// One row of --list-checks.
struct CheckInfo {
  Check check;
  const char* id;        ///< stable: users script against it
  const char* proves;    ///< the statement that it proves, or the quantity that it measures
  const char* accuracy;  ///< "exact", or the error that it states
  Severity severity;
  bool all_exact;      ///< it rests on exact decisions alone
  bool certificate;    ///< the certificate needs it
  bool needs_surface;  ///< it is skipped without a surface
};

const CheckInfo& info(Check check);
/// The check with this id; InputError when there is none.
Check check_of_id(const std::string& id);
/// The ids of all checks, in their order.
std::vector<std::string> check_ids();

enum class Verdict { pass, warning, fail, undecided, skipped };

/// Findings of another check that are consequences of a finding.
struct Consequence {
  Check check;
  std::int64_t count = 0;
};

/// A place where a check does not hold. Elements are given by their positions in the arrays of the TetMesh;
/// reports print the numbers of the file.
struct Finding {
  std::vector<Index> tets{};
  /// Where a finding concerns more tetrahedra than `tets` lists: all of them, as runs. First and last
  /// position of each run.
  std::vector<std::array<Index, 2>> tet_runs{};
  std::vector<Index> vertices{};
  std::vector<std::array<Index, 3>> faces{};  ///< three vertices each
  std::optional<Eigen::Vector3d> point{};     ///< [length], rounded from `point_exact` where that is given
  std::array<std::string, 3> point_exact{};   ///< rationals "n/d"; empty where `point` is exact
  std::string what{};
  std::vector<Consequence> consequences{};
};

struct CheckResult {
  Check check{};
  Verdict verdict = Verdict::skipped;
  std::int64_t count = 0;         ///< all findings that are not consequences of others
  std::int64_t consequences = 0;  ///< findings that are consequences of another check's, and counted there
  std::optional<double> measured{}, allowed{};
  std::vector<Finding> findings{};  ///< the first of those that `count` counts
  std::string why{};                ///< the reason, if it was skipped
};

/// Elements or checks that the verdict does not cover.
struct NotJudged {
  std::string what;  ///< "hexahedra", "cells of type 42", "check volume-voxel"
  std::int64_t count = 0;
  std::string why;  ///< the reason: "only tetrahedra are judged"
};

/// Counts and volume of a mesh or a surface. `components` counts the closed sheets of the boundary,
/// `cavities` those of them that bound a cavity; `genus` is the sum over the sheets. A boundary is cut into
/// sheets at its non-manifold edges, where faces that bound the same wedge of tetrahedra stay together, and
/// at its non-manifold vertices, with one copy of the vertex for each fan. The three are absent when the
/// faces do not match or the boundary has open edges.
struct Shape {
  std::int64_t points = 0, tets = 0, boundary_faces = 0;
  std::optional<std::int64_t> components{}, cavities{}, genus{};
  std::vector<std::int64_t> genus_per_component{};
  std::optional<double> volume{};  ///< [length^3], the exact volume rounded once
};

struct VolumeAccount {
  std::optional<double> mesh, surface, relative_difference;  ///< exact values rounded once
  std::optional<double> voxel_inside, voxel_error_bound, voxel_error_estimate;
  std::optional<double> missing, excess;  ///< volume of such regions, by voxels; absent when not looked for
};

/// The directed Hausdorff distances between the mesh's boundary and the surface [length]: each is at least
/// the given value, and at most `error_bound` more. With region outside, the mesh's own outer boundary is
/// left out.
struct Fidelity {
  std::optional<double> mesh_to_surface, surface_to_mesh;
  double error_bound = 0, allowed = 0;
  /// A point of the boundary (of the surface) whose distance to the other is at least the given value, up to
  /// rounding. Absent if the distance is 0 or was not measured.
  std::optional<Eigen::Vector3d> mesh_to_surface_at{}, surface_to_mesh_at{};
};

/// A distribution: `counts[i]` values lie in [edges[i], edges[i+1]). The last interval has no upper end, and
/// values below the first edge are counted in the first interval.
struct Distribution {
  double min = 0, max = 0;
  std::vector<double> edges{};
  std::vector<std::int64_t> counts{};
};

/// Dihedral angles and aspect ratios have a relative error below 2e-11, at every scale and however flat the
/// tetrahedron: where doubles would lose more, volume and normals are computed exactly. So do solid angles,
/// except at a vertex whose edges to two others are nearly opposite: if the three angles between its edges
/// are a, b, c, add 1e-14 / (1 + cos a + cos b + cos c).
struct Quality {
  std::int64_t tets = 0;         ///< tetrahedra that were measured: those of positive volume
  Distribution dihedral_angles;  ///< [degrees], six a tetrahedron
  Distribution solid_angles;     ///< [full angle 4 pi], four a tetrahedron
  Distribution aspect_ratios;    ///< longest edge / (2 sqrt(6) inradius): 1 for the regular tetrahedron
};

/// One region of a mesh of several regions. Its boundary faces belong to one tetrahedron of the region; faces
/// that it shares with other regions are among them.
struct RegionAccount {
  RegionTag tag{};
  Shape shape{};
};

/// The report on a mesh without the faults that concern it as a whole: re-wound, with other vertex numbers,
/// without its second copy. It shows what else is wrong. The mesh itself is judged as it is written.
struct Mended {
  std::string how;  ///< what was changed: "42 tetrahedra in the other vertex order"
  std::optional<bool> certificate;
  std::vector<CheckResult> checks;  ///< as in `Report`; elements are those of the mesh as it is written
};

struct Report {
  std::vector<CheckResult> checks;  ///< one for each check, in the order of `Check`
  /// Absent when a check that it needs was skipped and none failed. If it is given although findings are
  /// allowed, it holds except for these: with cracks closed, and for each part of a non-conforming interface.
  std::optional<bool> certificate;
  std::vector<Consequence> allowed;  ///< findings that `Options::allow` names, with their counts
  std::optional<Mended> if_mended;   ///< absent if no fault concerns the mesh as a whole
  /// Elements and checks that should have been judged and were not: with any, no verdict is sound.
  std::vector<NotJudged> not_judged;
  /// Elements and checks that the options left out. The verdict is about the rest, and says so.
  std::vector<NotJudged> left_out;
  bool by_corners = false;  ///< there are curved tetrahedra: all that is said of them is about their corners
  Shape mesh;
  std::vector<RegionAccount> regions;  ///< in the order of their tags; empty if there is only one region
  std::optional<Shape> surface;
  VolumeAccount volume;
  std::optional<Fidelity> fidelity;  ///< absent when no distance was measured
  std::optional<Quality> quality;
  std::vector<std::string> notes;
  std::vector<std::pair<std::string, double>> seconds;  ///< wall time per phase, only when asked for

  const CheckResult& operator[](Check check) const { return checks[static_cast<std::size_t>(check)]; }
};

/// A check failed.
bool defective(const Report& report);
/// No check failed, and everything was judged. A report that is neither sound nor defective is incomplete.
bool sound(const Report& report);

/// The report for people: the verdict, what is wrong and where, then counts and volumes. Numbers as in the
/// file.
std::string report_text(const Report& report, const Numbering& numbering = {});
/// The report as JSON: the text that `tetproof-verify --json` writes. The keys are a contract:
/// verify/reports/report.schema.json.
std::string report_json(const Report& report, const Numbering& numbering = {});
/// The report as JUnit XML for CI systems. The test suite is called `mesh`; characters that XML cannot hold
/// are replaced. Each check is a test case that may fail or be skipped; its system-out has warnings and
/// undecided results. What was not judged is a skipped test case, too.
std::string report_junit(const Report& report, const std::string& mesh, const Numbering& numbering = {});
/// The table of --list-checks.
std::string list_checks();

}  // namespace tetproof::verify
