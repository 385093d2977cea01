// SPDX-License-Identifier: GPL-3.0-or-later
// Reads records of TetGen's files: one line each, words between blanks and commas, a comment from # on.
// Comments are no data. Several threads read long runs of plain records. A kind of record is described once
// for both ways.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/input_file.hpp"
#include "io/bytes/plain_lines.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/model/node_index.hpp"

namespace tetproof::io {

class Records {
 public:
  /// `document` gets warnings, and the list of what is dropped.
  Records(const InputFile& file, Document& document);

  const std::string& path() const { return file_.path(); }
  const InputFile& file() const { return file_; }
  std::string_view bytes() const { return file_.bytes(); }
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - at_); }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - file_.bytes().data()); }

  /// Goes to the first word of the next record; false at the end of the file.
  bool next();
  /// Does the same, but the file must have a next record.
  void expect_next(const char* expected);
  /// Whether the record has another word.
  bool more();
  /// The number of words from here to the record's end.
  int words();

  std::int64_t integer(const char* expected);
  double real(const char* expected);
  /// Reads a count. InputError if the rest of the file has no room for so many items of so many bytes.
  std::int64_t count(const char* expected, std::int64_t least_bytes_each);
  void check_count(std::int64_t value, const char* expected, std::int64_t least_bytes_each) const;

  /// Reads the number of item `i` of a list. TetGen goes by the order of the lines, so the number is dropped.
  /// It is listed under `item` unless the numbers count up from 0 or 1. `first` is for the calls of one list.
  void list_number(const char* expected, std::int64_t i, std::int64_t& first, const char* item);

  /// Lists words that are left in the record as dropped.
  void end_record();
  /// Lists records that are left in the file as dropped. `elements`: they are elements of the mesh.
  void end_file(bool elements = false);
  /// Handles an element whose number is not the one that TetGen counts: warns once in this file, and lists it
  /// as dropped under `item` (null: the number is kept).
  void other_number(const char* what, std::int64_t number, std::int64_t counted, const char* item);

  /// Goes to the line after the current one. Returns where it begins.
  std::size_t next_line();
  void go_to(std::size_t offset);

  [[noreturn]] void fail(std::string_view message) const { here().fail_in_line(message); }

 private:
  std::string_view word();
  std::int64_t unusual_integer(const char* expected);
  void skip_line();
  void warn(const std::string& message);
  std::string place() const;
  Scanner here() const { return Scanner(file_.path(), file_.bytes(), offset()); }
  [[noreturn]] void fail(const char* expected, std::string_view found) const { here().fail(expected, found); }
  [[noreturn]] void fail_missing(const char* expected) const;

  const InputFile& file_;
  Document& document_;
  const char *at_, *end_;
  bool started_ = false, warned_of_base_ = false, listed_columns_ = false, warned_of_number_ = false;
};

/// A record that `read_rows` passes on where lines are plain. Each function returns false if the line is not
/// plain.
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

/// The same for any record. InputError for what the grammar does not permit.
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

/// Reads `count` records, called `what` in messages. `read(row, i)` takes the words of record i from a
/// PlainRow or an AnyRow, and returns whether it could. Several threads call it while rows are plain, so it
/// may write only to the place of record i.
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
      in.fail("expected " + counted(count, what) + ", found " + std::to_string(i) +
              " and the end of the file");
    AnyRow row(in, index);
    read(row, i);
    in.end_record();
  }
}

}  // namespace tetproof::io
