// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/joint_groups.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

namespace tetproof::io {

JointGroups join_groups(Document& document, const Document& other, std::size_t& renumbered) {
  std::set<std::pair<int, std::int64_t>> used, used_there;
  const auto collect = [](const Document& from, auto& into) {
    const auto add = [&](int dim, std::int32_t set) {
      for (const std::int64_t group : from.tag_sets[static_cast<std::size_t>(set)])
        into.insert({dim, std::abs(group)});
    };
    for (const ElementBlock& block : from.blocks) add(block.dim, block.groups);
    for (const Entity& entity : from.entities) add(entity.dim, entity.groups);
    for (const GroupName& name : from.group_names) into.insert({name.dim, name.group});
  };
  collect(document, used);
  collect(other, used_there);
  std::map<std::pair<int, std::int64_t>, std::string> names, names_there;
  std::map<std::pair<int, std::string>, std::int64_t> numbers;
  for (const GroupName& name : document.group_names) {
    names[{name.dim, name.group}] = name.name;
    numbers[{name.dim, name.name}] = name.group;
  }
  for (const GroupName& name : other.group_names) names_there[{name.dim, name.group}] = name.name;
  renumbered = 0;
  JointGroups joint;
  for (const auto& key : used_there) {
    const auto named = names_there.find(key);
    std::int64_t number = key.second;
    if (named != names_there.end()) {
      const auto same = numbers.find({key.first, named->second});
      const auto rival = names.find(key);
      if (same != numbers.end()) {
        number = same->second;
      } else if (rival != names.end()) {
        for (const auto* all : {&used, &used_there})
          for (const auto& [dim, group] : *all)
            if (dim == key.first) number = std::max(number, group + 1);
        used.insert({key.first, number});
      }
      if (same == numbers.end()) document.group_names.push_back({key.first, number, named->second});
    }
    renumbered += number != key.second;
    joint[key] = number;
  }
  return joint;
}

}  // namespace tetproof::io
