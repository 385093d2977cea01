// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "io/element_types.hpp"
#include "io/text_output.hpp"
#include "io/vtu.hpp"

namespace tetproof::io {
namespace {

struct Cell {
  int gmsh, vtk, nodes;
};
// clang-format off
constexpr Cell cells[] = {{15, 1, 1}, {1, 3, 2}, {2, 5, 3}, {3, 9, 4}, {4, 10, 4}, {5, 12, 8}, {6, 13, 6}, {7, 14, 5},
                          {8, 21, 3}, {9, 22, 6}, {16, 23, 8}, {10, 28, 9}, {11, 24, 10}};
// clang-format on

std::string escaped(const std::string& text) {
  std::string safe;
  for (char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  return safe;
}

constexpr char base64_digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

char* put_base64(char* to, const unsigned char* from, std::size_t size) {
  for (; size >= 3; size -= 3, from += 3, to += 4) {
    const unsigned bits = from[0] << 16 | from[1] << 8 | from[2];
    for (int k = 0; k < 4; ++k) to[k] = base64_digits[bits >> (18 - 6 * k) & 63];
  }
  if (size > 0) {
    const unsigned bits = from[0] << 16 | (size > 1 ? from[1] << 8 : 0);
    to[0] = base64_digits[bits >> 18 & 63];
    to[1] = base64_digits[bits >> 12 & 63];
    to[2] = size > 1 ? base64_digits[bits >> 6 & 63] : '=';
    to[3] = '=';
    to += 4;
  }
  return to;
}

class Writer {
 public:
  Writer(AtomicFile& file, const Document& document, bool binary)
      : file_(file), document_(document), binary_(binary) {
    for (const ElementBlock& block : document.blocks) {
      const int type = vtk_cell_type(block.type);
      for (std::size_t e = 0; type != 0 && e < block.count; ++e) {
        const Index* nodes = document.connectivity.data() + block.nodes + e * block.nodes_each;
        if (std::any_of(nodes, nodes + block.nodes_each, [](Index i) { return i < 0; })) continue;
        elements_.push_back(block.first + e);
        types_.push_back(static_cast<unsigned char>(type));
        const std::size_t start = connectivity_.size();
        connectivity_.insert(connectivity_.end(), nodes, nodes + block.nodes_each);
        if (block.type == tetrahedron10) std::swap(connectivity_[start + 8], connectivity_[start + 9]);
        offsets_.push_back(static_cast<std::int64_t>(connectivity_.size()));
      }
    }
  }

  void write() {
    file_.write(
        fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
                    "byte_order=\"{}\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
                    "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian",
                    document_.points.size(), elements_.size()));
    file_.write("<Points>\n");
    array<double>("Points", 3, 3 * document_.points.size(),
                  [&](std::size_t i) { return document_.points[i / 3][static_cast<int>(i % 3)]; });
    file_.write("</Points>\n<Cells>\n");
    array<std::int64_t>("connectivity", 1, connectivity_.size(),
                        [&](std::size_t i) { return connectivity_[i]; });
    array<std::int64_t>("offsets", 1, offsets_.size(), [&](std::size_t i) { return offsets_[i]; });
    array<unsigned char>("types", 1, types_.size(), [&](std::size_t i) { return types_[i]; });
    file_.write("</Cells>\n");
    point_data();
    cell_data();
    file_.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  }

 private:
  void point_data() {
    file_.write("<PointData>\n");
    for (const Values& values : document_.node_values) {
      const std::size_t size = document_.points.size() * values.components;
      if (values.integers.empty())
        array<double>(values.name, values.components, size, [&](std::size_t i) { return values.reals[i]; });
      else
        array<std::int64_t>(values.name, values.components, size,
                            [&](std::size_t i) { return values.integers[i]; });
    }
    file_.write("</PointData>\n");
  }

  void cell_data() {
    file_.write("<CellData>\n");
    bool several = false, groups = false;
    for (const ElementBlock& block : document_.blocks) {
      several = several || block.dim != document_.blocks[0].dim ||
                block.entity != document_.blocks[0].entity || block.entity < 0 ||
                block.entity > 1;  // 0 and 1 go without saying
      groups = groups || block.groups != 0;
    }
    if (several) of_blocks("entity", [](const ElementBlock& block) { return block.entity; });
    if (groups)
      of_blocks("group", [&](const ElementBlock& block) {
        const auto& tags = document_.tag_sets[block.groups];
        return tags.empty() ? 0 : tags[0];
      });
    for (const Values& values : document_.element_values) {
      const std::size_t n = values.components, size = elements_.size() * n;
      const auto source = [&](std::size_t i) { return elements_[i / n] * n + i % n; };
      if (values.integers.empty())
        array<double>(values.name, values.components, size,
                      [&](std::size_t i) { return values.reals[source(i)]; });
      else
        array<std::int64_t>(values.name, values.components, size,
                            [&](std::size_t i) { return values.integers[source(i)]; });
    }
    file_.write("</CellData>\n");
  }

  template <class Of>
  void of_blocks(const std::string& name, const Of& of) {
    std::vector<std::int64_t> values;
    values.reserve(elements_.size());
    std::size_t b = 0;
    for (std::size_t e : elements_) {
      while (e >= document_.blocks[b].first + document_.blocks[b].count) ++b;
      values.push_back(of(document_.blocks[b]));
    }
    array<std::int64_t>(name, 1, values.size(), [&](std::size_t i) { return values[i]; });
  }

  // `value(i)` of type T for i in 0 .. count-1.
  template <class T, class Value>
  void array(const std::string& name, int components, std::size_t count, const Value& value) {
    const char* type = std::is_same_v<T, double>         ? "Float64"
                       : std::is_same_v<T, std::int64_t> ? "Int64"
                                                         : "UInt8";
    file_.write(fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"{}\">\n",
                            type, escaped(name), components, binary_ ? "binary" : "ascii"));
    if (binary_) {
      // Groups of three values make whole groups of three bytes, so that no padding stands inside.
      const std::uint64_t bytes = count * sizeof(T);
      char header[12];
      file_.write(
          {header, static_cast<std::size_t>(
                       put_base64(header, reinterpret_cast<const unsigned char*>(&bytes), 8) - header)});
      write_items(file_, (count + 2) / 3, 4 * sizeof(T), [&](std::size_t group, char* to) {
        T three[3];
        const std::size_t from = 3 * group, size = std::min<std::size_t>(3, count - from);
        for (std::size_t k = 0; k < size; ++k) three[k] = static_cast<T>(value(from + k));
        return put_base64(to, reinterpret_cast<const unsigned char*>(three), size * sizeof(T));
      });
      file_.write("\n");
    } else {
      write_items(file_, count, longest_real + 1, [&](std::size_t i, char* to) {
        if constexpr (std::is_same_v<T, unsigned char>)
          return put(put(to, std::int64_t{value(i)}), '\n');
        else
          return put(put(to, static_cast<T>(value(i))), '\n');
      });
    }
    file_.write("</DataArray>\n");
  }

  AtomicFile& file_;
  const Document& document_;
  const bool binary_;
  std::vector<std::size_t> elements_;  // those that are written
  std::vector<Index> connectivity_;
  std::vector<std::int64_t> offsets_;
  std::vector<unsigned char> types_;
};

}  // namespace

int vtk_cell_type(int gmsh_type) {
  for (const Cell& cell : cells)
    if (cell.gmsh == gmsh_type) return cell.vtk;
  return 0;
}

Holds vtu_holds() {
  Holds holds;
  holds.element_entities = true;
  holds.groups = Holds::Groups::first;
  holds.nodes_each = [](const ElementBlock& block) {
    return vtk_cell_type(block.type) ? block.nodes_each : 0;
  };
  holds.values = [](const Values& values, Of of) {
    return of != Of::element_node && !values.of_view && values.at.empty() && values.first == 0;
  };
  return holds;
}

void write_vtu(AtomicFile& file, const Document& document, bool binary) {
  Writer(file, document, binary).write();
}

}  // namespace tetproof::io
