// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply/ply_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>

#include "io/bytes/tokens.hpp"

namespace tetproof::io {
namespace {

// Properties that customarily are one array of values.
struct Custom {
  std::string_view name;
  std::array<std::string_view, 4> properties;
  std::size_t count;
};
constexpr std::array<Custom, 4> customs{
    Custom{"normal", {"nx", "ny", "nz"}, 3}, Custom{"color", {"red", "green", "blue", "alpha"}, 4},
    Custom{"color", {"red", "green", "blue"}, 3}, Custom{"texture", {"s", "t"}, 2}};

}  // namespace

std::vector<PlyGroup> group_properties(const std::vector<std::string>& names, const std::vector<bool>& real) {
  std::vector<PlyGroup> groups;
  for (std::size_t i = 0; i < names.size(); i += groups.back().components) {
    PlyGroup group{decode_name(names[i]), i, 1};
    const auto same_kind = [&](std::size_t count) {
      if (i + count > names.size()) return false;
      for (std::size_t k = 1; k < count; ++k)
        if (real[i + k] != real[i]) return false;
      return true;
    };
    for (const Custom& custom : customs)
      if (group.components == 1 && same_kind(custom.count) &&
          std::equal(custom.properties.begin(),
                     custom.properties.begin() + static_cast<std::ptrdiff_t>(custom.count),
                     names.begin() + static_cast<std::ptrdiff_t>(i)))
        group.name = custom.name, group.components = custom.count;
    if (group.components == 1 && names[i].size() > 2 && names[i].ends_with("_0")) {
      const std::string base = names[i].substr(0, names[i].size() - 1);
      std::size_t count = 1;
      while (same_kind(count + 1) && names[i + count] == base + std::to_string(count)) ++count;
      if (count > 1) group.name = decode_name(base.substr(0, base.size() - 1)), group.components = count;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

namespace {

// `escaped`: names that are not grouped with others.
std::vector<std::string> property_names(const Values& values, bool escaped) {
  const auto count = static_cast<std::size_t>(values.components);
  std::string name = encode_name(values.name);
  if (escaped && !name.empty() && name[0] != '%') {
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto c = static_cast<unsigned char>(name[0]);
    name = std::string{'%', digits[c / 16], digits[c % 16]} + name.substr(1);
  }
  if (count == 1) return {name};
  std::vector<std::string> names;
  for (const Custom& custom : customs)
    if (values.name == custom.name && custom.count == count && !escaped) {
      names.assign(custom.properties.begin(), custom.properties.begin() + static_cast<std::ptrdiff_t>(count));
      return names;
    }
  for (std::size_t k = 0; k < count; ++k) names.push_back(fmt::format("{}_{}", name, k));
  return names;
}

bool may_be_named(const std::vector<std::string>& names, const std::set<std::string>& taken) {
  return !names.empty() && std::none_of(names.begin(), names.end(), [&](const std::string& name) {
    return name.empty() || taken.count(name) > 0;
  });
}

using Names = std::map<const Values*, std::vector<std::string>>;

// Returns the last of a part's values that would be read as something else; null: there are none.
const Values* misread(const std::vector<const Values*>& part, const Names& named) {
  std::vector<std::string> names;
  std::vector<bool> real;
  for (const Values* values : part)
    if (const auto found = named.find(values); found != named.end()) {
      names.insert(names.end(), found->second.begin(), found->second.end());
      real.insert(real.end(), found->second.size(), !values->reals.empty());
    }
  std::set<std::tuple<std::size_t, std::size_t, std::string>> read;
  for (const PlyGroup& group : group_properties(names, real))
    read.insert({group.first, group.components, group.name});
  std::size_t first = names.size();
  for (auto values = part.rbegin(); values != part.rend(); ++values) {
    const auto found = named.find(*values);
    if (found == named.end()) continue;
    first -= found->second.size();
    if (read.count({first, found->second.size(), (*values)->name}) == 0) return *values;
  }
  return nullptr;
}

}  // namespace

std::vector<PlyNamed> named_values(const std::vector<const Values*>& wanted,
                                   const std::vector<std::vector<const Values*>>& parts,
                                   const std::set<std::string>& taken) {
  Names named;
  std::set<std::string> used = taken;
  std::set<const Values*> escaped;
  const auto name = [&](const Values* values, bool escape) {
    std::vector<std::string> names = property_names(*values, escape);
    if (escape) escaped.insert(values);
    if (!may_be_named(names, used)) return false;
    used.insert(names.begin(), names.end());
    named[values] = std::move(names);
    return true;
  };
  for (const Values* values : wanted) name(values, false) || name(values, true);
  for (bool again = true; again;) {  // values that would not come back are escaped, then left out
    again = false;
    for (const auto& part : parts)
      if (const Values* values = misread(part, named)) {
        for (const std::string& word : named[values]) used.erase(word);
        named.erase(values);
        if (escaped.count(values) == 0) name(values, true);
        again = true;
      }
  }
  std::vector<PlyNamed> list;
  for (const Values* values : wanted)
    if (const auto found = named.find(values); found != named.end()) list.push_back({values, found->second});
  return list;
}

}  // namespace tetproof::io
