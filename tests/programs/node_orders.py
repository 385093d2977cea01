# SPDX-License-Identifier: GPL-3.0-or-later
"""Elements of every type in VTK and Medit files: each node is where VTK, meshio and Gmsh expect it."""
import subprocess
import warnings

import meshio
import numpy as np
import vtk

from vtk_common import GMSH, check, convert, read_vtk

corners = {
    "line": [(0, 0, 0), (1, 0, 0)],
    "triangle": [(0, 0, 0), (1, 0, 0), (0, 1, 0)],
    "quad": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
    "tetra": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "hexahedron": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)],
    "wedge": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1)],
    "pyramid": [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)],
}
# Gmsh's type, its shape, and the corners between which its other nodes are, from Gmsh's manual, "Node ordering".
elements = [
    (1, "line", ""), (2, "triangle", ""), (3, "quad", ""), (4, "tetra", ""), (5, "hexahedron", ""), (6, "wedge", ""),
    (7, "pyramid", ""), (8, "line", "01"), (9, "triangle", "01 12 02"), (16, "quad", "01 12 23 03"),
    (10, "quad", "01 12 23 03 0123"), (11, "tetra", "01 12 02 03 23 13"),
    (17, "hexahedron", "01 03 04 12 15 23 26 37 45 47 56 67"),
    (12, "hexahedron", "01 03 04 12 15 23 26 37 45 47 56 67 0123 0145 0347 1256 2367 4567 01234567"),
    (18, "wedge", "01 02 03 12 14 25 34 35 45"), (13, "wedge", "01 02 03 12 14 25 34 35 45 0134 0235 1245"),
    (19, "pyramid", "01 03 04 12 14 23 24 34"),
]
# Gmsh 4.8 writes these in VTK's order but reads them in another one. It does not know quadratic pyramids.
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
    """Each mid-edge node and its two corners, as VTK sees the cell."""
    for e in range(cell.GetNumberOfEdges()):
        edge = cell.GetEdge(e)
        if edge.GetNumberOfPoints() == 3:
            yield edge.GetPointId(2), edge.GetPointId(0), edge.GetPointId(1)


def gmsh_reads_binary(folder):
    """Whether Gmsh reads its own binary .vtk. 4.8.4 does; 4.13.1 says "Error loading" for every one."""
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
            # At the parametric coordinates of each node, the cell's interpolation gives that node.
            for k in range(len(points)):
                at, weights = [0.0] * 3, [0.0] * len(points)
                parametric = cell.GetParametricCoords()
                cell.EvaluateLocation(vtk.reference(0), parametric[3 * k:3 * k + 3], at, weights)
                check(f"type {kind} in {name}: VTK finds node {k} where it is",
                      np.allclose(at, grid.GetPoint(cell.GetPointId(k)), atol=1e-12))
            if kind not in (13, 18, 19):  # meshio 5.0 does not read these
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    mesh = meshio.read(folder / name)
                    expected = meshio.read(folder / "in.msh")
                # meshio converts Gmsh's orders into VTK's, which it uses for all cells.
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
        if kind in (4, 5, 8, 9, 11):  # Gmsh 4.8 does not read prisms and pyramids
            gmsh_sees(folder, kind, "x.mesh", points, gmsh(folder, "x.mesh", "back.msh", "msh22"))


def comes_back(folder, name, kind, points):
    convert(folder / name, folder / "again.msh", "--to", "msh22")
    found = element_of(folder / "again.msh")
    check(f"type {kind} comes back from {name}: {found}", found == (kind, [tuple(p) for p in points]))


def gmsh(folder, name, out, form):
    return subprocess.run([GMSH, "-0", folder / name, "-o", folder / out, "-format", form], capture_output=True,
                          text=True, timeout=60)


def element_of(path):
    """The type and the coordinates, in order, of the only element of a .msh 2.2."""
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
    """VTK's faces of linear cells point outwards. VTK orders the corners of a wedge differently from Gmsh."""
    for kind, shape, between in elements[3:7]:
        write_msh(folder / "in.msh", kind, nodes_of(shape, between))
        convert(folder / "in.msh", folder / "x.vtu")
        cell = read_vtk(folder / "x.vtu").GetCell(0)
        middle = np.mean(corners[shape], axis=0)
        for f in range(cell.GetNumberOfFaces()):
            p = [np.array(cell.GetFace(f).GetPoints().GetPoint(k)) for k in range(3)]
            check(f"face {f} of {shape} looks outwards", np.dot(np.cross(p[1] - p[0], p[2] - p[0]), p[0] - middle) > 0)
