// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the writers of .msh: numbers in text and in binary, and the sections that are the same in all
// versions.
#pragma once

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <string>

#include "io/bytes/text_output.hpp"
#include "io/document.hpp"
#include "io/loss/file_plan.hpp"
#include "io/loss/holds.hpp"
#include "io/msh/msh.hpp"

namespace tetproof::io {

inline constexpr std::int64_t largest_int = std::numeric_limits<std::int32_t>::max();

/// Returns the header; in binary, with the number 1.
std::string msh_header(const char* version, bool binary);
/// Returns $PhysicalNames with the names that are held; empty if there are none.
std::string msh_names(const Document& document, const Holds& holds);
/// Returns the sections that were kept as they stood: those from before the nodes, or those from after them.
std::string msh_kept_sections(const Document& document, const Holds& holds, bool before_nodes);

/// The numbers under which nodes and elements are written.
struct MshTags {
  const Document* document;
  bool renumber = false;           ///< from 1
  std::int64_t first_unknown = 0;  ///< when renumbering: the number of `Document::unknown[0]`

  std::int64_t node(Index i) const {
    if (!renumber) return document->named(i);
    return i < 0 ? unknown(i) : std::int64_t{i} + 1;
  }
  std::int64_t element_at(std::size_t e) const {
    return renumber ? static_cast<std::int64_t>(e) + 1 : document->element_tag(e);
  }
  std::int64_t element(Index i) const {
    if (i >= 0) return element_at(static_cast<std::size_t>(i));
    return renumber ? unknown(i) : document->unknown[static_cast<std::size_t>(-1 - i)];
  }
  std::int64_t unknown(Index i) const { return first_unknown - 1 - i; }
};

/// Whether numbers count up from 0, as readers count where a format has none. Gmsh takes 0 for no number and
/// numbers such nodes wrongly, so that they are written from 1.
bool counts_from_zero(const Document& document);

/// The tags of 4.0 and 4.1.
MshTags msh4_tags(const Document& document);

/// Writes $Periodic, $GhostElements and the sections of data, as far as they are held.
void write_msh_data(AtomicFile& file, const MshTags& tags, const Holds& holds, const std::string& format,
                    bool binary);

/// A plan of one .msh file, with the supplement in a section of its own at the end.
class MshFilePlan : public FilePlan {
 public:
  using FilePlan::FilePlan;
  /// Warns of physical groups that our reader takes back and Gmsh reads as others: those beyond 32 bits, and
  /// those below 0 that are not Gmsh's own.
  std::string warning(const std::string& path) final;
  void write(const std::string& path, const std::string& supplement) final;

 private:
  virtual void write_into(AtomicFile& file) = 0;
};

template <class T>
char* put_raw(char* to, T value) {
  std::memcpy(to, &value, sizeof(T));
  return to + sizeof(T);
}

/// Writes numbers one after the other: as text with blanks between them, or in binary.
template <bool Binary>
struct Putter {
  /// The most bytes that a number needs, its blank included.
  static constexpr std::size_t longest = Binary ? 8 : longest_real + 1;

  char* to;

  void integer(std::int64_t value) {
    if constexpr (Binary)
      to = put_raw(to, static_cast<std::int32_t>(value));
    else
      to = put(put(to, value), ' ');
  }
  void size(std::int64_t value) {
    if constexpr (Binary)
      to = put_raw(to, value);
    else
      to = put(put(to, value), ' ');
  }
  void real(double value) {
    if constexpr (Binary)
      to = put_raw(to, value);
    else
      to = put(put(to, value), ' ');
  }
  void end_line() {
    if constexpr (!Binary) to[-1] = '\n';  // in the place of the last blank
  }
};

/// Returns a line of a few numbers. `fill` puts them into the Putter that it is given.
template <bool Binary, class Fill>
std::string line(std::size_t numbers, const Fill& fill) {
  std::string text(numbers * Putter<Binary>::longest + 1, '\0');
  Putter<Binary> out{text.data()};
  fill(out);
  out.end_line();
  text.resize(out.to - text.data());
  return text;
}

/// Returns the least and the largest of `tag(0)` .. `tag(count - 1)`; both 0 if there are none.
template <class Tag>
std::pair<std::int64_t, std::int64_t> range_of(std::size_t count, const Tag& tag) {
  std::int64_t least = 0, most = 0;
  for (std::size_t i = 0; i < count; ++i) {
    least = i == 0 ? tag(i) : std::min(least, tag(i));
    most = i == 0 ? tag(i) : std::max(most, tag(i));
  }
  return {least, most};
}

/// The same for the tags of `count` nodes or elements, starting with the one at position `from`. `tags`: all
/// tags; if empty, the tags count up from `first`.
inline std::pair<std::int64_t, std::int64_t> range_of(const std::vector<std::int64_t>& tags,
                                                      std::int64_t first, std::size_t from,
                                                      std::size_t count) {
  if (!tags.empty() || count == 0) return range_of(count, [&](std::size_t i) { return tags[from + i]; });
  const std::int64_t start = first + static_cast<std::int64_t>(from);
  return {start, start + static_cast<std::int64_t>(count - 1)};
}

}  // namespace tetproof::io
