// SPDX-License-Identifier: GPL-3.0-or-later
// Plans under which names VTK's files store entities and physical groups, and keeps these names from values.
#pragma once

#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/vtk/vtk_plan.hpp"

namespace tetproof::io {

/// Whether one of VTK's files was read.
bool is_of_vtk(const Document& document);

/// Whether an element of the block is written. Tags of others would be zeros in the file, and so none.
bool is_written_in_vtk(const Document& document, const ElementBlock& block);

/// Whether an array of entities is needed. The tag 0 is none. The tag 1 is what readers of other formats give
/// to elements that have no other; in VTK's files it is in an array, which is kept.
bool has_vtk_entities(const Document& document);

/// The names of the arrays of the first, second, ... group of each element.
std::vector<std::string> vtk_names_of_groups(const Document& document);

/// The values that the reader makes of negative numbers in the array of the first group; null: there are
/// none.
const Values* negative_vtk_groups(const Document& document, const std::vector<std::string>& groups);

/// The name of the array of values of nodes, and the one with which they come back.
struct VtkNodeName {
  std::string array, back;
};
VtkNodeName vtk_node_name(const Document& document, const Values& values);

/// Whether the reader would take values of this name for tags, beside those of the plan.
bool is_taken_for_tags(const Values& values, const std::string& name, const VtkPlan& plan);

}  // namespace tetproof::io
