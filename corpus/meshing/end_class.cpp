// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of words by which the ends of meshers are told apart. All words are in lower case.
#include "corpus/meshing/end_class.hpp"

#include <signal.h>
#include <string.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "corpus/meshing/crash_words.hpp"
#include "corpus/meshing/output_lines.hpp"

namespace tetproof::corpus {

namespace {

using Words = std::string_view;

/// The input is invalid, it says.
constexpr std::array claims{
    Words{"self-intersect"},
    Words{"self intersect"},
    Words{"selfintersect"},
    Words{"overlapping"},
    Words{"facets nearly overlap"},
    Words{"intersect each other"},
    Words{"and a subface intersect"},  // TetGen 1.5
    Words{"facets intersect"},
    Words{"segments intersect"},
    Words{"facet intersect"},
    Words{"are intersecting"},
    Words{"segment and a facet"},
    Words{"vertex and a segment intersect"},
    Words{"lies in a segment"},
    Words{"lies in a facet"},  // TetGen 1.6 and HXT: "PLC Error: ..."
    Words{"plc error"},
    Words{"invalid plc"},
    Words{"invalid boundary mesh"},
    Words{"duplicated facets"},
    Words{"not closed"},
    Words{"not watertight"},
    Words{"non-manifold"},
    Words{"nonmanifold"},
    Words{"not manifold"},
    Words{"not a manifold"},
    Words{"degenerate"},
    Words{"inconsistent orientation"},
    Words{"not oriented"},
    Words{"not a closed surface"},
    Words{"surface is open"},
    Words{"surface mesh not consistent"},  // Netgen
    Words{"boundary surface mesh is overlapping"},
    Words{"input surface mesh is"},
    Words{"very small input feature"},
    Words{"very close input facets"},
};

/// What was asked for is not part of this build.
constexpr std::array absent{
    Words{"requires netgen"},  // Gmsh's frontal algorithm
    Words{"not compiled with"},       Words{"is not compiled in"},
    Words{"must be compiled with"},   Words{"has to be compiled with"},
    Words{"should be compiled with"}, Words{"was compiled without"},
    Words{"compiled without"},        Words{"not available in this"},
    Words{"algorithm not available"}, Words{"algorithm is not available"},
    Words{"not part of this build"},
};

constexpr std::array no_memory{
    Words{"bad_alloc"},
    Words{"out of memory"},
    Words{"cannot allocate memory"},
    Words{"memory exhausted"},
    Words{"failed to allocate memory"},
    Words{"not enough memory"},
};

/// Something was lost or changed.
constexpr std::array warnings{
    Words{"warning"},
    Words{"is replaced by"},
    Words{"ignored!"},
    Words{"skipping"},
    Words{"discard"},
    Words{"falling back"},
    Words{"fallback"},
    Words{"could not recover"},
    Words{"failed to recover"},
    Words{"is missing"},
    Words{"duplicated vertices are removed"},
    Words{"will be ignored"},
    Words{"instead of"},
    Words{"not inserted"},
    Words{"cannot recover"},
};

/// Words of lines that say why a program gave up, the best first.
constexpr std::array reasons{Words{"error"},  Words{"exception"}, Words{"fatal"},     Words{"fail"},
                             Words{"cannot"}, Words{"could not"}, Words{"unable to"}, Words{"invalid"}};

/// Lines with such words that say nothing.
constexpr std::array chatter{Words{"mesh generation error summary"},
                             Words{"-----"},
                             Words{" warnings"},
                             Words{"    1 warning"},
                             Words{"    1 error"},
                             Words{" errors"},
                             Words{"check the full log"},
                             Words{"degenerated elements removed"},
                             Words{"0 error"},
                             Words{"checking"},
                             Words{"no overlapping"},
                             Words{"no self-intersect"},
                             Words{"0 self-intersect"},
                             Words{"0 overlapping"},
                             Words{"0 degenerate"},
                             Words{"bytes of output were cut here"}};

template <std::size_t n>
bool says_one(const std::string& line, const std::array<Words, n>& words) {
  return std::any_of(words.begin(), words.end(), [&](Words part) { return says(line, part); });
}

template <std::size_t n>
const std::string* first_with(const std::vector<std::string>& lines, const std::array<Words, n>& words) {
  for (const std::string& line : lines)
    if (says_one(line, words) && !says_one(line, chatter)) return &line;
  return nullptr;
}

/// The line that is most likely to say why the program ended.
std::string telling_line(const std::vector<std::string>& lines) {
  for (const Words reason : reasons)
    for (const std::string& line : lines)
      if (says(line, reason) && !says_one(line, chatter)) return line;
  for (std::size_t i = lines.size(); i-- > 0;)
    if (lines[i].find_first_not_of(" \t") != std::string::npos &&
        !says(lines[i], "terminate called after throwing an instance of 'int'"))
      return lines[i];
  return "";
}

std::vector<std::string> warning_lines(const std::vector<std::string>& lines) {
  std::vector<std::string> result;
  std::size_t more = 0;
  for (const std::string& line : lines) {
    if (!says_one(line, warnings) || says_one(line, chatter)) continue;
    if (std::find(result.begin(), result.end(), line) != result.end()) continue;
    if (result.size() < 50)
      result.push_back(line);
    else
      ++more;
  }
  if (more > 0) result.push_back("and " + std::to_string(more) + " more such lines");
  return result;
}

bool is_crash(int signal) {
  return signal == SIGSEGV || signal == SIGABRT || signal == SIGBUS || signal == SIGFPE || signal == SIGILL ||
         signal == SIGTRAP || signal == SIGSYS;
}

}  // namespace

void add_backtrace(const std::vector<std::string>& command, const ProcessOptions& options, EndClass& end) {
  std::vector<std::string> frames = backtrace(command, options, end.by_exit);
  // Frames without a name tell little: they count only where there are no others.
  const auto is_named = [](const std::string& frame) { return frame[0] != '?'; };
  if (std::any_of(frames.begin(), frames.end(), is_named))
    std::erase_if(frames, [&](const std::string& frame) { return !is_named(frame); });
  for (std::size_t i = 0; i < frames.size() && i < 3; ++i)
    end.signature += (i == 0 ? " in " : " < ") + frames[i];
}

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

EndClass classify_end(const ProcessEnd& end) {
  const std::vector<std::string> lines = output_lines(end.output);
  EndClass result;
  result.warnings = warning_lines(lines);
  const auto fail = [&result](Outcome outcome, std::string signature, std::string message) {
    result.failure = outcome;
    result.signature = std::move(signature);
    result.message = std::move(message);
    return result;
  };

  if (end.limit == Limit::memory) return fail(Outcome::out_of_memory, "memory limit", telling_line(lines));
  if (end.limit == Limit::cpu) return fail(Outcome::slow, "CPU time limit", telling_line(lines));
  if (end.limit == Limit::wall) return fail(Outcome::slow, "wall time limit", telling_line(lines));

  // A shell or a wrapper that passes a signal on exits with 128 and its number.
  const bool wrapped = end.signal == 0 && end.exit_code > 128 &&
                       (is_crash(end.exit_code - 128) || end.exit_code == 128 + SIGKILL);
  const int signal = wrapped ? end.exit_code - 128 : end.signal;
  const bool success = signal == 0 && end.exit_code == 0;

  const auto crash = crash_words(lines);
  if (crash && (!success || !crash->needs_signal)) {
    result.wants_backtrace = crash->wants_backtrace;
    result.by_exit = signal == 0;
    return fail(Outcome::crashed, crash->signature, crash->message);
  }
  // A program that goes on without it says so as a warning; a banner may list what its build lacks.
  if (const std::string* line = first_with(lines, absent);
      line && (!success || says(*line, "warning") || says(*line, "error")))
    return fail(Outcome::not_compiled_in, without_numbers(*line), *line);
  if (success) return result;
  if (const std::string* line = first_with(lines, no_memory))
    return fail(Outcome::out_of_memory, without_numbers(*line), *line);
  if (signal == SIGKILL)  // not ours: so the kernel does where the machine has no memory left
    return fail(Outcome::out_of_memory, "killed by SIGKILL", "SIGKILL, which was not sent from here");

  if (signal == SIGTERM || signal == SIGINT || signal == SIGHUP)  // of a scheduler or a user
    return fail(Outcome::not_judged, "ended by " + signal_name(signal), signal_name(signal));

  const bool threw_int = std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
    return says(line, "throwing an instance of 'int'");
  });
  if (signal != 0 && !(signal == SIGABRT && threw_int)) {
    result.wants_backtrace = is_crash(signal);
    return fail(Outcome::crashed, signal_name(signal), signal_name(signal));
  }
  if (const std::string* line = first_with(lines, claims))
    return fail(Outcome::refused_valid, without_numbers(*line), *line);
  std::string line = telling_line(lines);
  std::string signature = without_numbers(line);
  if (signature.empty())
    signature = threw_int ? "an int thrown" : "exit code " + std::to_string(end.exit_code);
  return fail(Outcome::refused, std::move(signature), std::move(line));
}

}  // namespace tetproof::corpus
