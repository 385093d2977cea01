// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the elements of a PLY file, and the values and tables of a document that they become.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/ply/ply_data.hpp"
#include "io/ply/ply_header.hpp"

namespace tetproof::io {

/// A property of all instances of an element.
struct PlyStored {
  std::vector<double> reals;
  std::vector<std::int64_t> integers;
  std::vector<std::int32_t> lengths;  ///< of a list in each instance

  /// Reads it in one more instance.
  void read(PlyData& data, const PlyProperty& property);
};

/// Passes over a property in one instance.
void skip_property(PlyData& data, const PlyProperty& property);
/// Passes over all instances of an element.
void skip_element(PlyData& data, const PlyElement& element);

/// Whether a property lists the corners of a face or a strip.
inline bool names_corners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Makes values and tables of the properties that a reader stored.
class PlyProperties {
 public:
  explicit PlyProperties(Document& document) : document_(document) {}

  /// Makes values of the element's single numbers, in `all` from item `first` on, and a table of its lists.
  /// `wanted` says which properties are taken.
  void give(const PlyElement& element, std::vector<PlyStored>& stored,
            const std::function<bool(std::size_t)>& wanted, std::vector<Values>& all, std::size_t first);
  /// Makes a table of all properties of an element.
  void give_table(const PlyElement& element, std::vector<PlyStored>& stored);
  /// Joins values that faces and lines both have: those whose properties have the same names. Values whose
  /// properties have different names stay two, even if the names mean the same.
  void join_values();

 private:
  Document& document_;
  std::vector<std::vector<std::string>> property_names_;  // of each of the values of elements
};

}  // namespace tetproof::io
