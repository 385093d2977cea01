// SPDX-License-Identifier: GPL-3.0-or-later
// The options of tetproof-convert that edit what was read, and the order in which they work.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/document.hpp"
#include "io/edit/edits.hpp"
#include "io/program/program.hpp"

namespace tetproof::program {

/// In the order in which they work, wherever they stand on the command line. Several inputs are joined first;
/// the split by groups comes last.
struct EditOptions {
  std::optional<double> scale;
  std::string translate;
  std::string merge_points;  ///< empty: no; "exact" or a tolerance
  std::string only;
  bool boundary = false, triangulate = false, prune = false, renumber = false, group_texts = false;
  bool split_by_group = false;
};

/// A check for options: CLI11 takes an empty word for an option that is not given.
std::string not_empty(const std::string& word);

/// Adds the options to a program.
void declare_edits(CLI::App& app, EditOptions& options);

/// CLI11 lets a flag have a value behind '=' alone. So that a number may also be the next word,
/// `--merge-points 1e-9` becomes `--merge-points=1e-9`.
std::vector<std::string> with_joined_tolerance(int argc, char** argv);

/// What an option did.
struct DoneEdit {
  std::string option;  ///< with its value
  io::Edit edit;
};

/// InputError for values that no edit can take. To be called before anything is read.
void check_edits(const EditOptions& options);

/// Edits the document and says what was done: one line for each option.
std::vector<DoneEdit> apply_edits(const Common& common, const EditOptions& options, Document& document);
/// The line of one edit, and those of what it lost.
void say_edit(const Common& common, const DoneEdit& done);
/// An array of `option`, `did` and `lost`.
nlohmann::ordered_json edits_json(const std::vector<DoneEdit>& done);

/// The path of a part of a split output: out.msh and "steel" make out_steel.msh; out.1.node makes
/// out_steel.1.node.
std::string path_of_part(const std::string& out, const std::string& word);

}  // namespace tetproof::program
