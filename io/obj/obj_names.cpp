// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/obj_names.hpp"

#include <algorithm>

#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/surface/group_names.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

namespace {

// Returns the word for a name with its first `count` characters as codes. It means the same.
std::string with_codes(std::string_view name, std::size_t count) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string word;
  for (const char c : name.substr(0, count)) {
    const auto byte = static_cast<unsigned char>(c);
    word.append("%").append(1, digits[byte / 16]).append(1, digits[byte % 16]);
  }
  return word + encode_name(name.substr(std::min(count, name.size())));
}

}  // namespace

GroupWords::GroupWords(const Document& document) {
  std::map<std::pair<int, std::int64_t>, const std::string*> names;
  for (const GroupName& name : document.group_names)
    if (!name.name.empty()) names.try_emplace({name.dim, name.group}, &name.name);
  std::map<std::string, std::int64_t> known;  // words and their numbers
  std::vector<std::string> order;
  GroupNumbers unaided;
  for (const ElementBlock& block : document.blocks) {
    if (corners_kept(block) == 0 || block.count == 0) continue;
    for (const std::int64_t group : document.tag_sets[static_cast<std::size_t>(block.groups)]) {
      const auto [place, is_new] = words_.try_emplace({block.dim, group});
      if (!is_new) continue;
      const auto name = names.find({block.dim, group});
      std::string word = std::to_string(group);
      if (name != names.end())
        for (std::size_t codes = 0; codes <= name->second->size(); ++codes) {
          word = with_codes(*name->second, codes);
          const auto same = known.find(word);
          if (!group_number(word) && (same == known.end() || same->second == group)) break;
        }
      if (known.try_emplace(word, group).second) order.push_back(word);
      if (group_number(word)) unaided.take(group);
      place->second = word;
    }
  }
  // If a word alone would get another number, comments tell the numbers of all words.
  bool same = true;
  for (const std::string& word : order) same = same && unaided.number_of(word) == known[word];
  if (same) return;
  for (const std::string& word : order)
    if (!group_number(word)) numbered_.emplace_back(word, known[word]);
}

bool GroupWords::holds(const GroupName& name) const {
  const auto word = words_.find({name.dim, name.group});
  return word != words_.end() && !group_number(word->second) && decode_name(word->second) == name.name;
}

void GroupNumbers::take_comments(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  for (std::size_t at = 0; (at = bytes.find(group_comment, at)) != bytes.npos;) {
    const bool starts_line = at > 0 && (bytes[at - 1] == '\n' || bytes[at - 1] == '\r');
    at += group_comment.size();
    Scanner line(file.path(), bytes, at);
    const std::string_view text = line.rest_of_line();
    const std::size_t blank = text.find(' ');
    std::int64_t number;
    if (starts_line && blank != text.npos && parse_integer(text.substr(0, blank), number) &&
        blank + 1 < text.size() && text.find_first_of(" \t", blank + 1) == text.npos)
      take(text.substr(blank + 1), number);
  }
}

std::int64_t GroupNumbers::number_of(const std::string& word) {
  if (const auto own = group_number(word)) return *own;
  const auto [place, is_new] = numbers_.try_emplace(word, 0);
  if (is_new) {
    while (taken_.count(next_)) ++next_;
    place->second = next_++;
  }
  return place->second;
}

std::int32_t GroupNumbers::enter(int dim) {
  std::vector<std::int64_t> groups;
  for (const std::string& word : words_) {
    const std::int64_t number = number_of(word);
    if (!group_number(word) && entered_.insert({dim, number}).second)
      document_->group_names.push_back({dim, number, decode_name(word)});
    if (std::find(groups.begin(), groups.end(), number) == groups.end()) groups.push_back(number);
  }
  return (*sets_)(groups);
}

}  // namespace tetproof::io
