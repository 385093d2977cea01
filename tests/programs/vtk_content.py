# SPDX-License-Identifier: GPL-3.0-or-later
"""A grid with all kinds of cells and arrays: we must read every mode in which VTK writes it, and VTK must read ours."""
import itertools

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from vtk_common import check, convert, read_vtk


def arrays(data):
    found = {}
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        if isinstance(array, vtk.vtkStringArray):
            found[array.GetName()] = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
        else:
            found[array.GetName()] = vtk_to_numpy(array).astype(float if array.GetDataType() in (10, 11) else int)
    return found


def same_arrays(a, b):
    return a.keys() == b.keys() and all(
        (a[k] == b[k] if isinstance(a[k], list) else np.array_equal(a[k], b[k])) for k in a)


def cells(grid):
    return [(grid.GetCellType(c), [grid.GetCell(c).GetPointId(k) for k in range(grid.GetCell(c).GetNumberOfPoints())])
            for c in range(grid.GetNumberOfCells())]


def grid_of_everything():
    """Real numbers have few digits, because VTK writes no more in legacy text."""
    grid, points = vtk.vtkUnstructuredGrid(), vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for p in [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0.375), (1, 0, 1), (0.125, 0.75, 2), (3, 2, 1)]:
        points.InsertNextPoint(p)
    grid.SetPoints(points)
    for kind, ids in [(10, [0, 1, 2, 3]), (10, [1, 2, 3, 4]), (5, [0, 1, 2]), (9, [0, 1, 5, 3]), (7, [0, 1, 2, 3, 4]),
                      (13, [0, 1, 2, 3, 4, 5]), (3, [6, 7]), (1, [7])]:
        grid.InsertNextCell(kind, len(ids), ids)

    def add(to, kind, name, items, components, value):
        array = kind()
        array.SetName(name)
        array.SetNumberOfComponents(components)
        array.SetNumberOfTuples(items)
        for i in range(items * components):
            array.SetValue(i, value(i))
        to.AddArray(array)

    add(grid.GetPointData(), vtk.vtkDoubleArray, "doubles <&>", 8, 2, lambda i: i / 8 - 0.25)
    add(grid.GetPointData(), vtk.vtkFloatArray, "floats", 8, 1, lambda i: i / 4)
    for kind in (vtk.vtkSignedCharArray, vtk.vtkShortArray, vtk.vtkIntArray, vtk.vtkLongLongArray):
        add(grid.GetCellData(), kind, kind.__name__, 8, 1, lambda i: -3 * i)
    for kind in (vtk.vtkUnsignedCharArray, vtk.vtkUnsignedShortArray, vtk.vtkUnsignedIntArray,
                 vtk.vtkUnsignedLongLongArray, vtk.vtkIdTypeArray):
        add(grid.GetCellData(), kind, kind.__name__, 8, 1, lambda i: 31 * i)
    add(grid.GetFieldData(), vtk.vtkDoubleArray, "TimeValue", 1, 1, lambda i: 2.5)
    add(grid.GetFieldData(), vtk.vtkStringArray, "notes", 2, 1, lambda i: ["one two", "50% of it"][i])
    return grid


def written_by_vtk(folder):
    grid = grid_of_everything()
    expected = (cells(grid), *(arrays(d) for d in (grid.GetPointData(), grid.GetCellData(), grid.GetFieldData())))
    files = []
    for mode, packed, order, header in itertools.product(("Ascii", "Binary", "Appended", "Raw"), ("None", "ZLib", "LZ4", "LZMA"),
                                                          ("Little", "Big"), (32, 64)):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        files.append(folder / f"{mode}-{packed}-{order}-{header}.vtu")
        {"Ascii": writer.SetDataModeToAscii, "Binary": writer.SetDataModeToBinary}.get(mode, writer.SetDataModeToAppended)()
        writer.SetEncodeAppendedData(mode == "Appended")
        getattr(writer, f"SetCompressorTypeTo{packed}")()
        writer.SetBlockSize(64)
        getattr(writer, f"SetByteOrderTo{order}Endian")()
        getattr(writer, f"SetHeaderTypeToUInt{header}")()
        writer.SetInputData(grid), writer.SetFileName(str(files[-1])), writer.Write()
    for version, binary in itertools.product((42, 51), (False, True)):
        writer = vtk.vtkUnstructuredGridWriter()
        files.append(folder / f"legacy-{version}-{'binary' if binary else 'text'}.vtk")
        writer.SetHeader(""), writer.SetFileVersion(version), writer.SetFileType(2 if binary else 1)
        writer.SetInputData(grid), writer.SetFileName(str(files[-1])), writer.Write()
    outputs = set()
    for file in files:
        out = folder / "out.vtu"
        convert(file, out, "--strict")
        outputs.add(out.read_bytes().replace(b"\n", b""))
        if len(outputs) > 1:
            check(f"{file.name} is read as the others", False)
            outputs.pop()
    for name, options in (("x.vtu", ["--ascii"]), ("x.vtu", []), ("x.vtk", ["--ascii"]), ("x.vtk", [])):
        convert(files[0], folder / name, "--strict", *options)
        back = read_vtk(folder / name)
        found = (cells(back), *(arrays(d) for d in (back.GetPointData(), back.GetCellData(), back.GetFieldData())))
        what = f"{name} {options} is the grid that VTK wrote"
        check(what + ": cells", found[0] == expected[0])
        for k, kind in enumerate(("point", "cell", "field"), 1):
            check(f"{what}: {kind} data", same_arrays(found[k], expected[k]))
        check(what + ": points", np.array_equal(vtk_to_numpy(back.GetPoints().GetData()),
                                                vtk_to_numpy(grid.GetPoints().GetData())))
