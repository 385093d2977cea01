// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_types.hpp"

namespace tetproof::io {
namespace {

void count_wrapped(Document& document, const Column& column, const std::string& name) {
  const auto negative = [](std::int64_t value) { return value < 0; };
  const auto first = std::find_if(column.integers.begin(), column.integers.end(), negative);
  if (first == column.integers.end()) return;
  add_loss(document.dropped, "integers of 2^63 or more, kept as negative ones",
           static_cast<std::size_t>(std::count_if(first, column.integers.end(), negative)),
           fmt::format("{} of \"{}\"", static_cast<std::uint64_t>(*first), name));
}

}  // namespace

void add_vtk_values(Document& document, std::vector<Values>& to, Column&& column, const VtkItems& items,
                    std::vector<VtkRole>& roles) {
  const auto each = static_cast<std::size_t>(column.components);
  if (column.components < 1 || column_size(column) != items.count * each)
    throw InputError(fmt::format("{}: array \"{}\": expected {}, found {}", document.path, column.name,
                                 counted(items.count * each, "values"), column_size(column)));
  Values values{.name = std::move(column.name), .components = column.components};
  std::erase_if(roles, [&](const VtkRole& role) {
    if (role.array == values.name) values.roles.push_back(role.role);
    return role.array == values.name;
  });
  if (!column.texts.empty()) {
    std::unordered_map<std::string, std::int64_t> known;
    for (std::string& text : column.texts) {
      const auto [place, is_new] = known.try_emplace(text, static_cast<std::int64_t>(known.size()));
      if (is_new) values.labels.push_back(std::move(text));
      column.integers.push_back(place->second);
    }
  }
  if (column.type == "UInt64") count_wrapped(document, column, values.name);
  const auto pick = [&](auto& from) {
    if (!items.origin) return std::move(from);
    std::remove_cvref_t<decltype(from)> picked;
    picked.reserve(from.empty() ? 0 : items.origin->size() * each);
    for (const std::uint32_t c : *items.origin)
      for (std::size_t k = 0; k < each && !from.empty(); ++k) picked.push_back(from[c * each + k]);
    return picked;
  };
  values.reals = pick(column.reals);
  values.integers = pick(column.integers);
  // The array of the previous piece continues here.
  for (Values& before : to)
    if (before.name == values.name && before.components == values.components && items.first > 0 &&
        before.first + before.items() == items.first && before.labels.empty() && values.labels.empty() &&
        (values.size() == 0 || before.integers.empty() == values.integers.empty())) {
      before.reals.insert(before.reals.end(), values.reals.begin(), values.reals.end());
      before.integers.insert(before.integers.end(), values.integers.begin(), values.integers.end());
      return;
    }
  values.first = items.first;
  to.push_back(std::move(values));
}

}  // namespace tetproof::io
