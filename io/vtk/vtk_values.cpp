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

// Numbers texts as they come up, behind those that have a number already.
void number_texts(std::vector<std::string>&& texts, Values& values, VtkLabels& labels) {
  values.texts = true;
  auto& known = labels[values.name];
  if (known.size() != values.labels.size()) known.clear();  // those of other values of this name
  for (std::size_t k = known.size(); k < values.labels.size(); ++k)
    known.try_emplace(values.labels[k], static_cast<std::int64_t>(k));
  for (std::string& text : texts) {
    const auto [place, is_new] = known.try_emplace(text, static_cast<std::int64_t>(known.size()));
    values.integers.push_back(place->second);
    if (is_new) values.labels.push_back(std::move(text));
  }
}

// Whether a column continues the values of the previous pieces: it has the same kind, or one of them is
// empty.
bool continues(const Values& before, const Column& column, const VtkItems& items) {
  if (before.name != column.name || before.components != column.components ||
      before.first + before.items() != items.first)
    return false;
  if (before.size() == 0 || column_size(column) == 0) return true;
  return before.reals.empty() == column.reals.empty() && before.labels.empty() == column.texts.empty();
}

}  // namespace

void add_vtk_values(Document& document, std::vector<Values>& to, Column&& column, const VtkItems& items,
                    std::vector<VtkRole>& roles, VtkLabels& labels) {
  const auto each = static_cast<std::size_t>(column.components);
  if (column.components < 1 || column_size(column) != items.count * each)
    throw InputError(fmt::format("{}: array \"{}\": expected {}, found {}", document.path, column.name,
                                 counted(items.count * each, "values"), column_size(column)));
  std::vector<std::string> own_roles;
  std::erase_if(roles, [&](const VtkRole& role) {
    if (role.array == column.name) own_roles.push_back(role.role);
    return role.array == column.name;
  });
  if (column.type == "UInt64") count_wrapped(document, column, column.name);
  const auto pick = [&](auto& from) {
    if (!items.origin || from.empty()) return;
    std::remove_cvref_t<decltype(from)> picked;
    picked.reserve(items.origin->size() * each);
    for (const std::uint32_t c : *items.origin)
      for (std::size_t k = 0; k < each; ++k) picked.push_back(from[c * each + k]);
    from = std::move(picked);
  };
  pick(column.reals), pick(column.integers), pick(column.texts);
  const auto before = std::find_if(to.begin(), to.end(),
                                   [&](const Values& values) { return continues(values, column, items); });
  if (before == to.end() || (before->size() == 0 && items.first == 0)) {
    Values values{.name = std::move(column.name), .components = column.components, .first = items.first};
    values.roles = std::move(own_roles);
    values.reals = std::move(column.reals), values.integers = std::move(column.integers);
    if (!column.texts.empty()) number_texts(std::move(column.texts), values, labels);
    if (before == to.end())
      to.push_back(std::move(values));
    else
      *before = std::move(values);
    return;
  }
  before->reals.insert(before->reals.end(), column.reals.begin(), column.reals.end());
  before->integers.insert(before->integers.end(), column.integers.begin(), column.integers.end());
  if (!column.texts.empty()) number_texts(std::move(column.texts), *before, labels);
}

}  // namespace tetproof::io
