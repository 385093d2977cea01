// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/trace/first_steps.hpp"

#include <algorithm>

namespace tetproof::reference {

void record_first_steps(const FirstSteps& steps, const Recorder& record) {
  if (!record) return;
  const auto [nx, ny, nz] = steps.cells;
  const auto place = [&, columns = nx + 1, rows = ny + 1](int v) {
    return trace::LatticeVertex{v % columns, v / columns % rows, v / columns / rows};
  };
  const auto& [x, y, z] = steps.planes;
  record(trace::Lattice{
      {trace::Point(x.front(), y.front(), z.front()), trace::Point(x.back(), y.back(), z.back())},
      steps.cells});
  for (int k = 0, v = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j) {
      trace::Indicators row{.j = j, .k = k};
      for (int i = 0; i <= nx; ++i, ++v) {
        row.initial += "-0+"[steps.initial[v] + 1];
        row.after += "-0+"[steps.after[v] + 1];
      }
      record(row);
    }
  for (const auto& [v, point] : steps.settled)
    record(trace::Moved{place(v), point, steps.mended.contains(v)});
  for (const auto& [edge, point] : steps.cuts)
    record(trace::Cut{{place(edge.first), place(edge.second)}, point});
  for (std::size_t t = 0; t < steps.rows.size(); t += 6) {
    const auto cell = static_cast<int>(t / 6);
    trace::Rows rows{.cell = {cell % nx, cell / nx % ny, cell / nx / ny}};
    std::copy_n(steps.rows.begin() + static_cast<std::ptrdiff_t>(t), 6, rows.rows.begin());
    record(rows);
  }
}

}  // namespace tetproof::reference
