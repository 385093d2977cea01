// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/vtk/vtk_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/model/node_order.hpp"
#include "io/surface/surface_document.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

class Maker {
 public:
  Maker(const Document& document, const VtkPlan& plan)
      : document_(document), has_entities_(!plan.entities.empty()) {
    cells();
    for (std::size_t k = 0; k < plan.node_values.size(); ++k)
      add_values(mesh_.point_data, plan.node_values[k], document.node_values[k], nullptr,
                 document.points.size());
    if (!plan.entities.empty())
      of_blocks(plan.entities, [](const ElementBlock& block) { return block.entity; });
    for (std::size_t k = 0; k < plan.groups.size(); ++k)
      of_blocks(plan.groups[k], [&](const ElementBlock& block) {
        const auto& tags = document.tag_sets[static_cast<std::size_t>(block.groups)];
        return k < tags.size() ? tags[k] : 0;
      });
    if (plan.negative) add_negative(*plan.negative, plan.groups[0]);
    for (std::size_t k = 0; k < plan.element_values.size(); ++k)
      if (&document.element_values[k] != plan.negative)
        add_values(mesh_.cell_data, plan.element_values[k], document.element_values[k], &mesh_.elements,
                   document.elements());
    for (const VtkPlan::Field& field : plan.fields) add_field(*field.column, field.name);
  }

  VtkMesh mesh() { return std::move(mesh_); }

 private:
  void cells() {
    for (const ElementBlock& block : document_.blocks) {
      const VtkCell cell = vtk_cell(block);
      if (cell.type == 0) continue;
      const auto order = cell.nodes == block.nodes_each
                             ? node_order(block.type, NodeOrder::vtk)
                             : node_order(gmsh_type_of_cell(cell.type, static_cast<std::size_t>(cell.nodes)),
                                          NodeOrder::vtk);
      for (std::size_t e = 0; e < block.count; ++e) {
        const Index* nodes = document_.connectivity.data() + block.nodes + e * block.nodes_each;
        if (!nodes_exist(nodes, block.nodes_each)) continue;
        mesh_.elements.push_back(block.first + e);
        mesh_.types.push_back(static_cast<unsigned char>(cell.type));
        for (int k = 0; k < cell.nodes; ++k)
          mesh_.connectivity.push_back(nodes[order.empty() ? k : order[k]]);
        mesh_.ends.push_back(static_cast<std::int64_t>(mesh_.connectivity.size()));
        if (cell.type == vtk_polyhedron) add_faces(block, nodes);
      }
    }
    if (!mesh_.face_ends.empty()) mesh_.face_ends.resize(mesh_.types.size(), -1);
  }

  void add_faces(const ElementBlock& block, const Index* nodes) {
    const std::size_t first = mesh_.faces.size();
    mesh_.faces.push_back(0);
    for (std::size_t at = 0; at < block.faces.size(); ++mesh_.faces[first]) {
      const std::int32_t corners = block.faces[at++];
      mesh_.faces.push_back(corners);
      for (std::int32_t k = 0; k < corners; ++k) mesh_.faces.push_back(nodes[block.faces[at++]]);
    }
    mesh_.face_ends.resize(mesh_.types.size() - 1, -1);
    mesh_.face_ends.push_back(static_cast<std::int64_t>(mesh_.faces.size()));
  }

