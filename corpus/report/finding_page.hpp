// SPDX-License-Identifier: GPL-3.0-or-later
// A finding's folder as a page of HTML. Internal.
#pragma once

#include <string>

namespace tetproof::corpus {

/// The page of a finding that `write_finding` wrote into `folder`: what its README says, its picture, and the
/// shrunk surface in three dimensions; if there is a mesh, as the judge shows it against this surface. Other
/// files in the folder do not count. Throws InputError if a file of the folder is missing or cannot be read.
std::string finding_page(const std::string& folder);

/// The picture of the folder as an address that holds it; empty if there is none.
std::string picture_address(const std::string& folder);

}  // namespace tetproof::corpus
