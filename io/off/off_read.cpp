// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/node_index.hpp"
#include "io/off/off.hpp"
#include "io/off/off_binary.hpp"
#include "io/surface/rows.hpp"
#include "io/surface/surface_document.hpp"
#include "io/surface/text_of_file.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {
namespace {

// Reads [ST][C][N][4][n]OFF. A count may follow without a blank, as in "OFF8 6 12". A file without a keyword
// starts with its counts.
OffKeyword read_keyword(std::string_view bytes, Scanner& scanner) {
  const std::string_view word = scanner.peek_word('#');
  std::size_t at = 0;
  const auto skip = [&](std::string_view letters) {
    if (word.substr(at, letters.size()) != letters) return false;
    at += letters.size();
    return true;
  };
  OffKeyword keyword;
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

  ReadDocument read() {
    text_ = file_.bytes();
    Scanner start(file_);
    if (!surface_) source_.document.title = leading_comments(start);
    start.at_end('#');
    keyword_ = read_keyword(text_, start);
    if (Scanner(file_.path(), text_, keyword_.end).peek_word('#') == "BINARY") return read_binary();
    text_ = text_of_file(file_, source_.document);
    Scanner scanner(file_.path(), text_, keyword_.end);
    if (!surface_ && source_.document.title.empty()) source_.document.title = leading_comments(scanner);

    const std::int64_t vertices = scanner.count("the number of vertices", 6, '#');
    const std::int64_t faces = scanner.count("the number of faces", 2, '#');
    if (!scanner.at_line_end('#')) scanner.integer("the number of edges", '#');
    read_vertices(scanner, static_cast<std::size_t>(vertices));
    read_faces(scanner, static_cast<std::size_t>(faces));
    return std::move(source_);
  }

 private:
  ReadDocument read_binary() {
    source_.text = false;
    read_binary_off(file_, keyword_, surface_, source_);
    return std::move(source_);
  }

  // The numbers in the rest of the line.
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
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Vector3d& point = points.emplace_back();
      scanner.at_end('#');
      const std::size_t place = scanner.offset();
      for (int k = 0; k < 3; ++k) point[k] = scanner.real_in_line("a coordinate", '#');
      read_numbers(scanner);
      if (numbers_.empty()) continue;
      const std::size_t color = numbers_.size() - std::min(numbers_.size(), normal + texture);
      if (numbers_.size() < normal + texture || (color != 0 && color != 3 && color != 4)) {
        drop("numbers behind vertices to which OFF gives no meaning", place);
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
  }

  void read_faces(Scanner& scanner, std::size_t count) {
    Document& document = source_.document;
    // No triangle is shorter than "3 0 1 2".
    const std::size_t likely = std::min<std::size_t>(count, scanner.remaining() / 7);
    reserve_in_large_pages(document.connectivity, 3 * likely);
    if (surface_) reserve_in_large_pages(source_.places, likely);
    const Scanner first_face = scanner;
    const std::size_t dropped = document.dropped.size(), values = document.element_values.size(),
                      warnings = document.warnings.size();
    const auto again = [&] {
      scanner = first_face;
      document.blocks.clear(), document.connectivity.clear(), document.unknown.clear();
      document.dropped.resize(dropped), document.element_values.resize(values);
      document.warnings.resize(warnings), source_.places.clear();
    };
    std::exception_ptr error;
    try {
      read_faces_in_lines(scanner, count);
      if (scanner.at_end('#')) return;
    } catch (const InputError&) {
      error = std::current_exception();
    }
    again();
    if (read_faces_over_lines(scanner, count)) return;
    if (error) std::rethrow_exception(error);
    again();
    read_faces_in_lines(scanner, count);
    drop_lines(scanner);
  }

  // meshio passes over lines behind the last face that is announced. They may be faces.
  void drop_lines(Scanner& scanner) {
    scanner.at_end('#');
    const std::size_t place = scanner.offset();
    std::size_t lines = 0;
    for (; !scanner.at_end('#'); scanner.next_line()) ++lines;
    add_loss(source_.document.dropped, "lines behind the faces that are announced", lines,
             example_line(file_.path(), text_, place), true);
  }

  // A face in each line; numbers behind its corners are a colour.
  void read_faces_in_lines(Scanner& scanner, std::size_t count) {
    Document& document = source_.document;
    NodeIndex nodes(document);
    Rows colors;
    std::vector<Index> corners;
    for (std::size_t i = 0; i < count; ++i) {
      scanner.at_end('#');
      const std::size_t place = scanner.offset();
      if (surface_) source_.places.push_back(place);
      corners.resize(static_cast<std::size_t>(scanner.count("the number of a face's corners", 2, '#')));
      if (corners.empty()) scanner.fail_in_line("face has 0 corners, expected at least 3");
      for (Index& corner : corners) corner = nodes(scanner.integer_in_line("a vertex", '#'));
      read_numbers(scanner);
      add_element(document, corners);
      if (numbers_.size() == 2 || numbers_.size() > 4)
        drop("numbers behind faces to which OFF gives no meaning", place);
      else
        colors.add(i, numbers_, whole(0, numbers_.size()));
    }
    give_colors(std::move(colors), document.element_values, count, "faces");
  }

  // Faces that go on in the next line, which Geomview reads too. A face that lacks a corner looks the same,
  // so this is believed only if every number up to the file's end is one of a face, and none is a colour.
  bool read_faces_over_lines(Scanner& scanner, std::size_t count) {
    NodeIndex nodes(source_.document);
    std::vector<Index> corners;
    std::int64_t number = 0, first_line = 0;
    const auto next = [&] { return !scanner.at_end('#') && parse_integer(scanner.word('#'), number); };
    for (std::size_t i = 0; i < count; ++i) {
      scanner.at_end('#');
      const std::size_t place = scanner.offset();
      if (!next() || number < 1 || static_cast<std::size_t>(number) > scanner.remaining()) return false;
      if (surface_) source_.places.push_back(place);
      corners.resize(static_cast<std::size_t>(number));
      for (Index& corner : corners) {
        if (first_line == 0 && scanner.at_line_end('#')) first_line = scanner.line();
        if (!next() || number < 0 || static_cast<std::size_t>(number) >= source_.document.points.size())
          return false;
        corner = nodes(number);
      }
      add_element(source_.document, corners);
    }
    if (!scanner.at_end('#')) return false;
    source_.document.warnings.push_back(
        fmt::format("{}:{}: a face goes on in the next line (the first such)", file_.path(), first_line));
    return true;
  }

  void give_colors(Rows colors, std::vector<Values>& values, std::size_t items, const char* of) {
    const std::size_t before = values.size();
    std::move(colors).give(values, "color", items);
    for (std::size_t i = before; i < values.size(); ++i) warn_of_colours(source_.document, values[i], of);
  }

  // The example costs a count of the lines above, which only the first one of an item is worth.
  void drop(const std::string& item, std::size_t place) {
    std::vector<Loss>& dropped = source_.document.dropped;
    const bool is_new =
        std::none_of(dropped.begin(), dropped.end(), [&](const Loss& loss) { return loss.item == item; });
    add_loss(dropped, item, 1, is_new ? example_line(file_.path(), text_, place) : "");
  }

  const InputFile& file_;
  const bool surface_;
  std::string_view text_;
  OffKeyword keyword_;
  ReadDocument source_;
  std::vector<double> numbers_;  // behind the point or face that was read last
  std::vector<bool> whole_;      // whether each is written as an integer
};

}  // namespace

ReadDocument read_off(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
