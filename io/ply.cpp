// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "io/byte_order.hpp"
#include "io/error.hpp"
#include "io/polygons.hpp"
#include "io/surface_lines.hpp"

namespace tetproof::io {
namespace {

struct Type {
  std::string_view name, other_name;
  std::size_t bytes;
  double (*load)(const char*, std::endian);
};

template <class Number>
double load_as_double(const char* from, std::endian order) {
  return static_cast<double>(load<Number>(from, order));
}

constexpr std::array<Type, 8> types{{{"char", "int8", 1, load_as_double<std::int8_t>},
                                     {"uchar", "uint8", 1, load_as_double<std::uint8_t>},
                                     {"short", "int16", 2, load_as_double<std::int16_t>},
                                     {"ushort", "uint16", 2, load_as_double<std::uint16_t>},
                                     {"int", "int32", 4, load_as_double<std::int32_t>},
                                     {"uint", "uint32", 4, load_as_double<std::uint32_t>},
                                     {"float", "float32", 4, load_as_double<float>},
                                     {"double", "float64", 8, load_as_double<double>}}};

struct Property {
  std::string_view name;
  const Type* type = nullptr;
  const Type* count = nullptr;  // of a list's entries; none for a single number
};

struct Element {
  std::string_view name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool text = true;
  std::endian order = std::endian::little;
  std::vector<Element> elements;
};

const Type* read_type(Scanner& scanner) {
  const std::string_view word = scanner.word();
  for (const Type& type : types)
    if (word == type.name || word == type.other_name) return &type;
  scanner.fail("a type (char, uchar, short, ushort, int, uint, float, double)", word);
}

void read_format(Scanner& scanner, Header& header) {
  const std::string_view format = scanner.word();
  header.text = format == "ascii";
  if (format == "binary_big_endian")
    header.order = std::endian::big;
  else if (format != "binary_little_endian" && !header.text)
    scanner.fail("ascii, binary_little_endian or binary_big_endian", format);
  const std::string_view version = scanner.word();
  if (version != "1.0") scanner.fail("version 1.0", version);
}

Property read_property(Scanner& scanner) {
  Property property;
  if (scanner.peek_word() == "list") {
    scanner.word();
    property.count = read_type(scanner);
  }
  property.type = read_type(scanner);
  property.name = scanner.word();
  return property;
}

// Leaves the scanner at the first byte of the data.
Header read_header(Scanner& scanner, std::string_view bytes) {
  Header header;
  std::string_view word = scanner.word();
  if (word != "ply") scanner.fail("'ply'", word);
  // With lone CRs, the data may start with the byte of an LF.
  const bool cr = scanner.rest_of_line().empty() && bytes.substr(scanner.offset(), 1) == "\r" &&
                  bytes.substr(scanner.offset(), 2) != "\r\n";
  bool format = false;
  while ((word = scanner.word()) != "end_header") {
    if (word == "comment" || word == "obj_info") {
      scanner.rest_of_line();
      continue;
    }
    if (word == "format") {
      read_format(scanner, header);
      format = true;
    } else if (word == "element") {
      Element element;
      element.name = scanner.word();
      for (const Element& other : header.elements)
        if (other.name == element.name) scanner.fail("each element once", element.name);
      element.count = scanner.integer("the number of elements");
      if (element.count < 0)
        scanner.fail_in_line(fmt::format("expected the number of elements, found {}", element.count));
      header.elements.push_back(element);
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

// Reads the elements' numbers one after another, text or binary.
class Data {
 public:
  Data(Scanner& scanner, const Header& header) : scanner_(scanner), header_(header) {}

  double number(const Type& type) {
    if (header_.text) return scanner_.real_in_line("a number");
    return type.load(scanner_.raw(type.bytes, "a number").data(), header_.order);
  }
  /// The number of a list's entries, no more than the rest of the file can hold.
  std::int64_t entries(const Property& list) {
    const double value = number(*list.count);
    if (!(value >= 0) || value != std::floor(value))
      fail(fmt::format("expected the number of entries of a list, found {}", value));
    const std::size_t most =
        header_.text ? scanner_.remaining() / 2 + 1 : scanner_.remaining() / list.type->bytes;
    if (value > static_cast<double>(most))
      fail(fmt::format("list '{}' announces {} entries, more than the {} bytes left can hold", list.name,
                       value, scanner_.remaining()));
    return static_cast<std::int64_t>(value);
  }
  /// Checks an element's count against what is left of the file before anybody believes it.
  void begin(const Element& element, std::size_t least_bytes) {
    if (least_bytes == 0) return;
    const std::size_t most = (scanner_.remaining() + header_.text) / least_bytes;
    if (static_cast<std::size_t>(element.count) > most)
      fail(fmt::format("element '{}' announces {} of at least {} bytes, more than the {} bytes left can hold",
                       element.name, element.count, least_bytes, scanner_.remaining()));
  }
  std::size_t remaining() const { return scanner_.remaining(); }
  void end_instance() {
    if (!header_.text || scanner_.at_line_end()) return;
    const std::string_view found = scanner_.word();
    scanner_.fail("the end of the line", found);
  }
  /// Nothing but blanks may follow the last element: a count too small would lose the rest silently.
  void end(const Element& last) {
    if (scanner_.at_end()) return;
    const std::string expected =
        fmt::format("the end of the file after {} of element '{}'", last.count, last.name);
    if (!header_.text) fail(fmt::format("expected {}, found {} more bytes", expected, scanner_.remaining()));
    const std::string_view found = scanner_.word();
    scanner_.fail(expected, found);
  }
  /// Where the next instance starts.
  std::size_t start_instance() {
    if (header_.text) scanner_.at_end();
    return scanner_.offset();
  }
  [[noreturn]] void fail(const std::string& message) const {
    if (header_.text) scanner_.fail_in_line(message);
    scanner_.fail_at_byte(message);
  }

 private:
  Scanner& scanner_;
  const Header& header_;
};

std::size_t least_bytes(const Element& element, bool text) {
  std::size_t bytes = 0;
  for (const Property& property : element.properties)
    bytes += text ? 2 : (property.count ? property.count : property.type)->bytes;
  return bytes;
}

void skip(Data& data, const Property& property) {
  const std::int64_t numbers = property.count ? data.entries(property) : 1;
  for (std::int64_t i = 0; i < numbers; ++i) data.number(*property.type);
}

void skip(Data& data, const Element& element, bool text) {
  if (element.properties.empty()) return;
  data.begin(element, least_bytes(element, text));
  for (std::int64_t i = 0; i < element.count; ++i) {
    data.start_instance();
    for (const Property& property : element.properties) skip(data, property);
    data.end_instance();
  }
}

std::vector<Eigen::Vector3d> read_vertices(Data& data, const Element& element, bool text) {
  data.begin(element, least_bytes(element, text));
  std::vector<int> axis;  // of each property, -1 for none
  for (const Property& property : element.properties)
    axis.push_back(property.count         ? -1
                   : property.name == "x" ? 0
                   : property.name == "y" ? 1
                   : property.name == "z" ? 2
                                          : -1);
  std::vector<Eigen::Vector3d> points;
  points.reserve(element.count);
  for (std::int64_t i = 0; i < element.count; ++i) {
    data.start_instance();
    Eigen::Vector3d& point = points.emplace_back();
    for (std::size_t k = 0; k < axis.size(); ++k)
      if (axis[k] < 0)
        skip(data, element.properties[k]);
      else
        point[axis[k]] = data.number(*element.properties[k].type);
    data.end_instance();
  }
  return points;
}

bool names_corners(const Property& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

void read_faces(Data& data, const Element& element, bool text, SurfaceFaces& surface) {
  data.begin(element, least_bytes(element, text));
  surface.reserve(std::min<std::size_t>(
      element.count, data.remaining() / (text ? 8 : 4)));  // no face with three corners is shorter
  std::vector<std::int64_t> corners;
  for (std::int64_t i = 0; i < element.count; ++i) {
    const std::size_t place = data.start_instance();
    bool found = false;
    for (const Property& property : element.properties) {
      if (found || !names_corners(property)) {
        skip(data, property);
        continue;
      }
      found = true;
      corners.resize(data.entries(property));
      for (std::int64_t& corner : corners) {
        const double value = data.number(*property.type);
        if (!(std::abs(value) < 9e15) || value != std::floor(value))
          data.fail(fmt::format("expected a vertex, found {}", value));
        corner = static_cast<std::int64_t>(value);
      }
    }
    data.end_instance();
    surface.add(corners, place);
  }
}

void write_header(AtomicFile& file, std::string_view format, const TriangleSurface& surface) {
  file.write(fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, surface.vertices.size(), surface.triangles.size()));
}

}  // namespace

TriangleSurface read_ply(const InputFile& file) {
  Scanner scanner(file);
  const Header header = read_header(scanner, file.bytes());
  const Element *vertices = nullptr, *faces = nullptr;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") vertices = &element;
    if (element.name == "face" &&
        std::any_of(element.properties.begin(), element.properties.end(), names_corners))
      faces = &element;
  }
  const auto lacks = [&](std::string_view what) -> void {
    throw InputError(fmt::format("{}: expected {} in the header, found none", file.path(), what));
  };
  if (!vertices) lacks("an element 'vertex'");
  for (const std::string_view axis : {"x", "y", "z"})
    if (std::none_of(vertices->properties.begin(), vertices->properties.end(),
                     [&](const Property& property) { return !property.count && property.name == axis; }))
      lacks(fmt::format("a property '{}' of element 'vertex'", axis));
  if (!faces) lacks("an element 'face' with a list 'vertex_indices' or 'vertex_index'");

  Data data(scanner, header);
  std::optional<SurfaceFaces> surface;
  std::optional<Scanner> faces_before;  // faces above the points are passed over first and read at last
  for (const Element& element : header.elements) {
    if (&element == vertices) {
      surface.emplace(file, read_vertices(data, element, header.text), 0, header.text);
    } else if (&element == faces && surface) {
      read_faces(data, element, header.text, *surface);
    } else {
      if (&element == faces) faces_before = scanner;
      skip(data, element, header.text);
    }
  }
  data.end(header.elements.back());
  if (faces_before) {
    scanner = *faces_before;
    read_faces(data, *faces, header.text, *surface);
  }
  return surface->take();
}

void write_ply_text(AtomicFile& file, const TriangleSurface& surface) {
  write_header(file, "ascii", surface);
  write_points(file, "", surface.vertices);
  write_triangles(file, "3 ", surface.triangles, 0);
}

void write_ply_binary(AtomicFile& file, const TriangleSurface& surface) {
  write_header(file, "binary_little_endian", surface);
  write_items(file, surface.vertices.size(), 24, [&](std::size_t i, char* to) {
    for (int k = 0; k < 3; ++k) to = store(to, surface.vertices[i][k], std::endian::little);
    return to;
  });
  write_items(file, surface.triangles.size(), 13, [&](std::size_t i, char* to) {
    *to++ = 3;
    for (const Index corner : surface.triangles[i]) to = store(to, std::int32_t{corner}, std::endian::little);
    return to;
  });
}

}  // namespace tetproof::io
