// SPDX-License-Identifier: GPL-3.0-or-later
// Writes VTK's XML files. Most of such a file is numbers, so no XML library is used.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <span>
#include <string>

#include "io/bytes/base64.hpp"
#include "io/bytes/text_output.hpp"
#include "io/bytes/xml_text.hpp"
#include "io/model/tag_words.hpp"
#include "io/vtk/vtk_file_plan.hpp"
#include "io/vtk/vtk_mesh.hpp"
#include "io/vtk/vtk_types.hpp"
#include "io/vtk/vtk_words.hpp"
#include "io/vtk/vtu.hpp"
#include "io/vtk/vtu_data.hpp"

namespace tetproof::io {
namespace {

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, const VtkMesh& mesh, bool binary)
      : file_(file), document_(document), mesh_(mesh), binary_(binary) {}

  void write() {
    file_.write(
        fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                    "byte_order=\"{}\" header_type=\"UInt64\">\n<UnstructuredGrid>\n",
                    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"));
    if (!mesh_.field_data.empty()) data("FieldData", mesh_.field_data);
    file_.write(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                            document_.points.size(), mesh_.elements.size()));
    numbers<double>("Points", "Float64", 3, false, 3 * document_.points.size(),
                    [&](std::size_t i) { return document_.points[i / 3][static_cast<int>(i % 3)]; });
    file_.write("</Points>\n<Cells>\n");
    numbers<std::int64_t>("connectivity", "Int64", 1, false, mesh_.connectivity.size(),
                          [&](std::size_t i) { return mesh_.connectivity[i]; });
    numbers<std::int64_t>("offsets", "Int64", 1, false, mesh_.ends.size(),
                          [&](std::size_t i) { return mesh_.ends[i]; });
    numbers<unsigned char>("types", "UInt8", 1, false, mesh_.types.size(),
                           [&](std::size_t i) { return mesh_.types[i]; });
    if (!mesh_.face_ends.empty()) {
      numbers<std::int64_t>("faces", "Int64", 1, false, mesh_.faces.size(),
                            [&](std::size_t i) { return mesh_.faces[i]; });
      numbers<std::int64_t>("faceoffsets", "Int64", 1, false, mesh_.face_ends.size(),
                            [&](std::size_t i) { return mesh_.face_ends[i]; });
    }
    file_.write("</Cells>\n");
    data("PointData", mesh_.point_data);
    data("CellData", mesh_.cell_data);
    file_.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  }

 private:
  void data(const char* tag, const std::vector<VtkArray>& arrays) {
    std::string opening = fmt::format("<{}", tag);
    std::set<std::string> given;
    for (const VtkArray& array : arrays)
      for (const std::string& role : array.roles)
        if (is_vtk_role(role) && given.insert(role).second)
          opening += fmt::format(" {}=\"{}\"", role, xml_escaped(array.name));
    file_.write(opening + ">\n");
    for (const VtkArray& array : arrays) {
      const bool counted = &arrays == &mesh_.field_data;
      if (array.type == "String") {
        if (are_vtu_strings(array.texts)) strings(array);
      } else {
        with_number_type(array.type, [&](auto like) {
          using T = decltype(like);
          numbers<T>(array.name, array.type, array.components, counted, array.size(), [&](std::size_t i) {
            return array.integers.empty() ? static_cast<T>(array.reals[i])
                                          : static_cast<T>(array.integers[i]);
          });
        });
      }
    }
    file_.write(fmt::format("</{}>\n", tag));
  }

  void start(const char* tag, const std::string& name, const std::string& type, int components, bool counted,
             std::size_t count) {
    // meshio makes a table of one column where the number is 1.
    file_.write(fmt::format(
        "<{} type=\"{}\" Name=\"{}\"{}{} format=\"{}\">\n", tag, type, xml_escaped(name),
        components == 1 ? "" : fmt::format(" NumberOfComponents=\"{}\"", components),
        counted ? fmt::format(" NumberOfTuples=\"{}\"", count / static_cast<std::size_t>(components)) : "",
        binary_ ? "binary" : "ascii"));
  }

