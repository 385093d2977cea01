// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/checks/root_causes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetproof::verify {
namespace {

using Set = std::uint64_t;  // a set of checks, one bit for each
constexpr Set set() {
  return 0;
}
template <class... More>
constexpr Set set(Check check, More... more) {
  return Set{1} << static_cast<int>(check) | set(more...);
}

static_assert(check_count <= 64, "a set has a bit for each check");

// Tetrahedra that miss vertices, and tetrahedra that take no part in what follows.
constexpr Set without_vertices = set(Check::index_range, Check::repeated_vertex);
constexpr Set excluded = without_vertices | set(Check::finite_coordinates);
constexpr Set unmatched = set(Check::face_shared_thrice, Check::face_orientation);
constexpr Set turned = set(Check::inverted, Check::flat);
constexpr Set misplaced = turned | set(Check::duplicate_tet);

// The checks whose findings can cause a finding: if the two share a tetrahedron, two vertices, or one vertex.
struct Causes {
  Set by_tet = 0, by_edge = 0, by_vertex = 0;
};
constexpr Causes causes(Check check) {
  switch (check) {
    case Check::inverted:
    case Check::flat:
    case Check::face_shared_thrice:
      return {set(Check::duplicate_tet), 0, 0};
    case Check::face_orientation:
      return {misplaced, 0, 0};
    case Check::cavity:  // an excluded tetrahedron leaves one; one that is wound the wrong way looks like one
      return {misplaced | unmatched, excluded | misplaced | unmatched, without_vertices};
    case Check::boundary_nonmanifold_edge:
      return {0, excluded | misplaced | unmatched | set(Check::cavity), without_vertices};
    case Check::boundary_nonmanifold_vertex:
      return {0, 0, excluded | misplaced | unmatched | set(Check::cavity)};
    // A moved vertex makes faces meet. A missing tetrahedron does not.
    case Check::boundary_self_intersection:
      return {misplaced | unmatched, 0, turned};
    case Check::overlap:
      return {misplaced | unmatched, 0, set(Check::boundary_self_intersection)};
    default:
      return {};
  }
}

constexpr bool can_cause(Check check) {
  constexpr Set all =
      excluded | misplaced | unmatched | set(Check::cavity, Check::boundary_self_intersection);
  return all >> static_cast<int>(check) & 1;
}

// The places of earlier findings: the first finding at each tetrahedron and at each vertex. Cavities have a
// list of their own, so that they do not hide another cause at the same vertex.
class Roots {
 public:
  explicit Roots(const TetMesh& mesh) : mesh_(mesh) {}

  struct Root {
    Check check;
    std::size_t finding;  // position in its check's findings; past the reported ones: only counted
  };
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  const Root& operator[](std::uint32_t number) const { return roots_[number]; }

  // The number of the earliest finding that can have caused this one, or none.
  std::uint32_t of(const Finding& finding, const Causes& allowed) const {
    std::uint32_t best = none;
    const auto consider = [&](std::uint32_t root, Set checks) {
      if (root < best && (checks >> static_cast<int>(roots_[root].check) & 1) != 0) best = root;
    };
    const auto at = [](const std::vector<std::uint32_t>& roots, Index i) {
      return roots.empty() ? none : roots[static_cast<std::size_t>(i)];
    };
    for (const Index t : finding.tets) consider(at(at_tet_, t), allowed.by_tet);
    if (allowed.by_vertex != 0)
      for_each_vertex(finding, [&](Index v) {
        consider(at(at_vertex_, v), allowed.by_vertex);
        consider(at(cavity_at_vertex_, v), allowed.by_vertex);
      });
    if (allowed.by_edge != 0) {
      const auto edge = [&](Index a, Index b) {
        if (!in_range(a) || !in_range(b)) return;
        for (const auto* roots : {&at_vertex_, &cavity_at_vertex_})
          if (at(*roots, a) == at(*roots, b)) consider(at(*roots, a), allowed.by_edge);
      };
      if (finding.vertices.size() == 2) edge(finding.vertices[0], finding.vertices[1]);
      if (finding.vertices.empty())
        for (const auto& [a, b, c] : finding.faces) edge(a, b), edge(b, c), edge(c, a);
    }
    return best;
  }

  std::uint32_t add(Root root) {
    roots_.push_back(root);
    return static_cast<std::uint32_t>(roots_.size() - 1);
  }

