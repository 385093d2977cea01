# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections 3 and 4: insertions a second as the grid grows, and whole runs beside other meshers on the same surface."""
import os
import statistics
import subprocess

import surfaces
from measure import Failed, measure

# Cells that give some 1e4, 1e5 and 1e6 tetrahedra at the end, with V0 = 0.1, V1 = 1 and --points auto.
GROWTH_CELLS = [13, 29, 67]
# Some 181,000 tetrahedra, which is what Gmsh makes of the 26,000 triangles: cells, TetGen's largest volume, CGAL's largest cell radius.
PEER_CELLS, PEER_V1, TETGEN_VOLUME, CGAL_CELL_SIZE, CGAL_FACET_DISTANCE = 37, "1.1", "4.4e-5", "0.0427", "0.002"

AUTO = ["--v0", "0.1", "--points", "auto", "--voxels", "0", "--timings"]


def growth(bench, read_json):
    """One core, a torus of 100,000 vertices: the surface's share is the same in all columns."""
    surfaces.write_all(bench.path("torus100k"), *surfaces.torus(1, 0.4, 400, 250))
    core = {min(bench.cores)}
    print("### Insertions on one core: a torus of 100,000 vertices, V0 = 0.1, V1 = 1, until it stops by itself\n\n"
          "| flips | tetrahedra at first | at the end | insertions | flips made | s | insertions a second | microseconds an insertion / log2 of the end |\n"
          "|---|---|---|---|---|---|---|---|")
    for improve in ("none", "solid-angle"):
        for cells in GROWTH_CELLS:
            file = bench.path(f"adapt.{improve}.{cells}.json")
            command = bench.command(f"{cells} cells, --improve {improve}", bench.ours("tetproof-mesh"), "torus100k.off", "-o", "adapt.msh", "--binary",
                                    "--cells", cells, *AUTO, "--v1", 1, "--improve", improve, "--threads", 1, "--json", file)
            seconds = []
            for _ in range(bench.runs):
                measure([command], 1, core)
                seconds.append(read_json(file)["seconds"]["insertion"])
            made, s = read_json(file), statistics.median(seconds)
            adaptation, tets = made["adaptation"], made["mesh"]["tets"]
            n = adaptation["insertions"]
            bench.record.setdefault("adapt", {})[command.name] = {**command.record(), "tetrahedra": tets, "insertion_s": seconds, "adaptation": adaptation}
            print(f"| {improve} | {made['generation']['first_grid']['tets']:,} | {tets:,} | {n:,} | {adaptation['flips']:,} | {s:.2f} | {n / s:,.0f} | "
                  f"{1e6 * s / n / (tets.bit_length() - 1):.2f} |", flush=True)
    print()


def peers(bench, ele_tets, msh_tets, json_tets):
    """Meshers that refine a surface's inside to about the same count; all read a file and write one."""
    build_cgal(bench)
    surfaces.write_all(bench.path("torus"), *surfaces.torus(1, 0.4, 130, 100))
    threads = len(bench.cores)
    ours = [bench.ours("tetproof-mesh"), "torus.off", "--cells", PEER_CELLS, *AUTO, "--v1", PEER_V1, "--threads", threads]
    cgal = [bench.ours("cgal_mesh3"), "torus.off", "cgal.mesh", CGAL_CELL_SIZE, CGAL_FACET_DISTANCE]
    jobs = [
        (bench.command("tetproof-mesh", *ours, "-o", "peers.msh", "--json", "peers.json"), lambda: json_tets(bench.path("peers.json"))),
        (bench.command("tetproof-mesh --improve none", *ours, "--improve", "none", "-o", "peers.n.msh", "--json", "peers.n.json"),
         lambda: json_tets(bench.path("peers.n.json"))),
        (bench.command(f"TetGen -pqa{TETGEN_VOLUME}", "tetgen", f"-pqa{TETGEN_VOLUME}", "torus.smesh"), lambda: ele_tets(bench.path("torus.1.ele"))),
        *((bench.command(f"Gmsh HXT, {n} thread{'s' * (n > 1)}", "gmsh", "-3", "-nt", n, "torus.geo", "-o", "torus.hxt.msh"),
           lambda: msh_tets(bench.path("torus.hxt.msh"))) for n in sorted({1, threads})),
        (bench.command("CGAL Mesh_3, refinement alone", *cgal), lambda: mesh_tets(bench.path("cgal.mesh"))),
        (bench.command("CGAL Mesh_3, perturbed and exuded", *cgal, "optimise"), lambda: mesh_tets(bench.path("cgal.mesh"))),
    ]
    commands, count = [command for command, _ in jobs], dict(jobs)
    for command in commands:  # one run each for its count: two of them write the same file
        command.run(bench.cores)
        command.tets = count[command]()
        command.runs.clear()
    bench.measure("adapt: peers", commands, lambda command: command.tets)
    bench.print_meshing("The inside of a torus of 26,000 triangles, refined: `tetproof-mesh --points auto`, proof included, beside others", commands, commands[0])


def build_cgal(bench):
    """The program around CGAL's mesher is no part of the usual build."""
    words = ["cmake", "--build", bench.build, "--target", "cgal_mesh3"]
    run = subprocess.run(words, capture_output=True, text=True)
    if run.returncode or not os.path.exists(bench.ours("cgal_mesh3")):
        raise Failed(f"{' '.join(words)}: {(run.stdout + run.stderr).strip().splitlines()[-1:]}")


def mesh_tets(path):
    """Tetrahedra in a Medit .mesh: the number after the keyword."""
    with open(path) as file:
        for line in file:
            if line.strip() == "Tetrahedra":
                return int(file.readline())
    raise Failed(f"{path}: no Tetrahedra")
