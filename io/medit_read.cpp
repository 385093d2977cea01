// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>

#include "io/byte_order.hpp"
#include "io/element_types.hpp"
#include "io/medit.hpp"
#include "io/medit_keywords.hpp"
#include "io/second_order.hpp"
#include "io/tag_sets.hpp"

namespace tetproof::io {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// What both forms of the format come to: numbers by keyword, put together when all have been read.
class Content {
 public:
  explicit Content(const std::string& path) {
    document_.path = path;
    document_.format = "medit";
  }

  struct Elements {
    const MeditKeyword* keyword = nullptr;
    std::vector<std::int64_t> numbers{};  // nodes and reference of each
  };

  Document& document() { return document_; }
  std::vector<double>& references() { return references_; }
  std::vector<Elements>& elements() { return elements_; }
  void warn(std::string text) { document_.warnings.push_back(document_.path + text); }

  void section(const MeditKeyword* keyword, std::string_view name, std::string body, int dimension) {
    const auto lines = keyword ? medit_lines(*keyword, body, dimension) : std::nullopt;
    if (lines && medit_mark(name)) {
      marks_.emplace_back(medit_mark(name), lines->integers);
    } else if (lines && name.ends_with("Ordering") && take_order(name, lines->integers)) {
      return;
    } else {
      if (lines && dimension == 2) {  // is written in three dimensions
        MeditLines three = *lines;
        three.reals.clear();
        std::size_t next = 0;
        for (std::size_t line = 0; line < three.count; ++line)
          for (const char kind : keyword->format)
            for (int k = 0; k < (kind == 'c' ? 3 : kind == 'r' ? 1 : 0); ++k)
              three.reals.push_back(kind == 'c' && k == 2 ? 0 : lines->reals[next++]);
        if (three.reals.size() != lines->reals.size()) body = medit_body(*keyword, three, 3);
      }
      document_.sections.push_back({.name = std::string(name), .body = std::move(body), .format = "medit"});
    }
  }

  Document finish() {
    TagSets sets(document_);
    for (const Elements& list : elements_) add(list, sets);
    if (std::any_of(references_.begin(), references_.end(), [](double r) { return r != 0; })) {
      Values values{.name = "references"};
      if (std::all_of(references_.begin(), references_.end(), [](double r) { return r == std::floor(r); }))
        for (const double r : references_) values.integers.push_back(static_cast<std::int64_t>(r));
      else
        values.reals = std::move(references_);
      document_.node_values.push_back(std::move(values));
    }
    for (const auto& [mark, numbers] : marks_) add(*mark, numbers);
    return std::move(document_);
  }

 private:
  void add(const Elements& list, TagSets& sets) {
    const int type = list.keyword->element;
    const ElementType& known = *element_type(type);
    const auto each = static_cast<std::size_t>(known.nodes);
    const auto own = orders_.find(type);
    const std::span<const int> order =
        own != orders_.end() ? std::span<const int>(own->second) : node_order(type, NodeOrder::medit);
    const std::size_t count = list.numbers.size() / (each + 1), first = document_.elements();
    auto& blocks = document_.blocks;
    const std::size_t before = blocks.size();
    document_.connectivity.reserve(document_.connectivity.size() + count * each);
    for (std::size_t e = 0; e < count; ++e) {
      const std::int64_t* numbers = list.numbers.data() + e * (each + 1);
      const std::int32_t groups = numbers[each] == 0 ? 0 : sets({numbers[each]});
      if (blocks.size() == before || blocks.back().groups != groups)
        blocks.push_back({.type = type,
                          .dim = known.dim,
                          .groups = groups,
                          .nodes_each = known.nodes,
                          .first = document_.elements(),
                          .nodes = document_.connectivity.size()});
      ++blocks.back().count;
      const std::size_t start = document_.connectivity.size();
      document_.connectivity.resize(start + each);
      for (std::size_t k = 0; k < each; ++k)
        document_.connectivity[start + (order.empty() ? k : static_cast<std::size_t>(order[k]))] =
            position(numbers[k], document_.points.size());
    }
    if (count > 0) runs_.push_back({type, first, count});
  }

