// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the elements of a document that are not judged.
#include <fmt/core.h>

#include <algorithm>

#include "io/document.hpp"
#include "io/model/element_types.hpp"
#include "verify/verify.hpp"

namespace tetproof::verify {
namespace {

std::string name_of(const ElementBlock& block) {
  const std::string name = io::name_of_elements(block.type);
  return name == "elements" ? fmt::format("elements of type {}", block.type) : name;
}

// `what` is not read, with the place where the first one is.
NotJudged not_read(const std::string& what, const Loss& loss) {
  return {what, loss.count, "not read" + (loss.example.empty() ? "" : ": " + loss.example)};
}

}  // namespace

Unjudged unjudged(const Document& document) {
  Unjudged result{.elements = {}, .points = points_of_other_cells(document), .points_known = true};
  for (const ElementBlock& block : document.blocks) {
    if (!has_other_cells(block) || block.count == 0) continue;
    const std::string what = name_of(block);
    const auto known = std::find_if(result.elements.begin(), result.elements.end(),
                                    [&](const NotJudged& entry) { return entry.what == what; });
    if (known != result.elements.end())
      known->count += static_cast<std::int64_t>(block.count);
    else
      result.elements.push_back({what, static_cast<std::int64_t>(block.count),
                                 fmt::format("only tetrahedra are judged; the first is element {}",
                                             document.element_tag(block.first))});
  }
  for (const Loss& loss : document.dropped) {
    if (!loss.elements) continue;
    result.points_known = false;
    result.elements.push_back(not_read(loss.item, loss));
  }
  return result;
}

void add_unread_surface(Unjudged& unjudged, const std::vector<Loss>& dropped) {
  for (const Loss& loss : dropped)
    if (loss.elements) unjudged.elements.push_back(not_read(loss.item + " of the surface", loss));
}

}  // namespace tetproof::verify
