// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <set>
#include <tuple>

#include "io/byte_order.hpp"
#include "io/ply.hpp"
#include "io/ply_header.hpp"
#include "io/surface_lines.hpp"
#include "io/tokens.hpp"

namespace tetproof::io {
namespace {

// Where the numbers of a property stand: that of instance i at i x stride; of a list from `starts[i]` on.
struct Source {
  std::string name, type_words;
  const PlyType *type = nullptr, *count = nullptr;
  const double* reals = nullptr;
  const std::int64_t* integers = nullptr;
  std::size_t stride = 1;
  std::vector<std::size_t> starts;

  std::size_t longest() const {  // in text
    std::size_t most = 1;
    for (std::size_t i = 1; i < starts.size(); ++i) most = std::max(most, starts[i] - starts[i - 1] + 1);
    return most * (longest_real + 1);
  }
};

char* put_number(char* to, const Source& source, std::size_t at, bool binary) {
  if (source.reals) {
    const double value = source.reals[at];
    return binary ? source.type->store(to, value) : put(put(to, value), ' ');
  }
  const std::int64_t value = source.integers[at];
  return binary ? source.type->store(to, static_cast<double>(value)) : put(put(to, value), ' ');
}

char* put_source(char* to, const Source& source, std::size_t i, bool binary) {
  if (!source.count) return put_number(to, source, i * source.stride, binary);
  const std::size_t from = source.starts[i], end = source.starts[i + 1];
  to = binary ? source.count->store(to, static_cast<double>(end - from))
              : put(put(to, static_cast<std::int64_t>(end - from)), ' ');
  for (std::size_t at = from; at < end; ++at) to = put_number(to, source, at, binary);
  return to;
}

// An element of the file beside what stands in front of its properties: coordinates, corners.
struct Part {
  std::string name;
  std::size_t rows = 0;
  std::vector<Source> sources;
  std::size_t longest() const {
    std::size_t sum = 1;
    for (const Source& source : sources) sum += source.longest();
    return sum;
  }
};

bool fits_count(const PlyType& type, const std::vector<std::int32_t>& lengths) {
  return !type.real && std::all_of(lengths.begin(), lengths.end(),
                                   [&](std::int32_t n) { return n >= 0 && n <= type.most; });
}

class Plan {
 public:
  Plan(const Document& document, bool binary) : document_(document), binary_(binary) {
    for_each_kept(document, [&](const KeptElement& element) {
      if (element.corners >= 3) faces.push_back(element);
      if (element.corners == 2) lines.push_back(element);
    });
    ordered = keeps_all_elements(document, ply_nodes);
    for (std::size_t i = 0; i < faces.size(); ++i) ordered = ordered && faces[i].element == i;
    vertex = {"vertex", document.points.size(), {}};
    face = {"face", faces.size(), {}};
    edge = {"edge", lines.size(), {}};
    node_values();
    texture();
    element_values();
    lists();
  }

  static int ply_nodes(const ElementBlock& block) {
    const int corners = corners_kept(block);
    return corners >= 2 ? corners : 0;
  }

  std::vector<KeptElement> faces, lines;
  bool ordered = false;  // every element comes back at its place
  Part vertex, face, edge;
  std::vector<Part> others;
  std::vector<const Values*> held;
  bool tables_held = true;

 private:
  // Of values that may be written those that come back as they are, and the names of their properties.
  struct Named {
    const Values* values;
    std::vector<std::string> names;
  };
  static std::vector<Named> named(const std::vector<const Values*>& wanted, std::set<std::string> taken) {
    std::vector<Named> list;
    for (const Values* values : wanted) {
      Named one{values, property_names(*values, false)};
      const bool bad = std::any_of(one.names.begin(), one.names.end(), [&](const std::string& name) {
        return name.empty() || taken.count(name) > 0;
      });
      if (bad) one.names = property_names(*values, true);
      if (std::any_of(one.names.begin(), one.names.end(),
                      [&](const std::string& name) { return name.empty() || taken.count(name) > 0; }))
        continue;
      taken.insert(one.names.begin(), one.names.end());
      list.push_back(std::move(one));
    }
    for (const bool last : {false, true}) {  // what is not read back is escaped first, then left out
      std::vector<std::string> names;
      std::vector<bool> real;
      for (const Named& one : list) {
        names.insert(names.end(), one.names.begin(), one.names.end());
        real.insert(real.end(), one.names.size(), !one.values->reals.empty());
      }
      std::set<std::tuple<std::size_t, std::size_t, std::string>> read;
      for (const PlyGroup& group : group_properties(names, real))
        read.insert({group.first, group.components, group.name});
      std::size_t first = 0;
      std::vector<Named> kept;
      for (Named& one : list) {
        const std::size_t count = one.names.size();
        const bool back = read.count({first, count, one.values->name}) > 0;
        first += count;
        if (!back && last) continue;
        if (!back) one.names = property_names(*one.values, true);
        kept.push_back(std::move(one));
      }
      list = std::move(kept);
    }
    return list;
  }

