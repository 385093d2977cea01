// SPDX-License-Identifier: GPL-3.0-or-later
// Names of physical groups in VTK's files: an array of field data for each, with the name of the group, its
// number and its dimension. So does meshio, which cannot read texts in these files; ParaView shows them as
// field data.
#pragma once

#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// The names that come back: those that XML can hold, each once; one of each group that a written element
/// has.
std::vector<const GroupName*> names_in_vtk(const Document& document);

/// A column for each of these names.
Table table_of_names(const std::vector<const GroupName*>& names);

/// Returns which tables of the document would be taken for names of groups.
std::vector<const Table*> tables_taken_for_names(const Document& document);

/// Makes names of groups of the field data that are such arrays: the first of each group.
void take_group_names(Document& document);

}  // namespace tetproof::io
