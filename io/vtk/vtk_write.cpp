// SPDX-License-Identifier: GPL-3.0-or-later
// Writes VTK's legacy files, text and binary.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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
  Writer(AtomicFile& file, const Document& document, const VtkMesh& mesh, bool binary)
      : file_(file), document_(document), mesh_(mesh), binary_(binary) {}

  void write() {
    std::string title = document_.title.substr(0, longest_vtk_title);
    for (char& c : title)
      if (c == '\n' || c == '\r' || c == '\0') c = ' ';
    file_.write(fmt::format("# vtk DataFile Version 4.2\n{}\n{}\nDATASET UNSTRUCTURED_GRID\n", title,
                            binary_ ? "BINARY" : "ASCII"));
    if (!mesh_.field_data.empty()) {
      file_.write(fmt::format("FIELD FieldData {}\n", mesh_.field_data.size()));
      for (const VtkArray& each : mesh_.field_data) array(each, each.type);
    }
    file_.write(fmt::format("POINTS {} double\n", document_.points.size()));
    numbers<double>(3, 3 * document_.points.size(),
                    [&](std::size_t i) { return document_.points[i / 3][static_cast<int>(i % 3)]; });
    cells();
    data("POINT_DATA", document_.points.size(), mesh_.point_data);
    data("CELL_DATA", mesh_.elements.size(), mesh_.cell_data);
  }

 private:
  void cells() {
    const std::size_t count = mesh_.elements.size(), size = mesh_.connectivity.size() + count;
    file_.write(fmt::format("CELLS {} {}\n", count, size));
    const auto start = [&](std::size_t c) { return c == 0 ? 0 : mesh_.ends[c - 1]; };
    if (binary_) {
      std::vector<std::int32_t> list;
      list.reserve(size);
      for (std::size_t c = 0; c < count; ++c) {
        list.push_back(static_cast<std::int32_t>(mesh_.ends[c] - start(c)));
        list.insert(list.end(), mesh_.connectivity.begin() + start(c),
                    mesh_.connectivity.begin() + mesh_.ends[c]);
      }
      numbers<std::int32_t>(1, list.size(), [&](std::size_t i) { return list[i]; });
    } else {
      std::int64_t most = 0;
      for (std::size_t c = 0; c < count; ++c) most = std::max(most, mesh_.ends[c] - start(c));
      write_items(file_, count, (static_cast<std::size_t>(most) + 1) * (longest_integer + 1),
                  [&](std::size_t c, char* to) {
                    to = put(to, mesh_.ends[c] - start(c));
                    for (std::int64_t k = start(c); k < mesh_.ends[c]; ++k)
                      to = put(put(to, ' '), std::int64_t{mesh_.connectivity[static_cast<std::size_t>(k)]});
                    return put(to, '\n');
                  });
    }
    file_.write(fmt::format("CELL_TYPES {}\n", count));
    numbers<std::int32_t>(1, count, [&](std::size_t i) { return std::int32_t{mesh_.types[i]}; });
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
    if (arrays[0].name == "CellEntityIds") {  // as Gmsh writes it
      const char* type = all_int(arrays[0]) ? "Int32" : "Int64";
      file_.write(fmt::format("SCALARS CellEntityIds {} 1\nLOOKUP_TABLE default\n", vtk_word_of_type(type)));
      body(arrays[0], type);
      --fields;
    }
    if (fields == 0) return;
    file_.write(fmt::format("FIELD FieldData {}\n", fields));
    for (std::size_t a = arrays.size() - fields; a < arrays.size(); ++a)
      array(arrays[a], arrays[a].type == "Int64" && all_int(arrays[a]) ? "Int32" : arrays[a].type);
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
  const bool binary_;
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
  void write_into(AtomicFile& file) override { Writer(file, document_, mesh(), binary_).write(); }
};

}  // namespace

std::unique_ptr<FilePlan> plan_vtk(const Document& document, bool binary) {
  return std::make_unique<LegacyPlan>(document, binary);
}

}  // namespace tetproof::io
