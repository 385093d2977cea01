// SPDX-License-Identifier: GPL-3.0-or-later
// The arrays of VTK's two file formats. Types have the names that .vtu files use: Int8 to UInt64, Float32,
// Float64, and String.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/bytes/scanner.hpp"
#include "io/document.hpp"

namespace tetproof::io {

/// The bytes of a number; 0 for String and for unknown types.
std::size_t vtk_type_size(std::string_view type);
bool is_vtk_type(std::string_view type);
bool is_real_type(std::string_view type);

/// The number of values in a column.
inline std::size_t column_size(const Column& column) {
  return column.reals.size() + column.integers.size() + column.texts.size();
}

/// Appends `count` numbers of `column.type` to its reals or integers. UInt64 values of 2^63 and more become
/// negative.
void append_numbers(const char* from, std::size_t count, std::endian order, Column& column);

/// Appends `count` bits of packed ones, the highest of each byte first.
void append_bits(std::string_view bytes, std::size_t count, Column& column);

/// Reads an integer of this type from text. UInt64 values of 2^63 and more become negative.
std::int64_t read_vtk_integer(Scanner& in, std::string_view type);

/// Whether the column's type can hold all of its values, so that they can be written with this type.
bool fits_its_type(const Column& column);

/// A value of the column as a number of C++ type T.
template <class T>
T number_at(const Column& column, std::size_t i) {
  return column.reals.empty() ? static_cast<T>(column.integers[i]) : static_cast<T>(column.reals[i]);
}

/// Calls `with(T{})` for the C++ type that `type` names. It must be a type of numbers.
template <class With>
void with_number_type(std::string_view type, const With& with) {
  if (type == "Float64") return with(double{});
  if (type == "Float32") return with(float{});
  if (type == "Int64") return with(std::int64_t{});
  if (type == "UInt64") return with(std::uint64_t{});
  if (type == "Int32") return with(std::int32_t{});
  if (type == "UInt32") return with(std::uint32_t{});
  if (type == "Int16") return with(std::int16_t{});
  if (type == "UInt16") return with(std::uint16_t{});
  if (type == "Int8") return with(std::int8_t{});
  with(std::uint8_t{});
}

}  // namespace tetproof::io
