// SPDX-License-Identifier: GPL-3.0-or-later
// Places and sizes in which the same mesh is judged again.
#pragma once

#include <array>

namespace tetproof::test {

/// A mesh around another point, in another size.
struct Place {
  double shift, size;
};
inline constexpr std::array places{Place{0, 1}, Place{1e6, 1}, Place{0, 1e-9}};

}  // namespace tetproof::test
