#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the Python package costs beside the program, on a mesh of a million tetrahedra.

usage: python.py BUILD [--cells N] [--runs K]
Medians of K runs, which take turns since machines drift: the wall time of the program's verdict (its phases without reading)
and of the call of `tetproof.verify`; the CPU time of what brings the mesh to the judge, and its part of the call's.
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
    work = {name: (lambda arrays=arrays: tetproof.verify(*arrays),
                   lambda arrays=arrays: _core.Mesh(tetproof._arrays.point_array(arrays[0]),
                                                    tetproof._arrays.index_array(arrays[1], 4, "tets")))
            for name, arrays in layouts.items()}
    work["PyVista's attributes"] = (lambda: tetproof.verify(grid), lambda: _meshes.judged(grid))
    program, calls, cpu, bringing = [], *({name: [] for name in work} for _ in range(3))

    def seconds(call):
        wall, processor = time.perf_counter(), time.process_time()
        call()
        return time.perf_counter() - wall, time.process_time() - processor

    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "grid.msh"
        tetproof.write(file, (points, tets), binary=True)
        for _ in range(options.runs):
            done = subprocess.run([str(options.build / "tetproof-verify"), str(file), "--timings", "--json", "-"],
                                  capture_output=True, text=True)
            phases = json.loads(done.stdout)["seconds"]
            program.append(sum(s for phase, s in phases.items() if phase != "reading"))
            for name, (call, bring) in work.items():
                wall, processor = seconds(call)
                calls[name].append(wall)
                cpu[name].append(processor)
                bringing[name].append(seconds(bring)[1])
    verdict = statistics.median(program)
    print(f"{len(tets):,} tetrahedra; the program's verdict takes {verdict:.3f} s\n")
    print("| the mesh as | the call, s | beside the program's verdict | bringing it to the judge, ms of CPU | of the call's CPU |")
    print("|---|---|---|---|---|")
    for name in work:
        call, all_cpu, part = (statistics.median(of[name]) for of in (calls, cpu, bringing))
        print(f"| {name} | {call:.3f} | {100 * (call / verdict - 1):+.0f} % | {1e3 * part:.1f} | {100 * part / all_cpu:.1f} % |")


if __name__ == "__main__":
    main()
