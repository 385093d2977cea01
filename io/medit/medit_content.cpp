// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a document of the numbers of a Medit file.
#include "io/medit/medit_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "io/loss/loss_list.hpp"
#include "io/model/element_types.hpp"
#include "io/model/node_order.hpp"

namespace tetproof::io {
namespace {

// Returns the same lines with a third coordinate, 0, for every point.
MeditLines in_space(const MeditKeyword& keyword, const MeditLines& plane) {
  MeditLines space = plane;
  space.reals.clear();
  std::size_t next = 0;
  for (std::size_t line = 0; line < plane.count; ++line)
    for (const char kind : keyword.format)
      for (int k = 0; k < (kind == 'c' ? 3 : kind == 'r' ? 1 : 0); ++k)
        space.reals.push_back(kind == 'c' && k == 2 ? 0 : plane.reals[next++]);
  return space;
}

}  // namespace

MeditContent::MeditContent(const std::string& path) {
  document_.path = path;
  document_.format = "medit";
}

void MeditContent::start_vertices(std::size_t count) {
  has_vertices_ = true;
  document_.points.reserve(count);
  references_.reserve(count);
}

void MeditContent::add_vertex(const Eigen::Vector3d& point, double reference) {
  document_.points.push_back(point);
  references_.push_back(reference);
}

void MeditContent::add_vertex(const Eigen::Vector3d& point, std::int64_t reference) {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  if (reference > most || reference < -most) large_references_.emplace_back(references_.size(), reference);
  add_vertex(point, static_cast<double>(reference));
}

void MeditContent::add_section(const MeditKeyword* keyword, std::string_view name, std::string body,
                               int dimension) {
  const auto lines = keyword ? medit_lines(*keyword, body, dimension) : std::nullopt;
  if (lines && medit_mark(name)) {
    marks_.emplace_back(medit_mark(name), lines->integers);
    return;
  }
  if (lines && name.ends_with("Ordering") && take_order(name, lines->integers)) return;
  // One form for all, so that blanks and the dimension make no difference when it is written.
  if (lines) body = medit_body(*keyword, dimension == 2 ? in_space(*keyword, *lines) : *lines, 3);
  document_.sections.push_back({.name = std::string(name), .body = std::move(body), .format = "medit"});
}

void MeditContent::warn(std::string_view text) {
  document_.warnings.push_back(document_.path + std::string(text));
}

void MeditContent::warn_of(const std::string& path, std::string_view text) {
  document_.warnings.push_back(fmt::format("{}: {}", path, text));
}

void MeditContent::take_solutions(MeditContent other) {
  for (MeditSolution& solution : other.solutions_) solutions_.push_back(std::move(solution));
  for (std::string& warning : other.document_.warnings) document_.warnings.push_back(std::move(warning));
  for (const Loss& loss : other.document_.dropped)
    drop(loss.item, static_cast<std::size_t>(loss.count), loss.example, loss.elements);
  const auto drop_keyword = [&](std::string_view name) {
    drop(fmt::format("keywords of solutions that hold no values: {}", name), 1, other.document_.path);
  };
  for (const Section& section : other.document_.sections) drop_keyword(section.name);
  for (const auto& [mark, numbers] : other.marks_) drop_keyword(mark->name);
  for (const std::string& name : other.orderings_) drop_keyword(name);
}

void MeditContent::drop(const std::string& item, std::size_t count, const std::string& example,
                        bool elements) {
  add_loss(document_.dropped, item, count, example, elements);
}

Document MeditContent::finish() {
  TagSets sets(document_);
  // All elements of a keyword count from 1, also if it stands there twice.
  std::vector<const MeditKeyword*> kinds;
  for (const Elements& list : elements_)
    if (std::find(kinds.begin(), kinds.end(), list.keyword) == kinds.end()) kinds.push_back(list.keyword);
  std::stable_sort(elements_.begin(), elements_.end(), [&](const Elements& a, const Elements& b) {
    return std::find(kinds.begin(), kinds.end(), a.keyword) <
           std::find(kinds.begin(), kinds.end(), b.keyword);
  });
  for (const Elements& list : elements_) make_elements(list, sets);
  make_references();
  for (const auto& [mark, numbers] : marks_) make_mark(*mark, numbers);
  for (const MeditSolution& solution : solutions_) make_solution(solution);
  return std::move(document_);
}

void MeditContent::make_elements(const Elements& list, TagSets& sets) {
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
          node(numbers[k]);
  }
  if (count > 0) runs_.push_back({type, first, count});
}

