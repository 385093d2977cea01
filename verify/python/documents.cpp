// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module tetproof._core: documents, files, and documents from and to arrays in VTK's terms, as
// meshio's and PyVista's meshes have them.
#include <fmt/format.h>

#include <algorithm>

#include "io/error.hpp"
#include "io/loss/loss_list.hpp"
#include "io/mesh_files.hpp"
#include "io/model/element_types.hpp"
#include "io/model/group_signs.hpp"
#include "io/model/node_order.hpp"
#include "io/model/polylines.hpp"
#include "io/model/tag_words.hpp"
#include "io/program/refusal.hpp"
#include "io/vtk/vtk_cells.hpp"
#include "io/vtk/vtk_group_names.hpp"
#include "io/vtk/vtk_mesh.hpp"
#include "io/vtk/vtk_piece.hpp"
#include "io/vtk/vtk_tags.hpp"
#include "io/writing.hpp"
#include "verify/deadline.hpp"
#include "verify/python/interface.hpp"

namespace tetproof::python {
namespace {

using SharedDocument = std::shared_ptr<Document>;

// Points and elements are numbered from 1. So are the numbers that no point has.
template <class Mesh, std::size_t N>
SharedDocument document_of_rows(std::vector<Eigen::Vector3d>&& points, const py::array& rows) {
  std::vector<std::int64_t> unknown;
  std::vector<std::array<Index, N>> elements = rows_of<N>(rows, points.size(), unknown);
  auto document = std::make_shared<Document>(document_of(Mesh{std::move(points), std::move(elements)}));
  for (std::size_t k = 0; k < unknown.size(); ++k) document->unknown[k] = unknown[k] + 1;  // the same order
  return document;
}

SharedDocument document_of_arrays(const py::array_t<double>& points, const py::array& rows) {
  return rows.shape(1) == 3 ? document_of_rows<TriangleSurface, 3>(points_of(points), rows)
                            : document_of_rows<TetMesh, 4>(points_of(points), rows);
}

// An array of Python's, as a column of a file of VTK's: its name, its type there, and its numbers or texts.
using NamedArray = std::tuple<std::string, std::string, py::object>;

Column column_of(const NamedArray& named) {
  const auto& [name, type, values] = named;
  Column column{.name = name, .type = type};
  if (type == "String") {
    column.texts = values.cast<std::vector<std::string>>();
    return column;
  }
  const auto array = values.cast<py::array>();
  if (array.ndim() == 2) column.components = static_cast<int>(array.shape(1));
  const auto fill = [&](auto& to) {
    using Number = typename std::remove_cvref_t<decltype(to)>::value_type;
    const auto exact = values.cast<py::array_t<Number, py::array::c_style | py::array::forcecast>>();
    to.assign(exact.data(), exact.data() + exact.size());
  };
  if (array.dtype().kind() == 'f')
    fill(column.reals);
  else
    fill(column.integers);
  return column;
}

std::vector<Column> columns_of(const std::vector<NamedArray>& arrays) {
  std::vector<Column> columns;
  for (const NamedArray& array : arrays) columns.push_back(column_of(array));
  return columns;
}

std::vector<std::int64_t> integers_of(const py::array_t<std::int64_t, py::array::c_style>& array) {
  return {array.data(), array.data() + array.size()};
}

using Integers = py::array_t<std::int64_t, py::array::c_style>;

SharedDocument document_of_cells(const std::string& name, const py::array_t<double>& points,
                                 const Integers& connectivity, const Integers& ends, const Integers& types,
                                 const Integers& faces, const Integers& face_ends,
                                 const std::vector<NamedArray>& point_data,
                                 const std::vector<NamedArray>& cell_data,
                                 const std::vector<NamedArray>& fields, const std::vector<Loss>& dropped) {
  io::VtkPiece piece;
  piece.points = points_of(points);
  piece.connectivity = integers_of(connectivity);
  piece.ends = integers_of(ends);
  piece.types = integers_of(types);
  piece.faces = integers_of(faces);
  piece.face_ends = integers_of(face_ends);
  piece.point_data = columns_of(point_data);
  piece.cell_data = columns_of(cell_data);
  std::vector<Column> of_fields = columns_of(fields);
  return run(0, [&] {
    auto document = std::make_shared<Document>();
    document->path = name;
    document->format = "vtu";
    document->first_node = document->first_element = 0;
    document->dropped = dropped;
    for (Column& column : of_fields) io::add_vtk_field(*document, std::move(column));
    io::VtkPieces(*document).add(std::move(piece), true);
    io::take_group_names(*document);
    return document;
  });
}

py::object array_of(const io::VtkArray& array) {
  if (array.type == "String") return text(std::vector<std::string>(array.texts.begin(), array.texts.end()));
  const auto shaped = [&](const auto& numbers) {
    using Number = typename std::remove_cvref_t<decltype(numbers)>::value_type;
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(numbers.size()) / array.components};
    if (array.components != 1) shape.push_back(array.components);
    return py::array_t<Number>(std::move(shape), numbers.data());
  };
  if (array.integers.empty()) return shaped(std::vector<double>(array.reals.begin(), array.reals.end()));
  return shaped(std::vector<std::int64_t>(array.integers.begin(), array.integers.end()));
}

py::list arrays_of(const std::vector<io::VtkArray>& arrays) {
  py::list list;
  for (const io::VtkArray& array : arrays)
    if (array.components > 0) list.append(py::make_tuple(text(array.name), array_of(array)));
  return list;
}

// The document's cells and data as a .vtu file has them, but polylines cut into lines: meshio has no others.
py::dict cells_of_document(const SharedDocument& document) {
  std::vector<Loss> lost;
  SharedDocument written = document;
  io::VtkPlan plan;  // outlives the mesh, which refers to it
  io::VtkMesh mesh = run(0, [&] {
    if (io::has_signed_groups(*written))
      written = std::make_shared<Document>(io::with_unsigned_groups(*written));
    if (io::has_polylines(*written))
      written = std::make_shared<Document>(io::with_polylines_cut(*written, lost));
    plan = io::vtk_plan(*written, std::string(io::own_entity_word));
    return io::vtk_mesh(*written, plan);
  });
  py::dict cells;
  cells["point_data"] = arrays_of(mesh.point_data);
  cells["cell_data"] = arrays_of(mesh.cell_data);
  cells["field_data"] = arrays_of(mesh.field_data);
  cells["connectivity"] = own<Index, Index>(std::move(mesh.connectivity));
  cells["ends"] = own<std::int64_t, std::int64_t>(std::move(mesh.ends));
  cells["types"] = own<unsigned char, unsigned char>(std::move(mesh.types));
  cells["faces"] = own<std::int64_t, std::int64_t>(std::move(mesh.faces));
  cells["lost"] = lost;
  cells["face_ends"] = own<std::int64_t, std::int64_t>(std::move(mesh.face_ends));
  return cells;
}

// Node k of VTK's cell is node order[k] of Gmsh's element; empty: the same order.
std::vector<int> vtk_order(std::int64_t type, std::size_t nodes) {
  const int gmsh = io::gmsh_type_of_cell(type, nodes);
  const auto order = io::node_order(gmsh, io::NodeOrder::vtk);
  return {order.begin(), order.end()};
}

// What is known of a file that is going to be written, or has been.
struct Writing {
  std::vector<Loss> losses, kept_aside, dangling;
  std::string kept_in, warning, refusal;
  std::vector<std::string> files;
};

Writing write(const std::string& path, const SharedDocument& document, const std::string& format,
              std::optional<bool> binary, const std::string& strictness, bool with_reading, bool only_plan) {
  return run(0, [&] {
    PlannedFile file(path, *document, {format, binary});
    Writing done{
        file.losses(), file.kept_aside().items, file.dangling(), file.kept_aside().where, file.warning(), "",
        file.files()};
    const program::Strictness allowed = strictness == "native"   ? program::Strictness::native
                                        : strictness == "strict" ? program::Strictness::strict
                                                                 : program::Strictness::lax;
    const program::Refusal refusal(allowed, with_reading ? document->dropped : std::vector<Loss>{},
                                   done.losses, done.kept_aside, done.dangling);
    if (refusal.items() > 0)
      done.refusal =
          fmt::format("{}: not written, since {} {}", path,
                      refusal.items() == 1 ? "something" : "several things", refusal.why(done.kept_in));
    else if (!only_plan)
      file.write();
    return done;
  });
}

py::list blocks_of(const py::object& self) {
  const auto& document = self.cast<const Document&>();
  py::list blocks;
  for (const ElementBlock& block : document.blocks)
    blocks.append(py::make_tuple(
        block.type, io::name_of_elements(block.type), io::dimension_of_type(block.type),
        view(document.connectivity.data() + block.nodes,
             {static_cast<py::ssize_t>(block.count), static_cast<py::ssize_t>(block.nodes_each)}, self),
        block.entity, document.tag_sets[static_cast<std::size_t>(block.groups)]));
  return blocks;
}

// The numbers of nodes or elements.
py::array numbers(std::vector<std::int64_t> tags, std::int64_t first, std::size_t count) {
  if (tags.empty())
    for (std::size_t i = 0; i < count; ++i) tags.push_back(first + static_cast<std::int64_t>(i));
  return own<std::int64_t, std::int64_t>(std::move(tags));
}

}  // namespace

