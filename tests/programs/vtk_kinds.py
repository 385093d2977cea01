# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygonal data, structured grids, polyhedra and cells of higher order: VTK writes them, tetproof-convert reads and
writes them, and VTK must find the same again."""
import subprocess

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from vtk_common import GMSH, check, convert, read_vtk
from vtk_content import arrays, cells, same_arrays

SIMPLEX = {  # its VTK types (Lagrange, Bezier), corners, and Gmsh's types by order
    "curve": (68, 75, 2, (1, 8, 26, 27, 28, 62, 63, 64, 65, 66)),
    "triangle": (69, 76, 3, (2, 9, 21, 23, 25, 42, 43, 44, 45, 46)),
    "tetra": (71, 78, 4, (4, 11, 29, 30, 31, 71, 72, 73, 74, 75)),
}


def points_of(grid):
    return np.array([grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())])


def write_xml(data, path, mode="Appended", packed="LZ4", pieces=1, ghost_levels=0):
    kind = data.GetClassName()
    writer = getattr(vtk, kind.replace("vtk", "vtkXML") + "Writer")()
    getattr(writer, f"SetDataModeTo{mode}")()
    getattr(writer, f"SetCompressorTypeTo{packed}")()
    if data.GetExtentType() == vtk.VTK_3D_EXTENT:
        writer.SetNumberOfPieces(pieces), writer.SetGhostLevel(ghost_levels)
    writer.SetInputData(data), writer.SetFileName(str(path)), writer.Write()


def write_legacy(data, path, version, binary):
    kind = {"vtkImageData": "vtkStructuredPoints"}.get(data.GetClassName(), data.GetClassName())
    writer = getattr(vtk, kind + "Writer")()
    writer.SetHeader(""), writer.SetFileVersion(version), writer.SetFileType(2 if binary else 1)
    writer.SetInputData(data), writer.SetFileName(str(path)), writer.Write()


def files_of(data, folder, name, ending):
    """The data as VTK writes them: text, binary, compressed, legacy."""
    found = []
    for mode, packed in (("Ascii", "None"), ("Binary", "LZMA"), ("Appended", "LZ4"), ("Appended", "ZLib")):
        found.append(folder / f"{name}-{mode}-{packed}.{ending}")
        write_xml(data, found[-1], mode, packed)
    for version in (42, 51):
        for binary in (False, True):
            found.append(folder / f"{name}-{version}-{binary}.vtk")
            write_legacy(data, found[-1], version, binary)
    return found


def add_data(data, folder):
    for of, items, kind in ((data.GetPointData(), data.GetNumberOfPoints(), "p"), (data.GetCellData(), data.GetNumberOfCells(), "c")):
        for name, values in ((kind + "r", np.arange(items) / 8), (kind + "i", np.arange(items) * 3 - 1)):
            array = numpy_to_vtk(values, deep=True)
            array.SetName(name)
            of.AddArray(array)


def parts(data):
    """The cells as a document has them: strips and cells of several vertices in parts, voxels as hexahedra."""
    found, origin = [], []
    for c in range(data.GetNumberOfCells()):
        kind, cell = data.GetCellType(c), data.GetCell(c)
        ids = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        if kind == 2:
            new = [(1, [i]) for i in ids]
        elif kind == 6:
            new = [(5, [ids[i], ids[i + 1], ids[i + 2]] if i % 2 == 0 else [ids[i + 1], ids[i], ids[i + 2]])
                   for i in range(len(ids) - 2)]
        elif kind == 8:
            new = [(9, [ids[k] for k in (0, 1, 3, 2)])]
        elif kind == 11:
            new = [(12, [ids[k] for k in (0, 1, 3, 2, 4, 5, 7, 6)])]
        else:
            new = [(kind, ids)]
        found += new
        origin += [c] * len(new)
    return found, origin


def same_as(data, file, folder):
    for name in ("out.vtu", "out.vtk"):
        convert(file, folder / name)
        back = read_vtk(folder / name)
        expected, origin = parts(data)
        what = f"{file.name} to {name}"
        check(f"{what}: points", np.array_equal(points_of(back), points_of(data)))
        check(f"{what}: cells", cells(back) == expected)
        check(f"{what}: point data", same_arrays(arrays(back.GetPointData()), arrays(data.GetPointData())))
        of_cells = {k: v[origin] for k, v in arrays(data.GetCellData()).items()}
        check(f"{what}: cell data", same_arrays(arrays(back.GetCellData()), of_cells))


def polygonal(folder):
    data, points = vtk.vtkPolyData(), vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(12):
        points.InsertNextPoint(i % 3, i // 3, i * i / 16)
    data.SetPoints(points)
    for set_cells, ids in ((data.SetVerts, [[0], [1, 2]]), (data.SetLines, [[0, 1], [3, 4, 5, 6]]),
                           (data.SetPolys, [[0, 1, 2], [0, 1, 3, 2], [4, 5, 6, 7, 8]]), (data.SetStrips, [[0, 1, 2, 3, 4]])):
        array = vtk.vtkCellArray()
        for one in ids:
            array.InsertNextCell(len(one), one)
        set_cells(array)
    add_data(data, folder)
    for file in files_of(data, folder, "polygonal", "vtp"):
        same_as(data, file, folder)


def structured(folder):
    for dimensions in ((3, 4, 5), (3, 1, 4), (1, 4, 3), (4, 3, 1), (5, 1, 1), (1, 1, 1)):
        image = vtk.vtkImageData()
        image.SetDimensions(*dimensions), image.SetOrigin(0.5, 1, -2), image.SetSpacing(0.25, 0.1, 3)
        axes = [np.cumsum(np.arange(n) + 0.5) for n in dimensions]
        rectilinear = vtk.vtkRectilinearGrid()
        rectilinear.SetDimensions(*dimensions)
        for axis, set_axis in zip(axes, (rectilinear.SetXCoordinates, rectilinear.SetYCoordinates, rectilinear.SetZCoordinates)):
            set_axis(numpy_to_vtk(axis, deep=True))
        grid, points = vtk.vtkStructuredGrid(), vtk.vtkPoints()
        points.SetDataTypeToDouble()
        for i in range(image.GetNumberOfPoints()):
            x, y, z = rectilinear.GetPoint(i)
            points.InsertNextPoint(x + y / 4, y - z / 8, z)
        grid.SetDimensions(*dimensions), grid.SetPoints(points)
        for data, ending in ((image, "vti"), (rectilinear, "vtr"), (grid, "vts")):
            add_data(data, folder)
            for file in files_of(data, folder, "structured", ending):
                same_as(data, file, folder)
            for pieces, ghost_levels in ((2, 0), (3, 1), (4, 2)):
                file = folder / f"structured-{pieces}-{ghost_levels}.{ending}"
                write_xml(data, file, "Appended", "ZLib", pieces, ghost_levels)
                same_as(data, file, folder)


def lattice_of(cell):
    parametric = cell.GetParametricCoords()
    return [tuple(parametric[3 * k:3 * k + 3]) for k in range(cell.GetNumberOfPoints())]


def grid_of(kind, points, ids=None):
    grid, places = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    places.SetDataTypeToDouble()
    for p in points:
        places.InsertNextPoint(*p)
    grid.SetPoints(places)
    grid.InsertNextCell(kind, len(points), ids or list(range(len(points))))
    return grid


def at(grid, parametric):
    cell, place = grid.GetCell(0), [0.0] * 3
    cell.EvaluateLocation(vtk.reference(0), parametric, place, [0.0] * cell.GetNumberOfPoints())
    return place


def higher_order(folder):
    inside = [(0.1, 0.2, 0.3), (0.5, 0.1, 0.05), (0.25, 0.25, 0.25), (0.05, 0.7, 0.1)]
    for name, (lagrange, bezier, corners, types) in SIMPLEX.items():
        places = [p if corners == 4 else (p[0], p[1], 0) if corners == 3 else (p[0], 0, 0) for p in inside]
        for order in range(1, 11):
            count = {2: order + 1, 3: (order + 1) * (order + 2) // 2, 4: (order + 1) * (order + 2) * (order + 3) // 6}[corners]
            for kind in (lagrange, bezier):
                # A curved cell: its points are a quadratic function of where they are in the cell.
                lattice = lattice_of(grid_of(kind, [(i, 0, 0) for i in range(count)]).GetCell(0))
                grid = grid_of(kind, [(x + y * z / 4, y + x * x / 8, z - x * y / 4) for x, y, z in lattice])
                write_xml(grid, folder / "in.vtu")
                what = f"{'Bezier' if kind == bezier else 'Lagrange'} {name} of order {order}"
                for out in ("out.vtu", "out.vtk"):
                    convert(folder / "in.vtu", folder / out, "--strict")
                    back = read_vtk(folder / out)
                    check(f"{what} to {out}: one cell", back.GetNumberOfCells() == 1)
                    # Bezier cells never become others, from order 2 on.
                    check(f"{what} to {out}: its type", back.GetCellType(0) == kind if order > 3 or kind == bezier and order > 1
                          else back.GetCellType(0) not in range(75, 82))
                    check(f"{what} to {out}: its shape", all(np.allclose(at(grid, p), at(back, p), atol=1e-12) for p in places)
                          if back.GetCellType(0) not in (35,) else cells(back)[0][1] == cells(grid)[0][1])
                if kind == lagrange:
                    convert(folder / "in.vtu", folder / "out.msh", "--to", "msh22", "--strict")
                    line = (folder / "out.msh").read_text().split("$Elements\n")[1].split("\n")[1].split()
                    check(f"{what} to .msh: its type", line[1] == str(types[order - 1]))


def gmsh_orders(folder):
    """Gmsh's own tetrahedra of each order: VTK finds every node of a straight element where the cell has it."""
    (folder / "tet.geo").write_text(
        "Point(1)={0,0,0,9};Point(2)={1,0,0,9};Point(3)={0,1,0,9};Point(4)={0,0,1,9};"
        "Line(1)={1,2};Line(2)={2,3};Line(3)={3,1};Line(4)={1,4};Line(5)={2,4};Line(6)={3,4};"
        "Curve Loop(1)={1,2,3};Curve Loop(2)={1,5,-4};Curve Loop(3)={2,6,-5};Curve Loop(4)={3,4,-6};"
        "Plane Surface(1)={1};Plane Surface(2)={2};Plane Surface(3)={3};Plane Surface(4)={4};"
        "Surface Loop(1)={1,2,3,4};Volume(1)={1};\n")
    for order in range(2, 7):  # Gmsh takes minutes for 10
        subprocess.run([GMSH, "-3", "-v", "0", "-order", str(order), folder / "tet.geo", "-o", folder / "tet.msh"], timeout=120)
        for out in ("tet.vtu", "tet.vtk"):
            convert(folder / "tet.msh", folder / out)
            grid, kinds = read_vtk(folder / out), set()
            for c in range(grid.GetNumberOfCells()):
                cell = grid.GetCell(c)
                kinds.add(cell.GetCellDimension())
                if cell.GetCellDimension() == 0:
                    continue
                place, weights, ok = [0.0] * 3, [0.0] * cell.GetNumberOfPoints(), True
                for k, parametric in enumerate(lattice_of(cell)):
                    corner = [np.array(grid.GetPoint(cell.GetPointId(i))) for i in range(cell.GetCellDimension() + 1)]
                    cubic = grid.GetCellType(c) == 35  # its coordinate goes from -1 to 1
                    inside = [(t + 1) / 2 for t in parametric] if cubic else parametric
                    straight = corner[0] + sum(t * (p - corner[0]) for t, p in zip(inside, corner[1:]))
                    cell.EvaluateLocation(vtk.reference(0), parametric, place, weights)
                    ok &= np.allclose(straight, grid.GetPoint(cell.GetPointId(k)), atol=1e-9)
                    ok &= np.allclose(place, straight, atol=1e-9) or cubic
                check(f"Gmsh's elements of order {order} in {out}: cell {c} of type {grid.GetCellType(c)}", ok)
            check(f"Gmsh's elements of order {order} in {out}: all dimensions", kinds == {0, 1, 2, 3} or kinds == {1, 2, 3} or kinds == {3})