  // Adds an array for values of `items` nodes or elements. `written`: the positions of those that are
  // written; null: all are.
  void add_values(std::vector<VtkArray>& to, const std::string& name, const Values& values,
                  const std::vector<std::size_t>* written, std::size_t items) {
    if (values.components < 1 || !values.nodes.empty()) return;
    VtkArray array{.name = name, .components = values.components, .roles = values.roles};
    if (has_vtk_role(values, written && has_entities_))
      array.attribute = vtk_word_of_role(values.roles[0], values.components);
    if (are_texts(values, items)) return add_texts(to, std::move(array), values, written);
    const bool whole = covers(values, items) && (!written || written->size() == items);
    const auto take = [&](const auto& from, auto& own, auto& span, auto filler) {
      if (whole) {
        span = from;
        return;
      }
      const auto each = static_cast<std::size_t>(values.components);
      auto all = std::remove_cvref_t<decltype(from)>(items * each, filler);
      for (std::size_t k = 0; k < std::min(values.items(), from.size() / each); ++k) {
        const std::int64_t at =
            values.at.empty() ? static_cast<std::int64_t>(values.first + k) : std::int64_t{values.at[k]};
        if (at < 0 || at >= static_cast<std::int64_t>(items)) continue;
        std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(k * each), each,
                    all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(at) * each));
      }
      if (written && written->size() != items) {
        std::size_t n = 0;
        for (const std::size_t e : *written)
          for (std::size_t c = 0; c < each; ++c) all[n++] = all[e * each + c];
        all.resize(n);
      }
      own.push_back(std::move(all));
      span = own.back();
    };
    if (values.integers.empty())
      take(values.reals, mesh_.own_reals, array.reals, std::numeric_limits<double>::quiet_NaN());
    else
      take(values.integers, mesh_.own_integers, array.integers, std::int64_t{0});
    if (!values.integers.empty()) array.type = "Int64";
    to.push_back(std::move(array));
  }

  void add_texts(std::vector<VtkArray>& to, VtkArray&& array, const Values& values,
                 const std::vector<std::size_t>* written) {
    std::vector<std::string>& texts = mesh_.own_texts.emplace_back();
    const auto each = static_cast<std::size_t>(values.components);
    const std::size_t count = written ? written->size() : values.integers.size() / each;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < each; ++k)
        texts.push_back(
            values
                .labels[static_cast<std::size_t>(values.integers[(written ? (*written)[i] : i) * each + k])]);
    array.type = "String";
    array.texts = texts;
    to.push_back(std::move(array));
  }

  template <class Of>
  void of_blocks(const std::string& name, const Of& of) {
    std::vector<std::int64_t> values;
    values.reserve(mesh_.elements.size());
    std::size_t b = 0;
    for (const std::size_t e : mesh_.elements) {
      while (e >= document_.blocks[b].first + document_.blocks[b].count) ++b;
      values.push_back(of(document_.blocks[b]));
    }
    mesh_.own_integers.push_back(std::move(values));
    mesh_.cell_data.push_back({.name = name, .type = "Int64", .integers = mesh_.own_integers.back()});
  }

  // Puts negative numbers into the array of groups, in which they stood.
  void add_negative(const Values& values, const std::string& groups) {
    const auto array = std::find_if(mesh_.cell_data.begin(), mesh_.cell_data.end(),
                                    [&](const VtkArray& one) { return one.name == groups; });
    std::vector<std::int64_t> all(array->integers.begin(), array->integers.end());
    std::size_t k = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      while (k < values.at.size() && static_cast<std::size_t>(values.at[k]) < mesh_.elements[i]) ++k;
      if (k < values.at.size() && static_cast<std::size_t>(values.at[k]) == mesh_.elements[i])
        all[i] = values.integers[k];
    }
    mesh_.own_integers.push_back(std::move(all));
    array->integers = mesh_.own_integers.back();
  }

  void add_field(const Column& column, const std::string& name) {
    VtkArray array{.name = name,
                   .components = column.components,
                   .reals = column.reals,
                   .integers = column.integers,
                   .texts = column.texts};
    array.type = fits_its_type(column)      ? column.type
                 : !column.texts.empty()    ? "String"
                 : !column.integers.empty() ? "Int64"
                                            : "Float64";
    mesh_.field_data.push_back(std::move(array));
  }

  const Document& document_;
  const bool has_entities_;
  VtkMesh mesh_;
};

}  // namespace

VtkMesh vtk_mesh(const Document& document, const VtkPlan& plan) {
  return Maker(document, plan).mesh();
}

std::string first_place_of(bool (*wanted)(double), const Document& document, const VtkMesh& mesh) {
  for (const Eigen::Vector3d& point : document.points)
    if (std::any_of(point.begin(), point.end(), wanted)) return "a point";
  const std::pair<const char*, const std::vector<VtkArray>*> kinds[] = {
      {"point", &mesh.point_data}, {"cell", &mesh.cell_data}, {"field", &mesh.field_data}};
  for (const auto& [kind, arrays] : kinds)
    for (const VtkArray& array : *arrays)
      if (std::any_of(array.reals.begin(), array.reals.end(), wanted))
        return fmt::format("{} data \"{}\"", kind, array.name);
  return {};
}

}  // namespace tetproof::io
