// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes of values: which of them a format that writes plain numbers behind its items can take.
#pragma once

#include <cstddef>

#include "io/document.hpp"

namespace tetproof::io {

/// Whether values have a time, a step, a partition or a scheme. If they have none, it makes no difference
/// whether they are of a view.
bool has_step(const Values& values);

/// Whether values are numbers without labels and steps, `items` of them from `first` on.
bool plain_numbers(const Values& values, std::size_t items);
/// Whether they are so, and there is one for each of all `items` nodes or elements.
bool of_all(const Values& values, std::size_t items);
/// Whether they are so, for all `items` nodes or elements or for some of them in ascending order.
bool of_some(const Values& values, std::size_t items);

}  // namespace tetproof::io
