// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply/ply_plan.hpp"

#include <fmt/core.h>

#include <set>
#include <string_view>

#include "io/bytes/tokens.hpp"
#include "io/model/values.hpp"
#include "io/surface/titles.hpp"

namespace tetproof::io {
namespace {

bool fits_count(const PlyType& type, const std::vector<std::int32_t>& lengths) {
  return !type.real && std::all_of(lengths.begin(), lengths.end(),
                                   [&](std::int32_t n) { return n >= 0 && n <= type.most; });
}

int nodes_written(const ElementBlock& block) {
  const int corners = corners_kept(block);
  return corners >= 2 ? corners : 0;
}

// Adds properties for values. Row `first` + i of the values belongs to instance i.
void add(PlyPart& part, const PlyNamed& one, std::size_t first) {
  const Values& values = *one.values;
  const auto each = static_cast<std::size_t>(values.components);
  const PlyType* type = values.reals.empty() ? type_for(values.integers) : type_for(values.reals);
  for (std::size_t k = 0; k < each; ++k) {
    PlySource source;
    source.name = one.names[k], source.type = type, source.stride = each;
    if (values.reals.empty())
      source.integers = values.integers.data() + first * each + k;
    else
      source.reals = values.reals.data() + first * each + k;
    source.type_words = type->name;
    part.sources.push_back(std::move(source));
  }
}

bool has_type(const Values& values) {
  return !values.reals.empty() || type_for(values.integers);
}

}  // namespace

PlyPlan::PlyPlan(const Document& document, bool binary) : document_(document), binary_(binary) {
  for_each_kept(document, [&](const KeptElement& element) {
    if (element.corners >= 3) faces.push_back(element);
    if (element.corners == 2) lines.push_back(element);
  });
  ordered_ = keeps_all_elements(document, nodes_written);
  for (std::size_t i = 0; i < faces.size(); ++i) ordered_ = ordered_ && faces[i].element == i;
  vertex = {"vertex", document.points.size(), {}};
  face = {"face", faces.size(), {}};
  edge = {"edge", lines.size(), {}};
  node_values();
  texture();
  element_values();
  tables();
}

void PlyPlan::node_values() {
  std::vector<const Values*> wanted;
  for (const Values& values : document_.node_values)
    if (of_all(values, document_.points.size()) && has_type(values)) wanted.push_back(&values);
  for (const PlyNamed& one : named_values(wanted, {wanted}, {"x", "y", "z"})) {
    add(vertex, one, 0);
    held.push_back(one.values);
  }
}

// Values of elements have the file's order only if the elements do.
void PlyPlan::element_values() {
  if (!ordered_) return;
  std::vector<const Values*> wanted, of_faces, of_lines;
  const std::size_t count = faces.size() + lines.size();
  for (const Values& values : document_.element_values) {
    const std::size_t items = values.items();
    if (!values.at.empty() || !plain_numbers(values, items) || !has_type(values)) continue;
    const bool all = values.first == 0 && items == count;
    const bool is_of_faces = !faces.empty() && (all || (values.first == 0 && items == faces.size()));
    const bool is_of_lines =
        !lines.empty() && (all || (values.first == faces.size() && items == lines.size()));
    if (is_of_faces) of_faces.push_back(&values);
    if (is_of_lines) of_lines.push_back(&values);
    if (is_of_faces || is_of_lines) wanted.push_back(&values);
  }
  const auto in = [](const std::vector<const Values*>& list, const Values* values) {
    return std::find(list.begin(), list.end(), values) != list.end();
  };
  for (const PlyNamed& one :
       named_values(wanted, {of_faces, of_lines},
                    {"vertex_indices", "vertex_index", "texcoord", "vertex1", "vertex2"})) {
    if (in(of_faces, one.values)) add(face, one, 0);
    if (in(of_lines, one.values)) add(edge, one, one.values->first == 0 ? faces.size() : 0);
    held.push_back(one.values);
  }
}

void PlyPlan::texture() {
  for (const Values& values : document_.element_node_values) {
    if (!ordered_ || values.name != "texture" || values.components != 2 || values.reals.empty() ||
        !values.integers.empty() || !values.labels.empty() || values.first != 0 || !values.at.empty() ||
        values.nodes.size() != faces.size() || values.of_view || values.time != 0 || values.step != 0 ||
        values.partition != 0 || !values.interpolation.empty())
      continue;
    PlySource source;
    source.starts.push_back(0);
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (values.nodes[i] == faces[i].corners)
        source.starts.push_back(source.starts.back() + 2 * static_cast<std::size_t>(values.nodes[i]));
    if (source.starts.size() != faces.size() + 1 || source.starts.back() != values.reals.size()) continue;
    std::int64_t most = 0;
    for (const KeptElement& element : faces) most = std::max<std::int64_t>(most, 2 * element.corners);
    source.name = "texcoord", source.reals = values.reals.data();
    source.type = type_for(values.reals), source.count = type_for(std::vector<std::int64_t>{most});
    source.type_words = fmt::format("list {} {}", source.count->name, source.type->name);
    face.sources.push_back(std::move(source));
    held.push_back(&values);
    return;
  }
}

// Whether a column can be written as a property that comes back; if so, sets `source`.
bool PlyPlan::column(const Column& column, std::size_t rows, PlySource& source) const {
  source.name = encode_name(column.name);
  const bool list = !column.lengths.empty() || column.type.starts_with("list ");
  const std::size_t numbers = column.reals.size() + column.integers.size();
  if (column.components != 1 || !column.texts.empty() || source.name.empty() ||
      (!column.reals.empty() && !column.integers.empty()))
    return false;
  std::string_view words = column.type;
  if (list) {
    const std::size_t blank = words.find(' ', 5);
    if (!words.starts_with("list ") || blank == words.npos || column.lengths.size() != rows) return false;
    source.count = ply_type(words.substr(5, blank - 5));
    words = words.substr(blank + 1);
    if (!source.count || !fits_count(*source.count, column.lengths)) return false;
    source.starts.push_back(0);
    for (const std::int32_t length : column.lengths)
      source.starts.push_back(source.starts.back() + static_cast<std::size_t>(length));
    if (source.starts.back() != numbers) return false;
  } else if (numbers != rows) {
    return false;
  }
  source.type = ply_type(words);
  source.type_words = column.type;
  if (!source.type ||
      (source.type->real ? !column.integers.empty() || !fits(*source.type, column.reals, binary_)
                         : !column.reals.empty() || !fits(*source.type, column.integers)))
    return false;
  if (source.type->real)
    source.reals = column.reals.data();
  else
    source.integers = column.integers.data();
  return true;
}

// The tables "vertex", "face" and "edge" hold the lists of these elements. Every other table is an element of
// its own.
void PlyPlan::tables() {
  std::set<std::string> names{"vertex", "face", "edge"}, attached;
  for (const Table& table : document_.tables) {
    PlyPart* part = table.name == "vertex" ? &vertex
                    : table.name == "face" ? &face
                    : table.name == "edge" ? &edge
                                           : nullptr;
    PlyPart own{encode_name(table.name), table.rows, {}};
    const bool new_name =
        part ? attached.insert(table.name).second : !own.name.empty() && names.insert(own.name).second;
    std::set<std::string> known;
    if (part) {
      known = {"x", "y", "z", "vertex_indices", "vertex_index", "vertex1", "vertex2"};
      for (const PlySource& source : part->sources) known.insert(source.name);
    }
    bool held_here = new_name && (!part || (part->rows == table.rows && !table.columns.empty()));
    for (const Column& given : table.columns) {
      PlySource source;
      if (!column(given, table.rows, source) || (part && !source.count) ||
          !known.insert(source.name).second ||
          (part == &face && source.name == "texcoord" && source.type->real)) {
        held_here = false;
        break;
      }
      own.sources.push_back(std::move(source));
    }
    if (!held_here) continue;
    held_tables.push_back(&table);
    if (part)
      for (PlySource& source : own.sources) part->sources.push_back(std::move(source));
    else
      others.push_back(std::move(own));
  }
}

Holds ply_holds(const Document& document, const PlyPlan& plan) {
  Holds holds;
  holds.title = title_in_lines(document.title);
  holds.table = [held = plan.held_tables](const Table& table) {
    return std::find(held.begin(), held.end(), &table) != held.end();
  };
  holds.nodes_each = nodes_written;
  holds.kind = [](const ElementBlock& block) { return corners_kept(block) == 2 ? 1 : 0; };
  holds.values = [held = plan.held](const Values& values, Of) {
    return std::find(held.begin(), held.end(), &values) != held.end();
  };
  return holds;
}

}  // namespace tetproof::io
