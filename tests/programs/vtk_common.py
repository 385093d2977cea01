# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tetproof-convert and VTK's readers, and collects what fails."""
import pathlib
import shutil
import subprocess

import vtk

BUILD = pathlib.Path()  # set by vtk_files.py
GMSH = shutil.which("gmsh")
failures = []


def check(what, ok):
    if not ok:
        failures.append(what)
        print("FAILED:", what)


class Complaints:
    """Collects errors and warnings, which VTK reports as events."""

    def __init__(self, *objects):
        self.said = []
        for one in objects:
            for event in ("ErrorEvent", "WarningEvent"):
                one.AddObserver(event, lambda *_: self.said.append(event))


def convert(*arguments, code=0):
    run = subprocess.run([str(BUILD / "tetproof-convert"), *map(str, arguments)], capture_output=True, text=True, timeout=60)
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
