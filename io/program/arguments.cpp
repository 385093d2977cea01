// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/program/arguments.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace tetproof::program {
namespace {

// CLI11's words for what it permits, in ours. Sets are in the placeholder already.
std::string limits_of(const std::string& type) {
  const std::size_t colon = type.find(':');
  if (colon == type.npos) return "";
  const std::string rule = type.substr(colon + 1);
  if (rule.find('{') != rule.npos) return "";
  constexpr std::array<std::array<std::string_view, 2>, 5> words{{{"INT in ", "whole number in "},
                                                                  {"UINT in ", "whole number in "},
                                                                  {"FLOAT in ", "number in "},
                                                                  {"NONNEGATIVE", "not negative"},
                                                                  {"POSITIVE", "positive"}}};
  for (const auto& [theirs, ours] : words)
    if (rule.starts_with(theirs)) return std::string(ours) + rule.substr(theirs.size());
  return rule == "FILE" ? "a file that exists" : rule;
}

// "inside|outside" has two choices; "N|auto|0" has auto and 0, beside any number.
std::vector<std::string> choices_in(const std::string& value) {
  std::vector<std::string> words;
  if (value.find('|') == value.npos) return words;
  for (std::size_t from = 0; from <= value.size();) {
    const std::size_t end = std::min(value.find('|', from), value.size());
    const std::string word = value.substr(from, end - from);
    const bool placeholder =
        std::any_of(word.begin(), word.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
    if (!placeholder && !word.empty()) words.push_back(word);
    from = end + 1;
  }
  return words;
}

Argument::Kind kind_of(const Argument& argument, const std::string& place) {
  using Kind = Argument::Kind;
  if (argument.value.empty()) return Kind::flag;
  const auto begins = [&](std::string_view word) { return argument.value.starts_with(word); };
  if (!argument.choices.empty())
    return begins("LIST") || argument.value.find(',') != std::string::npos ? Kind::list : Kind::choice;
  if (begins("DIR")) return Kind::folder;
  if (place == "COMMAND") return Kind::command;
  for (const std::string_view file : {"FILE", "PATH", "GRID", "OTHER", "CASE"})
    if (begins(file)) return Kind::file;
  return place.empty() ? Kind::word : Kind::file;
}

}  // namespace

std::vector<Argument> arguments_of(const CLI::App& app, const Choices& choices) {
  std::vector<Argument> all;
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    if (option->get_group().empty()) continue;
    Argument argument{};
    for (const std::string& name : option->get_snames()) argument.names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) argument.names.push_back("--" + name);
    const bool positional = argument.names.empty();
    const std::string place = positional ? option->get_name(true) : "";
    const std::string type = option->get_type_name();
    if (!option->get_option_text().empty()) {  // "on|off [on]"
      argument.value = option->get_option_text();
      if (const std::size_t bracket = argument.value.find(" ["); bracket != std::string::npos) {
        argument.standard = argument.value.substr(bracket + 2, argument.value.size() - bracket - 3);
        argument.value.resize(bracket);
      }
    } else if (option->get_items_expected_max() > 0) {
      argument.value = positional ? place : type.substr(0, type.find(':'));
      argument.standard = option->get_default_str() == "[]" ? "" : option->get_default_str();
    }
    argument.limits = limits_of(type);
    argument.help = option->get_description();
    argument.group = positional ? "" : option->get_group();
    argument.required = option->get_required();
    argument.repeats = option->get_expected_max() > 1;
    for (const std::string& name : argument.names)
      if (const auto found = choices.find(name); found != choices.end()) argument.choices = found->second;
    if (argument.choices.empty()) {
      const auto found = choices.find(argument.value);
      argument.choices = found != choices.end() ? found->second : choices_in(argument.value);
    }
    argument.kind = kind_of(argument, place);
    all.push_back(std::move(argument));
  }
  return all;
}

}  // namespace tetproof::program
