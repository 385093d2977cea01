// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare_traces.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "verify/compare/compare_insertions.hpp"

namespace tetproof::verify {
namespace {

using Json = nlohmann::ordered_json;
using Verdict = TraceComparison::Verdict;

Json json(const TraceSide& side) {
  return {{"file", side.file},
          {"line", side.line ? Json(side.line) : Json()},
          {"says", side.says},
          {"record", side.record.empty() ? Json() : Json::parse(side.record)}};
}

// Whether the first grids of the two traces have the same tetrahedra, as far as the traces say them.
bool same_first_grid(TraceStream& other, TraceStream& reference, const FirstSteps& steps) {
  FirstGrid first(reference, steps);
  Differences differences;
  std::vector<std::string> not_compared;
  first.compare(other, differences, not_compared);
  return first.summary() && not_compared.empty() && !differences.has(Step::first_grid);
}

// Compares one with the other, up to the first difference. Then the verdict is `unresolved`, or `diverges` if
// a trace contradicts itself or if they were asked for different things.
void compare_with_each_other(TraceStream& other, TraceStream& reference, double tolerance,
                             TraceComparison& result) {
  // The steps are compared one after the other. After the first step with a difference nothing is compared,
  // because it would only show consequences.
  Differences differences;
  FirstSteps steps(reference, tolerance);
  steps.compare(other, differences, result.not_compared);
  differences.tell(result);
  if (differences.first_is(Step::table2) && same_first_grid(other, reference, steps))
    result.what += "; the tetrahedra of the first grid are the same";
  if (!differences.none()) return;

  FirstGrid first(reference, steps);
  first.compare(other, differences, result.not_compared);
  differences.tell(result);
  if (!differences.none()) return;

  compare_insertions(other, reference, steps, first, result);
  for (TraceStream* stream : {&reference, &other})
    if (result.verdict == Verdict::equal) {
      if (stream->next_is<trace::End>()) stream->take();
      if (stream->next()) stream->fail("nothing after the end");
    }
}

// Whether the method already differs from both traces in the part in which they agree. Then it has another
// surface than they, or other options that a trace does not state, and cannot tell which of them is wrong.
bool differs_from_both(const CheckedTrace& other, const CheckedTrace& reference,
                       const TraceComparison& result) {
  const auto before = [](const CheckedTrace& checked, const TraceSide& side) {
    return checked.cannot.empty() && !checked.admissible && checked.line < side.line;
  };
  return before(other, result.other) && before(reference, result.reference);
}

// Asks the method which of the two is wrong.
void resolve(TraceComparison& result, const CheckTrace& check) {
  const CheckedTrace other = check(result.other.file), reference = check(result.reference.file);
  if (differs_from_both(other, reference, result)) {
    result.notes.push_back(
        fmt::format("neither is what the method makes of this surface ({}:{}: {}): were they made from "
                    "another one? --surface FILE says which",
                    result.other.file, other.line, other.what));
    return;
  }
  for (const auto& [checked, side] :
       {std::pair(&other, &result.other), std::pair(&reference, &result.reference)}) {
    for (const std::string& what : checked->not_checked)
      if (!std::any_of(result.not_compared.begin(), result.not_compared.end(),
                       [&](const std::string& known) { return known.starts_with(what + ":"); }))
        result.not_compared.push_back(fmt::format("{}: {} has none", what, side->file));
    if (!checked->cannot.empty()) {
      result.notes.push_back(fmt::format("{} could not be checked: {}", side->file, checked->cannot));
    } else if (!checked->admissible) {
      if (result.verdict == Verdict::diverges)
        result.notes.push_back(
            fmt::format("{}:{} is not admissible either: {}", side->file, checked->line, checked->what));
      else
        result.wrong = {side->file, checked->line, checked->what, ""};
      result.verdict = Verdict::diverges;
    }
  }
  if (result.verdict == Verdict::diverges || !other.cannot.empty() || !reference.cannot.empty()) return;
  // Each may be the best one by its own rounding, so that neither check sees a tie where they part.
  const bool both_chose = result.step == name_of(Step::choice) || result.step == name_of(Step::table4) ||
                          result.step == name_of(Step::flips) || result.step == name_of(Step::end);
  result.ties = std::max<std::int64_t>({other.ties, reference.ties, both_chose});
  if (result.ties > 0) {
    result.verdict = Verdict::tie;
  } else if (result.step == name_of(Step::volume_law)) {
    result.verdict = Verdict::diverges;
    result.notes.emplace_back(
        "each is admissible for the volumes that it states: they were asked for others");
  } else {
    result.notes.emplace_back(
        "the method allows every decision of both without a tie: the difference is smaller than "
        "what it tells apart");
  }
}

}  // namespace

TraceComparison compare_traces(const std::string& other_path, const std::string& reference_path,
                               double tolerance, const CheckTrace& check) {
  TraceComparison result;
  result.reference.file = reference_path;
  result.other.file = other_path;
  TraceStream reference(reference_path), other(other_path);
  compare_with_each_other(other, reference, tolerance, result);
  if (result.verdict == Verdict::unresolved && check) resolve(result, check);
  return result;
}

const char* name_of(TraceComparison::Verdict verdict) {
  switch (verdict) {
    case Verdict::equal:
      return "equal";
    case Verdict::tie:
      return "tie";
    case Verdict::diverges:
      return "diverges";
    case Verdict::unresolved:
      return "unresolved";
  }
  return "";
}

std::string comparison_text(const TraceComparison& result) {
  const std::string so_far = counted(result.insertions, "insertion", "insertions") + " and " +
                             counted(result.flips, "flip", "flips");
  std::string text;
  if (result.verdict == Verdict::equal) {
    text = fmt::format("equal: every decision, {}\n", so_far);
  } else {
    const std::string verdict =
        result.verdict == Verdict::tie        ? fmt::format("equal but for {}: each is admissible to its end",
                                                            counted(result.ties, "proven tie", "proven ties"))
        : result.verdict == Verdict::diverges ? "they diverge"
                                              : "unresolved: it is not known which of them is wrong";
    text = fmt::format("{}\nthey part at {}:\n{}\n", verdict, result.place, result.what);
    if (result.count > 1) text += fmt::format("  the first of {} such differences\n", result.count);
    for (const auto& [name, side] :
         {std::pair{"reference", &result.reference}, std::pair{"other", &result.other}})
      text += fmt::format("  {} ({}{}): {}\n", name, side->file,
                          side->line ? fmt::format(":{}", side->line) : "", side->says);
    if (!result.wrong.file.empty())
      text += fmt::format("  wrong is {}:{}: {}\n", result.wrong.file, result.wrong.line, result.wrong.says);
    if (result.insertion > 0) text += fmt::format("  found the same: {}\n", so_far);
  }
  for (const std::string& what : result.not_compared) text += "  not compared: " + what + "\n";
  for (const std::string& note : result.notes) text += "  note: " + note + "\n";
  return text;
}

std::string comparison_json(const TraceComparison& result) {
  const bool equal = result.verdict == Verdict::equal;
  const auto unless_equal = [&](const auto& value) { return equal ? Json() : Json(value); };
  const Json all{{"compared", "traces"},
                 {"verdict", name_of(result.verdict)},
                 {"step", unless_equal(result.step)},
                 {"place", unless_equal(result.place)},
                 {"insertion", result.insertion ? Json(result.insertion) : Json()},
                 {"what", unless_equal(result.what)},
                 {"count", result.count},
                 {"reference", json(result.reference)},
                 {"other", json(result.other)},
                 {"wrong", result.wrong.file.empty() ? Json() : json(result.wrong)},
                 {"ties", result.ties},
                 {"insertions", result.insertions},
                 {"flips", result.flips},
                 {"not_compared", result.not_compared},
                 {"notes", result.notes}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tetproof::verify
