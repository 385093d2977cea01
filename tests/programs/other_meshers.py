# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes closed surfaces with TetGen, Gmsh and CGAL; tetproof-verify judges the meshes against the surface.

The script finds the right verdict independently, in exact arithmetic. Every tetrahedron is positive. Every face belongs to one
tetrahedron, or to two on opposite sides. If the mesher keeps the surface's triangles, the faces of one tetrahedron are exactly
these triangles, so nothing overlaps and nothing is missing. If all this holds, tetproof-verify must call the mesh sound, without
a finding; otherwise it must call it defective. Exit code 0: every verdict is right; 1: a verdict is wrong; 77: the tool is not
installed.

usage: other_meshers.py [OPTION...]     for example: other_meshers.py --set all --keep out/others"""
import argparse
import json
import os
import shutil
import sys
import tempfile
import time

sys.dont_write_bytecode = True
from mesh_truth import expected_warnings, faults, read_tetgen  # noqa: E402
from meshers import MESHERS, NoMesh, read_off, run, write_surface  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDERS = [os.path.join(ROOT, "corpus", "surfaces"), os.path.join(ROOT, "..", "shared", "surfaces")]
SMALL = ["unit_sphere.STL", "plate_holes.STL", "Cray_left.obj", "spot.obj"]
ALL = SMALL + ["torus.STL", "hull-body.obj", "NACA0012.obj", "BONESkull.stl", "1002_tray_bottom.STL", "ct_skull.off"]
NESTED = {"Cray_left.obj"}   # the second component bounds a cavity around the centre of the box

TOO_LARGE = {("tetgen-pq", "Cray_left.obj"), ("cgal", "Cray_left.obj")}   # for the small set, because the shell is thin

# A mesher that keeps the triangles is judged exactly. If TetGen may split triangles, it treats neighbours at more than 179.9
# degrees as one plane; on spot.obj it is off by 9.5e-6 of the diagonal. CGAL keeps its facet distance, 4e-4, at the centres of
# facets, but not along sharp edges.
FIDELITY = {"tetgen-pY": "0", "gmsh-delaunay": "0", "gmsh-hxt": "0", "gmsh-hxt-2": "0", "tetgen-pq": "1e-4", "cgal": "1e-2"}
KEEPS_TRIANGLES = {tool for tool, fidelity in FIDELITY.items() if fidelity == "0"}
PROGRAM = {tool: tool.split("-")[0] for tool in FIDELITY}


def judge(arguments, mesh, surface, fidelity, folder):
    report = os.path.join(folder, "report.json")
    done = run([os.path.join(arguments.build, "tetproof-verify"), mesh, surface, "--fidelity", fidelity, "--json", report],
               folder, arguments.timeout)
    if done.returncode not in (0, 1):
        raise NoMesh(f"tetproof-verify: {done.stderr.strip()}")
    with open(report) as file:
        return json.load(file)


def one(arguments, tool, surface, folder):
    """One line of the table, and whether the verdict is right."""
    stem, (vertices, triangles) = "s", read_off(os.path.join(folder, "s.off"))
    write_surface(os.path.join(folder, stem), vertices, triangles, surface in NESTED)
    start = time.time()
    try:
        mesh = MESHERS[tool](stem, folder, arguments.timeout, arguments.build)
    except NoMesh as reason:
        return f"no mesh: {reason}", True
    seconds = time.time() - start
    report = judge(arguments, mesh, "s.off", FIDELITY[tool], folder)
    run([os.path.join(arguments.build, "tetproof-convert"), mesh, "plain.node"], folder, arguments.timeout)
    points, tets = read_tetgen(os.path.join(folder, "plain"))
    kept = [frozenset(vertices[v] for v in t) for t in triangles] if tool in KEEPS_TRIANGLES else None
    wrong, may_warn = faults(points, tets, kept), expected_warnings(points, tets, triangles)
    warned = may_warn & {check["id"] for check in report["checks"] if check["verdict"] == "warning"}
    said = [f"{check['verdict']} {check['id']} {check['count']}" for check in report["checks"]
            if check["verdict"] == "fail" or check["verdict"] == "warning" and check["id"] not in warned]
    first = [f["what"] for check in report["checks"] if check["verdict"] == "fail" for f in check["findings"]][:1]
    missed = may_warn - {"topology"} - warned
    right = (report["verdict"] == "defective" and report["certificate"] is False if wrong
             else not said and not missed and report["certificate"] is True)
    line = f"{len(tets)} tetrahedra in {seconds:.1f} s: {report['verdict']}"
    line += f" but for {', '.join(sorted(warned))}" if warned else ""
    line += f"; truly: {', '.join(wrong)}" if wrong else ""
    line += f"; said: {', '.join(said)}" + (f" ({first[0]})" if first else "") if said else ""
    return line + ("" if right else "  <-- WRONG VERDICT"), right


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build"), help="where the programs are; build")
    parser.add_argument("--tools", default=",".join(FIDELITY), help="of " + ",".join(FIDELITY))
    parser.add_argument("--set", choices=["small", "all"], default="small", help="which surfaces; small")
    parser.add_argument("--surfaces", help="names of surfaces instead of a set")
    parser.add_argument("--timeout", type=float, default=300, help="seconds for each run of a program; 300")
    parser.add_argument("--keep", help="a folder for all files; otherwise they are removed")
    arguments = parser.parse_args()
    arguments.build = os.path.abspath(arguments.build)
    names = arguments.surfaces.split(",") if arguments.surfaces else SMALL if arguments.set == "small" else ALL
    work = os.path.abspath(arguments.keep) if arguments.keep else tempfile.mkdtemp(prefix="tetproof-others-")
    all_right, absent = True, []
    try:
        for tool in arguments.tools.split(","):
            if not (shutil.which(PROGRAM[tool]) or tool == "cgal" and os.path.exists(os.path.join(arguments.build, "cgal_mesh3"))):
                absent.append(tool)
                print(f"{tool}: skipped, {'cgal_mesh3 is not built' if tool == 'cgal' else PROGRAM[tool] + ' is not installed'}")
                continue
            for name in names:
                if arguments.set == "small" and not arguments.surfaces and (tool, name) in TOO_LARGE:
                    continue
                source = next((path for path in (os.path.join(folder, name) for folder in FOLDERS) if os.path.exists(path)), None)
                if not source:
                    print(f"{tool} {name}: skipped, the surface is not here")
                    continue
                folder = os.path.join(work, f"{tool} {name}")
                os.makedirs(folder, exist_ok=True)
                run([os.path.join(arguments.build, "tetproof-convert"), source, "s.off"], folder, arguments.timeout)
                line, right = one(arguments, tool, name, folder)
                print(f"{tool} {name}: {line}", flush=True)
                all_right &= right
    finally:
        if not arguments.keep:
            shutil.rmtree(work)
    if absent and len(absent) == len(arguments.tools.split(",")):
        sys.exit(77)
    sys.exit(0 if all_right else 1)


if __name__ == "__main__":
    main()
