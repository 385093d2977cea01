# SPDX-License-Identifier: GPL-3.0-or-later
"""What meshio and VTK read of a file, in a process of its own."""
import os
import pickle
import re
import sys

from differential_meshes import Mesh

# What meshio and VTK call Gmsh's types of elements.
MESHIO = {"vertex": 15, "line": 1, "triangle": 2, "quad": 3, "tetra": 4, "hexahedron": 5, "wedge": 6, "pyramid": 7,
          "line3": 8, "line4": 26, "triangle6": 9, "quad9": 10, "tetra10": 11, "hexahedron27": 12, "wedge18": 13,
          "pyramid14": 14, "quad8": 16, "hexahedron20": 17, "wedge15": 18, "pyramid13": 19, "polygon": 34}
VTK = {1: 15, 3: 1, 5: 2, 7: 34, 9: 3, 10: 4, 12: 5, 13: 6, 14: 7, 21: 8, 22: 9, 23: 16, 24: 11, 25: 17, 26: 18,
       27: 19, 28: 10, 29: 12, 32: 13, 35: 26, 37: 14}



def meshio_read(path, rounded):
    import meshio
    mesh = meshio.read(path)
    points = [list(map(float, p)) + [0.0] * (3 - len(p)) for p in mesh.points]
    elements = []
    for block in mesh.cells:
        if re.fullmatch("polygon[0-9]*", block.type):
            kind = 34
        else:
            kind = MESHIO[block.type]
        elements += [(kind, [int(i) for i in nodes]) for nodes in block.data]
    return Mesh(points, elements, rounded)



def vtk_read(path, rounded):
    import vtk
    ending = path.suffix.lower()
    if ending == ".vtk":
        reader = vtk.vtkGenericDataObjectReader()
    else:
        reader = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".stl": vtk.vtkSTLReader, ".ply": vtk.vtkPLYReader,
                  ".obj": vtk.vtkOBJReader}[ending]()
    if ending == ".stl":
        reader.MergingOff()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    points = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    elements = []
    for c in range(data.GetNumberOfCells()):
        cell = data.GetCell(c)
        nodes = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        if data.GetCellType(c) == 13:  # VTK's wedge has the opposite orientation of Gmsh's prism
            nodes = [nodes[k] for k in (0, 2, 1, 3, 5, 4)]
        elements.append((VTK[data.GetCellType(c)], nodes))
    return Mesh(points, elements, rounded)


def apart(read, path, rounded, folder):
    """Calls `read` in a process of its own, because peers crash and exit. Returns the mesh and everything it printed."""
    said, result = folder / "said", folder / "result"
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        out = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(out, 1)
        os.dup2(out, 2)
        code = 1
        try:
            with open(result, "wb") as file:
                pickle.dump(read(path, rounded), file)
            code = 0
        except Exception as error:  # of any kind, from a peer
            print("%s: %s" % (type(error).__name__, str(error).split("\n")[0]))
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(code)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    words = said.read_text(errors="replace").split("\n")
    words = [re.sub("\x1b\\[[0-9;]*m", "", line).strip() for line in words]
    words = " ".join(line for line in words if line)
    if code != 0:
        raise ValueError("it crashes (signal %d)" % -code if code < 0 else "it refuses: " + words[-200:])
    with open(result, "rb") as file:
        return pickle.load(file), words
