#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs verifiers of tetrahedral meshes on the files of this folder and prints, as a Markdown table, which of them sees which defect.

usage: matrix.py [--verify PROGRAM] [--every N] [--python PYTHON_WITH_VTK] > MATRIX.md

Exit code: 0; or 1 if tetproof-verify misses a defective mesh, or calls another mesh defective. Tools that are not installed are left out. OpenFOAM's checkMesh
gets the mesh that its gmshToFoam writes. OpenFOAM is expected at WM_PROJECT_DIR or, if that is not set, at /usr/share/openfoam."""
import argparse
import collections
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SEES, SILENT, REFUSES, CRASHES = "sees", "-", "refuses", "crashes"

VTK = """
import sys, vtk
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
vtk.vtkObject.GlobalWarningDisplayOff()
for path in sys.argv[1:]:
    words = open(path).read().split()
    at = words.index("$Nodes") + 1
    n = int(words[at])
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for i in range(n):
        points.InsertNextPoint(*map(float, words[at + 2 + 4 * i:at + 5 + 4 * i]))
    at = words.index("$Elements") + 1
    tets, cells = [], int(words[at])
    for i in range(cells):
        end = at + 1
        line = words[end:end + 3]
        tags = int(line[2])
        tets.append([int(w) - 1 for w in words[end + 3 + tags:end + 7 + tags]])
        at = end + 3 + tags + 4 - 1
    if any(v < 0 or v >= n for tet in tets for v in tet):
        print(path, "refuses", flush=True)  # vtkUnstructuredGrid cannot hold such a mesh
        continue
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    for tet in tets:
        grid.InsertNextCell(vtk.VTK_TETRA, 4, tet)
    validator = vtk.vtkCellValidator()
    validator.SetInputData(grid)
    validator.Update()
    states = validator.GetOutput().GetCellData().GetArray("ValidityState")
    wrong = sum(states.GetValue(i) != 0 for i in range(states.GetNumberOfTuples()))
    print(path, "sees" if wrong else "-", flush=True)
"""


def run(command, folder):
    """Runs a command. Returns its exit code (negative: a signal; None: it did not end within 20 seconds) and its whole output."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=20)
        return done.returncode, done.stdout + done.stderr
    except subprocess.TimeoutExpired:
        return None, ""


def crashed(code):
    return code is None or code < 0 or code >= 128


class Verify:
    def __init__(self, program):
        self.name, self.program = "tetproof-verify", program
        self.version = run([program, "--version"], HERE)[1].split("\n")[0]

    def judge(self, stem, folder):
        code, said = run([self.program, stem + ".msh"], folder)
        return CRASHES if crashed(code) else REFUSES if code == 2 else SEES if code == 1 else SILENT


class Gmsh:
    name, version = "gmsh -check", None

    def __init__(self):
        self.version = "Gmsh " + run(["gmsh", "--version"], HERE)[1].strip()

    def judge(self, stem, folder):
        code, said = run(["gmsh", "-check", stem + ".msh"], folder)
        if crashed(code):
            return CRASHES
        if "Error loading" in said:
            return REFUSES
        return SEES if code or re.search(r"^(Warning|Error) *:", said, re.M) else SILENT


class TetGen:
    name = "tetgen -rC"

    def __init__(self):
        code, said = run(["dpkg-query", "-W", "-f", "${Version}", "tetgen"], HERE) if shutil.which("dpkg-query") else (1, "")
        self.version = "TetGen" + (" " + said.split("-")[0] if code == 0 else "")  # TetGen does not print its version

    def judge(self, stem, folder):
        for ending in (".node", ".ele"):
            shutil.copy(stem + ending, folder)
        code, said = run(["tetgen", "-rC", os.path.basename(stem)], folder)
        if crashed(code):
            return CRASHES
        if "!!" in said or "appears to be consistent" not in said:
            return SEES if "Checking consistency" in said else REFUSES
        return SILENT


class Vtk:
    name = "VTK"

    def __init__(self, python):
        self.python = python
        self.version = "VTK " + run([python, "-c", "import vtk; print(vtk.vtkVersion().GetVTKVersion())"], HERE)[1].strip() + ", vtkCellValidator"

    def judge(self, stem, folder):
        code, said = run([self.python, "-c", VTK, stem + ".msh"], folder)
        last = said.rstrip().split("\n")[-1]  # the validator may print many lines before it
        return last.split()[-1] if code == 0 and last.startswith(stem) else CRASHES


