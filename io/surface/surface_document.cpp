// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surface/surface_document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/bytes/text_output.hpp"
#include "io/error.hpp"
#include "io/model/element_types.hpp"

namespace tetproof::io {

int type_of_corners(std::size_t corners) {
  return corners == 1   ? point1
         : corners == 2 ? line2
         : corners == 3 ? triangle3
         : corners == 4 ? quadrangle4
                        : polygon;
}

void add_element(Document& document, std::span<const Index> nodes, std::int32_t groups) {
  const int type = type_of_corners(nodes.size());
  const auto each = static_cast<std::int32_t>(nodes.size());
  if (document.blocks.empty() || document.blocks.back().type != type ||
      document.blocks.back().nodes_each != each || document.blocks.back().groups != groups)
    document.blocks.push_back({.type = type,
                               .dim = type == point1  ? 0
                                      : type == line2 ? 1
                                                      : 2,
                               .groups = groups,
                               .nodes_each = each,
                               .first = document.elements(),
                               .nodes = document.connectivity.size()});
  ++document.blocks.back().count;
  for (const Index node : nodes) document.connectivity.push_back(node);
}

void check_countable(const std::string& path, std::size_t points) {
  if (points > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
    throw InputError(fmt::format("{}: {} points, at most 2147483647 can be numbered", path, points));
}

std::string shown_name(std::string_view name) {
  std::string text;
  for (const char c : name.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (name.size() > 40 ? "..." : "");
}

int corners_kept(const ElementBlock& block) {
  if (block.type == polygon) return block.nodes_each >= 3 ? block.nodes_each : 0;
  const ElementType* type = element_type(block.type);
  const bool kept = type && (type->shape == Shape::point || type->shape == Shape::line ||
                             type->shape == Shape::triangle || type->shape == Shape::quadrangle);
  return kept ? type->corners : 0;
}

bool keeps_all_elements(const Document& document, const std::function<int(const ElementBlock&)>& nodes) {
  for (const ElementBlock& block : document.blocks) {
    if (block.count == 0) continue;
    if (nodes(block) != block.nodes_each) return false;
    const Index* node = document.connectivity.data() + block.nodes;
    for (std::size_t e = 0; e < block.count; ++e, node += block.nodes_each)
      if (!nodes_exist(node, block.nodes_each)) return false;
  }
  return true;
}

bool plain_numbers(const Values& values, std::size_t items) {
  return values.components > 0 && items > 0 && values.labels.empty() && values.nodes.empty() &&
         !has_step(values) && values.reals.empty() != values.integers.empty() &&
         values.size() == items * static_cast<std::size_t>(values.components);
}

bool of_all(const Values& values, std::size_t items) {
  return values.at.empty() && values.first == 0 && plain_numbers(values, items);
}

bool of_some(const Values& values, std::size_t items) {
  if (values.at.empty()) return of_all(values, items);
  return values.at.size() < items && values.first == 0 && plain_numbers(values, values.at.size()) &&
         values.at.front() >= 0 && static_cast<std::size_t>(values.at.back()) < items &&
         std::adjacent_find(values.at.begin(), values.at.end(), std::greater_equal<>()) == values.at.end();
}

void Rows::add(std::size_t item, std::span<const double> numbers, bool whole) {
  if (numbers.empty()) return;
  Group& group = groups_[numbers.size()];
  group.at.push_back(static_cast<Index>(item));
  group.numbers.insert(group.numbers.end(), numbers.begin(), numbers.end());
  group.whole = group.whole && whole;
}

void Rows::give(std::vector<Values>& all, const std::string& name, std::size_t items) && {
  for (auto& [components, group] : groups_) {
    Values values{.name = name, .components = static_cast<int>(components)};
    if (group.whole)
      for (const double number : group.numbers) values.integers.push_back(static_cast<std::int64_t>(number));
    else
      values.reals = std::move(group.numbers);
    if (group.at.size() != items) values.at = std::move(group.at);
    all.push_back(std::move(values));
  }
  groups_.clear();
}

bool RowsOf::add(const Values& values) {
  if (!of_some(values, items_)) return false;
  for (const std::int64_t number : values.integers)  // they are read as doubles first
    if (std::abs(static_cast<double>(number)) > 9007199254740992.0) return false;
  for (const Values* other : held_)
    if (other->components == values.components) return false;
  if (of_.empty()) of_.assign(items_, -1), row_.resize(items_);
  const auto item = [&](std::size_t i) {
    return values.at.empty() ? i : static_cast<std::size_t>(values.at[i]);
  };
  const std::size_t count = values.items();
  for (std::size_t i = 0; i < count; ++i)
    if (of_[item(i)] >= 0) return false;
  for (std::size_t i = 0; i < count; ++i) {
    of_[item(i)] = static_cast<std::int8_t>(held_.size());
    row_[item(i)] = static_cast<Index>(i);
  }
  held_.push_back(&values);
  return true;
}

bool RowsOf::complete() const {
  return held_.size() == 1 && held_[0]->at.empty();
}

int RowsOf::most_components() const {
  int most = 0;
  for (const Values* values : held_) most = std::max(most, values->components);
  return most;
}

char* put_decimal(char* to, double value) {
  char* const end = put(to, value);
  const bool looks_whole = std::all_of(to, end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); });
  if (!looks_whole) return end;
  end[0] = '.', end[1] = '0';
  return end + 2;
}

void warn_of_colours(Document& document, const Values& colours, const char* of) {
  std::size_t bad = 0;
  for (const std::int64_t c : colours.integers) bad += c < 0 || c > 255;
  for (const double c : colours.reals) bad += !(c >= 0 && c <= 1);
  if (bad > 0 && colours.components > 1)
    document.warnings.push_back(fmt::format("{}: {} numbers in colours of {} are outside of {}",
                                            document.path, bad, of,
                                            colours.reals.empty() ? "0 to 255" : "0 to 1"));
}

std::string leading_comments(Scanner scanner) {
  std::string title;
  bool first = true;
  while (scanner.remaining() > 0) {
    if (scanner.at_line_end()) {
      scanner.next_line();
      continue;
    }
    const std::string_view line = scanner.rest_of_line();
    if (line[0] != '#') break;
    title.append(first ? "" : "\n").append(line.substr(line.starts_with("# ") ? 2 : 1));
    first = false;
  }
  return title;
}

std::vector<std::string> title_lines(const std::string& title) {
  std::vector<std::string> lines;
  if (title.empty()) return lines;
  for (std::size_t from = 0;;) {
    const std::size_t end = title.find('\n', from);
    lines.push_back(title.substr(from, end - from));
    if (end == title.npos) return lines;
    from = end + 1;
  }
}

bool title_in_lines(const std::string& title) {
  return title.find('\r') == title.npos;  // which ends a line
}

}  // namespace tetproof::io
