# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the output of tetproof-verify --defects with VTK, and compares it with the mesh and the JSON report. Used by
verify_defects_test.cpp. Prints what is missing or superfluous; exit code 1 if there is any.

usage: defects.py {MESH.ele REPORT.json DEFECTS.vtu}..."""
import json
import math
import sys

import vtk


def read_mesh(path):
    def rows(name):
        with open(name) as file:
            return [line.split() for line in file if line.strip() and not line.startswith("#")][1:]
    points = {int(row[0]): tuple(map(float, row[1:4])) for row in rows(path[:-4] + ".node")}
    return points, {int(row[0]): tuple(map(int, row[1:5])) for row in rows(path)}


def read_vtu(path):
    """Cells as (type, points, {array: value})."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    data = grid.GetCellData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    cells = []
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        corners = [grid.GetPoint(cell.GetPointId(k)) for k in range(cell.GetNumberOfPoints())]
        cells.append((grid.GetCellType(c), corners, {a.GetName(): int(a.GetTuple1(c)) for a in arrays}))
    return cells, {a.GetName() for a in arrays}


def faults(mesh, report, vtu):
    points, tets = read_mesh(mesh)
    with open(report) as file:
        found = {check["id"]: check["findings"] for check in json.load(file)["checks"] if check["findings"]}
    cells, arrays = read_vtu(vtu)
    if arrays - {"entity"} != {"number", *found}:
        yield f"arrays {sorted(arrays)}"
    shown = {values["number"]: values for kind, _, values in cells if kind == vtk.VTK_TETRA}
    dots = [(corners[0], values) for kind, corners, values in cells if kind == vtk.VTK_VERTEX]
    if len(shown) + len(dots) != len(cells):
        yield "cells that are neither tetrahedra nor points"
    same = lambda a, b: all(x == y or math.isnan(x) and math.isnan(y) for x, y in zip(a, b))
    for kind, corners, values in cells:
        if kind == vtk.VTK_TETRA and not all(same(a, points[v]) for a, v in zip(corners, tets[values["number"]])):
            yield f"tetrahedron {values['number']} has other points than the file"

    touched, marked = set(), {id: set() for id in found}
    for id, findings in found.items():
        for finding in findings:
            named = set(finding["vertices"])
            for t in finding["tets"]:
                marked[id].add(t)
                touched |= set(tets[t])
                if not set(tets[t]) <= set(points):
                    named |= set(tets[t])
            for face in finding["faces"]:
                touched |= set(face)
            touched |= named
            for v in named & set(points):
                if all(map(math.isfinite, points[v])) and not any(
                        values[id] and values["number"] == v and at == points[v] for at, values in dots):
                    yield f"{id}: vertex {v} is not there"
            if finding["point"] and not any(values[id] and at == tuple(finding["point"]) for at, values in dots):
                yield f"{id}: the point {finding['point']} is not there"
    ring = {t for t, corners in tets.items() if touched & set(corners) and set(corners) <= set(points)}
    if set(shown) != ring:
        yield f"tetrahedra {sorted(set(shown) ^ ring)} are missing or too much"
    for id in found:
        wrong = {t for t, values in shown.items() if values[id] != (t in marked[id])}
        if wrong:
            yield f"{id}: tetrahedra {sorted(wrong)} are marked wrongly"


def main():
    code = 0
    for case in zip(*[iter(sys.argv[1:])] * 3):
        for fault in faults(*case):
            print(f"{case[0]}: {fault}")
            code = 1
    return code


if __name__ == "__main__":
    sys.exit(main())
