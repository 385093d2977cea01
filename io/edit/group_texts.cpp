// SPDX-License-Identifier: GPL-3.0-or-later
// The names of groups as values of elements.
#include <fmt/core.h>

#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "io/bytes/words.hpp"
#include "io/edit/edits.hpp"
#include "io/error.hpp"

namespace tetproof::io {

Edit add_group_texts(Document& document) {
  if (document.group_names.empty()) throw InputError(fmt::format("{}: no group has a name", document.path));
  std::map<std::pair<int, std::int64_t>, std::string> names;
  for (const GroupName& name : document.group_names) names.try_emplace({name.dim, name.group}, name.name);
  const auto text_of = [&](const ElementBlock& block) {
    std::string text;
    for (const std::int64_t group : document.tag_sets[static_cast<std::size_t>(block.groups)]) {
      const auto name = names.find({block.dim, std::abs(group)});
      text += text.empty() ? "" : ", ";
      text += name == names.end() ? fmt::format("{}", group) : name->second;
    }
    return text;
  };
  Values values{.name = "group names", .texts = true};
  std::map<std::string, std::int64_t> known;
  std::size_t named = 0;
  for (const ElementBlock& block : document.blocks) {
    if (block.count == 0) continue;
    const std::string text = text_of(block);
    const auto [place, is_new] = known.try_emplace(text, static_cast<std::int64_t>(known.size()));
    if (is_new) values.labels.push_back(text);
    values.integers.insert(values.integers.end(), block.count, place->second);
    if (!text.empty()) named += block.count;
  }
  document.element_values.push_back(std::move(values));
  return {fmt::format("{} of {} have the names or numbers of their groups as values \"group names\"", named,
                      counted(document.elements(), "elements")),
          {}};
}

}  // namespace tetproof::io
