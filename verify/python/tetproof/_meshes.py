# SPDX-License-Identifier: GPL-3.0-or-later
"""Documents from the meshes of other libraries: meshio, PyVista, VTK, trimesh.

They are recognised by their attributes, so that none of these libraries is needed. All of them become cells
in VTK's terms, which the extension takes as it takes a .vtu file.
"""
from __future__ import annotations

import re
from typing import Any

import numpy as np

from . import _core
from ._arrays import InputError, integer_array, is_path, point_array
from ._cells import POLYGON, POLYHEDRON, UNKNOWN, WEDGE, Cells
from ._documents import Document, of_rows, read

# meshio's names of VTK's types of cells. Names of Gmsh's complete elements of higher order follow from the
# shape.
# fmt: off
_VTK = {
    "empty": 0, "vertex": 1, "line": 3, "triangle": 5, "polygon": 7, "pixel": 8, "quad": 9, "tetra": 10,
    "hexahedron": 12, "wedge": 13, "pyramid": 14, "penta_prism": 15, "hexa_prism": 16, "line3": 21,
    "triangle6": 22, "quad8": 23, "tetra10": 24, "hexahedron20": 25, "wedge15": 26, "pyramid13": 27,
    "quad9": 28, "hexahedron27": 29, "quad6": 30, "wedge12": 31, "wedge18": 32, "hexahedron24": 33,
    "triangle7": 34, "line4": 35, "polyhedron": 42, "VTK_LAGRANGE_CURVE": 68, "VTK_LAGRANGE_TRIANGLE": 69,
    "VTK_LAGRANGE_QUADRILATERAL": 70, "VTK_LAGRANGE_TETRAHEDRON": 71, "VTK_LAGRANGE_HEXAHEDRON": 72,
    "VTK_LAGRANGE_WEDGE": 73, "VTK_LAGRANGE_PYRAMID": 74, "VTK_BEZIER_CURVE": 75, "VTK_BEZIER_TRIANGLE": 76,
    "VTK_BEZIER_QUADRILATERAL": 77, "VTK_BEZIER_TETRAHEDRON": 78, "VTK_BEZIER_HEXAHEDRON": 79,
    "VTK_BEZIER_WEDGE": 80, "VTK_BEZIER_PYRAMID": 81,
}
_HIGHER_ORDER = {
    "line": 68, "triangle": 69, "quad": 70, "tetra": 71, "hexahedron": 72, "wedge": 73, "pyramid": 74,
}
# fmt: on
MESHIO = {number: name for name, number in _VTK.items()}
# meshio lists the corners of a wedge as Gmsh does; in VTK's wedge the first triangle faces outwards.
WEDGE_ORDER = [0, 2, 1, 3, 5, 4]


def as_document(mesh: Any) -> Document:
    """The document of a mesh, with all its elements, groups and values.

    `mesh`: a Document; the path of a file; a pair of arrays (points, tetrahedra) or (points, triangles); a
    mesh of meshio, of PyVista or of VTK (unstructured grids and poly data), or of trimesh; or anything with
    their attributes: `points` and `cells`, `cells_dict` or `cells` with `celltypes`; `vertices` and `faces`.

    Points, and elements of such meshes, are numbered from 0, as a .vtu file has them: elements through all
    blocks. Pairs of arrays become a document that is numbered from 1, as `tetproof-mesh` writes it.
    """
    taken = _taken(mesh)
    return taken if isinstance(taken, Document) else taken.document(_name_of(mesh))


def judged(mesh: Any) -> _core.Mesh:
    """What `verify` judges of such a mesh. No document is made, which takes time, if all are tetrahedra."""
    taken = _taken(mesh)
    if isinstance(taken, Cells):
        tets = taken.only_tetrahedra()
        if tets is not None:
            return _core.Mesh(taken.points, tets)
        taken = taken.document(_name_of(mesh))
    return _core.Mesh(taken._core)


def _name_of(mesh: Any) -> str:
    return f"a mesh of type {type(mesh).__module__.split('.')[0]}.{type(mesh).__name__}"


