// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ as text: points, what corners have, and elements below what holds for them.
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include "io/bytes/tokens.hpp"
#include "io/obj/obj.hpp"
#include "io/obj/obj_names.hpp"
#include "io/surface/surface_lines.hpp"

namespace tetproof::io {
namespace {

// Values of corners as OBJ lists them: each row once, and the number of the row at every corner.
struct CornerRows {
  const Values* values = nullptr;
  std::vector<std::size_t> rows;        // the first item with these numbers
  std::vector<Index> row_of;            // by item; from 0
  std::vector<std::size_t> first_item;  // by element; npos: none
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  void take(const Values& given, std::size_t elements) {
    values = &given;
    first_item.assign(elements, npos);
    std::size_t item = 0;
    for (std::size_t i = 0; i < given.nodes.size(); ++i) {
      first_item[given.at.empty() ? i : static_cast<std::size_t>(given.at[i])] = item;
      item += static_cast<std::size_t>(given.nodes[i]);
    }
    using Bits = std::array<std::uint64_t, 3>;
    struct Hash {
      std::size_t operator()(const Bits& bits) const {
        std::uint64_t h = 0;
        for (const std::uint64_t b : bits) h = (h ^ b ^ (h >> 32)) * 0xd6e8feb86659fd93u;
        return h ^ (h >> 32);
      }
    };
    std::unordered_map<Bits, Index, Hash> known;
    const auto each = static_cast<std::size_t>(given.components);
    row_of.reserve(item);
    for (std::size_t i = 0; i < item; ++i) {
      Bits bits{};
      for (std::size_t k = 0; k < each; ++k)
        bits[k] = std::bit_cast<std::uint64_t>(given.reals[i * each + k]);
      const auto [place, is_new] = known.try_emplace(bits, static_cast<Index>(rows.size()));
      if (is_new) rows.push_back(i);
      row_of.push_back(place->second);
    }
  }
};

// Whether these are values of all corners of faces, and of nothing else.
bool of_corners(const Document& document, const Values& values) {
  const std::size_t elements = document.elements();
  if (values.nodes.empty() || values.components < 1 || values.reals.empty() || !values.integers.empty() ||
      !values.labels.empty() || values.first != 0 || has_step(values))
    return false;
  if (values.at.empty() ? values.nodes.size() != elements
                        : values.nodes.size() != values.at.size() || values.at.size() >= elements)
    return false;
  std::size_t items = 0, i = 0;
  for (const ElementBlock& block : document.blocks) {
    const bool face = block.dim == 2 && corners_kept(block) == block.nodes_each;
    for (std::size_t e = block.first; e < block.first + block.count; ++e) {
      const bool here = values.at.empty() || (i < values.at.size() && values.at[i] == static_cast<Index>(e));
      if (!here) continue;
      if (!face || values.nodes[i] != block.nodes_each) return false;
      items += static_cast<std::size_t>(values.nodes[i++]);
    }
  }
  return i == values.nodes.size() &&
         values.reals.size() == items * static_cast<std::size_t>(values.components);
}

// Whether each element has one of the labels, and these stand in the order of their first use.
bool of_labels(const Document& document, const Values& values) {
  const std::size_t elements = document.elements();
  if (values.components != 1 || values.labels.empty() || values.integers.size() != elements || elements == 0)
    return false;
  Values numbers;  // whether the rest is plain
  numbers.integers = values.integers, numbers.first = values.first, numbers.at = values.at;
  numbers.nodes = values.nodes, numbers.of_view = values.of_view, numbers.time = values.time;
  numbers.step = values.step, numbers.partition = values.partition, numbers.reals = values.reals;
  numbers.interpolation = values.interpolation;
  if (!of_all(numbers, elements)) return false;
  std::int64_t next = 0;
  for (const std::int64_t label : values.integers) {
    if (label < 0 || label > next) return false;
    next += label == next;
  }
  std::unordered_set<std::string_view> different(values.labels.begin(), values.labels.end());
  return static_cast<std::size_t>(next) == values.labels.size() && different.size() == values.labels.size();
}

bool is_libraries(const Table& table) {
  if (table.name != "mtllib" || table.columns.size() != 1) return false;
  const Column& column = table.columns[0];
  return column.name == "file" && column.type == "text" && column.components == 1 && column.reals.empty() &&
         column.integers.empty() && column.lengths.empty() && !column.texts.empty() &&
         column.texts.size() == table.rows &&
         std::none_of(column.texts.begin(), column.texts.end(),
                      [](const std::string& t) { return t.empty(); });
}

// The values that OBJ has a place for.
struct Kept {
  RowsOf behind;  // colours and weights
  CornerRows texture, normal;
  const Values *object = nullptr, *material = nullptr, *smoothing = nullptr;