  // Properties for `values`, of which the row of instance i is `first` + i.
  static void add(Part& part, const Named& one, std::size_t first) {
    const Values& values = *one.values;
    const auto each = static_cast<std::size_t>(values.components);
    const PlyType* type = values.reals.empty() ? type_for(values.integers) : type_for(values.reals);
    for (std::size_t k = 0; k < each; ++k) {
      Source source;
      source.name = one.names[k], source.type = type, source.stride = each;
      if (values.reals.empty())
        source.integers = values.integers.data() + first * each + k;
      else
        source.reals = values.reals.data() + first * each + k;
      source.type_words = type->name;
      part.sources.push_back(std::move(source));
    }
  }

  static bool has_type(const Values& values) { return !values.reals.empty() || type_for(values.integers); }

  void node_values() {
    std::vector<const Values*> wanted;
    for (const Values& values : document_.node_values)
      if (of_all(values, document_.points.size()) && has_type(values)) wanted.push_back(&values);
    for (const Named& one : named(wanted, {"x", "y", "z"})) {
      add(vertex, one, 0);
      held.push_back(one.values);
    }
  }

  // Values stand in the file's order only if the elements do.
  void element_values() {
    if (!ordered) return;
    std::vector<const Values*> of_faces, of_lines;
    const std::size_t count = faces.size() + lines.size();
    for (const Values& values : document_.element_values) {
      const std::size_t items = values.items();
      if (!values.at.empty() || !plain_numbers(values, items) || !has_type(values)) continue;
      const bool all = values.first == 0 && items == count;
      if (all || (values.first == 0 && items == faces.size())) of_faces.push_back(&values);
      if (all || (values.first == faces.size() && items == lines.size())) of_lines.push_back(&values);
    }
    if (faces.empty()) of_faces.clear();
    if (lines.empty()) of_lines.clear();
    const std::vector<Named> for_faces = named(of_faces, {"vertex_indices", "vertex_index", "texcoord"});
    const std::vector<Named> for_lines = named(of_lines, {"vertex1", "vertex2"});
    const auto given = [](const std::vector<Named>& list, const Values* values) {
      return std::any_of(list.begin(), list.end(), [&](const Named& one) { return one.values == values; });
    };
    const auto wanted = [](const std::vector<const Values*>& list, const Values* values) {
      return std::find(list.begin(), list.end(), values) != list.end();
    };
    for (const Values& values : document_.element_values) {
      const Values* v = &values;
      const bool in_faces = wanted(of_faces, v), in_lines = wanted(of_lines, v);
      if ((in_faces || in_lines) && in_faces == given(for_faces, v) && in_lines == given(for_lines, v))
        held.push_back(v);
    }
    for (const Named& one : for_faces) add(face, one, 0);
    for (const Named& one : for_lines) add(edge, one, one.values->first == 0 ? faces.size() : 0);
  }