def _taken(mesh: Any) -> Document | Cells:
    """The mesh as it comes in."""
    if isinstance(mesh, Document):
        return mesh
    if is_path(mesh):
        return read(mesh)
    if hasattr(mesh, "points") and hasattr(mesh, "triangles"):  # a Surface
        return of_rows(mesh.points, mesh.triangles)
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return of_rows(*mesh)
    cells = Cells()
    if hasattr(mesh, "GetCellTypesArray") or hasattr(mesh, "GetPolys"):
        _of_vtk(mesh, cells)
    elif hasattr(mesh, "points") and hasattr(mesh, "celltypes"):
        _of_pyvista(mesh, cells)
    elif hasattr(mesh, "points") and hasattr(mesh, "cells"):
        _of_meshio(mesh, cells)
    elif hasattr(mesh, "points") and hasattr(mesh, "cells_dict"):
        _of_blocks(mesh, list(mesh.cells_dict.items()), cells)
    elif hasattr(mesh, "points") and hasattr(mesh, "faces"):
        _of_poly_data(mesh, cells)
    elif hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return of_rows(mesh.vertices, mesh.faces)
    else:
        raise InputError(f"a mesh of type {type(mesh).__name__}: expected a Document, a path, a pair of "
                         "arrays, or an object with points and cells")
    return cells


def _points(points: Any) -> np.ndarray:
    table = np.asarray(points)
    if table.ndim == 2 and table.shape[1] == 2:
        raise InputError("points: expected three coordinates each, found two")
    return point_array(table)


def _of_meshio(mesh: Any, cells: Cells) -> None:
    """meshio.Mesh: blocks with `type` and `data`, cell data as a list of arrays, one for each block."""
    blocks = [(block.type, block.data) if hasattr(block, "type") else (block[0], block[1])
              for block in mesh.cells]
    _of_blocks(mesh, blocks, cells)
    for name, parts in (getattr(mesh, "cell_data", None) or {}).items():
        arrays = [np.asarray(part) for part in parts]
        if len(arrays) != len(blocks):
            raise InputError(f"data '{name}' of cells: expected {len(blocks)} blocks, found {len(arrays)}")
        cells.add_data("cells", name, np.concatenate(arrays) if arrays else np.empty(0), cells.count())
    for what in ("point_sets", "cell_sets"):
        sets = getattr(mesh, what, None) or {}
        cells.drop(f"meshio's {what}", len(sets), f"'{next(iter(sets), '')}'")
    cells.drop("meshio's gmsh_periodic", len(getattr(mesh, "gmsh_periodic", None) or ()), "periodic links")


def _of_blocks(mesh: Any, blocks: list[tuple[Any, Any]], cells: Cells) -> None:
    """Blocks of cells by meshio's names, or by VTK's numbers, of their types; and the data of points."""
    cells.points = _points(mesh.points)
    for name, data in blocks:
        if isinstance(name, str) and re.fullmatch(r"polyhedron\d*", name):
            for faces in data:
                cells.add_polyhedron(faces)
            continue
        nodes = integer_array(data, f"cells '{name}'") if len(data) else np.empty((0, 1), dtype=np.int64)
        if nodes.ndim != 2:
            raise InputError(f"cells '{name}': expected the shape (n, k), found {nodes.shape}")
        number, order = _type_of(name, nodes.shape[1])
        cells.add(number, nodes[:, order] if order else nodes)
    for name, values in (getattr(mesh, "point_data", None) or {}).items():
        cells.add_data("points", name, values, len(cells.points))
    for name, values in (getattr(mesh, "field_data", None) or {}).items():
        cells.add_data("neither", name, values, None)


def _type_of(name: Any, nodes: int) -> tuple[int, list[int]]:
    """VTK's type for a name of meshio's, and its order of the nodes; empty: the same order."""
    if not isinstance(name, str):
        return int(name), []  # PyVista's cells_dict
    if re.fullmatch(r"polygon\d*", name):
        return POLYGON, []
    if name in _VTK:
        return _VTK[name], WEDGE_ORDER if _VTK[name] == WEDGE else []
    shape = re.fullmatch(r"([a-z]+)(\d+)", name)
    if shape and shape[1] in _HIGHER_ORDER and int(shape[2]) == nodes:  # in Gmsh's order
        number = _HIGHER_ORDER[shape[1]]
        return number, _core.vtk_order(number, nodes)
    return UNKNOWN, []


def _of_pyvista(mesh: Any, cells: Cells) -> None:
    """pyvista.UnstructuredGrid by its attributes: `cells` has the number of points before those of each cell.
    """
    cells.points = _points(mesh.points)
    types = integer_array(mesh.celltypes, "celltypes")
    flat = integer_array(mesh.cells, "cells")
    connectivity, sizes = _unpacked(flat, len(types), "cells")
    cells.add_mixed(types, connectivity, sizes)
    _data_of_pyvista(mesh, cells)