def stream_of(grid, c):
    ids = vtk.vtkIdList()
    grid.GetFaceStream(c, ids)
    return [ids.GetId(k) for k in range(ids.GetNumberOfIds())]


def polyhedra(folder):
    grid, points = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(12):
        points.InsertNextPoint(i % 2, i // 2 % 2, i // 4)
    grid.SetPoints(points)
    cube = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]

    def add(faces, shift=0):
        stream = vtk.vtkIdList()
        for number in [len(faces)] + [n for face in faces for n in [len(face)] + [i + shift for i in face]]:
            stream.InsertNextId(number)
        grid.InsertNextCell(42, stream)
    add(cube)
    grid.InsertNextCell(10, 4, [0, 1, 2, 4])
    add(cube, 4)
    add([[8, 10, 9], [8, 9, 11], [9, 10, 11], [8, 11, 10]])
    grid.InsertNextCell(10, 4, [4, 5, 6, 8])
    add_data(grid, folder)
    for file in files_of(grid, folder, "polyhedra", "vtu"):
        for name, options in (("out.vtu", []), ("out.vtu", ["--ascii"]), ("out.vtk", []), ("out.vtk", ["--ascii"])):
            convert(file, folder / name, "--strict", *options)
            back = read_vtk(folder / name)
            what = f"{file.name} to {name} {options}"
            check(f"{what}: types", [back.GetCellType(c) for c in range(5)] == [42, 10, 42, 42, 10])
            for c in range(5):
                check(f"{what}: cell {c}", stream_of(back, c) == stream_of(grid, c))
            check(f"{what}: cell data", same_arrays(arrays(back.GetCellData()), arrays(grid.GetCellData())))


