// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts polylines into lines, for formats that have only these.
#pragma once

#include "io/document.hpp"

namespace tetproof::io {

bool has_polylines(const Document& document);

/// The document with a line for each part of a polyline; values of the polyline become those of all its
/// parts. Elements count up from `first_element` if any was cut. `lost` gets what is lost by that.
Document with_polylines_cut(const Document& document, std::vector<Loss>& lost);

}  // namespace tetproof::io
