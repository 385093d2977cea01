// SPDX-License-Identifier: GPL-3.0-or-later
// The part of documents_compare.hpp that compares entities.
#pragma once

#include <vector>

#include "documents_compare.hpp"
#include "documents_pairing.hpp"

namespace tetproof::test {

/// Compares the entities of elements and of nodes, the parameters of nodes, the entities themselves, and the
/// number of partitions.
std::vector<Difference> differences_of_entities(const Document& before, const Document& after,
                                                const Pairing& pairs);

}  // namespace tetproof::test
