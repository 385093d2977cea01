#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK's and Medit's files beside the programs that own them.

Files that VTK writes in every mode must come through tetproof-convert as VTK reads them itself; what
tetproof-convert writes, VTK, meshio and Gmsh must read without a warning and with equal content; and each of
them must see the mid-edge nodes of second-order elements at the middle of the edges."""
import argparse
import itertools
import pathlib
import shutil
import subprocess
import sys
import tempfile
import warnings

try:
    import meshio
    import numpy as np
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

failures = []


def check(what, ok):
    if not ok:
        failures.append(what)
        print("FAILED:", what)


class Complaints:
    """What VTK says by other means than the return value."""

    def __init__(self, *objects):
        self.said = []
        for one in objects:
            for event in ("ErrorEvent", "WarningEvent"):
                one.AddObserver(event, lambda *_: self.said.append(event))


def convert(*arguments, code=0):
    run = subprocess.run([CONVERT, *map(str, arguments)], capture_output=True, text=True, timeout=60)
    check(f"tetproof-convert {' '.join(map(str, arguments))}: {run.stderr.strip()}", run.returncode == code)


def read_vtk(path):
    reader = vtk.vtkXMLUnstructuredGridReader() if str(path).endswith(".vtu") else vtk.vtkUnstructuredGridReader()
    complaints = Complaints(reader)
    reader.SetFileName(str(path))
    if not str(path).endswith(".vtu"):
        reader.ReadAllScalarsOn(), reader.ReadAllVectorsOn(), reader.ReadAllFieldsOn()
    reader.Update()
    check(f"VTK reads {path.name} without a word", not complaints.said)
    return reader.GetOutput()


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
    """Real numbers are of few digits, since VTK writes no more in legacy text."""
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
    for mode, packed, order, header in itertools.product(("Ascii", "Binary", "Appended", "Raw"), (False, True),
                                                          ("Little", "Big"), (32, 64)):
        writer = vtk.vtkXMLUnstructuredGridWriter()
        files.append(folder / f"{mode}-{'zlib' if packed else 'plain'}-{order}-{header}.vtu")
        {"Ascii": writer.SetDataModeToAscii, "Binary": writer.SetDataModeToBinary}.get(mode, writer.SetDataModeToAppended)()
        writer.SetEncodeAppendedData(mode == "Appended")
        writer.SetCompressorTypeToZLib() if packed else writer.SetCompressorTypeToNone()
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


corners = {
    "line": [(0, 0, 0), (1, 0, 0)],
    "triangle": [(0, 0, 0), (1, 0, 0), (0, 1, 0)],
    "quad": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
    "tetra": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "hexahedron": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
    "wedge": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)],
    "pyramid": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)],
}
# Gmsh's type, its shape, and between which corners its further nodes stand: Gmsh's manual, "Node ordering".
elements = [
    (1, "line", ""), (2, "triangle", ""), (3, "quad", ""), (4, "tetra", ""), (5, "hexahedron", ""), (6, "wedge", ""),
    (7, "pyramid", ""), (8, "line", "01"), (9, "triangle", "01 12 02"), (16, "quad", "01 12 23 03"),
    (10, "quad", "01 12 23 03 0123"), (11, "tetra", "01 12 02 03 23 13"),
    (17, "hexahedron", "01 03 04 12 15 23 26 37 45 47 56 67"),
    (12, "hexahedron", "01 03 04 12 15 23 26 37 45 47 56 67 0123 0145 0347 1256 2367 4567 01234567"),
    (18, "wedge", "01 02 03 12 14 25 34 35 45"), (13, "wedge", "01 02 03 12 14 25 34 35 45 0134 0235 1245"),
    (19, "pyramid", "01 03 04 12 14 23 24 34"),
]
# Gmsh 4.8 writes VTK's order of these, and reads them back in another one; quadratic pyramids it does not know.
gmsh_reads_otherwise = {6, 12, 13, 17, 18, 19}
in_medit = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}


def nodes_of(shape, between):
    p = np.array(corners[shape], dtype=float)
    return np.vstack([p] + [p[[int(c) for c in word]].mean(axis=0) for word in between.split()])


def write_msh(path, kind, points):
    path.write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n%s$EndNodes\n$Elements\n1\n1 %d 2 1 1 %s\n$EndElements\n" % (
        len(points), "".join("%d %r %r %r\n" % (i + 1, *map(float, p)) for i, p in enumerate(points)), kind,
        " ".join(str(i + 1) for i in range(len(points)))))


def corner_pairs(cell):
    """Mid-edge node and its corners, as VTK sees the cell."""
    for e in range(cell.GetNumberOfEdges()):
        edge = cell.GetEdge(e)
        if edge.GetNumberOfPoints() == 3:
            yield edge.GetPointId(2), edge.GetPointId(0), edge.GetPointId(1)


def gmsh_reads_binary(folder):
    """Whether Gmsh reads the binary .vtk that it writes itself. 4.8.4 does; 4.13.1 says "Error loading" of every one."""
    write_msh(folder / "in.msh", 4, nodes_of("tetra", ""))
    subprocess.run([GMSH, "-0", "-bin", folder / "in.msh", "-o", folder / "own.vtk", "-format", "vtk"], capture_output=True, timeout=60)
    run = gmsh(folder, "own.vtk", "back.msh", "msh22")
    if "Error loading" not in run.stdout + run.stderr:
        return True
    version = subprocess.run([GMSH, "--version"], capture_output=True, text=True, timeout=60)
    print(f"Gmsh {(version.stdout + version.stderr).strip()} does not read its own binary .vtk: it is given text")
    return False


def orders_of_nodes(folder):
    encoding = [] if gmsh_reads_binary(folder) else ["--ascii"]
    for kind, shape, between in elements:
        points = nodes_of(shape, between)
        write_msh(folder / "in.msh", kind, points)
        for name in ("x.vtu", "x.vtk"):
            convert(folder / "in.msh", folder / name)
            grid = read_vtk(folder / name)
            cell = grid.GetCell(0)
            check(f"type {kind} in {name}: {len(points)} nodes", cell.GetNumberOfPoints() == len(points))
            for middle, a, b in corner_pairs(cell):
                check(f"type {kind} in {name}: VTK sees node {middle} between {a} and {b}",
                      np.allclose(grid.GetPoint(middle), (np.array(grid.GetPoint(a)) + grid.GetPoint(b)) / 2, atol=1e-15))
            # The cell's own coordinates of each node are where its interpolation finds that node.
            for k in range(len(points)):
                at, weights = [0.0] * 3, [0.0] * len(points)
                parametric = cell.GetParametricCoords()
                cell.EvaluateLocation(vtk.reference(0), parametric[3 * k:3 * k + 3], at, weights)
                check(f"type {kind} in {name}: VTK finds node {k} where it is",
                      np.allclose(at, grid.GetPoint(cell.GetPointId(k)), atol=1e-12))
            if kind not in (13, 18, 19):  # which meshio 5.0 has no use for
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    mesh = meshio.read(folder / name)
                    expected = meshio.read(folder / "in.msh")
                # meshio puts Gmsh's orders into VTK's, in which it keeps all cells.
                check(f"type {kind} in {name}: meshio sees the same element",
                      len(mesh.cells) == 1 and mesh.cells[0].type == expected.cells[0].type and
                      np.array_equal(mesh.points[mesh.cells[0].data], expected.points[expected.cells[0].data]))
            if name == "x.vtk" and kind not in gmsh_reads_otherwise:
                convert(folder / "in.msh", folder / "gmsh_in.vtk", *encoding)
                run = gmsh(folder, "gmsh_in.vtk", "back.msh", "msh22")
                gmsh_sees(folder, kind, name, points, run)
            comes_back(folder, name, kind, points)
        if kind != 19:
            gmsh(folder, "in.msh", "gmsh.vtk", "vtk")
            comes_back(folder, "gmsh.vtk", kind, points)
        if kind not in in_medit:
            continue
        for name in ("x.mesh", "x.meshb"):
            convert(folder / "in.msh", folder / name)
            comes_back(folder, name, kind, points)
            if kind < 8:
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    mesh = meshio.read(folder / name)
                check(f"type {kind} in {name}: meshio sees the same element",
                      mesh.cells[0].type == shape and np.array_equal(mesh.points[mesh.cells[0].data[0]], points))
        if kind in (4, 5, 8, 9, 11):  # Gmsh 4.8 reads no prisms and pyramids
            gmsh_sees(folder, kind, "x.mesh", points, gmsh(folder, "x.mesh", "back.msh", "msh22"))


def comes_back(folder, name, kind, points):
    convert(folder / name, folder / "again.msh", "--to", "msh22")
    found = element_of(folder / "again.msh")
    check(f"type {kind} comes back from {name}: {found}", found == (kind, [tuple(p) for p in points]))


def gmsh(folder, name, out, form):
    return subprocess.run([GMSH, "-0", folder / name, "-o", folder / out, "-format", form], capture_output=True,
                          text=True, timeout=60)


def element_of(path):
    """Type and coordinates, in order, of the only element of a .msh 2.2."""
    lines = path.read_text().split("\n")
    start = lines.index("$Nodes")
    nodes = {}
    for line in lines[start + 2:start + 2 + int(lines[start + 1])]:
        number, *xyz = line.split()
        nodes[number] = tuple(map(float, xyz))
    row = lines[lines.index("$Elements") + 2].split()
    return int(row[1]), [nodes[n] for n in row[3 + int(row[2]):]]


def gmsh_sees(folder, kind, name, points, run):
    what = f"type {kind} in {name}: Gmsh sees the same element"
    said = [line for line in (run.stdout + run.stderr).split("\n") if "Warning" in line or "Error" in line]
    check(f"{what}: {said}", run.returncode == 0 and not said)
    if not said and (folder / "back.msh").exists():
        found = element_of(folder / "back.msh")
        check(f"{what}: {found}", found[0] == kind and np.allclose(found[1], points, atol=1e-15))
        (folder / "back.msh").unlink()


def faces_look_outwards(folder):
    """VTK's faces of linear cells turn outwards: its order of a wedge's corners is not Gmsh's."""
    for kind, shape, between in elements[3:7]:
        write_msh(folder / "in.msh", kind, nodes_of(shape, between))
        convert(folder / "in.msh", folder / "x.vtu")
        cell = read_vtk(folder / "x.vtu").GetCell(0)
        middle = np.mean(corners[shape], axis=0)
        for f in range(cell.GetNumberOfFaces()):
            p = [np.array(cell.GetFace(f).GetPoints().GetPoint(k)) for k in range(3)]
            check(f"face {f} of {shape} looks outwards", np.dot(np.cross(p[1] - p[0], p[2] - p[0]), p[0] - middle) > 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True)
    CONVERT = str(pathlib.Path(parser.parse_args().build) / "tetproof-convert")
    GMSH = shutil.which("gmsh")
    if not GMSH:
        print("skipped: there is no gmsh")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        written_by_vtk(pathlib.Path(name))
        faces_look_outwards(pathlib.Path(name))
        orders_of_nodes(pathlib.Path(name))
    print(f"{len(failures)} failures")
    sys.exit(1 if failures else 0)
