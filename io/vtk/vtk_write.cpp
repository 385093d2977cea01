// SPDX-License-Identifier: GPL-3.0-or-later
// Writes VTK's legacy files, text and binary.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "io/bytes/byte_order.hpp"
#include "io/bytes/text_output.hpp"
#include "io/vtk/vtk.hpp"
#include "io/vtk/vtk_file_plan.hpp"
#include "io/vtk/vtk_mesh.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const VtkMesh& mesh, bool has_entities, bool binary)
      : file_(file), document_(document), mesh_(mesh), has_entities_(has_entities), binary_(binary) {}

  void write() {
    std::string title = document_.title.substr(0, longest_vtk_title);
    for (char& c : title)
      if (c == '\n' || c == '\r' || c == '\0') c = ' ';
    file_.write(fmt::format("# vtk DataFile Version 4.2\n{}\n{}\nDATASET UNSTRUCTURED_GRID\n", title,
                            binary_ ? "BINARY" : "ASCII"));
    file_.write(fmt::format("POINTS {} double\n", document_.points.size()));
    numbers<double>(3, 3 * document_.points.size(),
                    [&](std::size_t i) { return document_.points[i / 3][static_cast<int>(i % 3)]; });
    cells();
    if (!mesh_.field_data.empty()) {  // Gmsh reads no file in which this comes before the points
      file_.write(fmt::format("FIELD FieldData {}\n", mesh_.field_data.size()));
      for (const VtkArray& each : mesh_.field_data) array(each, each.type);
    }
    data("POINT_DATA", document_.points.size(), mesh_.point_data);
    data("CELL_DATA", mesh_.elements.size(), mesh_.cell_data);
  }

 private:
  void cells() {
    if (!mesh_.face_ends.empty()) put_faces_in_cells();
    const std::vector<Index>& connectivity = own_list_.empty() ? mesh_.connectivity : own_list_;
    const std::vector<std::int64_t>& ends = own_list_.empty() ? mesh_.ends : own_ends_;
    const std::size_t count = mesh_.elements.size(), size = connectivity.size() + count;
    file_.write(fmt::format("CELLS {} {}\n", count, size));
    const auto start = [&](std::size_t c) { return c == 0 ? 0 : ends[c - 1]; };
    if (binary_) {
      std::vector<std::int32_t> list;
      list.reserve(size);
      for (std::size_t c = 0; c < count; ++c) {
        list.push_back(static_cast<std::int32_t>(ends[c] - start(c)));
        list.insert(list.end(), connectivity.begin() + start(c), connectivity.begin() + ends[c]);
      }
      numbers<std::int32_t>(1, list.size(), [&](std::size_t i) { return list[i]; });
    } else {
      std::int64_t most = 0;
      for (std::size_t c = 0; c < count; ++c) most = std::max(most, ends[c] - start(c));
      write_items(file_, count, (static_cast<std::size_t>(most) + 1) * (longest_integer + 1),
                  [&](std::size_t c, char* to) {
                    to = put(to, ends[c] - start(c));
                    for (std::int64_t k = start(c); k < ends[c]; ++k)
                      to = put(put(to, ' '), std::int64_t{connectivity[static_cast<std::size_t>(k)]});
                    return put(to, '\n');
                  });
    }
    file_.write(fmt::format("CELL_TYPES {}\n", count));
    numbers<std::int32_t>(1, count, [&](std::size_t i) { return std::int32_t{mesh_.types[i]}; });
  }

  // In a legacy file the faces of a polyhedron stand in place of its points.
  void put_faces_in_cells() {
    std::int64_t start = 0, of_faces = 0;
    for (std::size_t c = 0; c < mesh_.ends.size(); ++c) {
      if (mesh_.face_ends[c] >= 0) {
        for (std::int64_t k = of_faces; k < mesh_.face_ends[c]; ++k)
          own_list_.push_back(static_cast<Index>(mesh_.faces[static_cast<std::size_t>(k)]));
        of_faces = mesh_.face_ends[c];
      } else {
        own_list_.insert(own_list_.end(), mesh_.connectivity.begin() + start,
                         mesh_.connectivity.begin() + mesh_.ends[c]);
      }
      start = mesh_.ends[c];
      own_ends_.push_back(static_cast<std::int64_t>(own_list_.size()));
    }
  }

  static bool all_int(const VtkArray& array) {
    return std::all_of(array.integers.begin(), array.integers.end(), [](std::int64_t value) {
      return value >= std::numeric_limits<std::int32_t>::min() &&
             value <= std::numeric_limits<std::int32_t>::max();
    });
  }

  void data(const char* keyword, std::size_t items, const std::vector<VtkArray>& arrays) {
    if (arrays.empty()) return;
    file_.write(fmt::format("{} {}\n", keyword, items));
    std::size_t fields = arrays.size();
    if (has_entities_ && &arrays == &mesh_.cell_data) {  // as Gmsh writes it
      const char* type = all_int(arrays[0]) ? "Int32" : "Int64";
      file_.write(fmt::format("SCALARS CellEntityIds {} 1\nLOOKUP_TABLE default\n", vtk_word_of_type(type)));
      body(arrays[0], type);
      --fields;
    }
    std::vector<const VtkArray*> in_field;
    bool any_role = false;
    std::set<std::string_view> given;  // VTK takes the first of a role
    for (std::size_t a = arrays.size() - fields; a < arrays.size(); ++a)
      if (arrays[a].attribute.empty() || !given.insert(arrays[a].roles[0]).second) {
        in_field.push_back(&arrays[a]);
      } else {
        attribute(arrays[a]);
        any_role = true;
      }
    // Without a FIELD, an attribute could as well be just how the array is written.
    if (in_field.empty() && !any_role) return;
    file_.write(fmt::format("FIELD FieldData {}\n", in_field.size()));
    for (const VtkArray* each : in_field) array(*each, type_of(*each));
  }

  static std::string type_of(const VtkArray& array) {
    return array.type == "Int64" && all_int(array) ? "Int32" : array.type;
  }

  void attribute(const VtkArray& array) {
    const std::string type = type_of(array);
    file_.write(fmt::format("{} {}", array.attribute, vtk_encoded(array.name)));
    if (array.attribute == "TEXTURE_COORDINATES") file_.write(fmt::format(" {}", array.components));
    file_.write(fmt::format(" {}", vtk_word_of_type(type)));
    if (array.attribute == "SCALARS") file_.write(fmt::format(" {}\nLOOKUP_TABLE default", array.components));
    file_.write("\n");
    body(array, type);
  }

  void array(const VtkArray& array, const std::string& type) {
    file_.write(fmt::format("{} {} {} {}\n", vtk_encoded(array.name), array.components,
                            array.size() / static_cast<std::size_t>(array.components),
                            vtk_word_of_type(type)));
    body(array, type);
  }

  void body(const VtkArray& array, const std::string& type) {
    if (type == "String") return strings(array);
    with_number_type(type, [&](auto like) {
      using T = decltype(like);
      numbers<T>(array.components, array.size(), [&](std::size_t i) {
        return array.integers.empty() ? static_cast<T>(array.reals[i]) : static_cast<T>(array.integers[i]);
      });
    });
  }

  void strings(const VtkArray& array) {
    for (const std::string& text : array.texts) {
      if (!binary_) {
        file_.write(vtk_encoded(text) + "\n");
        continue;
      }
      char length[4];
      const auto size = static_cast<std::uint32_t>(text.size());
      if (size < 1U << 6) {
        store(length, static_cast<std::uint8_t>(3U << 6 | size), std::endian::big);
        file_.write({length, 1});
      } else if (size < 1U << 14) {
        store(length, static_cast<std::uint16_t>(2U << 14 | size), std::endian::big);
        file_.write({length, 2});
      } else {
        store(length, 1U << 30 | size, std::endian::big);
        file_.write({length, 4});
      }
      file_.write(text);
    }
    if (binary_) file_.write("\n");
  }

  // Writes `value(i)` as type T for i in 0 .. count-1; in text, `components` of them in a line.
  template <class T, class Value>
  void numbers(int components, std::size_t count, const Value& value) {
    if (binary_) {
      write_items(file_, count, sizeof(T), [&](std::size_t i, char* to) {
        return store(to, static_cast<T>(value(i)), std::endian::big);
      });
      file_.write("\n");
      return;
    }
    const auto each = static_cast<std::size_t>(components);
    write_items(file_, count / each, each * (longest_real + 1), [&](std::size_t item, char* to) {
      for (std::size_t k = 0; k < each; ++k) {
        const T one = value(item * each + k);
        if constexpr (std::is_floating_point_v<T>)
          to = put(to, static_cast<double>(one));
        else if constexpr (std::is_same_v<T, std::uint64_t>)
          to = std::to_chars(to, to + longest_integer, one).ptr;
        else
          to = put(to, static_cast<std::int64_t>(one));
        to = put(to, k + 1 < each ? ' ' : '\n');
      }
      return to;
    });
  }

  AtomicFile& file_;
  const Document& document_;
  const VtkMesh& mesh_;
  const bool has_entities_;  // as the first cell data
  const bool binary_;
  std::vector<Index> own_list_;  // the cells, where polyhedra are among them
  std::vector<std::int64_t> own_ends_;
};

class LegacyPlan : public VtkFilePlan {
 public:
  LegacyPlan(const Document& document, bool binary) : VtkFilePlan(document, "CellEntityIds", binary) {
    holds_ = vtk_holds(document, plan_);
  }

  std::string warning(const std::string& path) override {
    if (binary_) return {};
    const std::string where =
        first_place_of([](double value) { return !std::isfinite(value); }, document_, mesh());
    return where.empty() ? ""
                         : fmt::format(
                               "{}: {} has nan or inf, which VTK itself reads in binary, but not in text, "
                               "where it misreads all that follows",
                               path, where);
  }

 private:
  void write_into(AtomicFile& file) override {
    Writer(file, document_, mesh(), !plan_.entities.empty(), binary_).write();
  }
};

}  // namespace

std::unique_ptr<FilePlan> plan_vtk(const Document& document, bool binary) {
  return std::make_unique<LegacyPlan>(document, binary);
}

}  // namespace tetproof::io
