// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/defects.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/mesh_files.hpp"

namespace tetproof::verify {

void write_defects(const std::string& path, const TetMesh& mesh, const Numbering& numbering,
                   const Report& report) {
  const auto in_range = [&](Index v) { return v >= 0 && v < static_cast<Index>(mesh.points.size()); };
  std::vector<std::uint8_t> broken_at(mesh.points.size(), 0);
  for (const CheckResult& result : report.checks)
    for (const Finding& finding : result.findings)
      for (const Index t : finding.tets) {
        for (const Index v : mesh.tets[t])
          if (in_range(v)) broken_at[v] = 1;
      }
  // A viewer cannot draw a tetrahedron without a point.
  TetMesh part;
  std::vector<Index> original, place(mesh.points.size(), -1);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    std::array<Index, 4> tet = mesh.tets[t];
    if (!std::all_of(tet.begin(), tet.end(), in_range)) continue;
    if (std::none_of(tet.begin(), tet.end(), [&](Index v) { return broken_at[v]; })) continue;
    for (Index& v : tet) {
      if (place[v] < 0) {
        place[v] = static_cast<Index>(part.points.size());
        part.points.push_back(mesh.points[v]);
      }
      v = place[v];
    }
    part.tets.push_back(tet);
    original.push_back(static_cast<Index>(t));
  }
  Document document = document_of(part);
  Values numbers{.name = "number", .components = 1, .reals = {}, .integers = {}};
  for (const Index t : original) numbers.integers.push_back(numbering.tet(t));
  document.element_values.push_back(std::move(numbers));
  for (const CheckResult& result : report.checks) {
    if (result.findings.empty()) continue;
    Values values{.name = info(result.check).id,
                  .components = 1,
                  .reals = {},
                  .integers = std::vector<std::int64_t>(original.size(), 0)};
    for (const Finding& finding : result.findings)
      for (const Index t : finding.tets)
        if (const auto at = std::lower_bound(original.begin(), original.end(), t);
            at != original.end() && *at == t)
          values.integers[static_cast<std::size_t>(at - original.begin())] = 1;
    document.element_values.push_back(std::move(values));
  }
  write_document(path, document);
}

}  // namespace tetproof::verify
