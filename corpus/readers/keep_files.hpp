// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps a file of each group of findings, made smaller. Not installed.
#pragma once

#include "corpus/readers/damaged_file.hpp"
#include "corpus/readers/read_campaign.hpp"

namespace tetproof::corpus {

/// Writes findings/NAME into the folder for each group: the file, and README.txt, which says what was done to
/// it. New groups are shrunk. Sets `file` and `shrunk` of the groups.
void keep_files(ReadResult& result, const DamageOptions& options, const DamagedFiles& files);

}  // namespace tetproof::corpus
