// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/off/off_binary.hpp"

#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/node_index.hpp"
#include "io/surface/rows.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  Reader(const InputFile& file, const OffKeyword& keyword, bool surface, ReadDocument& read)
      : file_(file),
        keyword_(keyword),
        surface_(surface),
        read_(read),
        scanner_(file.path(), file.bytes(), keyword.end) {}

  void read() {
    scanner_.word();  // BINARY
    scanner_.next_line();
    find_order();
    const std::size_t vertices = count("the number of vertices", 12);
    const std::size_t faces = count("the number of faces", 8);
    load<std::int32_t>(scanner_.raw(4, "the number of edges").data(), order_);
    read_vertices(vertices);
    read_faces(faces);
    if (scanner_.remaining() > 0)
      add_loss(read_.document.dropped, "bytes behind the last face", scanner_.remaining(),
               fmt::format("byte {}", scanner_.offset()));
  }

 private:
  // OFF is big-endian. Some programs write the order of their machine: the counts show it, unless they are
  // possible in both orders.
  void find_order() {
    const Scanner start = scanner_;
    const auto possible = [&] {
      scanner_ = start;
      const std::int64_t vertices = integer("the number of vertices"), faces = integer("the number of faces");
      const auto left = static_cast<std::int64_t>(scanner_.remaining());
      return vertices >= 0 && faces >= 0 && 12 * vertices + 8 * faces <= left;
    };
    if (!possible()) {
      order_ = std::endian::little;
      if (possible())
        read_.document.warnings.push_back(
            fmt::format("{}: byte {}: the numbers are little-endian; OFF has big-endian ones", file_.path(),
                        start.offset()));
      else
        order_ = std::endian::big;
    }
    scanner_ = start;
  }

  std::int32_t integer(const char* expected) {
    return load<std::int32_t>(scanner_.raw(4, expected).data(), order_);
  }

  // A count that the rest of the file can hold.
  std::size_t count(const char* expected, std::size_t bytes_each) {
    const std::size_t place = scanner_.offset();
    const std::int32_t number = integer(expected);
    if (number < 0 || static_cast<std::size_t>(number) > scanner_.remaining() / bytes_each)
      at(place).fail_at_byte(fmt::format("expected {}, found {}, which the {} left cannot hold", expected,
                                         number, counted(scanner_.remaining(), "bytes")));
    return static_cast<std::size_t>(number);
  }

  std::vector<double> floats(std::size_t how_many, const char* expected) {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < how_many; ++k)
      numbers.push_back(load<float>(scanner_.raw(4, expected).data(), order_));
    return numbers;
  }

  void read_vertices(std::size_t vertices) {
    Rows normals, colors, textures;
    auto& points = read_.document.points;
    points.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      const std::vector<double> point = floats(3, "a coordinate");
      points.emplace_back(point[0], point[1], point[2]);
      if (keyword_.normal) normals.add(i, floats(3, "a normal"), false);
      if (keyword_.color) colors.add(i, floats(4, "a colour"), false);
      if (keyword_.texture) textures.add(i, floats(2, "a texture coordinate"), false);
    }
    if (surface_) return;
    auto& values = read_.document.node_values;
    std::move(normals).give(values, "normal", vertices);
    std::move(colors).give(values, "color", vertices);
    std::move(textures).give(values, "texture", vertices);
  }

  void read_faces(std::size_t faces) {
    Document& document = read_.document;
    NodeIndex nodes(document);
    Rows colors;
    for (std::size_t i = 0; i < faces; ++i) {
      if (surface_) read_.places.push_back(scanner_.offset());
      const std::size_t place = scanner_.offset();
      std::vector<Index> corners(count("the number of a face's corners", 4));
      if (corners.empty()) at(place).fail_at_byte("face has 0 corners, expected at least 3");
      for (Index& corner : corners) corner = nodes(integer("a vertex"));
      add_element(document, corners);
      const std::size_t components = count("the number of a colour's components", 4);
      colors.add(i, floats(components, "a component of a colour"), false);
    }
    if (!surface_) std::move(colors).give(document.element_values, "color", faces);
  }

  Scanner at(std::size_t place) const { return {file_.path(), file_.bytes(), place}; }

  const InputFile& file_;
  const OffKeyword& keyword_;
  const bool surface_;
  ReadDocument& read_;
  Scanner scanner_;
  std::endian order_ = std::endian::big;
};

}  // namespace

void read_binary_off(const InputFile& file, const OffKeyword& keyword, bool surface, ReadDocument& read) {
  Reader(file, keyword, surface, read).read();
}

}  // namespace tetproof::io