  void add(const MeditMark& mark, const std::vector<std::int64_t>& numbers) {
    if (numbers.empty()) return;
    Values values{.name = std::string(mark.name)};
    values.integers.assign(numbers.size(), 1);
    for (const std::int64_t number : numbers) {
      if (mark.element == 0) {
        values.at.push_back(position(number, document_.points.size()));
        continue;
      }
      std::int64_t left = number - 1;  // of the elements of this type
      Index found = -1;
      for (const Run& run : runs_) {
        if (run.type != mark.element) continue;
        if (left >= 0 && left < static_cast<std::int64_t>(run.count)) {
          found = static_cast<Index>(run.first + static_cast<std::size_t>(left));
          break;
        }
        left -= static_cast<std::int64_t>(run.count);
      }
      values.at.push_back(found >= 0 ? found : unknown(number));
    }
    (mark.element == 0 ? document_.node_values : document_.element_values).push_back(std::move(values));
  }

  Index position(std::int64_t number, std::size_t count) {
    return number >= 1 && number <= static_cast<std::int64_t>(count) ? static_cast<Index>(number - 1)
                                                                     : unknown(number);
  }

  Index unknown(std::int64_t number) {
    const auto [place, is_new] =
        unknown_.try_emplace(number, -1 - static_cast<Index>(document_.unknown.size()));
    if (is_new) document_.unknown.push_back(number);
    return place->second;
  }

  bool take_order(std::string_view name, const std::vector<std::int64_t>& lattice) {
    const MeditKeyword* keyword =
        medit_keyword(name.substr(0, name.size() - std::string_view("Ordering").size()));
    std::vector<int> order = keyword ? order_of_lattice(keyword->element, lattice) : std::vector<int>{};
    if (order.empty()) {
      warn(fmt::format(": {} is kept, but not understood: the nodes are taken in the usual order", name));
      return false;
    }
    orders_[keyword->element] = std::move(order);
    return true;
  }

  struct Run {
    int type;
    std::size_t first, count;
  };

  Document document_;
  std::vector<double> references_;
  std::vector<Elements> elements_;
  std::vector<std::pair<const MeditMark*, std::vector<std::int64_t>>> marks_;
  std::unordered_map<int, std::vector<int>> orders_;
  std::vector<Run> runs_;
  std::unordered_map<std::int64_t, Index> unknown_;
};

class TextReader {
 public:
  explicit TextReader(const InputFile& file) : in_(file), bytes_(file.bytes()), content_(file.path()) {}

  Document read() {
    bool ended = false;
    while (!in_.at_end('#')) {
      const std::string_view name = in_.word('#');
      if (name == "End") {
        ended = true;
        break;
      }
      if (!std::all_of(name.begin(), name.end(),
                       [](char c) { return is_letter(c) || c == '_' || (c >= '0' && c <= '9'); }) ||
          !is_letter(name[0]))
        in_.fail("a keyword", name);
      keyword(name);
    }
    if (!has_version_) in_.fail("MeshVersionFormatted", {});
    if (dimension_ == 0) in_.fail("Dimension", {});
    if (!has_vertices_) in_.fail("Vertices", {});
    if (!ended) content_.warn(": the file does not close with End");
    return content_.finish();
  }

 private:
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
    if (name == "Vertices") return vertices();
    const MeditKeyword* known = medit_keyword(name);
    if (known && known->element != 0) return elements(*known);
    section(known, name);
  }

