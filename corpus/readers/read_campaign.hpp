// SPDX-License-Identifier: GPL-3.0-or-later
// Hands damaged and odd files to a reader: does it crash, hang, or take all memory?
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "corpus/meshing/process.hpp"

namespace tetproof::corpus {

/// A program that reads files.
struct Reader {
  std::string name;
  std::vector<std::string> words;  ///< with {file}; {stem}: the same without its ending
};

/// What a reader did with a file.
enum class Reading {
  read,           ///< exit code 0
  refused,        ///< another exit code
  crashed,        ///< a finding
  hung,           ///< over its limit of time: a finding, because the files are small
  out_of_memory,  ///< over its limit of memory: likewise
};
inline constexpr int reading_count = static_cast<int>(Reading::out_of_memory) + 1;

/// Stable, in reports: "read", "refused", "crashed", "slow", "out-of-memory"; the last three as of meshers.
const char* name_of(Reading reading);
bool is_finding(Reading reading);

/// A reader's end, told apart as in `CaseResult`.
struct ReaderRun {
  Reading reading = Reading::read;
  std::string signature;  ///< of a finding
  std::string message;    ///< the line of the output that says most
  bool wordless = true;   ///< it printed no warning; of a refusal: nothing at all
};

/// Runs the reader on a file in `folder`, where it may leave what it likes. With `trace` a crash whose words
/// do not say where it happened is run once more for a backtrace. InputError if there is no such program.
ReaderRun run_reader(const Reader& reader, const std::string& file, const std::string& folder,
                     const Limits& limits, bool trace = true);

/// One file.
struct ReadCase {
  std::uint64_t index = 0;
  std::string form, document;  ///< "msh41 binary", "tetrahedra"
  std::string damage, done;    ///< "truncated", "cut off at byte 17 of 300"; "none": the file is valid
  std::int64_t bytes = 0;      ///< of all its parts
  ReaderRun run{};
  /// It was read without a word, although its content is another than before the damage, or none.
  bool unnoticed = false;
};

/// Findings for the same cause, as far as one can tell from outside.
struct ReadGroup {
  std::string reader;
  Reading reading{};
  std::string signature;
  std::vector<ReadCase> cases;  ///< the smallest file first
  bool known = false;
  std::string file{};                    ///< in the folder; empty: none is kept
  std::optional<std::int64_t> shrunk{};  ///< bytes after shrinking
  bool unseen_again = false;             ///< the file did not fail once more, and so was not shrunk
  std::string id() const;                ///< "my-reader:crashed:SIGSEGV in f < g"
};

struct DamageOptions {
  std::uint64_t seed = 1, cases = 2000;
  std::vector<std::string> formats{};  ///< empty: all that are written
  std::vector<std::string> damages{};  ///< ids; empty: all
  Limits limits{};
  int threads = 0;
  double shrink_s = 0;               ///< for each group; needs `folder`
  std::string folder{};              ///< where a file of each group is kept; empty: nowhere
  std::vector<std::string> known{};  ///< ids of groups
  std::function<void(std::uint64_t cases)> started{};
  std::function<void(const ReadCase&)> progress{};  ///< called after each case, one at a time
};

struct ReadResult {
  Reader reader;
  std::uint64_t seed = 1;
  std::vector<ReadCase> cases;  ///< in the order of their indices: first the valid files
  std::vector<ReadGroup> groups;
  std::vector<std::string> known_unseen{};
  std::vector<std::string> not_applied{};  ///< kinds of damage that were asked for, and that no file got
};

/// Runs. Everything but backtraces and limits of time is the same for any number of threads. InputError for
/// an unknown format or kind of damage, and if there is no such program.
ReadResult run_reader_campaign(const Reader& reader, const DamageOptions& options);

/// The valid files that were refused: nothing is said of the reader on damaged files of such forms.
std::vector<const ReadCase*> refused_valid_files(const ReadResult& result);

std::string read_text(const ReadResult& result);
std::string read_json(const ReadResult& result);
/// The same as a page of HTML, with what is known about the files that are kept in `folder`.
std::string read_page(const ReadResult& result, const std::string& folder);
std::string read_junit(const ReadResult& result);

}  // namespace tetproof::corpus
