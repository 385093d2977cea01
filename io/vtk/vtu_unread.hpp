// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the elements and attributes of a .vtu file that its reader does not take.
#pragma once

#include <cstdint>
#include <functional>
#include <pugixml.hpp>
#include <vector>

#include "io/document.hpp"

namespace tetproof::io {

/// Whether an element is an array: <DataArray>, or <Array> for strings.
bool is_vtu_array(const pugi::xml_node& node);

/// Adds to `dropped` everything under <VTKFile> that a document has no place for. `line_of`: the line of an
/// element in the file.
void list_unread(const pugi::xml_node& root,
                 const std::function<std::int64_t(const pugi::xml_node&)>& line_of,
                 std::vector<Loss>& dropped);

}  // namespace tetproof::io