  void vertices() {
    if (dimension_ == 0) in_.fail("Dimension in front of Vertices", "Vertices");
    if (has_vertices_) in_.fail_in_line("a second Vertices");
    has_vertices_ = true;
    const std::int64_t count =
        in_.count("the number of vertices", 2 * static_cast<std::size_t>(dimension_) + 1, '#');
    if (count > std::numeric_limits<Index>::max())
      in_.fail_in_line(fmt::format("{} vertices are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    content_.document().points.reserve(static_cast<std::size_t>(count));
    content_.references().reserve(static_cast<std::size_t>(count));
    bool warned = false;
    for (std::int64_t i = 0; i < count; ++i) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (int k = 0; k < dimension_; ++k) point[k] = in_.real("a coordinate", '#');
      const double reference = in_.real("a reference", '#');
      if (!std::isfinite(reference) || std::abs(reference) > 9e15)
        in_.fail_in_line(fmt::format("expected the reference of vertex {}, found {}", i + 1, reference));
      if (reference != std::floor(reference) && !warned) {
        warned = true;
        content_.warn(
            fmt::format(":{}: {} is no integer, as references are (the first such)", in_.line(), reference));
      }
      content_.document().points.push_back(point);
      content_.references().push_back(reference);
    }
  }

  void elements(const MeditKeyword& keyword) {
    const auto each = static_cast<std::size_t>(element_type(keyword.element)->nodes) + 1;
    const std::int64_t count = in_.count("the number of elements", 2 * each - 1, '#');
    Content::Elements list{&keyword};
    list.numbers.reserve(static_cast<std::size_t>(count) * each);
    for (std::size_t i = 0; i < static_cast<std::size_t>(count) * each; ++i)
      list.numbers.push_back(
          in_.integer((i + 1) % each == 0 ? "a reference" : "the number of a vertex", '#'));
    content_.elements().push_back(std::move(list));
  }

  // As it stands, up to a line that begins with a letter.
  void section(const MeditKeyword* known, std::string_view name) {
    if (!known)
      content_.warn(fmt::format(":{}: the keyword {} is not known; what follows it is kept as it stands",
                                in_.line(), name));
    std::size_t begin = in_.offset(), end = begin;
    in_.rest_of_line();
    for (end = in_.offset(); in_.remaining() > 0; end = in_.offset()) {
      in_.next_line();
      const std::size_t line = in_.offset();
      const std::size_t next = bytes_.find_first_not_of(" \t", line);
      if (next != std::string_view::npos && is_letter(bytes_[next])) break;
      in_.rest_of_line();
    }
    constexpr const char* blanks = " \t\r\n\v\f";
    std::string_view body = bytes_.substr(begin, end - begin);
    begin = body.find_first_not_of(blanks);
    body = begin == std::string_view::npos ? std::string_view{}
                                           : body.substr(begin, body.find_last_not_of(blanks) + 1 - begin);
    content_.section(known, known ? known->name : name, std::string(body), std::max(2, dimension_));
  }

  Scanner in_;
  std::string_view bytes_;
  Content content_;
  int dimension_ = 0;
  bool has_version_ = false, has_vertices_ = false;
};

class BinaryReader {
 public:
  BinaryReader(const InputFile& file, std::endian order)
      : in_(file.path(), file.bytes(), 4), size_(file.bytes().size()), order_(order), content_(file.path()) {}

