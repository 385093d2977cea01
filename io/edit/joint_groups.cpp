// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/edit/joint_groups.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "io/edit/free_numbers.hpp"

namespace tetproof::io {
namespace {

using Key = std::pair<int, std::int64_t>;  // dimension and number

std::set<Key> groups_of(const Document& document) {
  std::set<Key> groups;
  const auto add = [&](int dim, std::int32_t set) {
    for (const std::int64_t group : document.tag_sets[static_cast<std::size_t>(set)])
      groups.insert({dim, std::abs(group)});
  };
  for (const ElementBlock& block : document.blocks) add(block.dim, block.groups);
  for (const Entity& entity : document.entities) add(entity.dim, entity.groups);
  for (const GroupName& name : document.group_names) groups.insert({name.dim, name.group});
  return groups;
}

// A group may have several names.
std::map<Key, std::set<std::string>> names_of(const Document& document) {
  std::map<Key, std::set<std::string>> names;
  for (const GroupName& name : document.group_names) names[{name.dim, name.group}].insert(name.name);
  return names;
}

class GroupJoiner {
 public:
  GroupJoiner(const Document& document, const Document& other)
      : groups_(groups_of(document)), groups_there_(groups_of(other)), names_there_(names_of(other)) {
    for (const auto& [key, names] : names_of(document)) named_.insert(key);
    for (const GroupName& name : document.group_names)
      with_name_[{name.dim, name.name}].push_back(name.group);
  }

  JointGroups join() {
    // Names first, so that no group without one takes the place of a group with the same name.
    for (const Key& key : groups_there_)
      if (const std::int64_t* number = with_a_name_of(key)) give(key, *number);
    for (const Key& key : groups_there_)
      if (!joint_.contains(key)) {
        const bool is_other = named_.contains(key) && names_there_.contains(key);
        give(key, is_other || taken_.contains(key) ? free_number(key.first) : key.second);
      }
    return std::move(joint_);
  }

 private:
  void give(const Key& key, std::int64_t number) {
    joint_[key] = number;
    taken_.insert({key.first, number});
  }

  // The number of a group of the document that has one of the names, and is not another group's yet.
  const std::int64_t* with_a_name_of(const Key& key) const {
    const auto names = names_there_.find(key);
    if (names == names_there_.end()) return nullptr;
    for (const std::string& name : names->second) {
      const auto same = with_name_.find({key.first, name});
      if (same == with_name_.end()) continue;
      for (const std::int64_t& number : same->second)
        if (!taken_.contains({key.first, number})) return &number;
    }
    return nullptr;
  }

  std::int64_t free_number(int dim) {
    if (const auto known = free_.find(dim); known != free_.end()) return known->second.next();
    std::vector<std::int64_t> all;
    for (const std::set<Key>* some : {&groups_, &groups_there_})
      for (const auto& [its_dim, number] : *some)
        if (its_dim == dim) all.push_back(number);
    return free_.emplace(dim, FreeNumbers(std::move(all))).first->second.next();
  }

  const std::set<Key> groups_, groups_there_;
  const std::map<Key, std::set<std::string>> names_there_;
  std::set<Key> named_;  // groups of the document that have names
  std::map<std::pair<int, std::string>, std::vector<std::int64_t>> with_name_;
  std::map<int, FreeNumbers> free_;  // by dimension
  JointGroups joint_;
  std::set<Key> taken_;  // numbers that groups of the other document have now
};

}  // namespace

JointGroups join_groups(Document& document, const Document& other, std::size_t& renumbered) {
  JointGroups joint = GroupJoiner(document, other).join();
  renumbered = static_cast<std::size_t>(std::count_if(
      joint.begin(), joint.end(), [](const auto& group) { return group.second != group.first.second; }));
  std::map<Key, std::set<std::string>> names = names_of(document);
  for (const GroupName& name : other.group_names) {
    const std::int64_t number = joint.at({name.dim, name.group});
    if (names[{name.dim, number}].insert(name.name).second)
      document.group_names.push_back({name.dim, number, name.name});
  }
  return joint;
}

}  // namespace tetproof::io
