// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/model/node_index.hpp"
#include "io/off/off.hpp"

namespace tetproof::io {
namespace {

struct Keyword {
  bool texture = false, color = false, normal = false;
  std::size_t end = 0;  // behind it
};

// [ST][C][N][4][n]OFF; what may follow without a blank, as in "OFF8 6 12", is left to be read. A file without
// keyword starts with its counts.
Keyword read_keyword(std::string_view bytes, Scanner& scanner) {
  const std::string_view word = scanner.peek_word('#');
  std::size_t at = 0;
  const auto skip = [&](std::string_view letters) {
    if (word.substr(at, letters.size()) != letters) return false;
    at += letters.size();
    return true;
  };
  Keyword keyword;
  keyword.texture = skip("ST"), keyword.color = skip("C"), keyword.normal = skip("N");
  const bool four = skip("4"), many = skip("n");
  std::int64_t number;
  if (!skip("OFF")) {
    if (parse_integer(word, number)) return {.end = scanner.offset()};
    scanner.word('#');
    scanner.fail("OFF or the number of vertices", word);
  }
  if (four || many)
    scanner.fail_in_line(fmt::format("expected three coordinates a vertex, found {}", word.substr(0, at)));
  keyword.end = static_cast<std::size_t>(word.data() - bytes.data()) + at;
  return keyword;
}

class Reader {
 public:
  Reader(const InputFile& file, Wanted wanted) : file_(file), surface_(wanted == Wanted::surface) {
    source_.document.path = file.path(), source_.document.format = "off";
    source_.document.first_node = 0;
  }

  SurfaceDocument read() {
    Scanner start(file_);
    if (!surface_) source_.document.title = leading_comments(start);
    start.at_end('#');
    keyword_ = read_keyword(file_.bytes(), start);
    Scanner scanner(file_.path(), file_.bytes(), keyword_.end);
    if (!surface_ && source_.document.title.empty()) source_.document.title = leading_comments(scanner);
    if (scanner.peek_word('#') == "BINARY") scanner.fail_in_line("expected OFF as text, found binary OFF");

    const std::int64_t vertices = scanner.count("the number of vertices", 6, '#');
    const std::int64_t faces = scanner.count("the number of faces", 2, '#');
    if (!scanner.at_line_end('#')) scanner.integer("the number of edges", '#');
    read_vertices(scanner, static_cast<std::size_t>(vertices));
    read_faces(scanner, static_cast<std::size_t>(faces));
    if (!scanner.at_end('#')) {
      const std::string_view found = scanner.word('#');
      scanner.fail(fmt::format("the end of the file after {} faces", faces), found);
    }
    return std::move(source_);
  }

 private:
  // What follows in the line.
  void read_numbers(Scanner& scanner) {
    numbers_.clear(), whole_.clear();
    while (!scanner.at_line_end('#')) {
      if (surface_) {
        scanner.real("a number or the end of the line", '#');
        continue;
      }
      const std::string_view word = scanner.word('#');
      std::int64_t integer;
      if (!parse_real(word, numbers_.emplace_back())) scanner.fail("a number or the end of the line", word);
      whole_.push_back(parse_integer(word, integer) && std::abs(numbers_.back()) <= 9007199254740992.0);
    }
  }

  bool whole(std::size_t first, std::size_t count) const {
    return std::all_of(whole_.begin() + static_cast<std::ptrdiff_t>(first),
                       whole_.begin() + static_cast<std::ptrdiff_t>(first + count), [](bool w) { return w; });
  }

  void read_vertices(Scanner& scanner, std::size_t count) {
    auto& points = source_.document.points;
    check_countable(file_.path(), count);
    reserve_in_large_pages(points, count);
    Rows normals, colors, textures;
    const std::size_t normal = keyword_.normal ? 3 : 0, texture = keyword_.texture ? 2 : 0;
    std::size_t dropped = 0;
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Vector3d& point = points.emplace_back();
      scanner.at_end('#');
      for (int k = 0; k < 3; ++k) point[k] = scanner.real_in_line("a coordinate", '#');
      read_numbers(scanner);
      if (numbers_.empty()) continue;
      const std::size_t color = numbers_.size() - std::min(numbers_.size(), normal + texture);
      if (numbers_.size() < normal + texture || (color != 0 && color != 3 && color != 4)) {
        ++dropped;
        continue;
      }
      const std::span<const double> all(numbers_);
      normals.add(i, all.first(normal), false);
      colors.add(i, all.subspan(normal, color), whole(normal, color));
      textures.add(i, all.last(texture), false);
    }
    auto& values = source_.document.node_values;
    std::move(normals).give(values, "normal", count);
    give_colors(std::move(colors), values, count, "vertices");
    std::move(textures).give(values, "texture", count);
    warn_of_dropped(dropped, "vertices");
  }

  void read_faces(Scanner& scanner, std::size_t count) {
    Document& document = source_.document;
    NodeIndex nodes(document);
    // No triangle is shorter than "3 0 1 2".
    const std::size_t likely = std::min<std::size_t>(count, scanner.remaining() / 7);
    reserve_in_large_pages(document.connectivity, 3 * likely);
    if (surface_) reserve_in_large_pages(source_.places, likely);
    Rows colors;
    std::size_t dropped = 0;
    std::vector<Index> corners;
    for (std::size_t i = 0; i < count; ++i) {
      scanner.at_end('#');
      if (surface_) source_.places.push_back(scanner.offset());
      corners.resize(static_cast<std::size_t>(scanner.count("the number of a face's corners", 2, '#')));
      if (corners.empty()) scanner.fail_in_line("face has 0 corners, expected at least 3");
      for (Index& corner : corners) corner = nodes(scanner.integer_in_line("a vertex", '#'));
      read_numbers(scanner);
      add_element(document, corners);
      if (numbers_.size() == 2 || numbers_.size() > 4)
        ++dropped;
      else
        colors.add(i, numbers_, whole(0, numbers_.size()));
    }
    give_colors(std::move(colors), document.element_values, count, "faces");
    warn_of_dropped(dropped, "faces");
  }

  void give_colors(Rows colors, std::vector<Values>& values, std::size_t items, const char* of) {
    const std::size_t before = values.size();
    std::move(colors).give(values, "color", items);
    for (std::size_t i = before; i < values.size(); ++i) warn_of_colours(source_.document, values[i], of);
  }

  void warn_of_dropped(std::size_t dropped, const char* of) {
    if (dropped > 0)
      source_.document.warnings.push_back(fmt::format(
          "{}: {} {} are followed by as many numbers as OFF gives no meaning to; they are not read",
          file_.path(), dropped, of));
  }

  const InputFile& file_;
  const bool surface_;
  Keyword keyword_;
  SurfaceDocument source_;
  std::vector<double> numbers_;  // behind the point or face just read
  std::vector<bool> whole_;      // written as integers
};

}  // namespace

SurfaceDocument read_off(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