class Foam:
    name = "checkMesh"

    def __init__(self):
        os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
        found = re.search(r"OpenFOAM-([0-9v.]+)|OpenFOAM-? ?\(([0-9v.]+)\)", run(["checkMesh", "-help"], HERE)[1])
        self.version = f"OpenFOAM {(found.group(1) or found.group(2)) + ', ' if found else ''}gmshToFoam and checkMesh"

    def judge(self, stem, folder):
        case = os.path.join(folder, "case")
        shutil.rmtree(case, ignore_errors=True)
        os.makedirs(os.path.join(case, "system"))
        schemes = "".join(f"{kind}Schemes {{}} " for kind in ("ddt", "grad", "div", "laplacian", "interpolation", "snGrad"))
        run_control = "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;"
        for name, text in (("controlDict", run_control), ("fvSchemes", schemes), ("fvSolution", "")):
            with open(os.path.join(case, "system", name), "w") as file:
                file.write(f"FoamFile {{ version 2.0; format ascii; class dictionary; object {name}; }}\n{text}\n")
        code, said = run(["gmshToFoam", stem + ".msh"], case)
        if code != 0:
            return REFUSES if "FOAM FATAL" in said and not crashed(code) else CRASHES
        code, said = run(["checkMesh"], case)
        if crashed(code):
            return CRASHES
        return SILENT if "Mesh OK." in said else SEES


def tools(arguments):
    found = [Verify(arguments.verify)]
    if shutil.which("gmsh"):
        found.append(Gmsh())
    if shutil.which("tetgen"):
        found.append(TetGen())
    if run([arguments.python, "-c", "import vtk"], HERE)[0] == 0:
        found.append(Vtk(arguments.python))
    if shutil.which("checkMesh") and shutil.which("gmshToFoam"):
        found.append(Foam())
    return found


def shown(entry, outcome):
    return "**complains**" if entry["verdict"] == "sound" and outcome != SILENT else outcome


def print_table(header, rows):
    print("|", " | ".join(header), "|")
    print("|---" * len(header) + "|")
    for row in rows:
        print("|", " | ".join(map(str, row)), "|")
    print()


THEMES = {"numbers": "numbers of points", "coordinates": "coordinates", "points": "points", "duplicates": "duplicate tetrahedra", "orientation": "orientation, flatness",
          "overlap": "overlaps", "boundary": "the boundary touches itself", "conformity": "hanging nodes, crossed diagonals", "cracks": "cracks", "two": "two defects at once"}


def theme(entry):
    return next((THEMES[flag] for flag in entry["flags"] if flag in THEMES), "other")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    default = os.path.join(HERE, "..", "..", "build", "tetproof-verify")
    parser.add_argument("--verify", default=shutil.which("tetproof-verify") or default)
    parser.add_argument("--every", type=int, default=1, help="use only every N-th mesh")
    parser.add_argument("--python", default="/usr/bin/python3", help="a Python with VTK")
    arguments = parser.parse_args()
    with open(os.path.join(HERE, "index.json")) as file:
        entries = json.load(file)[::arguments.every]
    used = tools(arguments)
    with tempfile.TemporaryDirectory() as folder:
        outcomes = {entry["id"]: [tool.judge(os.path.join(HERE, entry["id"]), folder) for tool in used] for entry in entries}

    print("# Who sees what\n")
    print("Made by `corpus/bad-meshes/matrix.py` with " + "; ".join(tool.version for tool in used) + ".\n")
    print("`sees`: the tool says, by its exit code or in words, that something is wrong. `-`: it says nothing. `refuses`: it does not read the mesh. `crashes`: it ends by a signal, or does not end within 20 seconds.")
    print("If a tool **complains** of a sound mesh, it is a false alarm, or a remark on quality, which some tools also measure. On a debatable mesh both answers are right.")
    print("The other tools were built for other purposes, and some of these defects are not their subject; we know no dedicated verifier to compare with.\n")
    names = [tool.name for tool in used]
    rows, themes = [], collections.defaultdict(list)
    for entry in entries:
        if entry["verdict"] == "defective":
            themes[theme(entry)].append(outcomes[entry["id"]])
    for title in [*THEMES.values(), "other"]:
        group = themes.get(title)
        if group:
            rows.append([title, len(group), *(sum(o[i] == SEES for o in group) for i in range(len(used)))])
    defective = [o for group in themes.values() for o in group]
    for title, outcome in (("**defective, seen**", SEES), ("defective, silent", SILENT), ("defective, refused", REFUSES), ("defective, crashed", CRASHES)):
        rows.append([title, len(defective), *(sum(o[i] == outcome for o in defective) for i in range(len(used)))])
    sound = [entry for entry in entries if entry["verdict"] == "sound"]
    rows.append(["sound, complained of", len(sound), *(sum(outcomes[e["id"]][i] != SILENT for e in sound) for i in range(len(used)))])
    print_table(["defects", "meshes", *names], rows)
    print_table(["mesh", "verdict", *names], [[f"[{e['id']}]({e['id']}.msh)", e["verdict"], *(shown(e, o) for o in outcomes[e["id"]])] for e in entries])

    wrong = [e["id"] for e in entries if (outcomes[e["id"]][0] == SEES) != (e["verdict"] == "defective")]
    if wrong:
        print("tetproof-verify is wrong on: " + ", ".join(wrong), file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
