// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers and writers of surface formats share: a document, where each of its elements stands in the
// file, and values that only some nodes or elements have.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/atomic_file.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/document.hpp"
#include "io/loss/holds.hpp"

namespace tetproof::io {

/// What a reader is asked for: all that the file says, or only what a TriangleSurface takes, with `places`.
enum class Wanted { document, surface };

struct SurfaceDocument {
  Document document;
  std::vector<std::size_t> places;  ///< the byte at which each element starts; only if a surface is wanted
  bool text = true;                 ///< places are told as lines, else as bytes
  bool welded = false;              ///< no two points are equal
};

/// The surface format of a file, by its ending or else its content: stl, off, obj or ply; empty: none.
std::string surface_format(const InputFile& file);
/// Reads a file of such a format; InputError if it has none.
SurfaceDocument read_surface_document(const InputFile& file, Wanted wanted);

/// Gmsh's type of an element with so many corners: a point, a line, a triangle, ...
int type_of_corners(std::size_t corners);

/// Adds an element at the end, to the last block if that is like it.
void add_element(Document& document, std::span<const Index> nodes, std::int32_t groups = 0);

/// InputError if there are more points than an Index can number.
void check_countable(const std::string& path, std::size_t points);

/// A name as a message shows it: printable, and not a page of it.
std::string shown_name(std::string_view name);

/// How many nodes of each element of a block a file of points and polygons keeps: its corners; 0 for what is
/// neither point, line nor face.
int corners_kept(const ElementBlock& block);

/// Whether all of an element's first `nodes` nodes exist.
inline bool nodes_exist(const Index* node, int nodes) {
  for (int k = 0; k < nodes; ++k)
    if (node[k] < 0) return false;
  return true;
}

/// Whether every element of a document is written with all its nodes; `nodes` as in Holds.
bool keeps_all_elements(const Document& document, const std::function<int(const ElementBlock&)>& nodes);

/// Plain numbers without labels for `items` nodes or elements, of any number of them from `first` on.
bool plain_numbers(const Values& values, std::size_t items);
/// The same for each of `items` nodes or elements.
bool of_all(const Values& values, std::size_t items);
/// Or for some of them, ascending.
bool of_some(const Values& values, std::size_t items);

/// Numbers that stand behind some of the points or faces, any number of them behind each.
class Rows {
 public:
  /// `whole`: each was written as an integer.
  void add(std::size_t item, std::span<const double> numbers, bool whole);
  /// Adds them to `all` as values called `name`, one for each number of components; integers where all are.
  void give(std::vector<Values>& all, const std::string& name, std::size_t items) &&;
  bool empty() const { return groups_.empty(); }

 private:
  struct Group {
    std::vector<Index> at;
    std::vector<double> numbers;
    bool whole = true;
  };
  std::map<std::size_t, Group> groups_;  // by the number of components
};

/// The other way: which values stand behind each item. Values may be given together if no item is in two of
/// them and their numbers of components differ, so that `Rows` gives them back.
class RowsOf {
 public:
  explicit RowsOf(std::size_t items) : items_(items) {}
  /// False, and nothing is changed, if they cannot come back.
  bool add(const Values& values);
  const std::vector<const Values*>& held() const { return held_; }
  bool empty() const { return held_.empty(); }
  /// The values of an item and their position in it; null for none.
  const Values* find(std::size_t item, std::size_t& row) const {
    if (of_.empty()) return nullptr;
    row = static_cast<std::size_t>(row_[item]);
    return of_[item] < 0 ? nullptr : held_[static_cast<std::size_t>(of_[item])];
  }
  /// Behind every item the same number of numbers.
  bool complete() const;
  int most_components() const;

 private:
  std::size_t items_;
  std::vector<const Values*> held_;
  std::vector<std::int8_t> of_;
  std::vector<Index> row_;
};

/// Numbers that a text would tell from integers: with a point or an exponent.
char* put_decimal(char* to, double value);
inline constexpr std::size_t longest_decimal = 26;

/// Warns of colours: integers outside of 0 to 255, reals outside of 0 to 1.
void warn_of_colours(Document& document, const Values& colours, const char* of);

/// The comments that stand in front of anything else, line by line without '#' and a blank behind it.
std::string leading_comments(Scanner scanner);
/// The lines of a title, without line ends.
std::vector<std::string> title_lines(const std::string& title);
/// Whether a title comes back from lines of comments.
bool title_in_lines(const std::string& title);

}  // namespace tetproof::io
