// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the numbers behind the header of a PLY file, text and binary by the same calls.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "io/bytes/input_file.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/ply/ply_header.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {

/// Reads the numbers of the elements one after another.
class PlyData {
 public:
  PlyData(const InputFile& file, Scanner& scanner, const PlyHeader& header)
      : file_(file), scanner_(scanner), header_(header) {}

  double number(const PlyType& type) {
    if (header_.text) return scanner_.real_in_line("a number");
    return type.load(scanner_.raw(type.bytes, "a number").data(), header_.order);
  }
  std::int64_t integer(const PlyType& type, const char* expected) {
    const double value = number(type);
    if (!(std::abs(value) < 9e15) || value != std::floor(value))
      fail(fmt::format("expected {}, found {}", expected, value));
    return static_cast<std::int64_t>(value);
  }
  /// The number of a list's entries. InputError if the rest of the file cannot hold so many.
  std::size_t entries(const PlyProperty& list) {
    const double value = number(*list.count);
    if (!(value >= 0) || value != std::floor(value))
      fail(fmt::format("expected the number of entries of a list, found {}", value));
    const std::size_t most =
        header_.text ? scanner_.remaining() / 2 + 1 : scanner_.remaining() / list.type->bytes;
    if (value > static_cast<double>(most))
      fail(fmt::format("list '{}' announces {} entries, more than the {} left can hold",
                       shown_name(list.name), value, counted(scanner_.remaining(), "bytes")));
    return static_cast<std::size_t>(value);
  }
  /// Checks the count of an element against the rest of the file, before memory is reserved for it.
  void begin(const PlyElement& element) {
    std::size_t least_bytes = 0;
    for (const PlyProperty& property : element.properties)
      least_bytes += header_.text ? 2 : (property.count ? property.count : property.type)->bytes;
    if (least_bytes == 0) return;
    const std::size_t most = (scanner_.remaining() + header_.text) / least_bytes;
    if (static_cast<std::size_t>(element.count) > most)
      fail(fmt::format("element '{}' announces {} of at least {}, more than the {} left can hold",
                       shown_name(element.name), element.count, counted(least_bytes, "bytes"),
                       counted(scanner_.remaining(), "bytes")));
  }
  /// Goes to the next instance; returns the byte where it starts.
  std::size_t start_instance() {
    if (header_.text) scanner_.at_end();
    return scanner_.offset();
  }
  void end_instance() {
    if (!header_.text || scanner_.at_line_end()) return;
    const std::string_view found = scanner_.word();
    scanner_.fail("the end of the line", found);
  }
  /// Lists what follows the last element, as VTK and meshio pass over it. It may be elements, if the counts
  /// are too small.
  void end(Document& document) {
    if (scanner_.at_end()) return;
    const std::size_t start = scanner_.offset();
    if (!header_.text) {
      constexpr std::size_t smallest_face = 1 + 3;  // with vertices of one byte
      add_loss(document.dropped, "bytes behind the last element", scanner_.remaining(),
               fmt::format("byte {}", start), scanner_.remaining() >= smallest_face);
      return;
    }
    double number;
    const bool elements = parse_real(scanner_.peek_word(), number);
    const std::string first = fmt::format("line {}", scanner_.line());
    std::size_t lines = 0;
    for (const std::size_t end = end_of_text(file_.bytes()); !scanner_.at_end() && scanner_.offset() < end;
         scanner_.next_line())
      ++lines;
    add_loss(document.dropped, "lines behind the last element", lines, first, elements);
  }
  std::size_t remaining() const { return scanner_.remaining(); }
  [[noreturn]] void fail(const std::string& message) const {
    if (header_.text) scanner_.fail_in_line(message);
    scanner_.fail_at_byte(message);
  }

 private:
  const InputFile& file_;
  Scanner& scanner_;
  const PlyHeader& header_;
};

}  // namespace tetproof::io
