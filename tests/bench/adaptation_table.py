#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What adaptation does to every clean surface, as one Markdown table: both pairs of volumes, three exponents, with and without
curvature, with and without flips, each run to its natural end (--points auto). Some minutes; interrupted, it goes on where it was.

usage: tests/bench/adaptation_table.py [--surface REGEX] [--settings REGEX] [--cells N] [--build FOLDER] [--out FOLDER] [--fresh]
Exit code: 0 all runs certified, 1 some not, 2 usage."""
import argparse
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = ("unit_sphere.STL", "torus.STL", "NACA0012.obj", "spot.obj", "BONESkull.stl", "plate_holes.STL", "1002_tray_bottom.STL",
         "Cray_left.obj", "hull-body.obj", "ct_skull.off")
CELLS = {"plate_holes.STL": "48", "1002_tray_bottom.STL": "48,6,48", "Cray_left.obj": "64", "wing:naca=0012,n=5000": "64"}  # thinner than 24 cells resolve
GENERATED = ("sphere:r=1,n=5000", "torus:R=1,r=0.4,n=5000", "wing:naca=0012,n=5000")  # with a parametric definition
VOLUMES = (("0.1", "1"), ("0.2", "2"))
EXPONENTS = (("1/4", "0.25"), ("1", "1"), ("3", "3"))


def surfaces():
    """(name, what the program reads); a file of the shared collection, or the project's own copy."""
    for name in FILES:
        for folder in (ROOT.parent / "shared/surfaces", ROOT / "corpus/surfaces"):
            if (folder / name).exists():
                yield name, str(folder / name)
                break
        else:
            print(f"{name} is absent: left out", file=sys.stderr)
    yield from ((spec, spec) for spec in GENERATED)


def settings():
    """(text, options)"""
    for (v0, v1), (name, p), curvature, improve in itertools.product(VOLUMES, EXPONENTS, (False, True), ("solid-angle", "none")):
        yield (f"V0/V1 {v0}/{v1}, p {name}, curvature {'on' if curvature else 'off'}, flips {'on' if improve != 'none' else 'off'}",
               ["--v0", v0, "--v1", v1, "--p", p, "--improve", improve] + ["--curvature"] * curvature)


def run(program, surface, options):
    """What one run came to."""
    with tempfile.TemporaryDirectory() as folder:
        report = os.path.join(folder, "report.json")
        start = time.perf_counter()
        done = subprocess.run([program, surface, "-o", os.path.join(folder, "grid.msh"), "--binary", "--quiet", "--voxels", "0",
                               "--points", "auto", "--timings", "--json", report, *options], capture_output=True, text=True)
        record = {"exit": done.returncode, "wall": time.perf_counter() - start}
        if done.returncode not in (0, 1):
            return {**record, "error": done.stderr.strip()}
        with open(report) as file:
            made = json.load(file)
    record |= {"certificate": made["certificate"], "verdict": made["verdict"], "tets": made["mesh"]["tets"],
               "first": made["generation"]["first_grid"]["tets"],
               "failed": [c["id"] for c in made["checks"] if c["verdict"] == "fail"]}
    if "adaptation" in made:
        keep = ("e_avg_first", "e_avg_last", "mean_volume", "insertions", "rows", "flips", "refused", "stopped")
        record |= {key: made["adaptation"][key] for key in keep} | {"insertion_s": made["seconds"].get("insertion", 0)}
    quality = made.get("quality") or {}
    record["dihedral"] = (quality.get("dihedral_angles") or {}).get("min")
    return record


def row_of(name, text, r):
    if "error" in r:
        return f"| {name} | {text} | exit {r['exit']}: {r['error']} |" + " |" * 8
    if "stopped" not in r:
        return f"| {name} | {text} | the first grid is empty: nothing to adapt |" + " |" * 6 + f" {r['wall']:.1f} | {'yes' if r['certificate'] else 'NO'} |"
    rows = ", ".join(f"{row} {count:,}" for row, count in r["rows"].items() if count)
    mean = r["mean_volume"]
    angle = "" if r["dihedral"] is None else f"{r['dihedral']:.2g}"
    return (f"| {name} | {text} | {r['e_avg_first'] / mean:.3f} | {r['e_avg_last'] / mean:.3f} | {r['first']:,} -> {r['tets']:,} | "
            f"{r['insertions']:,} | {r['flips']:,} | {rows} | {angle} | {r['stopped']} | {r['wall']:.1f} | {'yes' if r['certificate'] else 'NO'} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--surface", default="", help="only surfaces whose name matches")
    parser.add_argument("--settings", default="", help="only settings whose text matches, as in 'p 1/4.*curvature on'")
    parser.add_argument("--cells", help="lattice cells for all; 24, and more for surfaces that are thinner than that")
    parser.add_argument("--build", default=ROOT / "build", help="where the programs are; build")
    parser.add_argument("--out", default=ROOT / "out/bench", help="where results are kept; out/bench")
    parser.add_argument("--fresh", action="store_true", help="forget what earlier runs have found")
    arguments = parser.parse_args()
    program = os.path.join(arguments.build, "tetproof-mesh")
    kept = pathlib.Path(arguments.out) / "adaptation_table.jsonl"
    kept.parent.mkdir(parents=True, exist_ok=True)
    known = {}
    if arguments.fresh:
        kept.unlink(missing_ok=True)
    elif kept.exists():
        for line in kept.read_text().splitlines():
            try:
                record = json.loads(line)
            except ValueError:
                continue  # the line at which an earlier run was interrupted
            known[record["surface"], record["settings"], record["cells"]] = record
    wanted = [(s, t) for s in surfaces() if re.search(arguments.surface, s[0]) for t in settings() if re.search(arguments.settings, t[0])]
    print(f"`--cells 24` but where the surface's name says otherwise, `--points auto`; E_avg in mean volumes of the first grid, angles in degrees, seconds with proof and writing.\n")
    print("| surface | settings | E_avg before | after | tetrahedra | insertions | flips | rows of Table 4 | smallest dihedral angle | stopped | s | certificate |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|", flush=True)
    bad, stops = 0, {}
    for number, ((name, surface), (text, options)) in enumerate(wanted, 1):
        cells = arguments.cells or CELLS.get(name, "24")
        record = known.get((name, text, cells))
        if record is None:
            print(f"{number} of {len(wanted)}: {name}, {text}", file=sys.stderr, flush=True)
            record = {"surface": name, "settings": text, "cells": cells, **run(program, surface, ["--cells", cells, *options])}
            with open(kept, "a") as file:
                file.write(json.dumps(record) + "\n")
        print(row_of(name if cells == "24" else f"{name}, {cells} cells", text, record), flush=True)
        bad += record["exit"] != 0 or record.get("certificate") is not True
        stops[record.get("stopped", "not adapted")] = stops.get(record.get("stopped", "not adapted"), 0) + 1
    print(f"\n{len(wanted)} runs, {bad} without a certificate or with a defect; stopped: " + ", ".join(f"{k} {n}" for k, n in sorted(stops.items())) + ".")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
