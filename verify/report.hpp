// SPDX-License-Identifier: GPL-3.0-or-later
// What the judge says: a verdict per check, findings with their places, counts and measures.
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

/// The checks, in the order in which they are reported: a cause stands before what follows from it.
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
  near_contact,
  cavity,
  boundary_nonmanifold_edge,
  boundary_nonmanifold_vertex,
  boundary_self_intersection,
  overlap,
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
inline constexpr int check_count = 28;

/// What a finding of a check means for the verdict.
enum class Severity {
  fail,      ///< the mesh is defective
  warning,   ///< worth knowing, never defective
  topology,  ///< a warning that fails under strict topology
};

/// One row of --list-checks.
struct CheckInfo {
  Check check;
  const char* id;      ///< stable, users script against it
  const char* proves;  ///< what it proves or measures
  const char* exact;   ///< "exact", or the error it states
  Severity severity;
  bool certificate;    ///< the certificate needs it
  bool needs_surface;  ///< skipped without a surface
};

const CheckInfo& info(Check check);
/// The check with this id; InputError when there is none.
Check check_of_id(const std::string& id);

enum class Verdict { pass, warning, fail, undecided, skipped };

/// Findings of another check that follow from a finding.
struct Consequence {
  Check check;
  std::int64_t count = 0;
};

/// A place where a check does not hold. Positions in the arrays of the TetMesh; reports print the file's
/// numbers.
struct Finding {
  std::vector<Index> tets{};
  std::vector<Index> vertices{};
  std::vector<std::array<Index, 3>> faces{};  ///< three vertices each
  std::optional<Eigen::Vector3d> point{};     ///< [length], rounded from `point_exact` where that is given
  std::array<std::string, 3> point_exact{};   ///< rationals "n/d"; empty when doubles say it
  std::string what{};
  std::vector<Consequence> consequences{};
};

struct CheckResult {
  Check check{};
  Verdict verdict = Verdict::skipped;
  std::int64_t count = 0;         ///< all findings that have their root here
  std::int64_t consequences = 0;  ///< findings of this check that follow from another's, listed there
  std::optional<double> measured{}, allowed{};
  std::vector<Finding> findings{};  ///< the first of them
};

/// Counts and volume of a mesh or a surface. `components` are the closed sheets of the boundary, `cavities`
/// those of them that bound a cavity, `genus` the sum over the sheets. A boundary is cut into sheets at its
/// non-manifold edges, where faces that bound the same wedge of tetrahedra stay together, and at its
/// non-manifold vertices, one copy per fan. Absent when the faces do not match or the boundary has open
/// edges.
struct Shape {
  std::int64_t points = 0, tets = 0, boundary_faces = 0;
  std::optional<std::int64_t> components{}, cavities{}, genus{};
  std::vector<std::int64_t> genus_per_component{};
  std::optional<double> volume{};  ///< [length^3], the exact volume rounded once
};

struct VolumeAccount {
  std::optional<double> mesh, surface, relative_difference;  ///< exact values rounded once
  std::optional<double> voxel_inside, voxel_error_bound, voxel_error_estimate;
  std::optional<double> missing, excess;  ///< of the regions found, by voxels; absent when not looked for
};

/// The directed Hausdorff distances between the mesh's boundary and the surface [length]: each is at least
/// what is given and at most `error_bound` more. With region outside the mesh's own outer boundary is left
/// out.
struct Fidelity {
  std::optional<double> mesh_to_surface, surface_to_mesh;
  double error_bound = 0, allowed = 0;
};

/// A distribution: `counts[i]` values lie in [edges[i], edges[i+1]), the last from edges[i] on; lower ones
/// are in the first.
struct Distribution {
  double min = 0, max = 0;
  std::vector<double> edges{};
  std::vector<std::int64_t> counts{};
};

/// In double arithmetic. Angles: absolute error of some 1e-15 radians, but for nearly flat tetrahedra, where
/// the rounding of their coordinates' differences is seen.
struct Quality {
  std::int64_t tets = 0;         ///< those measured: of positive volume
  Distribution dihedral_angles;  ///< [degrees], six a tetrahedron
  Distribution solid_angles;     ///< [full angle 4 pi], four a tetrahedron
  Distribution aspect_ratios;    ///< longest edge / (2 sqrt(6) inradius): 1 for the regular tetrahedron
};

/// One region of a mesh of several. Boundary faces are those that no other tetrahedron of the region has:
/// faces shared with other regions are among them.
struct RegionAccount {
  std::int64_t tag = 0;
  Shape shape{};
};

struct Report {
  std::vector<CheckResult> checks;  ///< all, in the order of `Check`
  std::optional<bool> certificate;  ///< absent when a check that it needs was skipped and none failed
  Shape mesh;
  std::vector<RegionAccount> regions;  ///< by their tags; empty where there is one only
  std::optional<Shape> surface;
  VolumeAccount volume;
  std::optional<Fidelity> fidelity;  ///< absent when no distance was measured
  std::optional<Quality> quality;
  std::vector<std::string> notes;
  std::vector<std::pair<std::string, double>> seconds;  ///< wall time per phase, only when asked for

  const CheckResult& operator[](Check check) const { return checks[static_cast<std::size_t>(check)]; }
};

/// No check failed.
bool sound(const Report& report);

/// For people: the verdict, what is wrong and where, then counts and volumes. Numbers as in the file.
std::string report_text(const Report& report, const Numbering& numbering = {});
/// The keys are a contract: `--json` of tetproof-verify.
std::string report_json(const Report& report, const Numbering& numbering = {});
/// JUnit XML for CI systems: `mesh`, a test suite of this name; each check, a test case that may fail or be
/// skipped; warnings and what is undecided in its system-out. What XML cannot hold of the name is replaced.
std::string report_junit(const Report& report, const std::string& mesh, const Numbering& numbering = {});
/// The table of --list-checks.
std::string list_checks();

}  // namespace tetproof::verify
