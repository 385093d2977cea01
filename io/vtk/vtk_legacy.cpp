// SPDX-License-Identifier: GPL-3.0-or-later
// Reads arrays and cells of VTK's legacy files number by number.
#include "io/vtk/vtk_legacy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

constexpr std::size_t most_odd_types = 10;  // finding a line takes long in a large file

}  // namespace

std::string VtkLegacyScanner::next_word() const {
  Scanner ahead = *this;
  return lower_case(ahead.word());
}

std::string VtkLegacyScanner::type() {
  const std::string_view found = word();
  std::string type = type_of_vtk_word(found);
  if (type.empty()) {
    const std::string_view tried = vtk_type_tried_for(found);
    if (tried.empty()) fail("the type of numbers", found);
    const auto known = std::find_if(odd_types_.begin(), odd_types_.end(),
                                    [&](const OddType& odd) { return odd.word == found; });
    if (known != odd_types_.end())
      ++known->count;
    else if (odd_types_.size() < most_odd_types)
      odd_types_.push_back({std::string(found), line(), std::string(tried), 1});
    else
      ++odd_types_.back().others;
    return type_of_vtk_word(tried);
  }
  return type;
}

int VtkLegacyScanner::components() {
  const std::int64_t value = integer("the number of components");
  if (value < 1 || value > 1 << 20)
    fail_in_line(fmt::format("expected the number of components, found {}", value));
  return static_cast<int>(value);
}

void VtkLegacyScanner::numbers(Column& column, std::size_t count) {
  if (column.type == "String") return texts(column, count);
  const bool bits = column.type == "bit";
  if (bits) column.type = "UInt8";
  if (!binary_) {
    const bool reals = is_real_type(column.type);
    for (std::size_t i = 0; i < count; ++i)
      if (reals)
        column.reals.push_back(real("a number"));
      else
        column.integers.push_back(read_vtk_integer(*this, column.type));
    return;
  }
  next_line();
  if (bits) {
    return append_bits(raw((count + 7) / 8, "bits"), count, column);
  }
  const std::size_t size = vtk_type_size(column.type);
  if (count > remaining() / size)
    fail_at_byte(fmt::format("expected {} of {}, found {} and the end of the file", counted(count, "numbers"),
                             counted(size, "bytes"), counted(remaining(), "bytes")));
  append_numbers(raw(count * size, "numbers").data(), count, std::endian::big, column);
}

void VtkLegacyScanner::integers(Column& column, std::size_t count) {
  if (is_real_type(column.type) || column.type == "String" || column.type == "bit")
    fail_in_line("expected a type of integers");
  numbers(column, count);
}

// In text each text is a line. In binary the first two bits say how many bits hold the length: 6, 14, 30 or
// 62.
void VtkLegacyScanner::texts(Column& column, std::size_t count) {
  next_line();
  for (std::size_t i = 0; i < count; ++i) {
    if (remaining() == 0) fail("a text", {});
    if (!binary_) {
      column.texts.push_back(vtk_decoded(rest_of_line()));
      next_line();
      continue;
    }
    const unsigned first = static_cast<unsigned char>(raw(1, "a text's length")[0]);
    const std::size_t more = first >> 6 == 3 ? 0 : first >> 6 == 2 ? 1 : first >> 6 == 1 ? 3 : 7;
    std::uint64_t length = first & 63;
    for (const char c : raw(more, "a text's length")) length = length << 8 | static_cast<unsigned char>(c);
    column.texts.emplace_back(raw(length, "a text"));
  }
}

std::size_t VtkLegacyScanner::colors(Column& column, std::size_t count) {
  if (binary_) {
    numbers(column, count);
    return 0;
  }
  std::size_t rounded = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = real("a colour from 0 to 1");
    if (!(value >= 0 && value <= 1))
      fail_in_line(fmt::format("expected a colour from 0 to 1, found {}", value));
    const double nearest = std::floor(value * 255 + 0.5);
    rounded += std::abs(value * 255 - nearest) > 1e-3;
    column.integers.push_back(static_cast<std::int64_t>(nearest));
  }
  return rounded;
}

void VtkLegacyScanner::check_room(std::size_t items, std::size_t each) const {
  if (items > 0 && each > (8 * remaining() + 8) / items)
    fail_in_line(fmt::format("expected {} times {}, more than the {} left can hold", items,
                             counted(each, "values"), counted(remaining(), "bytes")));
}

void VtkLegacyScanner::cells(std::vector<std::int64_t>& connectivity, std::vector<std::int64_t>& ends) {
  if (!ends.empty()) fail_in_line("a second list of cells");
  const std::int64_t cells = count("the number of cells", 1);
  const std::int64_t size = count("the size of the list of cells", 1);
  if (next_word() == "offsets")
    return cells_by_offsets(static_cast<std::size_t>(cells), static_cast<std::size_t>(size), connectivity,
                            ends);
  Column list{.type = "Int32"};
  integers(list, static_cast<std::size_t>(size));
  std::size_t at = 0;
  for (std::int64_t c = 0; c < cells; ++c) {
    const std::int64_t left = size - static_cast<std::int64_t>(at) - 1;
    if (left < 0)
      fail_in_line(
          fmt::format("expected {}, found {} in {}", counted(cells, "cells"), c, counted(size, "numbers")));
    const std::int64_t n = list.integers[at];
    if (n < 0 || n > left)
      fail_in_line(fmt::format("cell {}: expected its number of points, up to {}, found {}", c, left, n));
    const auto start = list.integers.begin() + static_cast<std::ptrdiff_t>(at) + 1;
    connectivity.insert(connectivity.end(), start, start + n);
    ends.push_back(static_cast<std::int64_t>(connectivity.size()));
    at += static_cast<std::size_t>(n) + 1;
  }
  if (at != list.integers.size())
    fail_in_line(
        fmt::format("expected {} for {}, found {}", counted(at, "numbers"), counted(cells, "cells"), size));
}

void VtkLegacyScanner::cells_by_offsets(std::size_t count, std::size_t size,
                                        std::vector<std::int64_t>& connectivity,
                                        std::vector<std::int64_t>& ends) {
  word();  // OFFSETS
  Column offsets{.type = type()}, points{};
  integers(offsets, count);
  const std::string_view keyword = word();
  if (lower_case(keyword) != "connectivity") fail("CONNECTIVITY", keyword);
  points.type = type();
  integers(points, size);
  if (!offsets.integers.empty() && offsets.integers[0] != 0)
    fail_in_line(fmt::format("expected 0 as the first offset, found {}", offsets.integers[0]));
  if (!offsets.integers.empty()) ends.assign(offsets.integers.begin() + 1, offsets.integers.end());
  connectivity = std::move(points.integers);
}

}  // namespace tetproof::io
