// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "io/bytes/large_pages.hpp"
#include "io/bytes/scanner.hpp"
#include "io/bytes/tokens.hpp"
#include "io/bytes/words.hpp"
#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/model/node_index.hpp"
#include "io/ply/ply.hpp"
#include "io/ply/ply_data.hpp"
#include "io/ply/ply_header.hpp"
#include "io/ply/ply_properties.hpp"
#include "io/ply/ply_strips.hpp"
#include "io/surface/surface_document.hpp"

namespace tetproof::io {
namespace {

class Reader {
 public:
  Reader(const InputFile& file, Wanted wanted)
      : file_(file),
        surface_(wanted == Wanted::surface),
        scanner_(file),
        header_(read_ply_header(scanner_, file.bytes())),
        data_(file, scanner_, header_) {
    source_.text = header_.text;
    Document& document = source_.document;
    document.path = file.path(), document.format = "ply", document.first_node = 0;
    document.title = header_.title;
    if (const std::string warning = header_.text ? warning_of_end(file) : ""; !warning.empty())
      document.warnings.push_back(warning);
  }

  ReadDocument read() {
    choose();
    struct Later {
      const PlyElement* element;
      Scanner scanner;
    };
    // Elements that name points, and stand above these. Lines come behind the faces, as they are written:
    // their order in the file says nothing.
    std::vector<Later> later;
    bool points = false;
    std::size_t faces_left = (faces_ != nullptr) + (strips_ != nullptr);
    for (const PlyElement& element : header_.elements) {
      if (&element == vertices_) {
        read_vertices();
        points = true;
        continue;
      }
      const bool has_faces = &element == faces_ || &element == strips_;
      if (points ? &element == edges_ && faces_left > 0 : has_faces || &element == edges_) {
        later.push_back({&element, scanner_});
        skip_element(data_, element);
        continue;
      }
      read_other(element);
      faces_left -= has_faces;
    }
    data_.end(source_.document);
    std::stable_partition(later.begin(), later.end(),
                          [&](const Later& one) { return one.element != edges_; });
    for (const Later& one : later) {
      scanner_ = one.scanner;
      read_other(*one.element);
    }
    properties_.join_values();
    return std::move(source_);
  }

 private:
  // Finds the elements that are the points, faces, strips of triangles and lines.
  void choose() {
    const auto has = [](const PlyElement& element, std::string_view name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [&](const PlyProperty& p) { return !p.count && p.name == name; });
    };
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") vertices_ = &element;
      const bool has_corners =
          std::any_of(element.properties.begin(), element.properties.end(), names_corners);
      if (element.name == "face" && has_corners) faces_ = &element;
      if (element.name == "tristrips" && has_corners) strips_ = &element;
      if (element.name == "edge" && !surface_ && has(element, "vertex1") && has(element, "vertex2"))
        edges_ = &element;
    }
    const auto lacks = [&](const std::string& what) {
      throw InputError(fmt::format("{}: expected {} in the header, found none", file_.path(), what));
    };
    if (!vertices_) lacks("an element 'vertex'");
    for (const char* axis : {"x", "y", "z"})
      if (!has(*vertices_, axis)) lacks(fmt::format("a property '{}' of element 'vertex'", axis));
    if (!faces_ && !strips_ && surface_)
      lacks("an element 'face' with a list 'vertex_indices' or 'vertex_index'");
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
    std::vector<PlyStored> stored(axis.size());
    auto& points = source_.document.points;
    reserve_in_large_pages(points, static_cast<std::size_t>(element.count));
    for (std::int64_t i = 0; i < element.count; ++i) {
      data_.start_instance();
      Eigen::Vector3d& point = points.emplace_back();
      for (std::size_t k = 0; k < axis.size(); ++k)
        if (axis[k] >= 0)
          point[axis[k]] = data_.number(*element.properties[k].type);
        else if (surface_)
          skip_property(data_, element.properties[k]);
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
    else if (&element == strips_)
      read_strips();
    else if (&element == edges_)
      read_edges();
    else if (surface_)
      skip_element(data_, element);
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
    std::vector<PlyStored> stored(element.properties.size());
    std::vector<Index> corners;
    for (std::int64_t i = 0; i < element.count; ++i) {
      const std::size_t place = data_.start_instance();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (k != list) {
          surface_ ? skip_property(data_, property) : stored[k].read(data_, property);
          continue;
        }
        corners.resize(data_.entries(property));
        for (Index& corner : corners) corner = nodes(data_.integer(*property.type, "a vertex"));
      }
      data_.end_instance();
      // A document has them as lines and points, as meshio does.
      if (corners.size() < (surface_ ? 3u : 1u)) {
        const Scanner start(file_.path(), file_.bytes(), place);
        const std::string message =
            fmt::format("face has {}, expected at least 3", counted(corners.size(), "corners"));
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

  void read_strips() {
    const PlyElement& element = *strips_;
    Document& document = source_.document;
    data_.begin(element);
    NodeIndex nodes(document);
    for (std::int64_t i = 0; i < element.count; ++i) {
      const std::size_t place = data_.start_instance();
      std::vector<std::int64_t> strip;
      for (const PlyProperty& property : element.properties) {
        if (!names_corners(property)) {
          skip_property(data_, property);
          continue;
        }
        strip.resize(data_.entries(property));
        for (std::int64_t& corner : strip) corner = data_.integer(*property.type, "a vertex or -1");
      }
      data_.end_instance();
      for (const auto& [a, b, c] : triangles_of_strip(strip)) {
        if (surface_) source_.places.push_back(place);
        add_element(document, std::array{nodes(a), nodes(b), nodes(c)});
      }
    }
    if (surface_) return;
    for (const PlyProperty& property : element.properties)
      if (!names_corners(property))
        add_loss(document.dropped, "properties of tristrips", 1, shown_name(property.name));
  }

  // Whether a list has two numbers for each corner of each face.
  bool is_texture(const PlyStored& stored, std::size_t first) const {
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
    std::vector<PlyStored> stored(element.properties.size());
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

  void read_table(const PlyElement& element) {
    data_.begin(element);
    std::vector<PlyStored> stored(element.properties.size());
    for (std::int64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      data_.start_instance();
      for (std::size_t k = 0; k < stored.size(); ++k) stored[k].read(data_, element.properties[k]);
      data_.end_instance();
    }
    properties_.give_table(element, stored);
  }

  void give(const PlyElement& element, std::vector<PlyStored>& stored,
            const std::function<bool(std::size_t)>& wanted, std::vector<Values>& all, std::size_t first) {
    if (!surface_) properties_.give(element, stored, wanted, all, first);
  }

  const InputFile& file_;
  const bool surface_;
  Scanner scanner_;
  const PlyHeader header_;
  PlyData data_;
  ReadDocument source_;
  PlyProperties properties_{source_.document};
  const PlyElement *vertices_ = nullptr, *faces_ = nullptr, *strips_ = nullptr, *edges_ = nullptr;
};

}  // namespace

ReadDocument read_ply(const InputFile& file, Wanted wanted) {
  return Reader(file, wanted).read();
}

}  // namespace tetproof::io
