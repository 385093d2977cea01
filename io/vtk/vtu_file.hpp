// SPDX-License-Identifier: GPL-3.0-or-later
// The XML of one of VTK's files, and the arrays in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtu_data.hpp"
#include "io/vtk/vtu_skeleton.hpp"
#include "io/vtk/vtu_unread.hpp"

namespace tetproof::io {

class VtuFile {
 public:
  /// Parses the tags. InputError if this is no XML of VTK's, or if its data are encoded in an unknown way.
  explicit VtuFile(const InputFile& file);

  pugi::xml_node root() const { return xml_.child("VTKFile"); }
  const VtuEncoding& encoding() const { return encoding_; }
  std::int64_t line_of(const pugi::xml_node& node) const;
  [[noreturn]] void fail(const pugi::xml_node& node, std::string_view message) const {
    fail_at(node.offset_debug(), message);
  }

  /// The number in an attribute: not negative, and no more than can be numbered. `missing`: what a missing
  /// attribute says.
  std::size_t count(const pugi::xml_node& node, const char* attribute, const char* missing = "") const;
  /// The numbers in an attribute, separated by blanks; as they were if it is missing.
  void integers_in(const pugi::xml_node& node, const char* attribute, std::span<std::int64_t> to) const;
  void reals_in(const pugi::xml_node& node, const char* attribute, std::span<double> to) const;

  /// The values of an array: so many tuples, if that is known. Bytes behind them are added to `dropped`.
  Column column(const pugi::xml_node& array, std::optional<std::size_t> items,
                std::vector<Loss>& dropped) const;
  /// The same for an array of integers.
  std::vector<std::int64_t> integers(const pugi::xml_node& array, std::optional<std::size_t> items,
                                     std::vector<Loss>& dropped) const;

 private:
  [[noreturn]] void fail_at(std::ptrdiff_t in_xml, std::string_view message) const;
  void header();
  VtuPlace place(const pugi::xml_node& array) const;

  const InputFile& file_;
  VtuSkeleton skeleton_;
  VtuEncoding encoding_;
  bool appended_raw_ = false;
  std::size_t appended_end_ = 0;
  pugi::xml_document xml_;
};

/// Calls `take` for the arrays of all elements called `name`: a file may have several, if hardly ever.
template <class Do>
void each_array(const pugi::xml_node& parent, const char* name, const Do& take) {
  for (const pugi::xml_node data : parent.children(name))
    for (const pugi::xml_node array : data.children())
      if (is_vtu_array(array)) take(array);
}

}  // namespace tetproof::io
