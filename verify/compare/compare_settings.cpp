// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/compare/compare_settings.hpp"

namespace tetproof::verify {
namespace {

using namespace trace;

// The settings that differ, as text: for the whole sentence and for each side.
struct Differing {
  std::string what, reference, other;
};

Differing differing(const Settings& a, const Settings& b, const Tolerance& tolerance) {
  Differing all;
  const auto compare = [&](const char* key, const auto& reference, const auto& other) {
    bool same = reference == other;
    if constexpr (std::is_same_v<std::decay_t<decltype(reference)>, double>)
      same = tolerance.same(reference, other);
    if (same) return;
    const char* const separator = all.what.empty() ? "" : "; ";
    all.what += fmt::format("{}{} is {} in reference, {} in other", separator, key, reference, other);
    all.reference += fmt::format("{}{} {}", separator, key, reference);
    all.other += fmt::format("{}{} {}", separator, key, other);
  };
  compare("region", a.region, b.region);
  compare("box_scale", a.box_scale, b.box_scale);
  compare("on_surface", a.on_surface, b.on_surface);
  compare("diagonals", a.diagonals, b.diagonals);
  compare("literal", a.literal, b.literal);
  compare("parametric", a.parametric, b.parametric);
  compare("points", a.points, b.points);
  if (a.points == "0" && b.points == "0") return all;  // there are no steps (v) and (vi)
  compare("p", a.p, b.p);
  compare("curvature", a.curvature, b.curvature);
  compare("improve", a.improve, b.improve);
  if (a.improve != "none" || b.improve != "none") compare("improve_below", a.improve_below, b.improve_below);
  compare("past_dilution", a.past_dilution, b.past_dilution);
  return all;
}

Says side(const TracedSettings& traced, const std::string& says) {
  return {traced.line, traced.line ? says : "no settings record: the defaults", to_line(traced.settings)};
}

}  // namespace

void compare_settings(const TracedSettings& reference, const TracedSettings& other,
                      const Tolerance& tolerance, Differences& differences) {
  const Differing all = differing(reference.settings, other.settings, tolerance);
  if (all.what.empty()) return;
  differences.add(Step::settings, reference.line, other.line, [&] {
    return Differences::Difference{"the settings differ: " + all.what, side(reference, all.reference),
                                   side(other, all.other), true};
  });
}

}  // namespace tetproof::verify
