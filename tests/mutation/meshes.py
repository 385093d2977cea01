#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of the mutation campaign, from corpus/surfaces: by TetGen, Gmsh and CGAL where they are, and by ourselves.

usage: meshes.py BUILD_FOLDER FOLDER      writes into FOLDER, prints the meshes' paths"""
import os
import shutil
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "bench"))
import surfaces  # noqa: E402

SURFACES = ["unit_sphere.STL", "hull-body.obj", "plate_holes.STL", "spot.obj"]


def run(command, folder):
    """Whether it ended well; its talk is kept beside."""
    with open(os.path.join(folder, "log.txt"), "a") as log:
        print("$", *command, file=log, flush=True)
        return subprocess.run(command, cwd=folder, stdout=log, stderr=log).returncode == 0


def medit_to_tetgen(path, stem):
    """CGAL's .mesh as .node and .ele, with the points that its tetrahedra use."""
    with open(path) as file:
        words = file.read().split()
    at = words.index("Vertices")
    count = int(words[at + 1])
    points = [words[at + 2 + 4 * i:at + 5 + 4 * i] for i in range(count)]
    at = words.index("Tetrahedra")
    tets = [[int(w) for w in words[at + 2 + 5 * i:at + 6 + 5 * i]] for i in range(int(words[at + 1]))]
    number = {}
    for tet in tets:
        for v in tet:
            number.setdefault(v, len(number) + 1)
    with open(stem + ".node", "w") as file:
        file.write(f"{len(number)} 3 0 0\n")
        file.writelines(f"{i} {' '.join(points[v - 1])}\n" for v, i in number.items())
    with open(stem + ".ele", "w") as file:
        file.write(f"{len(tets)} 4 0\n")
        file.writelines(f"{i} {' '.join(str(number[v]) for v in tet)}\n" for i, tet in enumerate(tets, 1))


def extent(vertices):
    return max(max(c) - min(c) for c in zip(*vertices))


def main():
    build, folder = map(os.path.abspath, sys.argv[1:3])
    os.makedirs(folder, exist_ok=True)
    made, absent = [], [tool for tool in ("tetgen", "gmsh") if not shutil.which(tool)]
    cgal = os.path.join(build, "cgal_mesh3")
    if not os.path.exists(cgal):
        absent.append("cgal_mesh3 (ninja cgal_mesh3)")

    bodies = {"torus": surfaces.torus(1, 0.4, 20, 10)}
    for name in SURFACES:
        stem = name.split(".")[0]
        if run([os.path.join(build, "tetproof-convert"), os.path.join(HERE, "..", "..", "corpus", "surfaces", name), stem + ".off"], folder):
            bodies[stem] = surfaces.read_off(os.path.join(folder, stem + ".off"))
    for stem, (vertices, triangles) in bodies.items():
        surfaces.write_all(os.path.join(folder, stem), vertices, triangles)
        size = extent(vertices)
        if shutil.which("tetgen"):
            for name, switches in (("coarse", "-pQ"), ("quality", "-pqQ")):
                if name == "quality" and len(triangles) > 3000:
                    continue  # tens of thousands of tetrahedra say no more than thousands
                shutil.copy(os.path.join(folder, stem + ".smesh"), os.path.join(folder, f"tetgen-{stem}-{name}.smesh"))
                if run(["tetgen", switches, f"tetgen-{stem}-{name}.smesh"], folder):
                    made.append(f"tetgen-{stem}-{name}.1.ele")
        if shutil.which("gmsh"):
            if run(["gmsh", "-3", "-nt", "1", "-format", "msh2", "-o", f"gmsh-{stem}.msh", stem + ".geo"], folder):
                made.append(f"gmsh-{stem}.msh")
        if os.path.exists(cgal):
            if run([cgal, stem + ".off", f"cgal-{stem}.mesh", repr(size / 8), repr(size / 200)], folder):
                medit_to_tetgen(os.path.join(folder, f"cgal-{stem}.mesh"), os.path.join(folder, f"cgal-{stem}"))
                made.append(f"cgal-{stem}.ele")
        for cells, more in ((8, ["--points", "0"]), (10, ["--on-surface", "0.1", "--v0", "0.5"])):
            name = f"ours-{stem}-{cells}.msh"
            if run([os.path.join(build, "tetproof-mesh"), stem + ".off", "--cells", str(cells), "-q", "-o", name, *more], folder):
                made.append(name)
    for tool in absent:
        print("left out, not found:", tool, file=sys.stderr)
    for name in made:
        print(os.path.join(folder, name))


if __name__ == "__main__":
    main()