  explicit Kept(const Document& document) : behind(document.points.size()) {
    for (const Values& values : document.node_values) {
      const int each = values.components;
      if (values.integers.empty() &&
          ((values.name == "color" && (each == 3 || each == 4)) || (values.name == "weight" && each == 1)))
        behind.add(values);
    }
    for (const Values& values : document.element_node_values) {
      const int each = values.components;
      const bool is_texture = values.name == "texture" && (each == 2 || each == 3);
      const bool is_normal = values.name == "normal" && each == 3;
      CornerRows& place = is_texture ? texture : normal;
      if ((is_texture || is_normal) && !place.values && of_corners(document, values))
        place.take(values, document.elements());
    }
    for (const Values& values : document.element_values) {
      if (values.name == "object" && !object && of_labels(document, values)) object = &values;
      if (values.name == "material" && !material && of_labels(document, values)) material = &values;
      if (values.name == "smoothing" && !smoothing && values.components == 1 && values.reals.empty() &&
          of_all(values, document.elements()) &&
          std::any_of(values.integers.begin(), values.integers.end(), [](std::int64_t n) { return n != 0; }))
        smoothing = &values;
    }
  }

  std::vector<const Values*> all(bool elements) const {
    std::vector<const Values*> held = behind.held();
    if (elements) held.insert(held.end(), {texture.values, normal.values, object, material, smoothing});
    return held;
  }
};

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document)
      : file_(file), document_(document), kept_(document), words_(document) {}

  void write() {
    write_title(file_, "#", title_in_lines(document_.title) ? document_.title : "");
    for (const Table& table : document_.tables)
      if (is_libraries(table))
        for (const std::string& name : table.columns[0].texts)
          file_.write(fmt::format("mtllib {}\n", encode_name(name)));
    write_points();
    write_rows("vt", kept_.texture);
    write_rows("vn", kept_.normal);
    for (const auto& [word, number] : words_.numbered())
      file_.write(fmt::format("{}{} {}\n", group_comment, number, word));
    write_elements();
  }

 private:
  void write_points() {
    write_items(file_, document_.points.size(), 2 + 7 * (longest_real + 1), [&](std::size_t i, char* to) {
      to = put_point(put(to, "v "), document_.points[i]);
      std::size_t row = 0;
      if (const Values* values = kept_.behind.find(i, row))
        for (int k = 0; k < values->components; ++k)
          to = put(put(to, ' '), values->reals[row * static_cast<std::size_t>(values->components) +
                                               static_cast<std::size_t>(k)]);
      return put(to, '\n');
    });
  }

  void write_rows(std::string_view statement, const CornerRows& corners) {
    write_items(file_, corners.rows.size(), 4 + 3 * (longest_real + 1), [&](std::size_t i, char* to) {
      to = put(to, statement);
      const auto each = static_cast<std::size_t>(corners.values->components);
      for (std::size_t k = 0; k < each; ++k)
        to = put(put(to, ' '), corners.values->reals[corners.rows[i] * each + k]);
      return put(to, '\n');
    });
  }

