// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of VTK's types of numbers, and which values fit them.
#include "io/vtk/vtk_types.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "io/bytes/byte_order.hpp"

namespace tetproof::io {

std::size_t vtk_type_size(std::string_view type) {
  if (type == "Float64" || type == "Int64" || type == "UInt64") return 8;
  if (type == "Float32" || type == "Int32" || type == "UInt32") return 4;
  if (type == "Int16" || type == "UInt16") return 2;
  return type == "Int8" || type == "UInt8" ? 1 : 0;
}

bool is_vtk_type(std::string_view type) {
  return vtk_type_size(type) > 0 || type == "String";
}

bool is_real_type(std::string_view type) {
  return type == "Float64" || type == "Float32";
}

void append_numbers(const char* from, std::size_t count, std::endian order, Column& column) {
  with_number_type(column.type, [&](auto like) {
    using T = decltype(like);
    const auto append = [&](auto& to) {
      const std::size_t start = to.size();
      to.resize(start + count);
      using Number = std::remove_reference_t<decltype(to[0])>;
      for (std::size_t i = 0; i < count; ++i) {
        const T number = load<T>(from + i * sizeof(T), order);
        to[start + i] = static_cast<Number>(number);  // NOLINT(bugprone-signed-char-misuse): it is a number
      }
    };
    if constexpr (std::is_floating_point_v<T>)
      append(column.reals);
    else
      append(column.integers);
  });
}

void append_bits(std::string_view bytes, std::size_t count, Column& column) {
  for (std::size_t i = 0; i < count; ++i)
    column.integers.push_back(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1);
}

std::int64_t read_vtk_integer(Scanner& in, std::string_view type) {
  constexpr const char* expected = "an integer";
  if (type != "UInt64") return in.integer(expected);
  const std::string_view word = in.word();
  std::int64_t value = 0;
  if (parse_integer(word, value)) return value;
  std::uint64_t large = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), large);
  if (error != std::errc() || end != word.data() + word.size()) in.fail(expected, word);
  return static_cast<std::int64_t>(large);
}

bool fits_its_type(const Column& column) {
  if (column.type == "String") return column.reals.empty() && column.integers.empty();
  if (vtk_type_size(column.type) == 0 || !column.texts.empty()) return false;
  if (is_real_type(column.type)) {
    if (!column.integers.empty()) return false;
    return column.type == "Float64" ||
           std::all_of(column.reals.begin(), column.reals.end(), [](double value) {
             return std::isnan(value) || static_cast<double>(static_cast<float>(value)) == value;
           });
  }
  if (!column.reals.empty()) return false;
  bool fits = true;
  with_number_type(column.type, [&](auto like) {
    using T = decltype(like);
    if constexpr (sizeof(T) < 8)
      fits = std::all_of(column.integers.begin(), column.integers.end(), [](std::int64_t value) {
        return static_cast<std::int64_t>(static_cast<T>(value)) == value;
      });
  });
  return fits;
}

}  // namespace tetproof::io
