// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <stdexcept>

#include "corpus/fuzz/kind.hpp"
#include "corpus/fuzz_surface.hpp"
#include "corpus/generators/spec.hpp"

namespace tetproof::corpus {
namespace {

template <class Entry>
const Entry* find(const std::vector<Entry>& list, std::string_view name) {
  for (const Entry& entry : list)
    if (name == entry.name) return &entry;
  return nullptr;
}

std::string parameters_text(const std::vector<FuzzParameter>& parameters) {
  std::string text;
  for (const FuzzParameter& p : parameters)
    text += fmt::format("    {:<14} {} ({} to {}; at random {} to {})\n",
                        fmt::format("{}={}", p.key, number_text(p.simplest)), p.meaning, number_text(p.least),
                        number_text(p.most), number_text(p.low), number_text(p.high));
  return text;
}

}  // namespace

double Numbers::operator[](std::string_view key) const {
  for (std::size_t i = 0; i < parameters_->size(); ++i)
    if (key == (*parameters_)[i].key) return values_[i];
  throw std::logic_error(fmt::format("a kind of random surface has no parameter {}", key));
}

const std::vector<FuzzKind>& fuzz_kinds() {
  static const std::vector<FuzzKind> all = [] {
    std::vector<FuzzKind> list;
    for (auto theme : {chazelle_kinds, flat_kinds, cell_kinds, revolved_kinds, sphere_kinds, twisted_kinds,
                       hull_kinds, assembled_kinds})
      for (FuzzKind& kind : theme()) list.push_back(std::move(kind));
    return list;
  }();
  return all;
}

const FuzzKind* find_kind(std::string_view name) {
  return find(fuzz_kinds(), name);
}
const FuzzCombination* find_combination(std::string_view name) {
  return find(fuzz_combinations(), name);
}
const FuzzModifier* find_modifier(std::string_view name) {
  return find(fuzz_modifiers(), name);
}

const std::vector<FuzzParameter>* parameters_of(std::string_view kind) {
  if (const FuzzKind* leaf = find_kind(kind)) return &leaf->parameters;
  if (const FuzzCombination* combination = find_combination(kind)) return &combination->parameters;
  return nullptr;
}

std::string list_fuzz_kinds() {
  std::string text = "Kinds:\n";
  for (const FuzzKind& kind : fuzz_kinds())
    text += fmt::format("{}: {}\n    hard for: {}\n{}", kind.name, kind.meaning, kind.hard_for,
                        parameters_text(kind.parameters));
  text += "Combinations, with their parts in the parentheses:\n";
  for (const FuzzCombination& combination : fuzz_combinations())
    text += fmt::format("{}: {}\n{}", combination.name, combination.meaning,
                        parameters_text(combination.parameters));
  text += "Modifiers, after a '+':\n";
  for (const FuzzModifier& modifier : fuzz_modifiers())
    text += fmt::format("{}: {}\n{}", modifier.name, modifier.meaning, parameters_text(modifier.parameters));
  return text;
}

}  // namespace tetproof::corpus
