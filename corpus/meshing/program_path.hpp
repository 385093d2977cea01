// SPDX-License-Identifier: GPL-3.0-or-later
// Where programs are: in PATH, and beside the running program.
#pragma once

#include <string>

namespace tetproof::corpus {

/// The absolute path of a program: a name without a slash is looked up in PATH, a path is taken from the
/// present folder. Empty: there is none that can be executed.
std::string program_path(const std::string& name);

/// The folder of the running program; empty where it is unknown.
std::string own_folder();

}  // namespace tetproof::corpus
