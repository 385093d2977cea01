// SPDX-License-Identifier: GPL-3.0-or-later
// The decisions of a run of the paper's method, one record each, as a file of JSON lines. The format is
// described for implementers in corpus/vectors/TRACE.md.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tetproof::trace {

using Point = Eigen::Vector3d;  ///< [length]; the format names points by their coordinates, never by a number
using Tet = std::array<Point, 4>;          ///< in any order
using LatticeVertex = std::array<int, 3>;  ///< i, j, k

/// What was asked for. Volumes and lengths are absolute here.
struct Settings {
  std::string program;  ///< who wrote the trace
  std::string surface;  ///< the surface's file or specification, for the reader
  std::string region = "inside";
  double box_scale = 1.2, on_surface = 1e-6;
  std::string diagonals = "lowest";
  bool literal = false;
  double p = 1;
  bool curvature = false;
  bool parametric = false;
  std::string improve = "none";  ///< solid-angle, aspect-ratio, none
  double improve_below = 0.002;
  std::string points = "auto";  ///< auto, or a number
  bool past_dilution = false;
};

/// Step (i).
struct Lattice {
  std::array<Point, 2> box;  ///< its two extreme corners
  std::array<int, 3> cells;
};

/// Step (iii): the indicators of the lattice vertices (0,j,k) .. (nx,j,k), as '-', '0' and '+'.
struct Indicators {
  int j = 0, k = 0;
  std::string initial;  ///< before Table 3
  std::string after;    ///< after it
};

/// A lattice vertex that was taken to the surface for good (reading D4).
struct Moved {
  LatticeVertex vertex{};
  Point point;
  bool mended = false;  ///< because rounding had inverted a tetrahedron, not because it was near
};

/// Step (ii): the intersection point chosen on a lattice edge between -1 and +1; one of its ends if the cut
/// is there (reading D7).
struct Cut {
  std::array<LatticeVertex, 2> edge{};
  Point point;
};

/// Step (iv): the row of Table 2 by which each of the six tetrahedra of a cell was cut, in the order xyz,
/// xzy, yxz, yzx, zxy, zyx; "5-" is a tetrahedron with four surface points that was not kept (reading D10).
struct Rows {
  std::array<int, 3> cell{};
  std::array<std::string, 6> rows;
};

/// A point moved to the parametric surface (reading D12), or left where it was because a tetrahedron would
/// have turned over.
struct Mapped {
  Point from, to;  ///< equal if it was left
};

/// Step (v): what eqs (3.1) to (3.4) and (3.6) start from.
struct FirstGrid {
  std::int64_t points = 0, tets = 0;
  double mean_volume = 0, v0 = 0, v1 = 0, d1 = 0;
  std::optional<double> kappa_min, kappa_max;  ///< with curvature only
  double e_avg = 0;
};

/// Step (v): one tetrahedron of the first grid.
struct Weight {
  Tet tet;
  double d = 0;                 ///< eq. (3.2)
  std::optional<double> kappa;  ///< with curvature only
  double omega = 1;             ///< eq. (3.6)
  double volume = 0;
  double desired = 0;  ///< eq. (3.1)
  double error = 0;    ///< eq. (3.3)
};

/// Step (vi): the split of one tetrahedron.
struct Insertion {
  std::int64_t n = 0;  ///< 1 for the first
  Tet tet;             ///< the tetrahedron that is split
  std::string row;     ///< of Table 4; "0" for a tetrahedron without surface points
  std::vector<int>
      replaced;  ///< positions in `tet`: the corners of the edge, face or tetrahedron that holds the point
  Point point;
  double e_avg = 0;  ///< after it, eq. (3.5)
};

/// Section 4: one flip, after the insertion before it in the file.
struct Flip {
  bool two_to_three = true;  ///< the face goes and the edge comes; else the other way round
  std::array<Point, 3> face;
  std::array<Point, 2> edge;
  double quality_before = 0, quality_after = 0;  ///< the smallest of the set: S of 1, or D/A [1/length]
  double e_avg = 0;                              ///< after it
};

struct End {
  std::string stopped;  ///< no-gain, dilution, stalled, points, e-avg; "not-asked" without adaptation
  std::int64_t insertions = 0, flips = 0, refused = 0, points = 0, tets = 0;
  double e_avg = 0;
};

using Record = std::variant<Settings, Lattice, Indicators, Moved, Cut, Rows, Mapped, FirstGrid, Weight,
                            Insertion, Flip, End>;

/// One line of the file, without its line end. Doubles are written with the fewest digits that read back
/// equal; std::logic_error for one that is not finite.
std::string to_line(const Record& record);

/// What the format calls this kind of record: "first_grid".
const char* name_of(const Record& record);

/// Reads a trace record by record.
class Reader {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit Reader(const std::string& path);
  /// The next record, nothing at the end. Unknown kinds of records, unknown keys and empty lines are skipped.
  /// Throws InputError ("FILE:LINE: expected ..., found ...") for a line that is not a record; holds one line
  /// at a time, and none of more than 8 MiB.
  std::optional<Record> next();
  std::int64_t line() const { return line_; }  ///< of the record read last, from 1
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool read_line();

  std::ifstream file_;
  std::string text_;
  std::int64_t line_ = 0;
};

}  // namespace tetproof::trace
