// SPDX-License-Identifier: GPL-3.0-or-later
#include "remnants.hpp"

#include <algorithm>
#include <map>

namespace tetproof::test {
namespace {

std::string kind_of(const Text& text) {
  const std::size_t quote = text.item.find('"');
  return quote == std::string::npos ? text.item
                                    : text.item.substr(0, quote) + text.item.substr(text.item.rfind('"'));
}

// The letters and digits of a name. A format may have replaced any other character.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text)
    if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) out += c;
  return out;
}

bool is_of_tetgen(const Text& text) {
  return text.format == "tetgen" || text.format == "poly" || text.format == "smesh";
}

// Whether the names are equal, or the second one is "name #2" because the name was taken.
bool same_name(const std::string& was, const std::string& is) {
  const std::size_t mark = is.rfind(" #");
  return plain(was) == plain(is) || (mark != std::string::npos && plain(was) == plain(is.substr(0, mark)));
}

// Likewise; or the second one is the name that a format without names has for such values.
bool same_name(const Text& was, const Text& is) {
  return same_name(was.name, is.name) || are_words_for_one_tag(was, is) ||
         (is.format == "medit" && (is.name == "solution" || is.name.starts_with("solution ")));
}

// Whether nothing stands for 0: a mark that an element has not.
bool has_no_zeros(const Text& is) {
  return is_of_tetgen(is) && is.name == "markers" && is.item.ends_with(" elements");
}

bool values(const Text& was, const Text& is) {
  if (was.components != is.components || !same_name(was, is)) return false;
  return std::all_of(is.lines.begin(), is.lines.end(), [&](const Text::Line& line) {
    bool known = false, same = false;
    for (const Text::Line& old : was.lines) {
      if (old.of != line.of) continue;
      known = true;
      same = same || old.content == line.content;
    }
    return known ? same : line.empty;
  });
}

bool columns(const Text& was, const Text& is) {
  return std::all_of(is.lines.begin(), is.lines.end(), [&](const Text::Line& column) {
    return std::any_of(was.lines.begin(), was.lines.end(), [&](const Text::Line& old) {
      return old.content == column.content ||
             (old.content.substr(old.content.find('\n')) ==
                  column.content.substr(column.content.find('\n')) &&
              (same_name(was.name + old.of, column.of) || same_name(old.of, column.of)));
    });
  });
}

}  // namespace

bool is_remnant(const Text& was, const Text& is) {
  if (kind_of(was) != kind_of(is)) return false;
  if (is.item == "title") return plain(was.name).starts_with(plain(is.name));
  if (is.item.starts_with("values ")) return values(was, is);
  return is.item.starts_with("table ") && columns(was, is);
}

std::optional<std::vector<std::string>> gaps(const Text& was, const Text& is) {
  if (!was.item.starts_with("values ") || kind_of(was) != kind_of(is) || was.gone ||
      was.components != is.components || was.kind != is.kind || !same_name(was, is))
    return std::nullopt;
  std::multimap<std::string, const Text::Line*> left;
  for (const Text::Line& line : is.lines) left.emplace(line.of, &line);
  for (const Text::Line& line : was.lines) {
    const auto [from, to] = left.equal_range(line.of);
    const auto found =
        std::find_if(from, to, [&](const auto& other) { return other.second->content == line.content; });
    if (found == to && line.empty && has_no_zeros(is)) continue;
    if (found == to) return std::nullopt;
    left.erase(found);
  }
  if (was.lines.empty() && !left.empty()) return std::nullopt;  // no values to compare with
  std::vector<std::string> without;
  for (const auto& [of, line] : left) {
    const bool known =
        std::any_of(was.lines.begin(), was.lines.end(), [&](const Text::Line& old) { return old.of == of; });
    if (known || !line->empty) return std::nullopt;
    without.push_back(of);
  }
  return without;
}

bool are_words_for_one_tag(const Text& was, const Text& is) {
  const auto is_word = [](const std::string& name) { return name == "markers" || name == "references"; };
  return is_word(was.name) && is_word(is.name) && is.item.ends_with(" nodes");
}

bool comes_in_pieces(const Text& was) {
  return was.item.starts_with("table ");
}

}  // namespace tetproof::test
