#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times the page (tetproof-mesh --engine paper) against the fast engine, as one Markdown table, in CPU seconds of steps (i) to (vi):
those of the process, times the part of its wall time that is not reading, judging and writing. So the load of the machine matters little.
Of several runs the fastest counts. Both engines must write the same grid.

usage: tests/bench/engines.py [--cells N,N,...] [--surface SURFACE]... [--runs N] [--build FOLDER]
Exit code: 0 all grids equal, 1 some not, 2 usage."""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SURFACES = ("corpus/surfaces/spot.obj", "sphere")
AROUND = ("reading", "judging the surface", "reduction", "verification", "writing")  # the phases that are no step of the method
LONG = 20  # [CPU s] a run that takes longer is not repeated


def run(program, surface, cells, engine, runs, folder):
    """(CPU seconds of the method, what the report says of the adaptation, the bytes of the grid)"""
    grid, report = os.path.join(folder, engine + ".msh"), os.path.join(folder, engine + ".json")
    seconds = []
    while len(seconds) < runs and (not seconds or seconds[-1] < LONG):
        command = [program, surface, "-o", grid, "--engine", engine, "--cells", str(cells), "--quiet", "--voxels", "0", "--timings",
                   "--json", report]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode not in (0, 1):
            sys.exit(f"engines.py: {' '.join(command)}: exit code {done.returncode}: {done.stderr.strip()}")
        with open(report) as file:
            made = json.load(file)
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        steps = sum(s for phase, s in made["seconds"].items() if phase not in AROUND)
        seconds.append(cpu * steps / sum(made["seconds"].values()))
    return min(seconds), made, pathlib.Path(grid).read_bytes()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", default="6,12,24", help="numbers of cells along the longest side; 6,12,24")
    parser.add_argument("--surface", action="append", help=f"a file or a generated surface; {' and '.join(SURFACES)}")
    parser.add_argument("--runs", type=int, default=3, help=f"of each; 3, and 1 of what takes more than {LONG} s")
    parser.add_argument("--build", default=ROOT / "build", type=pathlib.Path, help="where the programs are; build")
    arguments = parser.parse_args()
    program = str(arguments.build.resolve() / "tetproof-mesh")
    print("| surface, cells | first grid's tetrahedra | insertions, flips | fast, CPU s | page, CPU s | ratio | same grid |")
    print("|---|---|---|---|---|---|---|", flush=True)
    different = 0
    for surface in arguments.surface or SURFACES:
        for cells in map(int, arguments.cells.split(",")):
            with tempfile.TemporaryDirectory() as folder:
                fast, made, grid = run(program, surface, cells, "fast", arguments.runs, folder)
                page, _, other = run(program, surface, cells, "paper", arguments.runs, folder)
            different += grid != other
            adapted = made.get("adaptation", {})
            print(f"| {os.path.basename(surface)}, {cells} | {made['generation']['first_grid']['tets']:,} | "
                  f"{adapted.get('insertions', 0):,}, {adapted.get('flips', 0):,} | {fast:.3f} | {page:.{2 if page < 10 else 0}f} | "
                  f"{page / fast:.0f} | {'yes' if grid == other else 'NO'} |", flush=True)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
