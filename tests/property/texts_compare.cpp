// SPDX-License-Identifier: GPL-3.0-or-later
#include "texts_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "remnants.hpp"

namespace tetproof::test {
namespace {

// The numbers behind question marks.
std::set<std::int64_t> unknown_in(const std::string& text) {
  std::set<std::int64_t> numbers;
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if (text[i] == '?' && text[i + 1] >= '0' && text[i + 1] <= '9')
      numbers.insert(std::strtoll(text.c_str() + i + 1, nullptr, 10));
  return numbers;
}

// The sorted lines, with "?17" replaced by "?".
std::string without_unknown(const std::string& text) {
  std::vector<std::string> lines(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    lines.back() += text[i];
    if (text[i] == '\n') lines.emplace_back();
    if (text[i] == '?')
      while (i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') ++i;
  }
  std::sort(lines.begin() + 1, lines.end());
  return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace

void compare_texts(std::vector<Text> was, std::vector<Text> is, DifferenceList& differences,
                   std::set<std::int64_t>& renumbered_unknown) {
  std::erase_if(was, [&](const Text& text) {
    const auto found = std::find_if(is.begin(), is.end(), [&](const Text& t) { return t.text == text.text; });
    if (found == is.end()) return false;
    if (text.gone) differences.add(text.item, text.count, text.text, true, text.subject);
    is.erase(found);
    return true;
  });
  std::erase_if(was, [&](const Text& text) {
    const auto found = std::find_if(is.begin(), is.end(), [&](const Text& t) {
      return t.item == text.item && without_unknown(t.text) == without_unknown(text.text);
    });
    if (found == is.end()) return false;
    const std::set<std::int64_t> still = unknown_in(found->text);
    for (const std::int64_t number : unknown_in(text.text))
      if (still.count(number) == 0 && renumbered_unknown.insert(number).second)
        differences.add("numbers of nodes that do not exist", 1, text.text);
    is.erase(found);
    return true;
  });
  std::erase_if(was, [&](const Text& text) {
    const auto found =
        std::find_if(is.begin(), is.end(), [&](const Text& t) { return gaps(text, t).has_value(); });
    if (found == is.end()) return false;
    const std::string whose = text.item.substr(text.item.rfind('"') + 2);
    if (text.name != found->name && !are_words_for_one_tag(text, *found))
      differences.add_one("names of values " + whose,
                          fmt::format("\"{}\" becomes \"{}\"", text.name, found->name));
    if (text.labels != found->labels)
      differences.add_one("labels of values " + whose, fmt::format("labels of \"{}\"", text.name));
    if (text.step != found->step)
      differences.add_one("times and steps of values " + whose, fmt::format("\"{}\" of time", text.name));
    if (const std::size_t count = gaps(text, *found)->size(); count > 0)
      differences.add("gaps in values " + whose, static_cast<std::int64_t>(count), text.text, false,
                      fmt::format("has no \"{}\"", text.name));
    is.erase(found);
    return true;
  });
  for (const Text& text : was) {
    differences.add(text.item, text.count, text.text, text.gone || text.may_be_said_otherwise, text.subject);
    for (auto t = is.begin(); t != is.end();) {
      if (!is_remnant(text, *t)) {
        ++t;
        continue;
      }
      t = is.erase(t);
      if (!comes_in_pieces(text)) break;
    }
  }
  for (const Text& text : is) differences.add(fmt::format("gained {}", text.item), text.count, text.text);
}

}  // namespace tetproof::test
