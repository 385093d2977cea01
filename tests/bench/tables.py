#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The README's tables about the grids themselves, made by running tetproof-mesh.

usage: tests/bench/tables.py [BUILD]      BUILD: the folder with the programs, build/ beside this project by default
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build"


def mesh(surface, *options):
    """The JSON report of one run of tetproof-mesh."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        run = subprocess.run(
            [BUILD / "tetproof-mesh", str(surface), "-o", pathlib.Path(folder) / "grid.msh", "--binary", "--quiet",
             "--json", report, "--voxels", "0", *map(str, options)],
            stdout=subprocess.DEVNULL, check=False)
        if run.returncode not in (0, 1):
            sys.exit(f"tetproof-mesh {surface} {options}: exit {run.returncode}")
        return json.loads(report.read_text())


def convergence():
    print("Volume of the grid against the surface's, inside; the order is that between the row and the one above it.\n")
    print("| surface | cells | tetrahedra | relative difference of volume | order |")
    print("|---|---|---|---|---|")
    for name, surface in (("sphere", "sphere:r=1,n=500000"), ("torus", "torus:R=1,r=0.4,n=500000")):
        before = None
        for cells in (8, 16, 32, 64, 128):
            report = mesh(surface, "--cells", cells)
            difference = report["volume"]["relative_difference"]
            order = f"{math.log2(before / difference):.2f}" if before else ""
            before = difference
            print(f"| {name} | {cells} | {report['mesh']['tets']:,} | {difference:.2e} | {order} |")
    print()


def tolerance():
    print("What `--on-surface` costs and brings (24 cells, inside).\n")
    print("| surface | tolerance | vertices moved | smallest dihedral angle | smallest solid angle / 4 pi | "
          "relative difference of volume | non-manifold edges, vertices |")
    print("|---|---|---|---|---|---|---|")
    surfaces = (("spot.obj", ROOT / "corpus/surfaces/spot.obj"), ("torus", "torus:R=1,r=0.4,n=26000"))
    for name, surface in surfaces:
        for tolerance_ in (0, 1e-6, 1e-3, 0.01, 0.05, 0.1, 0.15):
            report = mesh(surface, "--on-surface", tolerance_)
            checks = {check["id"]: check["count"] for check in report["checks"]}
            quality = report["quality"]
            print(f"| {name} | {tolerance_:g} | {report['generation']['moved_to_surface']:,} | "
                  f"{quality['dihedral_angles']['min']:.2g} | {quality['solid_angles']['min']:.1e} | "
                  f"{report['volume']['relative_difference']:.2e} | "
                  f"{checks['boundary-nonmanifold-edge']}, {checks['boundary-nonmanifold-vertex']} |")
    print()


convergence()
tolerance()
