// SPDX-License-Identifier: GPL-3.0-or-later
// Writes OFF.
#include <fmt/core.h>

#include <algorithm>

#include "io/off/off.hpp"
#include "io/off/off_plan.hpp"
#include "io/surface/kept_part.hpp"
#include "io/surface/surface_lines.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {
namespace {

void write_off(AtomicFile& file, const Document& document, const OffPlan& plan) {
  file.write(
      fmt::format("{}{}{}OFF\n", plan.texture ? "ST" : "", plan.color ? "C" : "", plan.normal ? "N" : ""));
  write_title(file, "#", plan.came_from_off && title_in_lines(document.title) ? document.title : "");
  std::vector<KeptElement> faces;
  for_each_kept(document, [&](const KeptElement& face) {
    if (face.corners >= 3 || plan.came_from_off) faces.push_back(face);
  });
  file.write(fmt::format("{} {} 0\n", document.points.size(), faces.size()));

  write_items(file, document.points.size(), 12 * (longest_decimal + 1), [&](std::size_t i, char* to) {
    to = put_point(to, document.points[i]);
    for (const Values* values : {plan.normal, plan.color, plan.texture})
      if (values) to = put_row(to, *values, i);
    return put(to, '\n');
  });
  std::size_t most = 0;
  for (const KeptElement& face : faces) most = std::max(most, static_cast<std::size_t>(face.corners));
  const std::size_t longest = (most + 1) * 12 + 4 * (longest_decimal + 1) + 1;
  write_items(file, faces.size(), longest, [&](std::size_t i, char* to) {
    const KeptElement& face = faces[i];
    to = put(to, face.corners);
    for (int k = 0; k < face.corners; ++k) to = put(put(to, ' '), face.nodes[k]);
    std::size_t row = 0;
    if (const Values* colors = plan.face_colors.find(face.element, row)) to = put_row(to, *colors, row);
    return put(to, '\n');
  });
}

std::vector<std::size_t> elements_written(const Document& document) {
  return kept_elements(document,
                       [&](const KeptElement& e) { return e.corners >= 3 || document.format == "off"; });
}

class OffFilePlan : public OneFilePlan {
 public:
  explicit OffFilePlan(const Document& document)
      : OneFilePlan(document),
        part_(document, elements_written, KeptPart::Form::lists),
        plan_(off_plan(part_.document())) {
    holds_ = part_.holds(off_holds(part_.document(), plan_));
  }

 private:
  void write_into(AtomicFile& file) override { write_off(file, part_.document(), plan_); }

  const KeptPart part_;
  const OffPlan plan_;
};

}  // namespace

std::unique_ptr<FilePlan> plan_off(const Document& document, bool) {
  return std::make_unique<OffFilePlan>(document);
}

}  // namespace tetproof::io