  Document read() {
    version_ = static_cast<int>(number<std::int32_t>("the version"));
    if (version_ < 1 || version_ > 4)
      in_.fail_at_byte(fmt::format("expected a version from 1 to 4, found {}", version_));
    bool ended = false;
    while (!ended && in_.remaining() > 0) ended = keyword();
    if (dimension_ == 0) in_.fail_at_byte("expected Dimension, found the end of the file");
    if (!has_vertices_) in_.fail_at_byte("expected Vertices, found the end of the file");
    if (!ended) content_.warn(": the file does not close with End");
    return content_.finish();
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
    const std::size_t end = next == 0 ? size_ : static_cast<std::size_t>(next);
    if (code == medit_dimension) {
      dimension_ = static_cast<int>(number<std::int32_t>("the dimension 2 or 3"));
      if (dimension_ != 2 && dimension_ != 3)
        in_.fail_at_byte(fmt::format("expected the dimension 2 or 3, found {}", dimension_));
    } else if (code == medit_vertices) {
      vertices(end);
    } else {
      const MeditKeyword* known =
          code > 0 && code < 1 << 16 ? medit_keyword(static_cast<int>(code)) : nullptr;
      if (known && known->element != 0)
        elements(*known, end);
      else if (!known || !section(*known, end))
        content_.warn(fmt::format(": byte {}: {} bytes of keyword {}{} are skipped", in_.offset(),
                                  end - in_.offset(), code, known ? fmt::format(" ({})", known->name) : ""));
      if (!known && next == 0) in_.fail_at_byte(fmt::format("expected a keyword, found {}", code));
    }
    if (next != 0) in_.raw(end - in_.offset(), "a keyword's data");
    return next == 0 && in_.remaining() == 0;
  }

  void vertices(std::size_t end) {
    if (dimension_ == 0) in_.fail_at_byte("expected Dimension in front of Vertices");
    if (has_vertices_) in_.fail_at_byte("a second Vertices");
    has_vertices_ = true;
    const std::size_t row = static_cast<std::size_t>(dimension_) * real_size() + integer_size();
    const std::size_t count = this->count("the number of vertices", row, end);
    if (count > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      in_.fail_at_byte(fmt::format("{} vertices are more than the {} that can be numbered here", count,
                                   std::numeric_limits<Index>::max()));
    content_.document().points.reserve(count);
    content_.references().reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      for (int k = 0; k < dimension_; ++k) point[k] = real();
      content_.document().points.push_back(point);
      content_.references().push_back(static_cast<double>(integer()));
    }
  }

  void elements(const MeditKeyword& keyword, std::size_t end) {
    const auto each = static_cast<std::size_t>(element_type(keyword.element)->nodes) + 1;
    const std::size_t count = this->count("the number of elements", each * integer_size(), end);
    Content::Elements list{&keyword};
    list.numbers.reserve(count * each);
    for (std::size_t i = 0; i < count * each; ++i) list.numbers.push_back(integer());
    content_.elements().push_back(std::move(list));
  }

  // False where the bytes are not as many as its form makes them.
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
    content_.section(&keyword, keyword.name, medit_body(keyword, lines, std::max(2, dimension_)),
                     std::max(2, dimension_));
    return true;
  }

  std::size_t real_size() const { return version_ == 1 ? 4 : 8; }
  std::size_t integer_size() const { return version_ == 4 ? 8 : 4; }
  double real() { return version_ == 1 ? number<float>("a number") : number<double>("a number"); }
  std::int64_t integer() {
    return version_ == 4 ? number<std::int64_t>("an integer") : number<std::int32_t>("an integer");
  }

  // Of lines of so many bytes each, which must stand in front of `end`.
  std::size_t count(const char* what, std::size_t row, std::size_t end) {
    const std::int64_t value = integer();
    const std::size_t left = end > in_.offset() ? end - in_.offset() : 0;
    if (value < 0 || static_cast<std::uint64_t>(value) > left / row)
      in_.fail_at_byte(fmt::format("expected {}, found {}; {} bytes are left for it", what, value, left));
    return static_cast<std::size_t>(value);
  }

  template <class T>
  T number(const char* what) {
    return load<T>(in_.raw(sizeof(T), what).data(), order_);
  }

  Scanner in_;
  std::size_t size_;
  std::endian order_;
  Content content_;
  int version_ = 0, dimension_ = 0;
  bool has_vertices_ = false;
};

}  // namespace

Document read_medit(const InputFile& file) {
  for (const std::endian order : {std::endian::little, std::endian::big})
    if (file.bytes().size() >= 4 && load<std::int32_t>(file.bytes().data(), order) == 1)
      return BinaryReader(file, order).read();
  return TextReader(file).read();
}

}  // namespace tetproof::io
