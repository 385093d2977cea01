// SPDX-License-Identifier: GPL-3.0-or-later
// Records of TetGen's files: a line each, words between blanks and commas, a comment from # on. Long runs of
// plain ones are read by several threads, and each kind of record is written down once for both ways.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/bytes/plain_lines.hpp"
#include "io/bytes/scanner.hpp"
#include "io/model/node_index.hpp"

namespace tetproof::io {

class Records {
 public:
  Records(const InputFile& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {
    at_ = file.bytes().data();
    end_ = at_ + file.bytes().size();
  }

  const std::string& path() const { return file_.path(); }
  const InputFile& file() const { return file_; }
  std::string_view bytes() const { return file_.bytes(); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - file_.bytes().data()); }

  /// To the first word of the next record; false at the end of the file.
  bool next();
  /// Likewise, but the file must have one.
  void expect_next(const char* expected);
  /// Whether the record has another word.
  bool more();
  /// How many it has from here on.
  int words();

  std::int64_t integer(const char* expected);
  double real(const char* expected);
  /// A count that the rest of the file has room for, at so many bytes each; else InputError.
  std::int64_t count(const char* expected, std::int64_t least_bytes_each);
  void check_count(std::int64_t value, const char* expected, std::int64_t least_bytes_each) const;

  /// Warns of words that are left in the record.
  void end_record();
  /// Warns of records that are left in the file.
  void end_file();
  /// Warns once in this file of an element whose number is not the one that TetGen counts.
  void warn_of_number(const char* what, std::int64_t number, std::int64_t counted);

  /// Where the line after the current one begins; the next record is looked for from there.
  std::size_t next_line();
  void go_to(std::size_t offset);

  [[noreturn]] void fail(std::string_view message) const { here().fail_in_line(message); }

 private:
  std::string_view word();
  std::int64_t unusual_integer(const char* expected);
  void skip_line();
  void warn(const std::string& message) const;
  Scanner here() const { return Scanner(file_.path(), file_.bytes(), offset()); }
  [[noreturn]] void fail(const char* expected, std::string_view found) const { here().fail(expected, found); }
  [[noreturn]] void fail_missing(const char* expected) const;

  const InputFile& file_;
  std::vector<std::string>& warnings_;
  const char *at_, *end_;
  bool started_ = false, warned_of_base_ = false, warned_of_columns_ = false, warned_of_number_ = false;
};

/// A record as `read_rows` hands it out where lines are plain: everything answers false if it is not so.
class PlainRow {
 public:
  static constexpr bool plain = true;
  PlainRow(PlainLine& line, const NodeIndex* index) : line_(line), index_(index) {}

  bool number(std::int64_t& value, std::int64_t counted, const char*) {
    return line_.integer(value) && value == counted;
  }
  bool integer(std::int64_t& value, const char*) { return line_.integer(value); }
  bool real(double& value, const char*) { return line_.real(value); }
  bool optional_integer(std::int64_t& value, const char*) { return line_.integer(value); }
  bool optional_real(double& value, const char*) { return line_.real(value); }
  bool node(Index& position) {
    std::int64_t number;
    return line_.integer(number) && (position = index_->known(number)) >= 0;
  }

 private:
  PlainLine& line_;
  const NodeIndex* index_;
};

/// The same for any record: what the grammar does not permit is an InputError.
class AnyRow {
 public:
  static constexpr bool plain = false;
  AnyRow(Records& in, NodeIndex* index) : in_(in), index_(index) {}

  bool number(std::int64_t& value, std::int64_t, const char* expected) { return integer(value, expected); }
  bool integer(std::int64_t& value, const char* expected) {
    value = in_.integer(expected);
    return true;
  }
  bool real(double& value, const char* expected) {
    value = in_.real(expected);
    return true;
  }
  bool optional_integer(std::int64_t& value, const char* expected) {
    return !in_.more() || integer(value, expected);
  }
  bool optional_real(double& value, const char* expected) { return !in_.more() || real(value, expected); }
  bool node(Index& position) {
    position = (*index_)(in_.integer("the number of a node"));
    return true;
  }

 private:
  Records& in_;
  NodeIndex* index_;
};

/// Reads `count` records, `what` in messages: `read(row, i)` takes the words of record i from a PlainRow or
/// an AnyRow, and answers whether it could. Nothing but `read`'s own place for record i may be written by it
/// while rows are plain.
template <class Read>
void read_rows(Records& in, std::size_t count, std::string_view what, NodeIndex* index, const Read& read) {
  const std::size_t start = in.next_line();
  const auto behind = read_plain_lines(in.file(), start, count, [&](PlainLine& line, std::size_t i) {
    PlainRow row(line, index);
    return read(row, i);
  });
  if (behind) return in.go_to(*behind);
  for (std::size_t i = 0; i < count; ++i) {
    if (!in.next())
      in.fail("expected " + std::to_string(count) + " " + std::string(what) + ", found " + std::to_string(i) +
              " and the end of the file");
    AnyRow row(in, index);
    read(row, i);
    in.end_record();
  }
}

}  // namespace tetproof::io
