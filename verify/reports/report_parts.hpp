// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a report before it is written, so that a program can add parts of its own. Not installed.
#pragma once

#include "io/page/page.hpp"
#include "verify/report_page.hpp"

namespace tetproof::verify {

/// The page that `report_page` writes.
io::Page report_page_parts(const Report& report, const PageSubject& subject);

}  // namespace tetproof::verify
