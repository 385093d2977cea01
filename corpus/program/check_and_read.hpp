// SPDX-License-Identifier: GPL-3.0-or-later
// tetproof-fuzz --judge and --reader: checkers on planted meshes, readers on damaged files. Not installed.
#pragma once

#include "corpus/program/fuzz_options.hpp"
#include "io/program/files_in_use.hpp"
#include "io/program/program.hpp"

namespace tetproof::corpus {

/// Whether the command line asks for one of the two. InputError if it asks for both, or for something that
/// they have no use for.
bool asks_for_other_programs(const FuzzArguments& a);

/// The kinds of defects and of damage, for --list-kinds.
std::string list_kinds_of_others();

/// Runs what is asked for, reports, and returns the exit code.
int check_or_read(const FuzzArguments& a, const program::Common& common, const program::FilesInUse& files);

}  // namespace tetproof::corpus