  // From now on, findings that touch this one may be its consequences.
  void mark(const Finding& finding, std::uint32_t root) {
    const bool cavity = roots_[root].check == Check::cavity;
    if (!cavity)
      for (const Index t : finding.tets) claim(at_tet_, mesh_.tets.size(), t, root);
    for_each_vertex(finding, [&](Index v) {
      claim(cavity ? cavity_at_vertex_ : at_vertex_, mesh_.points.size(), v, root);
    });
  }
  // So may findings that touch the faces of a consequence. Its tetrahedra are not marked: some may be
  // innocent.
  void mark_consequence(const Finding& finding, std::uint32_t root) {
    for (const auto& face : finding.faces)
      for (const Index v : face)
        if (in_range(v)) claim(at_vertex_, mesh_.points.size(), v, root);
  }

 private:
  static void claim(std::vector<std::uint32_t>& at, std::size_t size, Index i, std::uint32_t root) {
    if (at.empty()) at.assign(size, none);
    if (at[static_cast<std::size_t>(i)] == none) at[static_cast<std::size_t>(i)] = root;
  }
  bool in_range(Index v) const { return v >= 0 && v < static_cast<Index>(mesh_.points.size()); }

  template <class Visit>
  void for_each_vertex(const Finding& finding, const Visit& visit) const {
    const auto known = [&](Index v) {
      if (in_range(v)) visit(v);
    };
    for (const Index v : finding.vertices) known(v);
    for (const auto& face : finding.faces)
      for (const Index v : face) known(v);
    for (const Index t : finding.tets)
      for (const Index v : mesh_.tets[t]) known(v);
  }

  const TetMesh& mesh_;
  std::vector<Root> roots_;
  std::vector<std::uint32_t> at_tet_, at_vertex_, cavity_at_vertex_;
};

void add_consequence(Finding& cause, Check check) {
  for (Consequence& known : cause.consequences)
    if (known.check == check) {
      ++known.count;
      return;
    }
  cause.consequences.push_back({check, 1});
}

}  // namespace

CheckCounts separate_causes(const TetMesh& mesh, const std::vector<Suspects>& suspects,
                            const std::array<bool, check_count>& allowed, Report& report) {
  // These come last: points in one place are consequences of the crack between the faces that name them.
  constexpr Set last = set(Check::duplicate_point, Check::unused_point);
  // Checks whose suspects other suspects can name as their cause.
  constexpr Set named =
      set(Check::index_range, Check::duplicate_tet, Check::inverted, Check::face_orientation,
          Check::hanging_node, Check::crossed_diagonal, Check::crack, Check::non_conforming_interface,
          Check::bounding_box, Check::missing_region, Check::excess_region, Check::off_surface_vertex);
  const auto is_in = [](Check check, Set checks) { return (checks >> static_cast<int>(check) & 1) != 0; };
  CheckCounts excused{};
  Roots roots(mesh);
  std::array<std::vector<std::uint32_t>, check_count> root_of;  // the root of each suspect of these checks
  const auto settle_check = [&](CheckResult& result) {
    const auto check = static_cast<std::size_t>(result.check);
    const Suspects& found = suspects[check];
    for (std::size_t i = 0; i < found.count; ++i) {
      Finding finding = found.finding(i);
      std::uint32_t root = Roots::none;
      if (const auto cause = found.cause ? found.cause(i) : std::nullopt)
        if (const auto& known = root_of[static_cast<std::size_t>(cause->check)];
            cause->suspect < known.size())
          root = known[cause->suspect];
      if (root == Roots::none) root = roots.of(finding, causes(result.check));
      const bool follows = root != Roots::none;
      if (follows) {
        ++result.consequences;
        if (allowed[static_cast<std::size_t>(roots[root].check)]) ++excused[check];
        roots.mark_consequence(finding, root);
        auto& findings = report.checks[static_cast<std::size_t>(roots[root].check)].findings;
        if (roots[root].finding < findings.size())
          add_consequence(findings[roots[root].finding], result.check);
      } else if (can_cause(result.check) || is_in(result.check, named)) {
        root = roots.add({result.check, static_cast<std::size_t>(result.count)});
        if (can_cause(result.check)) roots.mark(finding, root);
      }
      if (is_in(result.check, named)) root_of[check].push_back(root);
      if (follows) continue;
      ++result.count;
      if (result.findings.size() >= most_findings) continue;
      if (found.describe) found.describe(i, finding);
      result.findings.push_back(std::move(finding));
    }
    result.count += static_cast<std::int64_t>(found.beyond);
  };
  for (CheckResult& result : report.checks)
    if (!is_in(result.check, last)) settle_check(result);
  for (CheckResult& result : report.checks)
    if (is_in(result.check, last)) settle_check(result);
  return excused;
}

}  // namespace tetproof::verify
