// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a trace line by line.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "io/error.hpp"
#include "io/traces/trace_json.hpp"
#include "io/traces/trace_keys.hpp"

namespace tetproof::trace {
namespace {

constexpr std::size_t longest_line = 8 << 20;  // bytes; the indicators of four million vertices in a row

// Checks the conditions that the types alone do not express.
template <class R>
void check(const R& r, const Fields& fields) {
  if constexpr (std::is_same_v<R, Indicators>) {
    for (const auto& [key, text] : {std::pair{"initial", &r.initial}, std::pair{"after", &r.after}})
      if (text->empty() || text->find_first_not_of("-0+") != std::string::npos)
        fields.fail(key, "a string of -, 0 and +");
    if (r.initial.size() != r.after.size())
      fields.fail("after", fmt::format("{} indicators as in \"initial\"", r.initial.size()),
                  std::to_string(r.after.size()));
  } else if constexpr (std::is_same_v<R, Lattice>) {
    if (std::count(r.cells.begin(), r.cells.end(), 0)) fields.fail("cells", "three integers from 1 on");
  } else if constexpr (std::is_same_v<R, Insertion>) {
    constexpr std::string_view rows[] = {"0", "1", "2a", "2b", "3a", "3b", "4a", "4b", "4c", "4d", "4e"};
    if (std::find(std::begin(rows), std::end(rows), r.row) == std::end(rows))
      fields.fail("row", fmt::format("a row of Table 4 ({})", fmt::join(rows, ", ")));
    std::vector<int> positions = r.replaced;
    std::sort(positions.begin(), positions.end());
    if (positions.size() < 2 || positions.back() > 3 ||
        std::adjacent_find(positions.begin(), positions.end()) != positions.end())
      fields.fail("replaced", "two to four different positions from 0 to 3");
    if (r.n == 0) fields.fail("n", "an integer from 1 on");
  }
}

template <std::size_t i = 0>
std::optional<Record> read(const JsonLine& line) {
  if constexpr (i == names.size()) {
    return std::nullopt;
  } else {
    if (line.kind() != names[i]) return read<i + 1>(line);
    std::variant_alternative_t<i, Record> record;
    Fields fields(line, names[i]);
    describe(record, fields);
    check(record, fields);
    return record;
  }
}

}  // namespace

Reader::Reader(const std::string& path) : path_(path) {
  const auto fail = [&](const char* what, int reason) {
    throw InputError(fmt::format("{}: {}: {}", path, what, std::strerror(reason)));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("cannot read", EISDIR);
  errno = 0;
  file_.open(path, std::ios::binary);
  if (!file_) fail("cannot open", errno ? errno : EIO);
}

bool Reader::read_line() {
  text_.clear();
  char part[1 << 14];
  for (;;) {
    file_.getline(part, sizeof part);  // if the line is longer, this reads what fits and fails
    const bool whole = !file_.fail();
    text_.append(part, file_.gcount() - (whole && !file_.eof() ? 1 : 0));
    if (file_.bad()) throw InputError(fmt::format("{}: cannot read: {}", path_, std::strerror(errno)));
    if (whole || file_.eof()) break;
    if (text_.size() > longest_line)
      throw InputError(fmt::format("{}:{}: expected a line of at most {} bytes, found a longer one", path_,
                                   line_ + 1, longest_line));
    file_.clear();
  }
  if (file_.eof() && text_.empty()) return false;
  ++line_;
  return true;
}

std::optional<Record> Reader::next() {
  while (read_line()) {
    if (text_.find_first_not_of(" \t\r\v\f") == std::string::npos) continue;
    const JsonLine line(text_, fmt::format("{}:{}", path_, line_));
    if (std::optional<Record> record = read(line)) return record;
  }
  return std::nullopt;
}

}  // namespace tetproof::trace