  // Says what holds from this element on and did not before.
  void say_state(const ElementBlock& block, std::size_t element) {
    const auto label = [&](const Values* values, const char* statement, std::int64_t& now) {
      if (!values || values->integers[element] == now) return;
      const std::int64_t before = now;
      now = values->integers[element];
      const std::string& name = values->labels[static_cast<std::size_t>(now)];
      if (before < 0 && name.empty() && values->labels.size() > 1) return;  // as it is without a statement
      file_.write(fmt::format("{}{}{}\n", statement, name.empty() ? "" : " ", encode_name(name, true)));
    };
    label(kept_.object, "o", object_);
    const std::pair<int, std::int32_t> groups{block.dim, block.groups};
    if (groups != groups_ && (block.groups != 0 || groups_.second != 0)) {
      std::string line = "g";
      for (const std::int64_t group : document_.tag_sets[static_cast<std::size_t>(block.groups)])
        line.append(" ").append(words_.word(block.dim, group));
      file_.write(line + "\n");
    }
    groups_ = groups;
    label(kept_.material, "usemtl", material_);
    if (kept_.smoothing && kept_.smoothing->integers[element] != smoothing_) {
      smoothing_ = kept_.smoothing->integers[element];
      file_.write(smoothing_ == 0 ? "s off\n" : fmt::format("s {}\n", smoothing_));
    }
  }

  bool same_state(std::size_t a, std::size_t b) const {
    for (const Values* values : {kept_.object, kept_.material, kept_.smoothing})
      if (values && values->integers[a] != values->integers[b]) return false;
    return true;
  }

  void write_elements() {
    std::vector<KeptElement> run;
    for (const ElementBlock& block : document_.blocks) {
      const int corners = corners_kept(block);
      if (corners == 0) continue;
      for (std::size_t e = 0; e < block.count;) {
        const std::size_t first = block.first + e;
        run.clear();
        for (; e < block.count && same_state(first, block.first + e); ++e) {
          const Index* node =
              document_.connectivity.data() + block.nodes + e * static_cast<std::size_t>(block.nodes_each);
          if (nodes_exist(node, block.nodes_each)) run.push_back({block.first + e, corners, node});
        }
        if (run.empty()) continue;
        say_state(block, first);
        write_run(run);
      }
    }
  }

  void write_run(const std::vector<KeptElement>& run) {
    const int corners = run[0].corners;
    const std::string_view statement = corners == 1 ? "p" : corners == 2 ? "l" : "f";
    write_items(file_, run.size(), 3 + static_cast<std::size_t>(corners) * 36, [&](std::size_t i, char* to) {
      to = put(to, statement);
      const auto row = [&](const CornerRows& rows, int k) -> std::int64_t {
        const std::size_t first = rows.values ? rows.first_item[run[i].element] : CornerRows::npos;
        return first == CornerRows::npos ? 0
                                         : 1 + std::int64_t{rows.row_of[first + static_cast<std::size_t>(k)]};
      };
      for (int k = 0; k < corners; ++k) {
        to = put(put(to, ' '), std::int64_t{run[i].nodes[k]} + 1);
        const std::int64_t t = row(kept_.texture, k), n = row(kept_.normal, k);
        if (t > 0 || n > 0) to = put(to, '/');
        if (t > 0) to = put(to, t);
        if (n > 0) to = put(put(to, '/'), n);
      }
      return put(to, '\n');
    });
  }

  AtomicFile& file_;
  const Document& document_;
  const Kept kept_;
  std::int64_t object_ = -1, material_ = -1, smoothing_ = 0;
  std::pair<int, std::int32_t> groups_{2, 0};
  const GroupWords words_;
};

}  // namespace

void write_obj(AtomicFile& file, const Document& document, bool) {
  Writer(file, document).write();
}

Holds obj_holds(const Document& document, bool) {
  Holds holds;
  holds.title = title_in_lines(document.title);
  holds.nodes_each = corners_kept;
  holds.tables = document.tables.empty() || (document.tables.size() == 1 && is_libraries(document.tables[0]));
  const std::vector<const Values*> held = Kept(document).all(keeps_all_elements(document, corners_kept));
  holds.values = [held](const Values& values, Of) {
    return std::find(held.begin(), held.end(), &values) != held.end();
  };
  holds.groups = Holds::Groups::all;
  const GroupWords words(document);
  holds.name = [words](const GroupName& name) { return words.holds(name); };
  return holds;
}

}  // namespace tetproof::io
