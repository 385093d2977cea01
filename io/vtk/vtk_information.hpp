// SPDX-License-Identifier: GPL-3.0-or-later
// Lists what VTK's files say about an array beyond its values: a document has no place for it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// The array has a role in VTK's attributes: it is the active "SCALARS", "Vectors", ...
void add_vtk_role(std::vector<Loss>& dropped, const std::string& array, std::string_view role);

/// A component of the array has a name; an empty one is none.
void add_vtk_component_name(std::vector<Loss>& dropped, const std::string& array, std::string_view name);

/// The array has an information key, such as UNITS_LABEL. Ranges and lists of values are not listed: they
/// follow from the values.
void add_vtk_information(std::vector<Loss>& dropped, const std::string& array, std::string_view key);

/// Reads the lines behind METADATA in a legacy file, up to an empty line. `array`: the one in front of them.
void read_vtk_metadata(Scanner& in, const std::string& array, std::vector<Loss>& dropped);

}  // namespace tetproof::io
