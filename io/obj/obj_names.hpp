// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the groups of OBJ, which are words in the file, to and from the numbers with names of a document.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/document.hpp"
#include "io/model/tag_sets.hpp"

namespace tetproof::io {

/// Starts a comment that tells the number of a group with a name, such as `# group 5 wing`. Used where the
/// word would get another number.
inline constexpr std::string_view group_comment = "# group ";

/// The words for the groups of those elements that OBJ keeps. Each word stands for one number and name.
class GroupWords {
 public:
  explicit GroupWords(const Document& document);
  const std::string& word(int dim, std::int64_t group) const { return words_.at({dim, group}); }
  /// The words whose numbers comments must tell, with these numbers.
  const std::vector<std::pair<std::string, std::int64_t>>& numbered() const { return numbered_; }
  /// Whether the name of a group comes back.
  bool holds(const GroupName& name) const;

 private:
  std::map<std::pair<int, std::int64_t>, std::string> words_;
  std::vector<std::pair<std::string, std::int64_t>> numbered_;
};

/// Numbers groups in the order in which they are used, and adds their names to the document.
class GroupNumbers {
 public:
  /// Before `start`: reserves a number that the file has.
  void take(std::int64_t number) { taken_.insert(number); }
  /// Before `start`: sets the number of a word.
  void take(std::string_view word, std::int64_t number) {
    if (numbers_.try_emplace(std::string(word), number).second) taken_.insert(number);
  }
  /// Before `start`: sets the numbers that the file tells in comments (see `group_comment`).
  void take_comments(const InputFile& file);
  /// From now on, sets and names go into `document`.
  void start(Document& document) {
    document_ = &document;
    sets_.emplace(document);
  }
  /// Sets the words of the next elements.
  void set(std::vector<std::string> words) {
    words_ = std::move(words), cached_.fill(words_.empty() ? 0 : -1);
  }
  /// Returns the number of a word. A word without a number gets one.
  std::int64_t number_of(const std::string& word);
  /// Returns the groups of the words set, for an element of dimension `dim`: a position in `tag_sets`.
  std::int32_t of(int dim) {
    std::int32_t& cached = cached_[static_cast<std::size_t>(dim)];
    return cached >= 0 ? cached : cached = enter(dim);
  }

 private:
  std::int32_t enter(int dim);

  Document* document_ = nullptr;
  std::optional<TagSets> sets_;
  std::set<std::int64_t> taken_;
  std::int64_t next_ = 1;
  std::map<std::string, std::int64_t, std::less<>> numbers_;
  std::set<std::pair<int, std::int64_t>> entered_;
  std::vector<std::string> words_;
  std::array<std::int32_t, 3> cached_{};
};

}  // namespace tetproof::io
