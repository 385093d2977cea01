// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply/ply_header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"

namespace tetproof::io {
namespace {

template <class Number>
double load_as_double(const char* from, std::endian order) {
  return static_cast<double>(load<Number>(from, order));
}
template <class Number>
char* store_double(char* to, double value) {
  return store(to, static_cast<Number>(value), std::endian::little);
}

template <class Number>
constexpr PlyType integers(std::string_view name, std::string_view other_name) {
  return {name,
          other_name,
          sizeof(Number),
          false,
          std::numeric_limits<Number>::min(),
          std::numeric_limits<Number>::max(),
          load_as_double<Number>,
          store_double<Number>};
}

constexpr std::array<PlyType, 8> types{
    integers<std::int8_t>("char", "int8"),
    integers<std::uint8_t>("uchar", "uint8"),
    integers<std::int16_t>("short", "int16"),
    integers<std::uint16_t>("ushort", "uint16"),
    integers<std::int32_t>("int", "int32"),
    integers<std::uint32_t>("uint", "uint32"),
    PlyType{"float", "float32", 4, true, 0, 0, load_as_double<float>, store_double<float>},
    PlyType{"double", "float64", 8, true, 0, 0, load_as_double<double>, store_double<double>}};

bool is_float(double x) {
  return std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(x))) ==
         std::bit_cast<std::uint64_t>(x);
}

const PlyType& read_type(Scanner& scanner) {
  const std::string_view word = scanner.word();
  if (const PlyType* type = ply_type(word)) return *type;
  scanner.fail("a type (char, uchar, short, ushort, int, uint, float, double)", word);
}

void read_format(Scanner& scanner, PlyHeader& header) {
  const std::string_view format = scanner.word();
  header.text = format == "ascii";
  if (format == "binary_big_endian")
    header.order = std::endian::big;
  else if (format != "binary_little_endian" && !header.text)
    scanner.fail("ascii, binary_little_endian or binary_big_endian", format);
  const std::string_view version = scanner.word();
  if (version != "1.0") scanner.fail("version 1.0", version);
}

PlyProperty read_property(Scanner& scanner) {
  PlyProperty property;
  const auto type = [&] {
    property.type_words.append(property.type_words.empty() ? "" : " ").append(scanner.peek_word());
    return &read_type(scanner);
  };
  if (scanner.peek_word() == "list") {
    property.type_words = scanner.word();
    property.count = type();
  }
  property.type = type();
  property.name = scanner.word();
  return property;
}

PlyElement read_element(Scanner& scanner, const PlyHeader& header) {
  PlyElement element;
  element.name = scanner.word();
  for (const PlyElement& other : header.elements)
    if (other.name == element.name) scanner.fail("each element once", element.name);
  element.count = scanner.integer("the number of elements");
  if (element.count < 0)
    scanner.fail_in_line(fmt::format("expected the number of elements, found {}", element.count));
  return element;
}

}  // namespace

const PlyType* ply_type(std::string_view name) {
  for (const PlyType& type : types)
    if (name == type.name || name == type.other_name) return &type;
  return nullptr;
}

const PlyType* type_for(const std::vector<double>& numbers) {
  return ply_type(!numbers.empty() && std::all_of(numbers.begin(), numbers.end(), is_float) ? "float"
                                                                                            : "double");
}

const PlyType* type_for(const std::vector<std::int64_t>& numbers) {
  for (const std::string_view name : {"uchar", "short", "int", "uint"})
    if (const PlyType* type = ply_type(name); fits(*type, numbers)) return type;
  return nullptr;
}

bool fits(const PlyType& type, const std::vector<double>& numbers, bool binary) {
  return type.real && (!binary || type.bytes == 8 || std::all_of(numbers.begin(), numbers.end(), is_float));
}

bool fits(const PlyType& type, const std::vector<std::int64_t>& numbers) {
  return !type.real && std::all_of(numbers.begin(), numbers.end(),
                                   [&](std::int64_t n) { return n >= type.least && n <= type.most; });
}

PlyHeader read_ply_header(Scanner& scanner, std::string_view bytes) {
  PlyHeader header;
  std::string_view word = scanner.word();
  if (word != "ply") scanner.fail("'ply'", word);
  // With lone CRs, the data may start with the byte of an LF.
  const bool cr = scanner.rest_of_line().empty() && bytes.substr(scanner.offset(), 1) == "\r" &&
                  bytes.substr(scanner.offset(), 2) != "\r\n";
  bool format = false, titled = false;
  while ((word = scanner.word()) != "end_header") {
    if (word == "comment" || word == "obj_info") {
      const std::string_view line = scanner.rest_of_line();
      header.title.append(titled ? "\n" : "").append(word == "comment" ? "" : "obj_info ");
      header.title.append(line.substr(line.starts_with(' ')));
      titled = true;
      continue;
    }
    if (word == "format") {
      read_format(scanner, header);
      format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(scanner, header));
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(scanner));
    } else {
      scanner.fail("'format', 'element', 'property', 'comment' or 'end_header'", word);
    }
    if (!scanner.at_line_end()) {
      const std::string_view found = scanner.word();
      scanner.fail("the end of the line", found);
    }
  }
  if (!format) scanner.fail_in_line("expected a line 'format' in the header, found none");
  scanner.rest_of_line();
  if (cr && scanner.remaining() > 0)
    scanner.raw(1, "a line end");
  else
    scanner.next_line();
  return header;
}

}  // namespace tetproof::io
