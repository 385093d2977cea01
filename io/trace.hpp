// SPDX-License-Identifier: GPL-3.0-or-later
// Traces: the decisions of a run of the paper's method, as a file with one JSON record a line.
// corpus/vectors/TRACE.md describes the format for implementers.
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

/// [length]. The format names points by their coordinates, never by a number.
using Point = Eigen::Vector3d;
using Tet = std::array<Point, 4>;          ///< in any order
using LatticeVertex = std::array<int, 3>;  ///< i, j, k

/// What the user asked for. Volumes and lengths are absolute here.
struct Settings {
  std::string program;  ///< the program that wrote the trace
  std::string surface;  ///< the surface's file or specification, for people
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
  std::array<Point, 2> box;  ///< the lowest and the highest corner
  std::array<int, 3> cells;
};

/// Step (iii): the indicators of the lattice vertices (0,j,k) .. (nx,j,k), as '-', '0' and '+'.
struct Indicators {
  int j = 0, k = 0;
  std::string initial;  ///< before Table 3
  std::string after;    ///< after it
};

/// A lattice vertex that was moved to the surface permanently (reading D4).
struct Moved {
  LatticeVertex vertex{};
  Point point;
  bool mended = false;  ///< moved because rounding had inverted a tetrahedron, not because it was near
};

/// Step (ii): the intersection point chosen on a lattice edge between -1 and +1. It is one of the edge's ends
/// if the cut is there (reading D7).
struct Cut {
  std::array<LatticeVertex, 2> edge{};
  Point point;
};

/// Step (iv): the row of Table 2 by which each of a cell's six tetrahedra was cut, in the order xyz, xzy,
/// yxz, yzx, zxy, zyx. "5-" is a tetrahedron with four surface points that was not kept (reading D10).
struct Rows {
  std::array<int, 3> cell{};
  std::array<std::string, 6> rows;
};

/// A point that was moved to the parametric surface (reading D12), or left in place because a tetrahedron
/// would have been inverted.
struct Mapped {
  Point from, to;  ///< equal if it was left in place
};

/// Step (v): the values of the first grid that eqs (3.1) to (3.4) and (3.6) use, and its average error.
struct FirstGrid {
  std::int64_t points = 0, tets = 0;
  double mean_volume = 0, v0 = 0, v1 = 0, d1 = 0;
  std::optional<double> kappa_min, kappa_max;  ///< with curvature only
  double e_avg = 0;
  std::optional<double> e_avg_goal{};  ///< the average at which the insertion ends, if one was asked for
};

/// Step (v): one tetrahedron of the first grid.
struct Weight {
  Tet tet;
  double d = 0;                   ///< eq. (3.2)
  std::optional<double> kappa{};  ///< with curvature only
  double omega = 1;               ///< eq. (3.6)
  double volume = 0;
  double desired = 0;  ///< eq. (3.1)
  double error = 0;    ///< eq. (3.3)
};

/// Step (vi): the split of one tetrahedron.
struct Insertion {
  std::int64_t n = 0;  ///< 1 for the first
  Tet tet;             ///< the tetrahedron that is split
  std::string row;     ///< of Table 4; "0" for a tetrahedron without surface points
  /// Positions in `tet`: the corners of the edge, face or tetrahedron that holds the new point.
  std::vector<int> replaced;
  Point point;       ///< the new point
  double e_avg = 0;  ///< after the split, eq. (3.5)
};

/// Section 4: one flip. It follows the insertion before it in the file.
struct Flip {
  bool two_to_three = true;  ///< the edge replaces the face; otherwise the face replaces the edge
  std::array<Point, 3> face{};
  std::array<Point, 2> edge{};
  /// The smallest quality of the tetrahedra: S as a fraction of the full solid angle, or D/A [1/length].
  double quality_before = 0, quality_after = 0;
  double e_avg = 0;  ///< after the flip
};

struct End {
  std::string stopped;  ///< no-gain, dilution, stalled, points, e-avg; "not-asked" without adaptation
  std::int64_t insertions = 0, flips = 0, refused = 0, points = 0, tets = 0;
  double e_avg = 0;
};

using Record = std::variant<Settings, Lattice, Indicators, Moved, Cut, Rows, Mapped, FirstGrid, Weight,
                            Insertion, Flip, End>;

/// The record as one line of the file, without its line end. Doubles are written with the fewest digits that
/// read back equal. Throws std::logic_error for a double that is not finite.
std::string to_line(const Record& record);

/// The format's name for this kind of record: "first_grid".
const char* name_of(const Record& record);

/// Reads a trace record by record.
class Reader {
 public:
  /// Throws InputError if the file cannot be opened.
  explicit Reader(const std::string& path);
  /// The next record; nothing at the end. Skips unknown kinds of records, unknown keys and empty lines.
  /// Throws InputError ("FILE:LINE: expected ..., found ...") for a line that is not a record or is longer
  /// than 8 MiB. Holds one line at a time.
  std::optional<Record> next();
  std::int64_t line() const { return line_; }  ///< the line of the record read last, from 1
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  bool read_line();

  std::ifstream file_;
  std::string text_;
  std::int64_t line_ = 0;
};

}  // namespace tetproof::trace