def _of_poly_data(mesh: Any, cells: Cells) -> None:
    """pyvista.PolyData by its attributes: the faces, with the number of points before those of each."""
    cells.points = _points(mesh.points)
    faces = integer_array(mesh.faces, "faces")
    if faces.ndim == 2:
        cells.add(POLYGON, faces)
        return
    connectivity, sizes = _unpacked(faces, None, "faces")
    cells.add_mixed(np.full(len(sizes), POLYGON), connectivity, sizes)


def _data_of_pyvista(mesh: Any, cells: Cells) -> None:
    for kind, items in (("point", len(cells.points)), ("cell", cells.count()), ("field", None)):
        data = getattr(mesh, f"{kind}_data", None) or {}
        for name in list(data.keys()):
            to = {"point": "points", "cell": "cells", "field": "neither"}[kind]
            cells.add_data(to, name, data[name], items)


def _unpacked(flat: np.ndarray, cells: int | None, what: str) -> tuple[np.ndarray, np.ndarray]:
    """The points of all cells, and their numbers, from a list in which each number stands before its points.
    """
    each = int(flat[0]) + 1 if len(flat) else 1
    fits = len(flat) % each == 0 and (cells is None or len(flat) == each * cells)
    if fits and (flat[::each] == each - 1).all():  # all alike, as in most meshes
        rows = flat.reshape(-1, each)
        return rows[:, 1:].ravel(), np.broadcast_to(each - 1, len(rows))
    kept, sizes, at = np.ones(len(flat), dtype=bool), [], 0
    while at < len(flat):
        size = int(flat[at])
        if size < 0 or at + size >= len(flat):
            raise InputError(f"{what}: expected the number of points of a cell at {at}, found {size}")
        sizes.append(size)
        kept[at] = False
        at += size + 1
    if cells is not None and len(sizes) != cells:
        raise InputError(f"{what}: expected {cells} cells, found {len(sizes)}")
    return flat[kept], np.array(sizes, dtype=np.int64)


def _of_vtk(mesh: Any, cells: Cells) -> None:
    """VTK's own unstructured grids and poly data, which PyVista's are too."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkIdList

    if mesh.GetPoints():
        cells.points = _points(vtk_to_numpy(mesh.GetPoints().GetData()))

    def arrays(of: Any) -> tuple[np.ndarray, np.ndarray]:
        return vtk_to_numpy(of.GetConnectivityArray()), np.diff(vtk_to_numpy(of.GetOffsetsArray()))

    if hasattr(mesh, "GetCellTypesArray"):
        if mesh.GetNumberOfCells():
            types = vtk_to_numpy(mesh.GetCellTypesArray())
            cells.add_mixed(types, *arrays(mesh.GetCells()))
            stream, cells.face_ends[0] = vtkIdList(), np.full(len(types), -1)
            for cell in np.flatnonzero(types == POLYHEDRON):
                mesh.GetFaceStream(int(cell), stream)
                cells.faces += [stream.GetId(i) for i in range(stream.GetNumberOfIds())]
                cells.face_ends[0][cell] = len(cells.faces)
    else:
        for part, several, one in ((mesh.GetVerts(), 2, 1), (mesh.GetLines(), 4, 3), (mesh.GetPolys(), 7, 0),
                                   (mesh.GetStrips(), 6, 0)):
            if part.GetNumberOfCells():
                connectivity, sizes = arrays(part)
                types = np.where(sizes == one, one, several) if one == 1 else np.full(len(sizes), several)
                cells.add_mixed(types, connectivity, sizes)
    for kind, of, items in (("points", mesh.GetPointData(), len(cells.points)),
                            ("cells", mesh.GetCellData(), cells.count()),
                            ("neither", mesh.GetFieldData(), None)):
        for i in range(of.GetNumberOfArrays()):
            array = of.GetAbstractArray(i)
            if hasattr(array, "GetVoidPointer") and of.GetArray(i) is not None:
                values: Any = vtk_to_numpy(array)
            elif array.IsA("vtkStringArray"):
                values = np.array([array.GetValue(k) for k in range(array.GetNumberOfValues())], dtype=object)
            else:
                cells.drop(f"data of {kind} that are neither numbers nor texts", 1, f"'{array.GetName()}'")
                continue
            cells.add_data(kind, array.GetName() or "", values, items)
