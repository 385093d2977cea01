// SPDX-License-Identifier: GPL-3.0-or-later
// Facts: "VTK File Formats", https://vtk.org/wp-content/uploads/2015/04/file-formats.pdf, and the XML writers
// of VTK 9.1.
#include "io/vtk/vtu_unread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "io/loss/loss_list.hpp"
#include "io/vtk/vtk_information.hpp"
#include "io/vtk/vtk_words.hpp"

namespace tetproof::io {
namespace {

// What the reader takes of an element, or anybody can compute, as the range of an array.
struct Taken {
  std::string_view element;
  std::vector<std::string_view> attributes, children;  // "DataArray": <Array>, too
};
const Taken taken[] = {
    {"VTKFile",
     {"type", "version", "byte_order", "header_type", "compressor"},
     {"UnstructuredGrid", "PolyData", "ImageData", "RectilinearGrid", "StructuredGrid", "AppendedData"}},
    {"AppendedData", {"encoding"}, {}},
    {"UnstructuredGrid", {}, {"FieldData", "Piece"}},
    {"PolyData", {}, {"FieldData", "Piece"}},
    {"ImageData", {"WholeExtent", "Origin", "Spacing", "Direction"}, {"FieldData", "Piece"}},
    {"RectilinearGrid", {"WholeExtent"}, {"FieldData", "Piece"}},
    {"StructuredGrid", {"WholeExtent"}, {"FieldData", "Piece"}},
    {"FieldData", {}, {"DataArray"}},
    {"Piece",
     {"NumberOfPoints", "NumberOfCells", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys",
      "Extent"},
     {"PointData", "CellData", "Points", "Cells", "Verts", "Lines", "Strips", "Polys", "Coordinates"}},
    {"PointData", {}, {"DataArray"}},
    {"CellData", {}, {"DataArray"}},
    {"Points", {}, {"DataArray"}},
    {"Coordinates", {}, {"DataArray"}},
    {"Cells", {}, {"DataArray"}},
    {"Verts", {}, {"DataArray"}},
    {"Lines", {}, {"DataArray"}},
    {"Strips", {}, {"DataArray"}},
    {"Polys", {}, {"DataArray"}},
    {"DataArray",
     {"type", "Name", "NumberOfComponents", "NumberOfTuples", "format", "offset", "RangeMin", "RangeMax",
      "IdType"},
     {"InformationKey"}}};

bool has(const auto& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

// The arrays that only <Cells> has.
constexpr std::string_view of_cells[] = {"types",
                                         "faces",
                                         "faceoffsets",
                                         "face_connectivity",
                                         "face_offsets",
                                         "polyhedron_to_faces",
                                         "polyhedron_offsets"};

bool is_list_of_cells(std::string_view element) {
  constexpr std::string_view lists[] = {"Cells", "Verts", "Lines", "Strips", "Polys"};
  return has(lists, element);
}

std::string_view kind_of(const pugi::xml_node& node) {
  return is_vtu_array(node) ? "DataArray" : node.name();
}

// A value as an example shows it: not a page of it.
std::string start_of(std::string_view value) {
  constexpr std::size_t most = 40;
  return fmt::format("{}{}", value.substr(0, most), value.size() > most ? "..." : "");
}

// Which of the children that a piece can have belong to it, by the kind of its grid.
bool belongs(const pugi::xml_node& piece, const pugi::xml_node& child) {
  const std::string_view grid = piece.parent().name(), name = child.name();
  if (name == "PointData" || name == "CellData") return true;
  if (name == "Points") return grid != "ImageData" && grid != "RectilinearGrid";
  if (name == "Cells") return grid == "UnstructuredGrid";
  if (name == "Coordinates") return grid == "RectilinearGrid";
  return grid == "PolyData";
}

class Lister {
 public:
  Lister(const std::function<std::int64_t(const pugi::xml_node&)>& line_of, std::vector<Loss>& dropped)
      : line_of_(line_of), dropped_(dropped) {}

  void list(const pugi::xml_node& node) {
    const std::string_view kind = kind_of(node);
    const Taken& known = *std::find_if(std::begin(taken), std::end(taken),
                                       [&](const Taken& one) { return one.element == kind; });
    for (const pugi::xml_attribute attribute : node.attributes()) this->attribute(node, known, attribute);
    std::set<std::string> seen;
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_pcdata)
        text(node);
      else if (!has(known.children, kind_of(child)) || (kind == "Piece" && !belongs(node, child)))
        add(fmt::format("element <{}> in <{}>", child.name(), node.name()), child);
      else if (kind_of(child) == "InformationKey")
        add_vtk_information(dropped_, node.attribute("Name").value(), child.attribute("name").value());
      else if (takes(node, child, seen))
        list(child);
    }
  }

 private:
  // Finding a line takes long in a large file, so only the first of an item has one.
  void add(const std::string& item, const pugi::xml_node& node, const std::string& detail = {}) {
    const bool listed =
        std::any_of(dropped_.begin(), dropped_.end(), [&](const Loss& loss) { return loss.item == item; });
    add_loss(dropped_, item, 1, listed ? "" : fmt::format("line {}{}", line_of_(node), detail));
  }

  void attribute(const pugi::xml_node& node, const Taken& known, const pugi::xml_attribute& attribute) {
    const std::string_view name = attribute.name();
    const bool of_data = known.element == "PointData" || known.element == "CellData";
    // Roles become those of values, or are listed where these are made.
    if (has(known.attributes, name) || (of_data && is_vtk_role(name))) return;
    if (known.element == "DataArray" && name.starts_with("ComponentName"))
      add_vtk_component_name(dropped_, node.attribute("Name").value(), attribute.value());
    else
      add(fmt::format("attribute {} of <{}>", name, node.name()), node,
          fmt::format(": \"{}\"", start_of(attribute.value())));
  }

  // The values of an array that stand in its element are its text.
  void text(const pugi::xml_node& node) {
    if (!is_vtu_array(node) || node.attribute("format").as_string() == std::string_view("appended"))
      add(fmt::format("text in <{}>", node.name()), node);
  }

  // Whether the reader takes this child. It takes the first of a kind where there is room for one.
  bool takes(const pugi::xml_node& node, const pugi::xml_node& child, std::set<std::string>& seen) {
    const std::string_view kind = kind_of(node), name = child.name();
    if (is_list_of_cells(kind)) {
      const std::string array = child.attribute("Name").value();
      const bool first = seen.insert(array).second;
      const bool of_any = array == "connectivity" || array == "offsets";
      if (first && (of_any || (kind == "Cells" && has(of_cells, array)))) return true;
      add(fmt::format("array \"{}\" of <{}>", array, kind), child);
      return false;
    }
    const bool one_of_a_kind = kind == "VTKFile" || kind == "Points" || name == "Points" ||
                               name == "Coordinates" || is_list_of_cells(name);
    if (!one_of_a_kind || seen.insert(std::string(kind_of(child))).second) return true;
    add(kind == "Points" ? fmt::format("array \"{}\" of <Points>", child.attribute("Name").value())
                         : fmt::format("a further <{}>", name),
        child);
    return false;
  }

  const std::function<std::int64_t(const pugi::xml_node&)>& line_of_;
  std::vector<Loss>& dropped_;
};

}  // namespace

bool is_vtu_array(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name == "DataArray" || name == "Array";
}

void list_unread(const pugi::xml_node& root,
                 const std::function<std::int64_t(const pugi::xml_node&)>& line_of,
                 std::vector<Loss>& dropped) {
  Lister(line_of, dropped).list(root);
}

}  // namespace tetproof::io
