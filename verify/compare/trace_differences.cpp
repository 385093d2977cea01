// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/trace_differences.hpp"

#include <cmath>

namespace tetproof::verify {

const std::vector<TraceStep>& trace_steps() {
  static const std::vector<TraceStep> steps{
      // in the order of `Step`
      {"settings", "what was asked for"},
      {"lattice", "step (i), eq. (2.1)"},
      {"indicators", "step (iii)"},
      {"table-3", "step (iii), Table 3"},
      {"moved", "step (iii), reading D4"},
      {"cut", "step (ii), Table 3"},
      {"table-2", "step (iv), Tables 1 and 2"},
      {"mapped", "step (iv), reading D12"},
      {"first-grid", "step (iv), Table 2"},
      {"distance", "step (v), eq. (3.2)"},
      {"curvature", "step (v), reading D15"},
      {"weight", "step (v), eq. (3.6)"},
      {"volume", "step (v), the volume V"},
      {"volume-law", "step (v), the constants of eq. (3.1)"},
      {"desired", "step (v), eq. (3.1)"},
      {"error", "step (v), eq. (3.3)"},
      {"average", "step (v), eq. (3.4)"},
      {"choice", "step (vi), eq. (3.5)"},
      {"table-4", "step (vi), Table 4"},
      {"point", "step (vi), Table 4: the new point"},
      {"average-after", "step (vi), eq. (3.5): the errors after the split"},
      {"flips", "section 4"},
      {"end", "step (vi), the end"}};
  return steps;
}

void tell(TraceComparison& result, Step step, std::int64_t count, const Differences::Difference& difference) {
  const TraceStep& about = trace_steps()[static_cast<std::size_t>(step)];
  result.verdict =
      difference.asked ? TraceComparison::Verdict::diverges : TraceComparison::Verdict::unresolved;
  result.step = about.name;
  result.place = about.place;
  result.what = difference.what;
  result.count = count;
  const auto fill = [](TraceSide& side, const Says& says) {
    side.line = says.line;
    side.says = says.says;
    side.record = says.record;
  };
  fill(result.reference, difference.reference);
  fill(result.other, difference.other);
}

void Differences::tell(TraceComparison& result) const {
  if (found_.empty()) return;
  const auto& [where, found] = *found_.begin();
  verify::tell(result, where.first, found.count, found.difference);
  if (where.second) result.what += "; rounding may decide that";
}

std::string text(const trace::Point& point) {
  return fmt::format("({}, {}, {})", point.x(), point.y(), point.z());
}

std::string text(const trace::LatticeVertex& vertex) {
  return fmt::format("({}, {}, {})", vertex[0], vertex[1], vertex[2]);
}

std::string short_text(const trace::Point& point) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", point.x(), point.y(), point.z());
}

std::string short_text(const trace::Tet& tet) {
  return short_text(tet[0]) + " " + short_text(tet[1]) + " " + short_text(tet[2]) + " " + short_text(tet[3]);
}

std::string at(const trace::Tet& tet) {
  const trace::Point centroid = (tet[0] / 4 + tet[1] / 4) + (tet[2] / 4 + tet[3] / 4);  // no overflow
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", centroid.x(), centroid.y(), centroid.z());
}

std::pair<std::string, std::string> apart(std::int64_t a, std::int64_t b) {
  return {std::to_string(a), std::to_string(b)};
}

std::pair<std::string, std::string> apart(double a, double b, int digits) {
  const auto word = [](double x, int most) {
    return std::isnan(x) ? "none" : fmt::format("{:.{}g}", x, most);
  };
  for (int more = digits; more <= 17; ++more) {
    if (word(a, more) != word(b, more)) return {word(a, more + 1), word(b, more + 1)};
  }
  return {word(a, digits), word(b, digits)};
}

std::string counted(std::int64_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

}  // namespace tetproof::verify
