// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file: elements, their properties, and the types of these.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/scanner.hpp"
#include "io/document.hpp"

namespace tetproof::io {

struct PlyType {
  std::string_view name, other_name;
  std::size_t bytes;
  bool real;
  std::int64_t least, most;  // of integers
  double (*load)(const char*, std::endian);
  char* (*store)(char*, double);  // little endian
};

/// The type with this name, old ("uchar") or new ("uint8"); null if there is none.
const PlyType* ply_type(std::string_view name);
/// The smallest type that holds all numbers exactly; null if there is none.
const PlyType* type_for(const std::vector<double>& numbers);
const PlyType* type_for(const std::vector<std::int64_t>& numbers);
/// Whether a type holds all numbers exactly. In text (not `binary`), a float is not rounded.
bool fits(const PlyType& type, const std::vector<double>& numbers, bool binary);
bool fits(const PlyType& type, const std::vector<std::int64_t>& numbers);

struct PlyProperty {
  std::string name;
  const PlyType* type = nullptr;
  const PlyType* count = nullptr;  // the type of a list's number of entries; null for a single number
  std::string type_words;          // as in the file: "float", "list uchar int"
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool text = true;
  std::endian order = std::endian::little;
  std::vector<PlyElement> elements;
  std::string title;
};

/// Reads the header, and leaves the scanner at the first byte of the data.
PlyHeader read_ply_header(Scanner& scanner, std::string_view bytes);

}  // namespace tetproof::io