void bind_documents(py::module_& module) {
  py::class_<Loss>(module, "Loss")
      .def(py::init<std::string, std::int64_t, std::string, bool>(), py::arg("item"), py::arg("count"),
           py::arg("example"), py::arg("elements"))
      .def_property_readonly("item", [](const Loss& loss) { return text(loss.item); })
      .def_readonly("count", &Loss::count)
      .def_property_readonly("example", [](const Loss& loss) { return text(loss.example); })
      .def_readonly("elements", &Loss::elements);

  py::class_<Document, SharedDocument>(module, "Document")
      .def(py::init(&document_of_arrays), py::arg("points").noconvert(), py::arg("rows").noconvert())
      .def_property_readonly("path", [](const Document& document) { return text(document.path); })
      .def_readonly("format", &Document::format)
      .def_property_readonly("title", [](const Document& document) { return text(document.title); })
      .def_property_readonly("warnings", [](const Document& document) { return text(document.warnings); })
      .def_readonly("dropped", &Document::dropped)
      .def_readonly("unknown", &Document::unknown)
      .def_property_readonly(
          "points", [](const py::object& self) { return view(self.cast<const Document&>().points, self); })
      .def_property_readonly("blocks", &blocks_of)
      .def_property_readonly("elements", &Document::elements)
      .def_property_readonly(
          "point_numbers",
          [](const Document& d) { return numbers(d.node_tags, d.first_node, d.points.size()); })
      .def_property_readonly(
          "element_numbers",
          [](const Document& d) { return numbers(d.element_tags, d.first_element, d.elements()); })
      .def_property_readonly("group_names", [](const Document& document) {
        py::dict names;
        for (const GroupName& name : document.group_names)
          names[py::make_tuple(name.dim, name.group)] = text(name.name);
        return names;
      });
  module.def("document_of_cells", &document_of_cells, py::arg("name"), py::arg("points").noconvert(),
             py::arg("connectivity"), py::arg("ends"), py::arg("types"), py::arg("faces"),
             py::arg("face_ends"), py::arg("point_data"), py::arg("cell_data"), py::arg("fields"),
             py::arg("dropped"));
  module.def("cells_of_document", &cells_of_document, py::arg("document"));
  module.def("may_be_tag_name", &io::may_be_vtk_tag_name, py::arg("name"));
  module.def("vtk_order", &vtk_order, py::arg("type"), py::arg("nodes"));
  module.def(
      "read",
      [](const std::string& path, const std::string& format) {
        return run(0, [&] { return std::make_shared<Document>(read_document(path, {format})); });
      },
      py::arg("path"), py::arg("format"));

  py::class_<Writing>(module, "Writing")
      .def_readonly("losses", &Writing::losses)
      .def_readonly("kept_aside", &Writing::kept_aside)
      .def_readonly("dangling", &Writing::dangling)
      .def_readonly("kept_in", &Writing::kept_in)
      .def_property_readonly("warning", [](const Writing& done) { return text(done.warning); })
      .def_property_readonly("refusal", [](const Writing& done) { return text(done.refusal); })
      .def_property_readonly("files", [](const Writing& done) { return text(done.files); });
  module.def("write", &write, py::arg("path"), py::arg("document"), py::kw_only(), py::arg("format"),
             py::arg("binary"), py::arg("strictness"), py::arg("with_reading"), py::arg("only_plan"));
}

}  // namespace tetproof::python

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  using namespace tetproof;
  module.doc() = "The extension behind the package tetproof.";
  module.attr("version") = TETPROOF_VERSION;
  // Never destroyed: at the process's end Python is gone before static objects are.
  static const auto* const input_error =
      new py::exception<InputError>(module, "InputError", PyExc_ValueError);
  input_error->attr("__module__") = "tetproof";
  input_error->attr("__doc__") =
      "An argument or a file that cannot be used; the message says which, and why.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      PyErr_SetObject(input_error->ptr(), python::text(error.what()).ptr());
    } catch (const verify::OutOfTime& error) {
      PyErr_SetString(PyExc_TimeoutError, error.what());
    } catch (const std::logic_error& error) {
      PyErr_SetString(PyExc_RuntimeError,
                      (std::string("a fault of tetproof, please report it: ") + error.what()).c_str());
    }
  });
  python::bind_documents(module);
  python::bind_surfaces(module);
  python::bind_judge(module);
}