void MeditContent::make_references() {
  if (std::all_of(references_.begin(), references_.end(), [](double r) { return r == 0; })) return;
  Values values{.name = "references"};
  if (std::all_of(references_.begin(), references_.end(), [](double r) { return r == std::floor(r); })) {
    for (const auto& [vertex, large] : large_references_) references_[vertex] = 0;
    for (const double r : references_) values.integers.push_back(static_cast<std::int64_t>(r));
    for (const auto& [vertex, large] : large_references_) values.integers[vertex] = large;
  } else {
    for (const auto& [vertex, large] : large_references_)
      if (references_[vertex] >= 0x1p63 || static_cast<std::int64_t>(references_[vertex]) != large)
        drop("references of vertices, rounded to doubles", 1,
             fmt::format("{} of vertex {}", large, vertex + 1));
    values.reals = std::move(references_);
  }
  document_.node_values.push_back(std::move(values));
}

void MeditContent::make_mark(const MeditMark& mark, const std::vector<std::int64_t>& numbers) {
  if (numbers.empty()) return;
  Values values{.name = std::string(mark.name)};
  values.integers.assign(numbers.size(), 1);
  for (const std::int64_t number : numbers)
    values.at.push_back(mark.element == 0 ? node(number) : element(number, mark.element));
  (mark.element == 0 ? document_.node_values : document_.element_values).push_back(std::move(values));
}

void MeditContent::make_solution(const MeditSolution& solution) {
  const int type = solution.keyword->element;
  std::vector<Index> at;
  for (const Run& run : runs_)
    for (std::size_t e = 0; run.type == type && e < run.count; ++e)
      at.push_back(static_cast<Index>(run.first + e));
  const std::size_t items = type == 0 ? document_.points.size() : at.size();
  if (solution.count != items)
    return drop(fmt::format("values of {}, since their number is another one", solution.keyword->name),
                solution.count, fmt::format("{} in place of {}", solution.count, items));
  if (items == 0) return;
  auto& all = type == 0 ? document_.node_values : document_.element_values;
  for (Values& values : medit_values(solution)) {
    if (type != 0 && items != document_.elements()) values.at = at;
    all.push_back(std::move(values));
  }
}

bool MeditContent::take_order(std::string_view name, const std::vector<std::int64_t>& lattice) {
  const MeditKeyword* keyword =
      medit_keyword(name.substr(0, name.size() - std::string_view("Ordering").size()));
  std::vector<int> order = keyword ? order_of_lattice(keyword->element, lattice) : std::vector<int>{};
  if (order.empty()) {
    warn(fmt::format(": {} is kept, but not understood: the nodes are taken in the usual order", name));
    return false;
  }
  orders_[keyword->element] = std::move(order);
  orderings_.emplace_back(name);
  return true;
}

Index MeditContent::node(std::int64_t number) {
  return number >= 1 && number <= static_cast<std::int64_t>(document_.points.size())
             ? static_cast<Index>(number - 1)
             : unknown(number);
}

// The position in the document of the element with this number among those of its type.
Index MeditContent::element(std::int64_t number, int type) {
  if (number < 1) return unknown(number);
  auto left = static_cast<std::size_t>(number - 1);
  for (const Run& run : runs_) {
    if (run.type != type) continue;
    if (left < run.count) return static_cast<Index>(run.first + left);
    left -= run.count;
  }
  return unknown(number);
}

Index MeditContent::unknown(std::int64_t number) {
  const auto [place, is_new] =
      unknown_.try_emplace(number, -1 - static_cast<Index>(document_.unknown.size()));
  if (is_new) document_.unknown.push_back(number);
  return place->second;
}

}  // namespace tetproof::io
