// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/engine/first_grid/extract.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <stdexcept>

#include "io/bytes/large_pages.hpp"
#include "reference/engine/first_grid/row_choice.hpp"

namespace tetproof::reference {
namespace {

using Eigen::Vector3d;
using namespace tables;

constexpr int first_row_of(std::string_view name) {
  int r = 0;
  while (table2[r].name != name) ++r;
  return r;
}
constexpr int case_1 = first_row_of("1"), case_5 = first_row_of("5");

constexpr std::uint8_t used = 1, surface_point = 2;
constexpr double tie = 1e-12;  // relative: two diagonals whose lengths differ by less are equal (reading D9)

// The tetrahedra of one layer of cells. They name their points as follows: a lattice vertex by its number, a
// cut by (number of lattice vertices) + (number of the cut), a centroid by -1 - (its number in the layer).
struct Layer {
  std::vector<std::array<Index, 4>> tets;
  std::vector<std::uint32_t> lattice_tet;
  std::vector<Vector3d> centroids;
  std::vector<std::uint32_t> centroid_of;
  std::array<std::int64_t, table2.size()> rows{};
  std::int64_t collapsed = 0;
};

class Extraction {
 public:
  Extraction(const Lattice& lattice, const Indicators& indicators, const SurfaceVertices& settled,
             Diagonals diagonals, const std::function<bool(const Vector3d&)>& keep_case_5)
      : lattice_(lattice),
        indicators_(indicators),
        settled_(settled),
        diagonals_(diagonals),
        keep_case_5_(keep_case_5),
        marks_(lattice.vertices() + indicators.cuts.points.size(), 0) {
    io::reserve_in_large_pages(lattice_rows_, static_cast<std::size_t>(lattice.tets()));
    lattice_rows_.resize(static_cast<std::size_t>(lattice.tets()), case_1);
    for (int bits = 0; bits < 8; ++bits) offsets_[bits] = lattice.offset(bits);
  }

  Grid run() {
    std::vector<Layer> layers(lattice_.cells[2]);
    tbb::parallel_for(0, lattice_.cells[2], [&](int k) { cut_layer(k, layers[k]); });
    return assemble(layers);
  }

 private:
  struct LatticeTet {
    Vertex base;
    const std::array<int, 4>* corners;
    SortedVertices sorted;
    std::array<Index, 11> name;  // the name of each RowPoint that its row may use
  };

  void cut_layer(int k, Layer& layer) {
    const auto [nx, ny, nz] = lattice_.cells;
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const Vertex base = lattice_.vertex(i, j, k);
        const auto cell = static_cast<std::uint32_t>(i + nx * (j + static_cast<std::int64_t>(ny) * k));
        std::array<std::int8_t, 8> sign;
        int outside = 0;
        for (int corner = 0; corner < 8; ++corner) {
          sign[corner] = indicators_.sign[base + offsets_[corner]];
          outside += sign[corner] < 0;
        }
        if (outside == 8) {
          layer.rows[case_1] += 6;
          continue;
        }
        for (std::uint32_t t = 0; t < 6; ++t) cut_tet(base, 6 * cell + t, sign, layer);
      }
  }

  void cut_tet(Vertex base, std::uint32_t number, const std::array<std::int8_t, 8>& sign, Layer& layer) {
    const std::array<int, 4>& corners = kuhn_tets[number % 6];
    const SortedVertices sorted =
        sort_vertices({sign[corners[0]], sign[corners[1]], sign[corners[2]], sign[corners[3]]});
    int row = sorted.first_row;
    lattice_rows_[number] = static_cast<std::uint8_t>(row);
    if (table2[row].size == 0) {
      ++layer.rows[row];
      return;
    }
    LatticeTet tet{base, &corners, sorted, {}};
    for (int v = 0; v < 4; ++v) tet.name[v] = base + offsets_[corners[sorted.order[v]]];
    if (row == case_5 && !keep_case_5_(0.25 * (place(tet.name[0]) + place(tet.name[1]) + place(tet.name[2]) +
                                               place(tet.name[3])))) {
      lattice_rows_[number] = Grid::case_5_dropped;
      return;
    }
    for (int p = 0; p < 6; ++p)
      if (table1_possible(row, p)) tet.name[p12 + p] = cut(tet, p);
    row = choose_row(row, diagonals(tet));
    ++layer.rows[row];
    lattice_rows_[number] = static_cast<std::uint8_t>(row);
    if (table2[row].size == 8) {
      tet.name[c] = -1 - static_cast<Index>(layer.centroids.size());
      Vector3d sum = Vector3d::Zero();
      for (const RowPoint p : {v1, v2, v3, p14, p24, p34}) sum += place(tet.name[p]);
      layer.centroids.push_back(sum / 6);
      layer.centroid_of.push_back(number);
    }
    for (int t = 0; t < table2[row].size; ++t) emit(tet, row, t, kuhn_signs[number % 6], number, layer);
  }

