// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <sys/stat.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/large_pages.hpp"
#include "io/node_index.hpp"
#include "io/plain_lines.hpp"
#include "io/supplement.hpp"
#include "io/tetgen.hpp"

namespace tetproof::io {
namespace {

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
bool is_separator(char c) {
  return c == ' ' || c == '\t' || c == ',' || c == '\v' || c == '\f';
}

// Records of one line each, of words between blanks and commas; from # on a line is a comment.
class Records {
 public:
  Records(const InputFile& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {
    at_ = file.bytes().data();
    end_ = at_ + file.bytes().size();
  }

  std::size_t remaining() const { return end_ - at_; }

  // To the first word of the next record; false at the end of the file.
  bool next() {
    if (started_) skip_line();
    started_ = true;
    while (!more() && at_ < end_) skip_line();
    return at_ < end_;
  }

  // Whether the record has another word.
  bool more() {
    while (at_ < end_ && is_separator(*at_)) ++at_;
    return at_ < end_ && !is_line_end(*at_) && *at_ != '#';
  }

  std::int64_t integer(const char* expected) {
    if (!more()) fail_missing(expected);
    std::uint64_t value = 0;  // wraps round harmlessly where there are too many digits
    const char* c = at_;
    for (unsigned digit; c < end_ && (digit = static_cast<unsigned char>(*c) - '0') < 10; ++c)
      value = 10 * value + digit;
    const bool plain =
        c > at_ && c - at_ <= 18 && (*at_ != '0' || c == at_ + 1) && (c == end_ || ends_word(*c));
    if (!plain) return unusual_integer(expected);
    at_ = c;
    return static_cast<std::int64_t>(value);
  }

  double real(const char* expected) {
    if (!more()) fail_missing(expected);
    double value;
    const auto [c, error] = std::from_chars(at_, end_, value);
    if (error == std::errc() && (c == end_ || ends_word(*c))) {
      at_ = c;
      return value;
    }
    const std::string_view text = word();
    if (!parse_real(text, value)) fail(expected, text);
    return value;
  }

  // Where the line after the current one begins.
  std::size_t next_line() {
    skip_line();
    started_ = false;
    return static_cast<std::size_t>(at_ - file_.bytes().data());
  }

  [[noreturn]] void fail(std::string_view message) const { here().fail_in_line(message); }

 private:
  static bool ends_word(char c) { return is_separator(c) || is_line_end(c) || c == '#'; }

  std::string_view word() {
    const char* const start = at_;
    while (at_ < end_ && !ends_word(*at_)) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }

  // TetGen reads integers as C source does: 0x10 is sixteen, 010 is eight.
  std::int64_t unusual_integer(const char* expected) {
    const std::string_view text = word();
    std::string_view digits = text;
    const bool negative = !digits.empty() && digits[0] == '-';
    if (negative || (!digits.empty() && digits[0] == '+')) digits.remove_prefix(1);
    int base = 10;
    if (digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
      base = 16;
      digits.remove_prefix(2);
    } else if (digits.size() > 1 && digits[0] == '0') {
      base = 8;
    }
    std::uint64_t value = 0;
    const auto [c, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (error != std::errc() || c != digits.data() + digits.size() || digits.empty() ||
        value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
      fail(expected, text);
    if (base != 10 && !warned_) {
      warned_ = true;
      warnings_.push_back(
          fmt::format("{}:{}: {} is {} to TetGen, which reads integers as C does (the first such)",
                      file_.path(), here().line(), text, value));
    }
    return negative ? -static_cast<std::int64_t>(value) : static_cast<std::int64_t>(value);
  }

  void skip_line() {
    while (at_ < end_ && !is_line_end(*at_)) ++at_;
    if (at_ < end_ && *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n') ++at_;
    if (at_ < end_) ++at_;
  }

  Scanner here() const {
    return Scanner(file_.path(), file_.bytes(), static_cast<std::size_t>(at_ - file_.bytes().data()));
  }
  [[noreturn]] void fail(const char* expected, std::string_view found) const { here().fail(expected, found); }
  [[noreturn]] void fail_missing(const char* expected) const {
    if (at_ >= end_) here().fail(expected, {});
    fail(fmt::format("expected {}, found the end of the line", expected));
  }

  const InputFile& file_;
  std::vector<std::string>& warnings_;
  const char *at_, *end_;
  bool started_ = false, warned_ = false;
};

void check_count(const Records& in, std::int64_t count, const char* what, std::int64_t least_bytes_each) {
  if (count < 0) in.fail(fmt::format("expected {}, found {}", what, count));
  if (count > static_cast<std::int64_t>(in.remaining()) / least_bytes_each + 1)
    in.fail(fmt::format("expected {}, found {}, more than the {} bytes left can hold", what, count,
                        in.remaining()));
}

// Attributes may be missing in their lines, but not nearly all of them.
Values attributes(const Records& in, std::int64_t items, std::int64_t each) {
  if (each > 0) check_count(in, each, "the number of attributes", 1);
  if (each > 0 && items > 0 && each > static_cast<std::int64_t>(in.remaining()) / items + 4)
    in.fail(fmt::format(
        "expected the number of attributes, found {}, more than the {} bytes left can hold for {} lines",
        each, in.remaining(), items));
  Values values{.name = "attributes", .components = static_cast<int>(each), .reals = {}, .integers = {}};
  values.reals.assign(static_cast<std::size_t>(items) * each, 0.0);
  return values;
}

// Nodes whose every line is plain; false where one is not.
bool read_plain_nodes(const InputFile& file, std::size_t offset, bool marked, Document& document,
                      Values& values, Values& markers) {
  const std::size_t count = document.points.size();
  const auto each = static_cast<std::size_t>(values.components);
  if (count < least_plain_lines) return false;
  std::int64_t first = -1;
  if (PlainLine line(file.bytes().data() + offset, file.bytes().data() + file.bytes().size());
      !line.integer(first) || first < 0 || first > 1)
    return false;
  document.first_node = first;
  return read_plain_lines(file, offset, count,
                          [&](PlainLine& line, std::size_t i) {
                            std::int64_t number;
                            Eigen::Vector3d& p = document.points[i];
                            bool plain = line.integer(number) &&
                                         number == first + static_cast<std::int64_t>(i) && line.real(p.x()) &&
                                         line.real(p.y()) && line.real(p.z());
                            for (std::size_t k = 0; k < each && plain; ++k)
                              plain = line.real(values.reals[i * each + k]);
                            return plain && (!marked || line.integer(markers.integers[i]));
                          })
      .has_value();
}

void read_nodes(const InputFile& file, Document& document) {
  Records in(file, document.warnings);
  if (!in.next()) in.fail("expected the number of nodes, found the end of the file");
  const std::int64_t count = in.integer("the number of nodes");
  const std::int64_t dimension = in.more() ? in.integer("the dimension 3") : 3;
  const std::int64_t attributes_each = in.more() ? in.integer("the number of attributes") : 0;
  const bool marked = in.more() && in.integer("0 or 1 for boundary markers") != 0;
  if (dimension != 3) in.fail(fmt::format("expected the dimension 3, found {}", dimension));
  check_count(in, count, "the number of nodes", 8);
  check_count(in, attributes_each, "the number of attributes", 1);
  if (count > std::numeric_limits<Index>::max())
    in.fail(fmt::format("{} nodes are more than the {} that can be numbered here", count,
                        std::numeric_limits<Index>::max()));
  Values values = attributes(in, count, attributes_each);
  Values markers{.name = "markers", .components = 1, .reals = {}, .integers = {}};
  if (marked) markers.integers.assign(count, 0);
  resize_in_large_pages(document.points, static_cast<std::size_t>(count));
  const std::size_t start = in.next_line();
  const bool plain = read_plain_nodes(file, start, marked, document, values, markers);
  if (!plain) document.points.clear();
  for (std::int64_t i = 0; i < count && !plain; ++i) {
    if (!in.next()) in.fail(fmt::format("expected {} nodes, found {} and the end of the file", count, i));
    const std::int64_t number = in.integer("the number of a node");
    if (i == 0) {
      if (number != 0 && number != 1)
        in.fail(fmt::format("expected 0 or 1 as the first node's number, found {}", number));
      document.first_node = number;
    }
    if (number != document.first_node + i)
      in.fail(fmt::format("expected node {}, found {}: nodes must stand in order", document.first_node + i,
                          number));
    const double x = in.real("a coordinate"), y = in.real("a coordinate"), z = in.real("a coordinate");
    document.points.emplace_back(x, y, z);
    for (std::int64_t k = 0; k < attributes_each && in.more(); ++k)
      values.reals[i * attributes_each + k] = in.real("an attribute");
    if (marked && in.more()) markers.integers[i] = in.integer("a boundary marker");
  }
  if (attributes_each > 0) document.node_values.push_back(std::move(values));
  if (marked) document.node_values.push_back(std::move(markers));
}

// Tetrahedra whose every line is plain; false where one is not.
bool read_plain_elements(const InputFile& file, std::size_t offset, std::int64_t each, std::size_t count,
                         const NodeIndex& index, Index* nodes, Values& values, Tags& tags) {
  if (count < least_plain_lines) return false;
  const auto attributes_each = static_cast<std::size_t>(values.components);
  const auto behind = read_tagged_lines(file, offset, count, tags, 0, [&](PlainLine& line, std::size_t i) {
    Index* const mine = nodes + static_cast<std::int64_t>(i) * each;
    for (std::int64_t k = 0; k < each; ++k) {
      std::int64_t node;
      if (!line.integer(node)) return false;
      Index& place = mine[each == 10 ? tetgen_order[k] : k];
      place = index.known(node);
      if (place < 0) return false;
    }
    for (std::size_t k = 0; k < attributes_each; ++k)
      if (!line.real(values.reals[i * attributes_each + k])) return false;
    return true;
  });
  return behind.has_value();
}

void read_elements(const InputFile& file, Document& document) {
  Records in(file, document.warnings);
  if (!in.next()) in.fail("expected the number of tetrahedra, found the end of the file");
  const std::int64_t count = in.integer("the number of tetrahedra");
  const std::int64_t each = in.more() ? in.integer("4 or 10 nodes a tetrahedron") : 4;
  const std::int64_t attributes_each = in.more() ? in.integer("the number of attributes") : 0;
  if (each != 4 && each != 10) in.fail(fmt::format("expected 4 or 10 nodes a tetrahedron, found {}", each));
  check_count(in, count, "the number of tetrahedra", 2 * (1 + each));
  check_count(in, attributes_each, "the number of attributes", 1);
  Values values = attributes(in, count, attributes_each);
  NodeIndex index(document);
  Tags tags(document.element_tags, document.first_element);
  document.first_element = document.first_node;
  resize_in_large_pages(document.connectivity, static_cast<std::size_t>(count) * each);
  Index* nodes = document.connectivity.data();
  const bool plain = read_plain_elements(file, in.next_line(), each, static_cast<std::size_t>(count), index,
                                         nodes, values, tags);
  for (std::int64_t i = 0; i < count && !plain; ++i, nodes += each) {
    if (!in.next())
      in.fail(fmt::format("expected {} tetrahedra, found {} and the end of the file", count, i));
    tags.add(i, in.integer("the number of a tetrahedron"));
    for (int k = 0; k < each; ++k)
      nodes[each == 10 ? tetgen_order[k] : k] = index(in.integer("the number of a node"));
    for (std::int64_t k = 0; k < attributes_each && in.more(); ++k)
      values.reals[i * attributes_each + k] = in.real("an attribute");
  }
  if (count > 0)
    document.blocks.push_back({.type = each == 10 ? tetrahedron10 : tetrahedron4,
                               .nodes_each = static_cast<std::int32_t>(each),
                               .count = static_cast<std::size_t>(count)});
  if (attributes_each > 0) document.element_values.push_back(std::move(values));
}

}  // namespace

Document read_tetgen(const std::string& stem, bool needs_elements) {
  Document document;
  document.format = "tetgen";
  document.path = stem + (needs_elements ? ".ele" : ".node");
  std::optional<InputFile> elements;
  struct stat about {};
  if (needs_elements || ::stat((stem + ".ele").c_str(), &about) == 0)
    elements.emplace(stem + ".ele");
  else
    document.warnings.push_back(fmt::format("{}.node: there is no {}.ele beside it: nodes only", stem, stem));
  read_nodes(InputFile(stem + ".node"), document);
  if (elements) read_elements(*elements, document);
  take_back_comments(stem + ".node", stem, document);
  return document;
}

const Values* values_named(const std::vector<Values>& values, const std::string& name) {
  for (const Values& v : values)
    if (v.name == name) return &v;
  return nullptr;
}

}  // namespace tetproof::io