def roles(folder):
    grid = grid_of(10, [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    add_data(grid, folder)
    for name, n in (("vectors", 3), ("normals", 3), ("others", 3)):
        array = numpy_to_vtk(np.arange(4 * n).reshape(4, n) / 4, deep=True)
        array.SetName(name)
        grid.GetPointData().AddArray(array)
    for to in (grid.GetPointData(), grid.GetCellData()):
        to.SetActiveScalars(("p" if to == grid.GetPointData() else "c") + "i")
    grid.GetPointData().SetActiveVectors("vectors"), grid.GetPointData().SetActiveNormals("normals")
    for file in files_of(grid, folder, "roles", "vtu"):
        for name in ("out.vtu", "out.vtk"):
            convert(file, folder / name, "--strict")
            back = read_vtk(folder / name)
            what = f"{file.name} to {name}: the active"
            check(f"{what} scalars of points", back.GetPointData().GetScalars().GetName() == "pi")
            check(f"{what} vectors", back.GetPointData().GetVectors().GetName() == "vectors")
            check(f"{what} normals", back.GetPointData().GetNormals().GetName() == "normals")
            check(f"{what} scalars of cells", back.GetCellData().GetScalars().GetName() == "ci")


def kinds_of_data(folder):
    polygonal(folder)
    structured(folder)
    higher_order(folder)
    gmsh_orders(folder)
    polyhedra(folder)
    roles(folder)
