// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/error.hpp"
#include "io/model/node_index.hpp"
#include "io/ply/ply.hpp"
#include "io/ply/ply_data.hpp"
#include "io/ply/ply_header.hpp"
#include "io/ply/ply_names.hpp"

namespace tetproof::io {
namespace {

void skip(PlyData& data, const PlyProperty& property) {
  const std::size_t numbers = property.count ? data.entries(property) : 1;
  for (std::size_t i = 0; i < numbers; ++i) data.number(*property.type);
}

bool names_corners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

// What a property of all instances of an element says.
struct Stored {
  std::vector<double> reals;
  std::vector<std::int64_t> integers;
  std::vector<std::int32_t> lengths;

  void read(PlyData& data, const PlyProperty& property) {
    const std::size_t numbers = property.count ? data.entries(property) : 1;
    if (property.count) lengths.push_back(static_cast<std::int32_t>(numbers));
    for (std::size_t i = 0; i < numbers; ++i)
      if (property.type->real)
        reals.push_back(data.number(*property.type));
      else
        integers.push_back(data.integer(*property.type, "an integer"));
  }
};

class Reader {
 public:
  Reader(const InputFile& file, Wanted wanted)
      : file_(file),
        surface_(wanted == Wanted::surface),
        scanner_(file),
        header_(read_ply_header(scanner_, file.bytes())),
        data_(scanner_, header_) {
    source_.text = header_.text;
    Document& document = source_.document;
    document.path = file.path(), document.format = "ply", document.first_node = 0;
    document.title = header_.title;
  }

  SurfaceDocument read() {
    choose();
    struct Later {
      const PlyElement* element;
      Scanner scanner;
    };
    std::vector<Later> later;  // what names points and stands above them
    bool points = false;
    for (const PlyElement& element : header_.elements) {
      if (&element == vertices_) {
        read_vertices();
        points = true;
      } else if ((&element == faces_ || &element == edges_) && !points) {
        later.push_back({&element, scanner_});
        skip_all(element);
      } else {
        read_other(element);
      }
    }
    data_.end(header_.elements.back());
    for (const Later& one : later) {
      scanner_ = one.scanner;
      read_other(*one.element);
    }
    join_values();
    return std::move(source_);
  }

