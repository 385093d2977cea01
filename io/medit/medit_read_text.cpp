// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Medit's text files: keywords in any order, each followed by its numbers.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "io/bytes/scanner.hpp"
#include "io/bytes/text_encoding.hpp"
#include "io/bytes/words.hpp"
#include "io/medit/medit_content.hpp"
#include "io/medit/medit_plan.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  Reader(const InputFile& file, MeditContent& content, MeditPart part)
      : in_(file.path(), file.bytes().substr(0, end_of_text(file.bytes())), start_of_utf8(file.bytes())),
        bytes_(file.bytes().substr(0, end_of_text(file.bytes()))),
        content_(content),
        part_(part) {
    refuse_wide_text(file);
    if (const std::string warning = warning_of_end(file); !warning.empty())
      content_.warn(warning.substr(file.path().size()));
  }

  void read() {
    bool ended = false;
    for (std::string_view last; !at_end_behind(last);) {
      const std::string_view name = in_.word('#');
      if (name == "End") {
        ended = true;
        break;
      }
      if (!looks_like_medit_keyword(name)) in_.fail("a keyword", name);
      keyword(name);
      const MeditKeyword* known = medit_keyword(name);
      const bool lines = name == "Vertices" || medit_solution_keyword(name) || (known && known->element != 0);
      last = lines ? name : std::string_view{};
    }
    if (!has_version_) in_.fail("MeshVersionFormatted", {});
    if (dimension_ == 0) in_.fail("Dimension", {});
    if (part_ == MeditPart::mesh && !content_.has_vertices()) in_.fail("Vertices", {});
    if (part_ == MeditPart::solution && !content_.has_solutions()) in_.fail("SolAtVertices", {});
    if (!ended) content_.warn(": the file does not close with End");
    drop_rest();
  }

 private:
  // Drops lines of numbers behind those that the last keyword announces, as Gmsh and MMG pass over them.
  bool at_end_behind(std::string_view last) {
    if (last.empty() || !in_.at_line_end('#')) return in_.at_end('#');
    const MeditKeyword* known = medit_keyword(last);
    const auto is_number = [](char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; };
    for (; !in_.at_end('#') && is_number(in_.peek_byte()); in_.next_line())
      content_.drop(fmt::format("lines of {} behind those that it announces", last), 1,
                    fmt::format("line {}", in_.line()), known && known->element != 0);
    return in_.remaining() == 0;
  }

  void keyword(std::string_view name) {
    if (name == "MeshVersionFormatted") {
      const std::int64_t version = in_.integer("a version from 1 to 4", '#');
      if (version < 0 || version > 4)
        in_.fail_in_line(fmt::format("expected a version from 1 to 4, found {}", version));
      has_version_ = true;
      return;
    }
    if (!has_version_) in_.fail("MeshVersionFormatted", name);
    if (name == "Dimension") {
      const std::int64_t dimension = in_.integer("the dimension 2 or 3", '#');
      if (dimension != 2 && dimension != 3)
        in_.fail_in_line(fmt::format("expected the dimension 2 or 3, found {}", dimension));
      dimension_ = static_cast<int>(dimension);
      return;
    }
    if (const MeditSolutionKeyword* values = medit_solution_keyword(name)) return solution(*values);
    if (part_ == MeditPart::solution) return section(medit_keyword(name), name);
    if (name == "Vertices") return vertices();
    const MeditKeyword* known = medit_keyword(name);
    if (known && known->element != 0) return elements(*known);
    section(known, name);
  }

  // Lines behind End that are no comments.
  void drop_rest() {
    for (; !in_.at_end('#'); in_.next_line())
      content_.drop("lines behind End", 1, fmt::format("line {}", in_.line()));
  }

  void vertices() {
    if (dimension_ == 0) in_.fail("Dimension in front of Vertices", "Vertices");
    if (content_.has_vertices()) in_.fail_in_line("a second Vertices");
    const std::int64_t count =
        in_.count("the number of vertices", 2 * static_cast<std::size_t>(dimension_) + 1, '#');
    if (count > std::numeric_limits<Index>::max())
      in_.fail_in_line(fmt::format("{} vertices are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    content_.start_vertices(static_cast<std::size_t>(count));
    bool warned = false;
    for (std::int64_t i = 0; i < count; ++i) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (int k = 0; k < dimension_; ++k) point[k] = in_.real("a coordinate", '#');
      const std::string_view word = in_.peek_word('#');
      const double reference = in_.real("a reference", '#');
      if (!(std::abs(reference) < largest_medit_real_reference)) {
        std::int64_t large = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), large);
        if (error == std::errc() && stop == word.data() + word.size()) {
          content_.add_vertex(point, large);
          continue;
        }
        in_.fail_in_line(fmt::format("expected the reference of vertex {}, found {}", i + 1, word));
      }
      if (reference != std::floor(reference) && !warned) {
        warned = true;
        content_.warn(
            fmt::format(":{}: {} is no integer, as references are (the first such)", in_.line(), reference));
      }
      content_.add_vertex(point, reference);
    }
  }

  void elements(const MeditKeyword& keyword) {
    const auto each = static_cast<std::size_t>(element_type(keyword.element)->nodes) + 1;
    const std::int64_t count = in_.count("the number of elements", 2 * each - 1, '#');
    MeditContent::Elements list{&keyword};
    list.numbers.reserve(static_cast<std::size_t>(count) * each);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count) * each; ++i)
      list.numbers.push_back(
          in_.integer((i + 1) % each == 0 ? "a reference" : "the number of a vertex", '#'));
    content_.add_elements(std::move(list));
  }

  // The number of vertices or elements, the types of the fields, and their numbers.
  void solution(const MeditSolutionKeyword& keyword) {
    if (dimension_ == 0) in_.fail("Dimension in front of the values", keyword.name);
    MeditSolution solution{&keyword, dimension_};
    solution.count = static_cast<std::size_t>(in_.count("the number of values", 2, '#'));
    const std::int64_t fields = in_.count("the number of fields", 2, '#');
    std::size_t row = 0;
    for (std::int64_t f = 0; f < fields; ++f) {
      const std::int64_t field = in_.integer("the type of a field, 1 to 4", '#');
      const int numbers = medit_numbers(field, dimension_);
      if (numbers == 0)
        in_.fail_in_line(fmt::format("expected the type of a field, 1 to 4, found {}", field));
      solution.fields.push_back(static_cast<int>(field));
      row += static_cast<std::size_t>(numbers);
    }
    if (row > 0 && solution.count > in_.remaining() / row + 1)
      in_.fail_in_line(fmt::format("expected {} of {}, found {} left for them",
                                   counted(solution.count, "values"), counted(row, "numbers"),
                                   counted(in_.remaining(), "bytes")));
    solution.numbers.reserve(solution.count * row);
    for (std::size_t i = 0; i < solution.count * row; ++i)
      solution.numbers.push_back(in_.real("a number of a field", '#'));
    content_.add_solution(std::move(solution));
  }

  // Keeps what follows the keyword as it stands, up to a line that begins with a letter.
  void section(const MeditKeyword* known, std::string_view name) {
    if (!known && name != "Vertices")
      content_.warn(fmt::format(":{}: the keyword {} is not known; what follows it is kept as it stands",
                                in_.line(), name));
    std::size_t begin = in_.offset(), end = begin;
    in_.rest_of_line();
    for (end = in_.offset(); in_.remaining() > 0; end = in_.offset()) {
      in_.next_line();
      const std::size_t line = in_.offset();
      const std::size_t next = bytes_.find_first_not_of(" \t", line);
      if (next != std::string_view::npos && is_medit_letter(bytes_[next])) break;
      in_.rest_of_line();
    }
    constexpr const char* blanks = " \t\r\n\v\f";
    std::string_view body = bytes_.substr(begin, end - begin);
    begin = body.find_first_not_of(blanks);
    body = begin == std::string_view::npos ? std::string_view{}
                                           : body.substr(begin, body.find_last_not_of(blanks) + 1 - begin);
    content_.add_section(known, known ? known->name : name, std::string(body), std::max(2, dimension_));
  }

  Scanner in_;
  std::string_view bytes_;
  MeditContent& content_;
  const MeditPart part_;
  int dimension_ = 0;
  bool has_version_ = false;
};

}  // namespace

void read_medit_text(const InputFile& file, MeditContent& content, MeditPart part) {
  Reader(file, content, part).read();
}

}  // namespace tetproof::io
