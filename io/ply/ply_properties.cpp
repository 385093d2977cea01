// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply/ply_properties.hpp"

#include <map>
#include <utility>

#include "io/bytes/tokens.hpp"
#include "io/ply/ply_names.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

Column column_of(const PlyProperty& property, PlyStored& stored) {
  Column column;
  column.name = decode_name(property.name), column.type = property.type_words;
  column.reals = std::move(stored.reals), column.integers = std::move(stored.integers);
  column.lengths = std::move(stored.lengths);
  return column;
}

}  // namespace

void PlyStored::read(PlyData& data, const PlyProperty& property) {
  const std::size_t numbers = property.count ? data.entries(property) : 1;
  if (property.count) lengths.push_back(static_cast<std::int32_t>(numbers));
  for (std::size_t i = 0; i < numbers; ++i)
    if (property.type->real)
      reals.push_back(data.number(*property.type));
    else
      integers.push_back(data.integer(*property.type, "an integer"));
}

void skip_property(PlyData& data, const PlyProperty& property) {
  const std::size_t numbers = property.count ? data.entries(property) : 1;
  for (std::size_t i = 0; i < numbers; ++i) data.number(*property.type);
}

void skip_element(PlyData& data, const PlyElement& element) {
  if (element.properties.empty()) return;
  data.begin(element);
  for (std::int64_t i = 0; i < element.count; ++i) {
    data.start_instance();
    for (const PlyProperty& property : element.properties) skip_property(data, property);
    data.end_instance();
  }
}

void PlyProperties::give(const PlyElement& element, std::vector<PlyStored>& stored,
                         const std::function<bool(std::size_t)>& wanted, std::vector<Values>& all,
                         std::size_t first) {
  std::vector<std::size_t> singles;
  std::vector<std::string> names;
  std::vector<bool> real;
  Table lists;
  for (std::size_t k = 0; k < stored.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    if (!wanted(k)) continue;
    if (property.count) {
      lists.columns.push_back(column_of(property, stored[k]));
    } else {
      singles.push_back(k), names.push_back(property.name), real.push_back(property.type->real);
    }
  }
  if (!lists.columns.empty()) {
    lists.name = element.name, lists.rows = static_cast<std::size_t>(element.count);
    document_.tables.push_back(std::move(lists));
  }
  if (element.count == 0) return;
  for (const PlyGroup& group : group_properties(names, real)) {
    Values values{.name = group.name, .components = static_cast<int>(group.components)};
    values.first = first;
    const auto weave = [&](auto member) {
      auto& to = values.*(member.first);
      if (group.components == 1) {
        to = std::move(stored[singles[group.first]].*(member.second));
        return;
      }
      to.reserve(group.components * static_cast<std::size_t>(element.count));
      for (std::size_t i = 0; i < static_cast<std::size_t>(element.count); ++i)
        for (std::size_t k = 0; k < group.components; ++k)
          to.push_back((stored[singles[group.first + k]].*(member.second))[i]);
    };
    if (real[group.first])
      weave(std::pair{&Values::reals, &PlyStored::reals});
    else
      weave(std::pair{&Values::integers, &PlyStored::integers});
    if (group.name == "color") warn_of_colours(document_, values, element.name.c_str());
    if (&all == &document_.element_values) {
      const auto word = names.begin() + static_cast<std::ptrdiff_t>(group.first);
      property_names_.emplace_back(word, word + static_cast<std::ptrdiff_t>(group.components));
    }
    all.push_back(std::move(values));
  }
}

void PlyProperties::give_table(const PlyElement& element, std::vector<PlyStored>& stored) {
  Table& table = document_.tables.emplace_back();
  table.name = decode_name(element.name), table.rows = static_cast<std::size_t>(element.count);
  for (std::size_t k = 0; k < stored.size(); ++k)
    table.columns.push_back(column_of(element.properties[k], stored[k]));
}

void PlyProperties::join_values() {
  auto& all = document_.element_values;
  std::map<std::pair<std::vector<std::string>, bool>, std::size_t> known;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [place, is_new] = known.try_emplace({property_names_[i], all[i].reals.empty()}, kept);
    Values& before = all[place->second];
    if (!is_new && before.first + before.items() == all[i].first) {
      before.reals.insert(before.reals.end(), all[i].reals.begin(), all[i].reals.end());
      before.integers.insert(before.integers.end(), all[i].integers.begin(), all[i].integers.end());
    } else {
      if (kept != i) all[kept] = std::move(all[i]);
      ++kept;
    }
  }
  all.resize(kept);
}

}  // namespace tetproof::io
