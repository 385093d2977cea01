// SPDX-License-Identifier: GPL-3.0-or-later
// The groups of OBJ: words in its file, numbers with names in a document.
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

/// A comment that tells the number of a group with a name, `# group 5 wing`, where it is not the one that the
/// word would get.
inline constexpr std::string_view group_comment = "# group ";

/// The words for the groups of the elements that OBJ keeps, each for one number and name.
class GroupWords {
 public:
  explicit GroupWords(const Document& document);
  const std::string& word(int dim, std::int64_t group) const { return words_.at({dim, group}); }
  /// Words whose numbers a comment must tell.
  const std::vector<std::pair<std::string, std::int64_t>>& numbered() const { return numbered_; }
  /// Whether the name comes back.
  bool holds(const GroupName& name) const;

 private:
  std::map<std::pair<int, std::int64_t>, std::string> words_;
  std::vector<std::pair<std::string, std::int64_t>> numbered_;
};

/// Numbers groups as they are used, and enters their names.
class GroupNumbers {
 public:
  /// Before the start: a number that stands in the file.
  void take(std::int64_t number) { taken_.insert(number); }
  /// Before the start: the number of a word.
  void take(std::string_view word, std::int64_t number) {
    if (numbers_.try_emplace(std::string(word), number).second) taken_.insert(number);
  }
  /// Before the start: those that comments of the file tell, as `group_comment` says.
  void take_comments(const InputFile& file);
  /// From here on sets and names go into `document`.
  void start(Document& document) {
    document_ = &document;
    sets_.emplace(document);
  }
  /// The words of the elements to come.
  void set(std::vector<std::string> words) {
    words_ = std::move(words), cached_.fill(words_.empty() ? 0 : -1);
  }
  /// The number of a word, which it gets if it has none.
  std::int64_t number_of(const std::string& word);
  /// Their groups, for an element of dimension `dim`: a position in `tag_sets`.
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