  void texture() {
    for (const Values& values : document_.element_node_values) {
      if (!ordered || values.name != "texture" || values.components != 2 || values.reals.empty() ||
          !values.integers.empty() || !values.labels.empty() || values.first != 0 || !values.at.empty() ||
          values.nodes.size() != faces.size() || values.of_view || values.time != 0 || values.step != 0 ||
          values.partition != 0 || !values.interpolation.empty())
        continue;
      Source source;
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

  // Whether a column can be written so that it comes back, as a property.
  bool column(const Column& column, std::size_t rows, Source& source) const {
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

  // Tables "vertex", "face" and "edge" are lists of these elements; all others are elements of their own.
  void lists() {
    std::set<std::string> names{"vertex", "face", "edge"}, attached;
    int last = 0;
    for (const Table& table : document_.tables) {
      Part* part = table.name == "vertex" ? &vertex
                   : table.name == "face" ? &face
                   : table.name == "edge" ? &edge
                                          : nullptr;
      Part own{encode_name(table.name), table.rows, {}};
      const bool new_name =
          part ? attached.insert(table.name).second : !own.name.empty() && names.insert(own.name).second;
      std::set<std::string> known;
      if (part) {
        known = {"x", "y", "z", "vertex_indices", "vertex_index", "vertex1", "vertex2"};
        for (const Source& source : part->sources) known.insert(source.name);
      }
      bool held_here = new_name && (!part || (part->rows == table.rows && !table.columns.empty()));
      for (const Column& given : table.columns) {
        Source source;
        if (!column(given, table.rows, source) || (part && !source.count) ||
            !known.insert(source.name).second ||
            (part == &face && source.name == "texcoord" && source.type->real)) {
          held_here = false;
          break;
        }
        own.sources.push_back(std::move(source));
      }
      const int rank = part == &vertex ? 0 : part == &face ? 1 : part == &edge ? 2 : 3;
      if (held_here && rank < last) tables_held = false;
      if (!held_here) {
        tables_held = false;
        continue;
      }
      last = rank;
      if (part)
        for (Source& source : own.sources) part->sources.push_back(std::move(source));
      else
        others.push_back(std::move(own));
    }
  }

  const Document& document_;
  const bool binary_;
};

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, bool binary)
      : file_(file), document_(document), binary_(binary), plan_(document, binary) {}

  void write() {
    header();
    points();
    faces();
    lines();
    for (const Part& part : plan_.others)
      if (!part.sources.empty()) rows(part, 0, [](std::size_t, char* to) { return to; });
  }

 private:
  void header() {
    std::string text = fmt::format("ply\nformat {} 1.0\n", binary_ ? "binary_little_endian" : "ascii");
    if (title_in_lines(document_.title))
      for (const std::string& line : title_lines(document_.title)) {
        if (!line.starts_with("obj_info ")) text += line.empty() ? "comment" : "comment ";
        text += line;
        text += "\n";
      }
    const auto element = [&](const Part& part) {
      for (const Source& source : part.sources)
        text += fmt::format("property {} {}\n", source.type_words, source.name);
    };
    point_type_ = point_type();
    text += fmt::format("element vertex {0}\nproperty {1} x\nproperty {1} y\nproperty {1} z\n",
                        plan_.vertex.rows, point_type_->name);
    element(plan_.vertex);
    for (const KeptElement& face : plan_.faces) corners_ = std::max(corners_, face.corners);
    count_type_ = type_for(std::vector<std::int64_t>{corners_});
    text += fmt::format("element face {}\nproperty list {} int vertex_indices\n", plan_.face.rows,
                        count_type_->name);
    element(plan_.face);
    if (plan_.edge.rows > 0) {
      text += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\n", plan_.edge.rows);
      element(plan_.edge);
    }
    for (const Part& part : plan_.others) {
      text += fmt::format("element {} {}\n", part.name, part.rows);
      element(part);
    }
    file_.write(text + "end_header\n");
  }

  // Float if every coordinate is one.
  const PlyType* point_type() const {
    const PlyType* type = document_.points.empty() ? ply_type("double") : ply_type("float");
    for (const Eigen::Vector3d& point : document_.points)
      for (const double x : point)
        if (std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(x))) !=
            std::bit_cast<std::uint64_t>(x))
          return ply_type("double");
    return type;
  }

  // The rows of an element: what `start` puts, at most so many bytes, and the properties.
  template <class Start>
  void rows(const Part& part, std::size_t longest_start, const Start& start) {
    write_items(file_, part.rows, longest_start + part.longest() + 1, [&](std::size_t i, char* to) {
      to = start(i, to);
      for (const Source& source : part.sources) to = put_source(to, source, i, binary_);
      if (!binary_) to[-1] = '\n';  // in place of the last blank
      return to;
    });
  }

  char* put_index(char* to, Index node) const {
    return binary_ ? store(to, node, std::endian::little) : put(put(to, node), ' ');
  }

  void points() {
    rows(plan_.vertex, 3 * (longest_real + 1), [&](std::size_t i, char* to) {
      for (const double x : document_.points[i])
        to = binary_ ? point_type_->store(to, x) : put(put(to, x), ' ');
      return to;
    });
  }

  void faces() {
    rows(plan_.face, 12 * (static_cast<std::size_t>(corners_) + 1), [&](std::size_t i, char* to) {
      const KeptElement& face = plan_.faces[i];
      to = binary_ ? count_type_->store(to, face.corners) : put(put(to, face.corners), ' ');
      for (int k = 0; k < face.corners; ++k) to = put_index(to, face.nodes[k]);
      return to;
    });
  }

  void lines() {
    rows(plan_.edge, 24, [&](std::size_t i, char* to) {
      return put_index(put_index(to, plan_.lines[i].nodes[0]), plan_.lines[i].nodes[1]);
    });
  }

  AtomicFile& file_;
  const Document& document_;
  const bool binary_;
  const Plan plan_;
  const PlyType *point_type_ = nullptr, *count_type_ = nullptr;
  int corners_ = 0;
};

}  // namespace

void write_ply(AtomicFile& file, const Document& document, bool binary) {
  Writer(file, document, binary).write();
}

Holds ply_holds(const Document& document, bool binary) {
  const Plan plan(document, binary);
  Holds holds;
  holds.title = title_in_lines(document.title);
  holds.tables = plan.tables_held;
  holds.nodes_each = Plan::ply_nodes;
  holds.kind = [](const ElementBlock& block) { return corners_kept(block) == 2 ? 1 : 0; };
  holds.values = [held = plan.held](const Values& values, Of) {
    return std::find(held.begin(), held.end(), &values) != held.end();
  };
  return holds;
}

}  // namespace tetproof::io
