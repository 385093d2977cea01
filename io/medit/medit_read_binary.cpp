// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Medit's binary files: a chain of numbered keywords, each with the place of the next one.
#include <fmt/format.h>

#include <bit>
#include <limits>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/words.hpp"
#include "io/medit/medit_content.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  Reader(const InputFile& file, std::endian order, MeditContent& content, MeditPart part)
      : in_(file.path(), file.bytes(), 4),
        size_(file.bytes().size()),
        order_(order),
        content_(content),
        part_(part) {}

  void read() {
    version_ = static_cast<int>(number<std::int32_t>("the version"));
    if (version_ < 1 || version_ > 4)
      in_.fail_at_byte(fmt::format("expected a version from 1 to 4, found {}", version_));
    bool ended = false;
    while (!ended && in_.remaining() > 0) ended = keyword();
    if (dimension_ == 0) in_.fail_at_byte("expected Dimension, found the end of the file");
    if (part_ == MeditPart::mesh && !content_.has_vertices())
      in_.fail_at_byte("expected Vertices, found the end of the file");
    if (part_ == MeditPart::solution && !content_.has_solutions())
      in_.fail_at_byte("expected SolAtVertices, found the end of the file");
    if (!ended) content_.warn(": the file does not close with End");
    content_.drop("bytes behind End", in_.remaining(), fmt::format("byte {}", in_.offset()));
  }

 private:
  bool keyword() {
    const std::int64_t code = number<std::int32_t>("a keyword");
    const std::int64_t next = version_ < 3 ? number<std::int32_t>("the place of the next keyword")
                                           : number<std::int64_t>("the place of the next keyword");
    if (code == medit_end) return true;
    if (next != 0 &&
        (next < static_cast<std::int64_t>(in_.offset()) || next > static_cast<std::int64_t>(size_)))
      in_.fail_at_byte(fmt::format("expected the place of the next keyword, from {} to {}, found {}",
                                   in_.offset(), size_, next));
    const std::size_t start = in_.offset(), end = next == 0 ? size_ : static_cast<std::size_t>(next);
    std::string name = "Dimension";
    if (code == medit_dimension) {
      dimension_ = static_cast<int>(number<std::int32_t>("the dimension 2 or 3"));
      if (dimension_ != 2 && dimension_ != 3)
        in_.fail_at_byte(fmt::format("expected the dimension 2 or 3, found {}", dimension_));
    } else if (const MeditSolutionKeyword* values = medit_solution_keyword(code_of(code))) {
      name = std::string(values->name);
      solution(*values, end);
    } else if (code == medit_vertices) {
      name = "Vertices";
      if (part_ == MeditPart::mesh) {
        vertices(end);
      } else {
        content_.add_section(nullptr, name, {}, 3);
        in_.raw(end - start, "a keyword's data");
      }
    } else {
      const MeditKeyword* known = code_of(code) > 0 ? medit_keyword(code_of(code)) : nullptr;
      name = known ? std::string(known->name) : fmt::format("of code {}", code);
      if (!known && next == 0) in_.fail_at_byte(fmt::format("expected a keyword, found {}", code));
      if (known && known->element != 0 && part_ == MeditPart::mesh) {
        elements(*known, end);
      } else if (!known || known->element != 0 || !section(*known, end)) {
        // A keyword of unknown code may be a kind of elements: a judge must not call the mesh whole.
        content_.drop("keyword " + name, 1, fmt::format("byte {}: {}", start, counted(end - start, "bytes")),
                      !known);
        in_.raw(end - start, "a keyword's data");
      }
    }
    if (next != 0) {
      const std::size_t behind = in_.offset();
      in_.raw(end - behind, "a keyword's data");
      content_.drop("bytes behind the numbers of " + name, end - behind, fmt::format("byte {}", behind));
    }
    return next == 0 && in_.remaining() == 0;
  }

  void vertices(std::size_t end) {
    if (dimension_ == 0) in_.fail_at_byte("expected Dimension in front of Vertices");
    if (content_.has_vertices()) in_.fail_at_byte("a second Vertices");
    const std::size_t row = static_cast<std::size_t>(dimension_) * real_size() + integer_size();
    const std::size_t count = this->count("the number of vertices", row, end);
    if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      in_.fail_at_byte(fmt::format("{} vertices are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    content_.start_vertices(count);
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (int k = 0; k < dimension_; ++k) point[k] = real();
      content_.add_vertex(point, integer());
    }
  }

  void elements(const MeditKeyword& keyword, std::size_t end) {
    const auto each = static_cast<std::size_t>(element_type(keyword.element)->nodes) + 1;
    const std::size_t count = this->count("the number of elements", each * integer_size(), end);
    MeditContent::Elements list{&keyword};
    list.numbers.reserve(count * each);
    for (std::size_t i = 0; i < count * each; ++i) list.numbers.push_back(integer());
    content_.add_elements(std::move(list));
  }

  void solution(const MeditSolutionKeyword& keyword, std::size_t end) {
    if (dimension_ == 0) in_.fail_at_byte("expected Dimension in front of the values");
    MeditSolution solution{&keyword, dimension_};
    const std::int64_t items = integer();
    const std::int64_t fields = number<std::int32_t>("the number of fields");
    const std::size_t left = end > in_.offset() ? end - in_.offset() : 0;
    if (fields < 0 || static_cast<std::size_t>(fields) > left / 4)
      in_.fail_at_byte(fmt::format("expected the number of fields, found {}", fields));
    std::size_t row = 0;
    for (std::int64_t f = 0; f < fields; ++f) {
      const std::int64_t field = number<std::int32_t>("the type of a field");
      const int numbers = medit_numbers(field, dimension_);
      if (numbers == 0)
        in_.fail_at_byte(fmt::format("expected the type of a field, 1 to 4, found {}", field));
      solution.fields.push_back(static_cast<int>(field));
      row += static_cast<std::size_t>(numbers);
    }
    const std::size_t room = end > in_.offset() ? end - in_.offset() : 0;
    if (items < 0 || (row > 0 && static_cast<std::uint64_t>(items) > room / (row * real_size())))
      in_.fail_at_byte(fmt::format("expected {} of {}, found {} for them", counted(items, "values"),
                                   counted(row, "numbers"), counted(room, "bytes")));
    solution.count = static_cast<std::size_t>(items);
    solution.numbers.reserve(solution.count * row);
    for (std::size_t i = 0; i < solution.count * row; ++i) solution.numbers.push_back(real());
    content_.add_solution(std::move(solution));
  }

  // False where the number of bytes does not fit the keyword's form. Then nothing was read.
  bool section(const MeditKeyword& keyword, std::size_t end) {
    if (dimension_ == 0 && keyword.format.find('c') != std::string_view::npos) return false;
    std::size_t row = 0;
    for (const char kind : keyword.format)
      row += kind == 'i'   ? integer_size()
             : kind == 'r' ? real_size()
                           : static_cast<std::size_t>(dimension_) * real_size();
    MeditLines lines;
    const Scanner start = in_;
    if (keyword.counted) lines.count = count("a number of lines", row, end);
    if (in_.offset() + lines.count * row != end) {
      in_ = start;
      return false;
    }
    for (std::size_t line = 0; line < lines.count; ++line)
      for (const char kind : keyword.format)
        for (int k = 0; k < (kind == 'c' ? dimension_ : 1); ++k)
          if (kind == 'i')
            lines.integers.push_back(integer());
          else
            lines.reals.push_back(real());
    content_.add_section(&keyword, keyword.name, medit_body(keyword, lines, std::max(2, dimension_)),
                         std::max(2, dimension_));
    return true;
  }

  static int code_of(std::int64_t code) { return code > 0 && code < 1 << 16 ? static_cast<int>(code) : 0; }
  std::size_t real_size() const { return version_ == 1 ? 4 : 8; }
  std::size_t integer_size() const { return version_ == 4 ? 8 : 4; }
  double real() { return version_ == 1 ? number<float>("a number") : number<double>("a number"); }
  std::int64_t integer() {
    return version_ == 4 ? number<std::int64_t>("an integer") : number<std::int32_t>("an integer");
  }

  // A number of lines of `row` bytes each, which must fit in front of `end`.
  std::size_t count(const char* what, std::size_t row, std::size_t end) {
    const std::int64_t value = integer();
    const std::size_t left = end > in_.offset() ? end - in_.offset() : 0;
    if (value < 0 || static_cast<std::uint64_t>(value) > left / row)
      in_.fail_at_byte(fmt::format("expected {}, found {}; {} left for it", what, value,
                                   left == 1 ? "1 byte is" : fmt::format("{} bytes are", left)));
    return static_cast<std::size_t>(value);
  }

  template <class T>
  T number(const char* what) {
    return load<T>(in_.raw(sizeof(T), what).data(), order_);
  }

  Scanner in_;
  std::size_t size_;
  std::endian order_;
  MeditContent& content_;
  const MeditPart part_;
  int version_ = 0, dimension_ = 0;
};

}  // namespace

void read_medit_binary(const InputFile& file, std::endian order, MeditContent& content, MeditPart part) {
  Reader(file, order, content, part).read();
}

}  // namespace tetproof::io
