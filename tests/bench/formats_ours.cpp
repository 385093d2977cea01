// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing a mesh by this project's functions, each repetition timed by itself; formats.py runs it
// beside its peers.
//   formats_ours make CELLS FILE
//   formats_ours read FILE TIMES THREADS
//   formats_ours write FILE OUT FORMAT ascii|binary TIMES THREADS
// `make` makes a cube of CELLS^3 cells of six tetrahedra each, with groups and names. Prints "seconds WALL
// cpu CPU" for each repetition, and after reading "arrays BYTES": what the points and elements take.
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <string>

#include "formats_timed.hpp"
#include "io/mesh_files.hpp"

namespace {

using namespace tetproof;
using bench::timed;

// In (-0.3, 0.3), from a number; of full length in decimal, as coordinates usually are.
double jitter(std::uint64_t number) {
  number = (number + 1) * 0x9e3779b97f4a7c15u;
  number = (number ^ number >> 30) * 0xbf58476d1ce4e5b9u;
  number = (number ^ number >> 27) * 0x94d049bb133111ebu;
  return 0.6 * (static_cast<double>((number ^ number >> 31) >> 11) * 0x1p-53 - 0.5);
}

// Layers of four materials, and the six sides of the cube.
Document cube(int cells) {
  const int n = cells + 1;
  const auto node = [&](int x, int y, int z) { return static_cast<Index>((z * n + y) * n + x); };
  Document document;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        Eigen::Vector3d p(x, y, z);
        for (int k = 0; k < 3; ++k)
          if (p[k] > 0 && p[k] < cells) p[k] += jitter(3 * document.points.size() + k);
        document.points.push_back(p / cells);
      }
  const auto start = [&](int type, int dim, int entity, int corners, const char* name) {
    document.tag_sets.push_back({entity});
    document.group_names.push_back({.dim = dim, .group = entity, .name = name});
    document.blocks.push_back({.type = type,
                               .dim = dim,
                               .entity = entity,
                               .groups = static_cast<std::int32_t>(document.tag_sets.size()) - 1,
                               .nodes_each = corners,
                               .first = document.elements(),
                               .nodes = document.connectivity.size()});
  };
  const auto add = [&](auto... nodes) {
    (document.connectivity.push_back(nodes), ...);
    ++document.blocks.back().count;
  };
  constexpr std::array<const char*, 6> sides{"left", "right", "front", "back", "bottom", "top"};
  for (int side = 0; side < 6; ++side) {
    start(2, 2, 1 + side, 3, sides[side]);
    const auto at = [&](int u, int v) {
      const int w = side % 2 * cells;
      return side < 2 ? node(w, u, v) : side < 4 ? node(u, w, v) : node(u, v, w);
    };
    for (int v = 0; v < cells; ++v)
      for (int u = 0; u < cells; ++u) {
        add(at(u, v), at(u + 1, v), at(u + 1, v + 1));
        add(at(u, v), at(u + 1, v + 1), at(u, v + 1));
      }
  }
  constexpr std::array<const char*, 4> layers{"rock", "sand", "clay", "soil"};
  // From (0,0,0) to (1,1,1) along the three axes in each of their orders.
  constexpr int orders[6][3]{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int z = 0, layer = -1; z < cells; ++z) {
    if (const int here = 4 * z / cells; here != layer) start(4, 3, 11 + here, 4, layers[layer = here]);
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x)
        for (const auto& order : orders) {
          std::array<int, 3> p{x, y, z};
          std::array<Index, 4> corners{node(x, y, z)};
          for (int k = 0; k < 3; ++k) {
            ++p[order[k]];
            corners[k + 1] = node(p[0], p[1], p[2]);
          }
          const bool odd = &order >= &orders[3];
          add(corners[0], corners[odd ? 2 : 1], corners[odd ? 1 : 2], corners[3]);
        }
  }
  document.node_blocks.push_back({.dim = 3, .entity = 11, .count = document.points.size()});
  return document;
}

int run(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const auto threads = [&](int i) {
    const int some = std::atoi(argv[i]);
    return static_cast<std::size_t>(some > 0 ? some : 1);
  };
  if (what == "make" && argc == 4) {
    const Document document = cube(std::atoi(argv[2]));
    write_document(argv[3], document, {.format = "msh41", .binary = true});
    fmt::print("tetrahedra {}\n", document.elements() - document.blocks[6].first);
  } else if (what == "read" && argc == 5) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads(4));
    for (int i = 0; i < std::atoi(argv[3]); ++i) {
      Document document;
      timed([&] { document = read_document(argv[2]); });
      if (i == 0)
        fmt::print("arrays {}\n", document.points.size() * sizeof(Eigen::Vector3d) +
                                      document.connectivity.size() * sizeof(Index));
    }
  } else if (what == "write" && argc == 8) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads(7));
    const Document document = read_document(argv[2]);
    const WriteOptions options{.format = argv[4], .binary = std::string(argv[5]) == "binary"};
    for (int i = 0; i < std::atoi(argv[6]); ++i) timed([&] { write_document(argv[3], document, options); });
  } else {
    fmt::print(stderr,
               "usage: formats_ours make CELLS FILE | read FILE TIMES THREADS | "
               "write FILE OUT FORMAT ascii|binary TIMES THREADS\n");
    return 2;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
