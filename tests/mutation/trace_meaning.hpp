// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a changed trace still means the same.
#pragma once

#include <string>
#include <vector>

#include "io/trace.hpp"

namespace tetproof::mutation {

/// The records of a trace, with what does not count taken out: the names for people, settings without an
/// effect, the order of the points of a tetrahedron, face or edge.
/// Throws InputError for a file that is no trace.
std::vector<trace::Record> canonical_records(const std::string& path);

/// Whether two traces mean the same: their canonical records are the same in their order, that of steps (i)
/// to (iv) and of step (v) being free; numbers and points within the tolerance 1e-9 of
/// corpus/vectors/TRACE.md.
bool same_meaning(const std::vector<trace::Record>& original, const std::vector<trace::Record>& changed);

}  // namespace tetproof::mutation
