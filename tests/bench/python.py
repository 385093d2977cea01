#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python package costs beside the program, on a mesh of a million tetrahedra.

usage: python.py BUILD [--cells N] [--runs K]
Each line is a median of K runs: the verdict itself as the program times it (its phases without reading), the call of
`tetproof.verify` in all, and what of it brings the arrays to the judge. The two verdicts take turns, since machines drift.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--cells", type=int, default=76)
    parser.add_argument("--runs", type=int, default=7)
    options = parser.parse_args()
    sys.path.insert(0, str(options.build.resolve() / "python"))
    import numpy as np
    import tetproof
    from tetproof import _core, _meshes

    points, tets = tetproof.mesh("sphere:r=1,n=5000", cells=options.cells)
    wide = tets.astype(np.int64)
    layouts = {"float64, int32, in C's order": (points, tets), "float64, int64": (points, wide),
               "in Fortran's order": (np.asfortranarray(points), np.asfortranarray(wide)),
               "of the other byte order": (points.astype(">f8"), wide.astype(">i8"))}
    flat = np.insert(wide, 0, 4, axis=1).ravel()
    grid = type("Grid", (), {"points": points, "cells": flat, "celltypes": np.full(len(tets), 10, np.uint8)})
    times = {name: [] for name in ("program", "judge", *layouts, "grid")}
    calls = {name: [] for name in (*layouts, "grid")}

    def seconds(work):
        start = time.perf_counter()
        result = work()
        return time.perf_counter() - start, result

    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "grid.msh"
        tetproof.write(file, (points, tets), binary=True)
        for _ in range(options.runs):
            done = subprocess.run([str(options.build / "tetproof-verify"), str(file), "--timings", "--json", "-"],
                                  capture_output=True, text=True)
            phases = json.loads(done.stdout)["seconds"]
            times["program"].append(sum(s for phase, s in phases.items() if phase != "reading"))
            for name, arrays in layouts.items():
                calls[name].append(seconds(lambda: tetproof.verify(*arrays))[0])
                times[name].append(seconds(lambda: _core.Mesh(
                    tetproof._arrays.point_array(arrays[0]), tetproof._arrays.index_array(arrays[1], 4, "tets")))[0])
            calls["grid"].append(seconds(lambda: tetproof.verify(grid))[0])
            times["grid"].append(seconds(lambda: _meshes.judged(grid))[0])
    program = statistics.median(times["program"])
    print(f"{len(tets):,} tetrahedra; the program's verdict, without reading: {program:.4f} s\n")
    print("| the mesh as | call s | over the program's verdict | bringing it to the judge s | of the verdict |\n|---|---|---|---|---|")
    for name in calls:
        call, bringing = statistics.median(calls[name]), statistics.median(times[name])
        what = name if name != "grid" else "PyVista's attributes"
        print(f"| {what} | {call:.4f} | {100 * (call / program - 1):+.1f} % | {bringing:.4f} | {100 * bringing / program:.1f} % |")


if __name__ == "__main__":
    main()
