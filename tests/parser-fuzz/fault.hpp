// SPDX-License-Identifier: GPL-3.0-or-later
// The judgement on one file that a reader is given.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace tetproof::test {

/// What is wrong with the reading of this file; empty if nothing is. It must end, with a result or an
/// InputError of one line, and take at most 64 MiB + 10 times the size of what stands in the file's folder.
std::string fault(const std::function<void(const std::string&)>& read, const std::filesystem::path& file);

}  // namespace tetproof::test
