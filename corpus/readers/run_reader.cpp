// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a reader on one file and classes its end.
#include <array>
#include <filesystem>

#include "corpus/meshing/command_words.hpp"
#include "corpus/meshing/end_class.hpp"
#include "corpus/readers/read_campaign.hpp"
#include "io/error.hpp"
#include "io/mesh_files.hpp"

namespace tetproof::corpus {

const char* name_of(Reading reading) {
  static constexpr std::array names{"read", "refused", "crashed", "slow", "out-of-memory"};
  static_assert(names.size() == reading_count);
  return names[static_cast<std::size_t>(reading)];
}

bool is_finding(Reading reading) {
  return reading > Reading::refused;
}

ReaderRun run_reader(const Reader& reader, const std::string& file, const std::string& folder,
                     const Limits& limits, bool trace) {
  const std::string ending = ending_of(file);
  const std::vector<std::string> command =
      replaced(reader.words, {{"{file}", file}, {"{stem}", file.substr(0, file.size() - ending.size())}});
  const ProcessOptions options{.folder = folder, .limits = limits};
  const ProcessEnd end = run_process(command, options);
  if (!end.started) throw InputError(end.output.substr(0, end.output.find('\n')));
  EndClass ended = classify_end(end);
  ReaderRun run{.message = replaced(ended.message, {{folder + "/", ""}})};
  if (!ended.failure) {
    run.wordless = ended.warnings.empty();
    return run;
  }
  run.reading = Reading::refused;
  if (*ended.failure == Outcome::crashed) {
    run.reading = Reading::crashed;
    if (trace && ended.wants_backtrace) add_backtrace(command, options, ended);
  } else if (*ended.failure == Outcome::slow) {
    run.reading = Reading::hung;
  } else if (*ended.failure == Outcome::out_of_memory && (end.limit == Limit::memory || end.signal != 0)) {
    run.reading = Reading::out_of_memory;  // a program that says so and exits has refused
  }
  if (is_finding(run.reading)) run.signature = ended.signature;
  run.wordless = end.output.find_first_not_of(" \t\r\n") == std::string::npos;
  return run;
}

}  // namespace tetproof::corpus