  void strings(const VtkArray& array) {
    std::string bytes;
    for (const std::string& text : array.texts) (bytes += text) += '\0';
    start("Array", array.name, "String", array.components, true, array.texts.size());
    values<unsigned char>(bytes.size(), [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); });
    file_.write("</Array>\n");
  }

  // Writes `value(i)` as type T for i in 0 .. count-1.
  template <class T, class Value>
  void numbers(const std::string& name, const std::string& type, int components, bool counted,
               std::size_t count, const Value& value) {
    start("DataArray", name, type, components, counted, count);
    values<T>(count, value);
    file_.write("</DataArray>\n");
  }

  template <class T, class Value>
  void values(std::size_t count, const Value& value) {
    if (binary_) {
      // The header and the values are one stream of bytes in base64, as VTK writes them; padding inside it
      // stops Python's decoder, and so meshio. The first values go with the header so that what follows
      // starts a group of three bytes; groups of three values then make whole groups of bytes.
      constexpr std::size_t most = sizeof(T) % 3;
      const std::size_t first = std::min(count, most);
      const std::uint64_t bytes = count * sizeof(T);
      std::array<unsigned char, sizeof bytes + most * sizeof(T)> head;
      std::memcpy(head.data(), &bytes, sizeof bytes);
      for (std::size_t k = 0; k < most; ++k) {
        if (k == first) break;
        const T number = static_cast<T>(value(k));
        std::memcpy(head.data() + sizeof bytes + k * sizeof(T), &number, sizeof(T));
      }
      std::array<char, (head.size() + 2) / 3 * 4> text;
      file_.write({text.data(), static_cast<std::size_t>(
                                    put_base64(text.data(), head.data(), sizeof bytes + first * sizeof(T)) -
                                    text.data())});
      write_items(file_, (count - first + 2) / 3, 4 * sizeof(T), [&](std::size_t group, char* to) {
        T three[3];
        const std::size_t from = first + 3 * group, size = std::min<std::size_t>(3, count - from);
        for (std::size_t k = 0; k < size; ++k) three[k] = static_cast<T>(value(from + k));
        return put_base64(to, reinterpret_cast<const unsigned char*>(three), size * sizeof(T));
      });
      file_.write("\n");
    } else {
      write_items(file_, count, longest_real + 1, [&](std::size_t i, char* to) {
        if constexpr (std::is_floating_point_v<T>)
          return put(put(to, static_cast<double>(value(i))), '\n');
        else if constexpr (std::is_same_v<T, std::uint64_t>)
          return put(std::to_chars(to, to + longest_integer, static_cast<std::uint64_t>(value(i))).ptr, '\n');
        else
          return put(put(to, static_cast<std::int64_t>(value(i))), '\n');
      });
    }
  }

  AtomicFile& file_;
  const Document& document_;
  const VtkMesh& mesh_;
  const bool binary_;
};

class XmlPlan : public VtkFilePlan {
 public:
  XmlPlan(const Document& document, bool binary)
      : VtkFilePlan(document, std::string(own_entity_word), binary) {
    holds_ = vtu_holds(document, plan_);
  }

  std::string warning(const std::string& path) override {
    if (binary_) return {};
    const std::string where =
        first_place_of([](double value) { return std::isinf(value) && value < 0; }, document_, mesh());
    return where.empty() ? ""
                         : fmt::format("{}: {} has -inf, which VTK itself reads in text as inf", path, where);
  }

 private:
  void write_into(AtomicFile& file) override { Writer(file, document_, mesh(), binary_).write(); }
};

}  // namespace

std::unique_ptr<FilePlan> plan_vtu(const Document& document, bool binary) {
  return std::make_unique<XmlPlan>(document, binary);
}

}  // namespace tetproof::io