  void emit(const LatticeTet& from, int row, int t, int lattice_sign, std::uint32_t number, Layer& layer) {
    std::array<Index, 4> tet;
    for (int v = 0; v < 4; ++v) tet[v] = from.name[table2[row].tets[t][v]];
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b)
        if (tet[a] == tet[b]) {
          ++layer.collapsed;
          return;
        }
    if (listed_orientation(row, t) * from.sorted.sign * lattice_sign < 0) std::swap(tet[2], tet[3]);
    for (const Index p : tet)
      if (p >= 0) mark(p, used);
    layer.tets.push_back(tet);
    layer.lattice_tet.push_back(number);
  }

  static bool table1_possible(int row, int p) {
    static constexpr auto possible = [] {
      std::array<std::array<bool, 6>, table2.size()> all{};
      for (std::size_t r = 0; r < table2.size(); ++r)
        for (const Table1Row& one : table1)
          if (one.indicators == table2[r].indicators)
            for (int q = 0; q < 6; ++q) all[r][q] = one.possible[q] == y;
      return all;
    }();
    return possible[row][p];
  }

  // The name of the cut on one of the tetrahedron's edges. The cut is a new point, or the end of the edge
  // that was 0 before Table 3 (reading D7).
  Index cut(const LatticeTet& tet, int p) {
    static constexpr std::array<std::array<int, 2>, 6> ends{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
    const auto [i, e] = ends[p];  // v_i is inside, v_e outside
    const Vertex interior = tet.name[i], exterior = tet.name[e];
    Vertex end = exterior;
    if (indicators_.initial[exterior] != 0) {
      const int a = (*tet.corners)[tet.sorted.order[i]], b = (*tet.corners)[tet.sorted.order[e]];
      const std::int64_t own = indicators_.cuts.find(Edge{std::min(interior, exterior)} * 8 + (a ^ b));
      if (own >= 0) {
        const auto name = static_cast<Index>(lattice_.vertices() + own);
        mark(name, surface_point);
        return name;
      }
      if (indicators_.initial[interior] != 0)
        throw std::logic_error(
            "a lattice edge between outside and inside has no intersection with the surface");
      end = interior;
    }
    mark(end, surface_point);
    return end;
  }

  unsigned diagonals(const LatticeTet& tet) const {
    if (diagonals_ == Diagonals::lowest) return choose_lowest(tet.sorted.first_row);
    const Quads& quads = shared_quads(tet.sorted.first_row);
    unsigned from_the_first = 0;
    for (int q = 0; q < quads.size; ++q) {
      const Quad& quad = quads.quads[q];
      const double first = (place(tet.name[quad.vi]) - place(tet.name[quad.pje])).squaredNorm();
      const double second = (place(tet.name[quad.vj]) - place(tet.name[quad.pie])).squaredNorm();
      from_the_first |= static_cast<unsigned>(first <= second * (1 + 2 * tie)) << q;
    }
    return from_the_first;
  }
  // Vertices with the same indicator are sorted by number. So the lower-numbered interior vertex of each
  // quadrilateral is its `vi`, and the diagonal of `lowest` starts there.
  static unsigned choose_lowest(int first_row) { return (1u << shared_quads(first_row).size) - 1; }

  Vector3d place(Index name) const {
    if (name >= lattice_.vertices()) return indicators_.cuts.points[name - lattice_.vertices()];
    if (indicators_.sign[name] == 0) {
      const auto at = std::lower_bound(settled_.vertices.begin(), settled_.vertices.end(), name);
      if (at != settled_.vertices.end() && *at == name)
        return settled_.points[at - settled_.vertices.begin()];
    }
    return lattice_.point(name);
  }

  void mark(Index name, std::uint8_t what) {
    std::atomic_ref<std::uint8_t> there(marks_[name]);
    if ((there.load(std::memory_order_relaxed) & what) != what)
      there.fetch_or(what, std::memory_order_relaxed);
  }

  // The numbers of the points in the grid: of each name that is used, and of the first centroid of each
  // layer.
  struct Numbers {
    std::vector<Index> of_name, first_centroid;
  };

  Grid assemble(std::vector<Layer>& layers) {
    Grid grid;
    for (const Layer& layer : layers) {
      for (std::size_t r = 0; r < grid.rows.size(); ++r) grid.rows[r] += layer.rows[r];
      grid.collapsed += layer.collapsed;
    }
    add_tets(layers, add_points(layers, grid), grid);
    grid.lattice_rows = std::move(lattice_rows_);
    return grid;
  }

  // Adds the used points in the order of their names, then the centroids in the order of their layers.
  Numbers add_points(const std::vector<Layer>& layers, Grid& grid) const {
    constexpr std::size_t names_a_task = 1 << 14;
    const std::size_t tasks = (marks_.size() + names_a_task - 1) / names_a_task;
    const auto for_used_names = [&](std::size_t task, const auto& visit) {
      const std::size_t end = std::min(marks_.size(), (task + 1) * names_a_task);
      for (std::size_t name = task * names_a_task; name < end; ++name)
        if (marks_[name] & used) visit(static_cast<Index>(name));
    };
    std::vector<Index> first(tasks + 1, 0);  // the number of each task's first point
    tbb::parallel_for(std::size_t{0}, tasks,
                      [&](std::size_t task) { for_used_names(task, [&](Index) { ++first[task + 1]; }); });
    std::partial_sum(first.begin(), first.end(), first.begin());
    Numbers numbers;
    io::reserve_in_large_pages(numbers.of_name, marks_.size());
    numbers.of_name.resize(marks_.size(), -1);
    auto points = static_cast<std::size_t>(first.back());
    for (const Layer& layer : layers) {
      numbers.first_centroid.push_back(static_cast<Index>(points));
      points += layer.centroids.size();
    }

    io::resize_in_large_pages(grid.mesh.points, points);
    io::resize_in_large_pages(grid.sources, points);
    grid.origins.resize(points);
    grid.on_surface.resize(points);
    const auto set = [&](Index n, const Vector3d& p, Origin origin, std::int64_t source, bool surface) {
      grid.mesh.points[n] = p;
      grid.origins[n] = origin;
      grid.sources[n] = source;
      grid.on_surface[n] = surface;
    };
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
      Index n = first[task];
      for_used_names(task, [&](Index name) {
        numbers.of_name[name] = n;
        if (name < lattice_.vertices())
          set(n++, place(name), Origin::lattice_vertex, name,
              indicators_.sign[name] == 0 || (marks_[name] & surface_point));
        else
          set(n++, place(name), Origin::cut, name - lattice_.vertices(), true);
      });
    });
    tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t k) {
      Index n = numbers.first_centroid[k];
      for (std::size_t q = 0; q < layers[k].centroids.size(); ++q)
        set(n++, layers[k].centroids[q], Origin::centroid, layers[k].centroid_of[q], false);
    });
    return numbers;
  }

  // Adds the tetrahedra in the order of their layers, and empties the layers.
  static void add_tets(std::vector<Layer>& layers, const Numbers& numbers, Grid& grid) {
    std::vector<std::size_t> first;  // the number of each layer's first tetrahedron
    std::size_t tets = 0;
    for (const Layer& layer : layers) {
      first.push_back(tets);
      tets += layer.tets.size();
    }
    io::resize_in_large_pages(grid.mesh.tets, tets);
    io::resize_in_large_pages(grid.lattice_tet, tets);
    tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t k) {
      for (std::size_t t = 0; t < layers[k].tets.size(); ++t) {
        std::array<Index, 4> tet = layers[k].tets[t];
        for (Index& p : tet) p = p < 0 ? numbers.first_centroid[k] + (-1 - p) : numbers.of_name[p];
        grid.mesh.tets[first[k] + t] = tet;
        grid.lattice_tet[first[k] + t] = layers[k].lattice_tet[t];
      }
      layers[k] = {};
    });
  }

  const Lattice& lattice_;
  const Indicators& indicators_;
  const SurfaceVertices& settled_;
  Diagonals diagonals_;
  const std::function<bool(const Vector3d&)>& keep_case_5_;
  std::vector<std::uint8_t> marks_;
  std::vector<std::uint8_t> lattice_rows_;
  std::array<Vertex, 8> offsets_;
};

}  // namespace

Grid extract(const Lattice& lattice, const Indicators& indicators, const SurfaceVertices& settled,
             Diagonals diagonals, const std::function<bool(const Vector3d&)>& keep_case_5) {
  return Extraction(lattice, indicators, settled, diagonals, keep_case_5).run();
}

}  // namespace tetproof::reference
