// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare_traces.hpp"

#include <nlohmann/json.hpp>

#include "verify/compare/compare_insertions.hpp"

namespace tetproof::verify {
namespace {

using Json = nlohmann::ordered_json;
using Verdict = TraceComparison::Verdict;

// The advice that follows a tie.
std::string after(const TraceComparison& tie) {
  return tie.insertion > 0
             ? "from here on the two can't be compared step by step; tetproof-mesh --follow checks the rest"
             : "what follows from the tie can't be compared; another --box-scale, --cells or --on-surface "
               "may "
               "give a lattice without ties";
}

Json json(const TraceSide& side) {
  return {{"file", side.file},
          {"line", side.line ? Json(side.line) : Json()},
          {"says", side.says},
          {"record", side.record.empty() ? Json() : Json::parse(side.record)}};
}

}  // namespace

TraceComparison compare_traces(const std::string& other_path, const std::string& reference_path,
                               double tolerance) {
  TraceComparison result;
  result.reference.file = reference_path;
  result.other.file = other_path;
  TraceStream reference(reference_path), other(other_path);

  // The steps are compared one after the other. After the first step with a difference nothing is compared,
  // because it would only show consequences.
  Differences differences;
  FirstSteps steps(reference, tolerance);
  steps.compare(other, differences, result.notes);
  differences.tell(result);
  if (!differences.none()) return result;

  FirstGrid first(reference, steps);
  first.compare(other, differences, result.notes);
  differences.tell(result);
  if (!differences.none()) return result;

  compare_insertions(other, reference, steps, first, result);
  for (TraceStream* stream : {&reference, &other})
    if (result.verdict == Verdict::equal) {
      if (stream->next_is<trace::End>()) stream->take();
      if (stream->next()) stream->fail("nothing after the end");
    }
  return result;
}

std::string comparison_text(const TraceComparison& result) {
  std::string text;
  const std::string so_far =
      counted(result.insertions, "insertion", "insertions") + " and " +
      counted(result.flips, "flip", "flips") +
      (result.reordered ? fmt::format(", {} of them in another order within ties", result.reordered) : "");
  if (result.verdict == Verdict::equal) {
    text = fmt::format("equal: every decision, {}\n", so_far);
  } else {
    text = fmt::format("{}, {}:\n{}\n", result.verdict == Verdict::tie ? "a tie" : "they diverge",
                       result.place, result.what);
    if (result.count > 1) text += fmt::format("  the first of {} such differences\n", result.count);
    for (const auto& [name, side] :
         {std::pair{"reference", &result.reference}, std::pair{"other", &result.other}})
      text += fmt::format("  {} ({}{}): {}\n", name, side->file,
                          side->line ? fmt::format(":{}", side->line) : "", side->says);
    if (result.insertion > 0) text += fmt::format("  found the same: {}\n", so_far);
    if (result.verdict == Verdict::tie) text += fmt::format("  {}\n", after(result));
  }
  for (const std::string& note : result.notes) text += "  note: " + note + "\n";
  return text;
}

std::string comparison_json(const TraceComparison& result) {
  const bool equal = result.verdict == Verdict::equal;
  const auto unless_equal = [&](const auto& value) { return equal ? Json() : Json(value); };
  std::vector<std::string> notes = result.notes;
  if (result.verdict == Verdict::tie) notes.push_back(after(result));
  const Json all{{"compared", "traces"},
                 {"verdict", equal                            ? "equal"
                             : result.verdict == Verdict::tie ? "tie"
                                                              : "diverges"},
                 {"step", unless_equal(result.step)},
                 {"place", unless_equal(result.place)},
                 {"insertion", result.insertion ? Json(result.insertion) : Json()},
                 {"what", unless_equal(result.what)},
                 {"count", result.count},
                 {"reference", json(result.reference)},
                 {"other", json(result.other)},
                 {"insertions", result.insertions},
                 {"flips", result.flips},
                 {"reordered", result.reordered},
                 {"notes", notes}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tetproof::verify