 private:
  // Which elements are the points, faces and lines.
  void choose() {
    const auto has = [](const PlyElement& element, std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const PlyProperty& p) { return !p.count && p.name == name; });
    };
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") vertices_ = &element;
      if (element.name == "face" &&
          std::any_of(element.properties.begin(), element.properties.end(), names_corners))
        faces_ = &element;
      if (element.name == "edge" && !surface_ && has(element, "vertex1") && has(element, "vertex2"))
        edges_ = &element;
    }
    const auto lacks = [&](const std::string& what) {
      throw InputError(fmt::format("{}: expected {} in the header, found none", file_.path(), what));
    };
    if (!vertices_) lacks("an element 'vertex'");
    for (const char* axis : {"x", "y", "z"})
      if (!has(*vertices_, axis)) lacks(fmt::format("a property '{}' of element 'vertex'", axis));
    if (!faces_ && surface_) lacks("an element 'face' with a list 'vertex_indices' or 'vertex_index'");
  }

  void skip_all(const PlyElement& element) {
    if (element.properties.empty()) return;
    data_.begin(element);
    for (std::int64_t i = 0; i < element.count; ++i) {
      data_.start_instance();
      for (const PlyProperty& property : element.properties) skip(data_, property);
      data_.end_instance();
    }
  }

  void read_vertices() {
    const PlyElement& element = *vertices_;
    data_.begin(element);
    check_countable(file_.path(), static_cast<std::size_t>(element.count));
    std::vector<int> axis;  // of each property, -1 for none
    for (const PlyProperty& property : element.properties)
      axis.push_back(property.count         ? -1
                     : property.name == "x" ? 0
                     : property.name == "y" ? 1
                     : property.name == "z" ? 2
                                            : -1);
    std::vector<Stored> stored(axis.size());
    auto& points = source_.document.points;
    reserve_in_large_pages(points, static_cast<std::size_t>(element.count));
    for (std::int64_t i = 0; i < element.count; ++i) {
      data_.start_instance();
      Eigen::Vector3d& point = points.emplace_back();
      for (std::size_t k = 0; k < axis.size(); ++k)
        if (axis[k] >= 0)
          point[axis[k]] = data_.number(*element.properties[k].type);
        else if (surface_)
          skip(data_, element.properties[k]);
        else
          stored[k].read(data_, element.properties[k]);
      data_.end_instance();
    }
    give(
        element, stored, [&](std::size_t k) { return axis[k] < 0; }, source_.document.node_values, 0);
  }

  void read_other(const PlyElement& element) {
    if (&element == faces_)
      read_faces();
    else if (&element == edges_)
      read_edges();
    else if (surface_)
      skip_all(element);
    else
      read_table(element);
  }

  void read_faces() {
    const PlyElement& element = *faces_;
    Document& document = source_.document;
    data_.begin(element);
    NodeIndex nodes(document);
    const std::size_t first = document.elements();
    // No face with three corners is shorter.
    const std::size_t likely = std::min<std::size_t>(static_cast<std::size_t>(element.count),
                                                     data_.remaining() / (header_.text ? 8 : 4));
    reserve_in_large_pages(document.connectivity, 3 * likely);
    if (surface_) reserve_in_large_pages(source_.places, likely);
    std::size_t list = 0;
    while (!names_corners(element.properties[list])) ++list;
    std::vector<Stored> stored(element.properties.size());
    std::vector<Index> corners;
    for (std::int64_t i = 0; i < element.count; ++i) {
      const std::size_t place = data_.start_instance();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (k != list) {
          surface_ ? skip(data_, property) : stored[k].read(data_, property);
          continue;
        }
        corners.resize(data_.entries(property));
        for (Index& corner : corners) corner = nodes(data_.integer(*property.type, "a vertex"));
      }
      data_.end_instance();
      if (corners.size() < 3) {
        const Scanner start(file_.path(), file_.bytes(), place);
        const std::string message = fmt::format("face has {} corners, expected at least 3", corners.size());
        header_.text ? start.fail_in_line(message) : start.fail_at_byte(message);
      }
      if (surface_) source_.places.push_back(place);
      add_element(document, corners);
    }
    std::size_t texture = list;
    for (std::size_t k = 0; k < stored.size(); ++k)
      if (element.properties[k].name == "texcoord" && is_texture(stored[k], first)) texture = k;
    if (texture != list) {
      Values values{.name = "texture", .components = 2};
      values.reals = std::move(stored[texture].reals);
      for (const std::int32_t numbers : stored[texture].lengths) values.nodes.push_back(numbers / 2);
      values.first = first;
      document.element_node_values.push_back(std::move(values));
    }
    give(
        element, stored, [&](std::size_t k) { return k != list && k != texture; }, document.element_values,
        first);
  }

  // Two numbers for each corner of each face.
  bool is_texture(const Stored& stored, std::size_t first) const {
    const Document& document = source_.document;
    if (stored.lengths.empty() || stored.reals.empty()) return false;
    std::size_t i = 0;
    for (const ElementBlock& block : document.blocks)
      for (std::size_t e = 0; e < block.count && block.first >= first; ++e)
        if (stored.lengths[i++] != 2 * block.nodes_each) return false;
    return i == stored.lengths.size();
  }

  void read_edges() {
    const PlyElement& element = *edges_;
    Document& document = source_.document;
    data_.begin(element);
    NodeIndex nodes(document);
    const std::size_t first = document.elements();
    std::vector<Stored> stored(element.properties.size());
    const auto end = [](const PlyProperty& p) {
      return p.count ? -1 : p.name == "vertex1" ? 0 : p.name == "vertex2" ? 1 : -1;
    };
    for (std::int64_t i = 0; i < element.count; ++i) {
      data_.start_instance();
      std::array<Index, 2> ends{};
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const int which = end(property);
        if (which >= 0)
          ends[static_cast<std::size_t>(which)] = nodes(data_.integer(*property.type, "a vertex"));
        else
          stored[k].read(data_, property);
      }
      data_.end_instance();
      // Faces above and lines are never of one block.
      add_element(document, ends);
    }
    give(
        element, stored, [&](std::size_t k) { return end(element.properties[k]) < 0; },
        document.element_values, first);
  }

  static Column column_of(const PlyProperty& property, Stored& stored) {
    Column column;
    column.name = decode_name(property.name), column.type = property.type_words;
    column.reals = std::move(stored.reals), column.integers = std::move(stored.integers);
    column.lengths = std::move(stored.lengths);
    return column;
  }

  void read_table(const PlyElement& element) {
    data_.begin(element);
    std::vector<Stored> stored(element.properties.size());
    for (std::int64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      data_.start_instance();
      for (std::size_t k = 0; k < stored.size(); ++k) stored[k].read(data_, element.properties[k]);
      data_.end_instance();
    }
    Table& table = source_.document.tables.emplace_back();
    table.name = decode_name(element.name), table.rows = static_cast<std::size_t>(element.count);
    for (std::size_t k = 0; k < stored.size(); ++k)
      table.columns.push_back(column_of(element.properties[k], stored[k]));
  }

  // The properties of points, faces or lines: single numbers as values, lists as a table.
  void give(const PlyElement& element, std::vector<Stored>& stored,
            const std::function<bool(std::size_t)>& wanted, std::vector<Values>& all, std::size_t first) {
    if (surface_) return;
    std::vector<std::size_t> singles;
    std::vector<std::string> names;
    std::vector<bool> real;
    Table lists;
    for (std::size_t k = 0; k < stored.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (!wanted(k)) continue;
      if (property.count) {
        lists.columns.push_back(column_of(property, stored[k]));
      } else {
        singles.push_back(k), names.push_back(property.name), real.push_back(property.type->real);
      }
    }
    if (!lists.columns.empty()) {
      lists.name = element.name, lists.rows = static_cast<std::size_t>(element.count);
      source_.document.tables.push_back(std::move(lists));
    }
    if (element.count == 0) return;
    for (const PlyGroup& group : group_properties(names, real)) {
      Values values{.name = group.name, .components = static_cast<int>(group.components)};
      values.first = first;
      const auto weave = [&](auto member) {
        auto& to = values.*(member.first);
        if (group.components == 1) {
          to = std::move(stored[singles[group.first]].*(member.second));
          return;
        }
        to.reserve(group.components * static_cast<std::size_t>(element.count));
        for (std::size_t i = 0; i < static_cast<std::size_t>(element.count); ++i)
          for (std::size_t k = 0; k < group.components; ++k)
            to.push_back((stored[singles[group.first + k]].*(member.second))[i]);
      };
      if (real[group.first])
        weave(std::pair{&Values::reals, &Stored::reals});
      else
        weave(std::pair{&Values::integers, &Stored::integers});
      if (group.name == "color") warn_of_colours(source_.document, values, element.name.c_str());
      if (&all == &source_.document.element_values) {
        const auto word = names.begin() + static_cast<std::ptrdiff_t>(group.first);
        property_names_.emplace_back(word, word + static_cast<std::ptrdiff_t>(group.components));
      }
      all.push_back(std::move(values));
    }
  }

  // Values that both faces and lines have are one; those whose properties have different names are two, even
  // if these mean the same.
  void join_values() {
    auto& all = source_.document.element_values;
    std::map<std::pair<std::vector<std::string>, bool>, std::size_t> known;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [place, is_new] = known.try_emplace({property_names_[i], all[i].reals.empty()}, kept);
      Values& before = all[place->second];
      if (!is_new && before.first + before.items() == all[i].first) {
        before.reals.insert(before.reals.end(), all[i].reals.begin(), all[i].reals.end());
        before.integers.insert(before.integers.end(), all[i].integers.begin(), all[i].integers.end());
      } else {
        if (kept != i) all[kept] = std::move(all[i]);
        ++kept;
      }
    }
    all.resize(kept);
  }

  const InputFile& file_;
  const bool surface_;
  Scanner scanner_;
  const PlyHeader header_;
  PlyData data_;
  SurfaceDocument source_;
  std::vector<std::vector<std::string>> property_names_;  // of each of the values of elements
  const PlyElement *vertices_ = nullptr, *faces_ = nullptr, *edges_ = nullptr;
};

}  // namespace

SurfaceDocument read_ply(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
