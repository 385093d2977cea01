// SPDX-License-Identifier: GPL-3.0-or-later
// The physical groups of two documents that are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "io/document.hpp"

namespace tetproof::io {

/// By dimension and number in the other document: the number in the joint one.
using JointGroups = std::map<std::pair<int, std::int64_t>, std::int64_t>;

/// Groups are one if they have a name in common, or the same number and names in one document at most. Two
/// groups of `other` stay two. Adds its names to `document`; `renumbered` gets how many of its groups have
/// another number now.
JointGroups join_groups(Document& document, const Document& other, std::size_t& renumbered);

}  // namespace tetproof::io
