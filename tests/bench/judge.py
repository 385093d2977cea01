# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge beside other checkers on the same meshes: a cube of 10^5, 10^6 and 10^7 tetrahedra by TetGen. And the judge alone on
fans of tetrahedra around one edge.

Every program reads its file and checks validity; none of ours is left out. The others prove less: see corpus/bad-meshes/MATRIX.md."""
import json
import math
import os
import random
import shutil
import statistics

from measure import measure

SIZES = [("10^5", "1.9e-5"), ("10^6", "1.9e-6"), ("10^7", "1.85e-7")]   # and TetGen's bound for a tetrahedron's volume
LARGE = 5_000_000            # from here on the others run once: minutes each

CUBE = """8 3 0 0
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
6 0
1
4 1 2 3 4
1
4 5 6 7 8
1
4 1 2 6 5
1
4 2 3 7 6
1
4 3 4 8 7
1
4 4 1 5 8
0
0
"""


def make(bench, name, volume, ele_tets):
    """NAME.1.node/.ele by TetGen, NAME.msh (4.1) and NAME.22.msh of it; the number of tetrahedra."""
    ele = bench.path(f"{name}.1.ele")
    if not os.path.exists(bench.path(f"{name}.22.msh")):
        with open(bench.path(f"{name}.poly"), "w") as file:
            file.write(CUBE)
        bench.command(f"TetGen {name}", "tetgen", f"-pqa{volume}BF", f"{name}.poly").run(bench.cores)
        for out, target in ((f"{name}.msh", "msh41"), (f"{name}.22.msh", "msh22")):
            bench.command(f"convert {out}", bench.ours("tetproof-convert"), f"{name}.1.ele", out, "--to", target).run(bench.cores)
    return ele_tets(ele)


def foam_case(bench, name):
    """What checkMesh wants to find; the mesh itself is converted by gmshToFoam, whose time does not count."""
    os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    system = bench.path(os.path.join(f"{name}.foam", "system"))
    os.makedirs(system, exist_ok=True)
    schemes = "".join(f"{kind}Schemes {{}} " for kind in ("ddt", "grad", "div", "laplacian", "interpolation", "snGrad"))
    control = "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeControl timeStep; writeInterval 1;"
    for file, text in (("controlDict", control), ("fvSchemes", schemes), ("fvSolution", "")):
        with open(os.path.join(system, file), "w") as out:
            out.write(f"FoamFile {{ version 2.0; format ascii; class dictionary; object {file}; }}\n{text}\n")
    bench.command(f"gmshToFoam {name}", "gmshToFoam", "-case", f"{name}.foam", f"{name}.22.msh").run(bench.cores)


def judge(bench, ele_tets):
    rows = []
    for power, volume in SIZES:
        name = "cube" + power.replace("^", "")
        tets = make(bench, name, volume, ele_tets)
        verify, threads = bench.ours("tetproof-verify"), len(bench.cores)
        ours = [bench.command("tetproof-verify of .msh 4.1", verify, f"{name}.msh", "--threads", threads),
                bench.command("tetproof-verify of .msh 4.1, 1 thread", verify, f"{name}.msh", "--threads", 1),
                bench.command("tetproof-verify of .msh 2.2", verify, f"{name}.22.msh", "--threads", threads),
                bench.command("tetproof-verify of .ele", verify, f"{name}.1.ele", "--threads", threads)]
        # Each beside ours of the same file.
        others = [(bench.command("tetgen -rC", "tetgen", "-rC", f"{name}.1"), ours[3]),
                  (bench.command("tetgen -rCNEF, which writes nothing", "tetgen", "-rCNEF", f"{name}.1"), ours[3]),
                  (bench.command("gmsh -check of .msh 4.1", "gmsh", "-check", "-nt", threads, f"{name}.msh", accept=(0, 1)), ours[0]),
                  (bench.command("gmsh -check of .msh 2.2", "gmsh", "-check", "-nt", threads, f"{name}.22.msh", accept=(0, 1)), ours[2])]
        if shutil.which("gmshToFoam") and shutil.which("checkMesh") and tets < LARGE:
            foam_case(bench, name)
            others.append((bench.command("checkMesh, after gmshToFoam", "checkMesh", "-case", f"{name}.foam"), ours[0]))
        commands = ours + [command for command, _ in others]
        if tets < LARGE:
            measure(commands, bench.runs, bench.cores)
        else:
            measure(ours, bench.runs, bench.cores)
            measure([command for command, _ in others], 1, bench.cores)
        beside = dict((command.name, own) for command, own in others)
        for command in commands:
            bench.record.setdefault("judge", {})[f"{power}: {command.name}"] = {**command.record(), "tetrahedra": tets}
            rows.append((tets, command, beside.get(command.name)))
    print("### The whole proof of validity, reading included: a cube by TetGen\n\n"
          "| tetrahedra | | wall s | CPU s | ns a tetrahedron | times ours | peak MiB | bytes a tetrahedron |\n|---|---|---|---|---|---|---|---|")
    for tets, c, own in rows:
        ratio = f"{c.wall / own.wall:.1f}" if own else ""
        print(f"| {tets:,} | {c.name} | {c.wall:.2f} ± {100 * c.spread():.0f} % | {c.cpu:.2f} | {1e9 * c.wall / tets:,.0f} | {ratio} | {c.memory:,.0f} | "
              f"{c.memory * 2**20 / tets:,.0f} |")
    print(flush=True)
    growth(bench)


def growth(bench):
    """Our phases on the three meshes; with --json angles are measured too, the phase quality."""
    columns = []
    for power, _ in SIZES:
        name = "cube" + power.replace("^", "")
        command = bench.command(f"phases {power}", bench.ours("tetproof-verify"), f"{name}.msh", "--threads", len(bench.cores), "--timings",
                                "--json", "phases.json")
        columns.append(phases(bench, command))
    names = list(columns[0][1])
    print("| microseconds a tetrahedron | " + " | ".join(f"{tets:,}" for tets, _ in columns) + " |\n|---|" + "---|" * len(columns))
    for phase in names:
        print(f"| {phase} | " + " | ".join(f"{1e6 * seconds[phase] / tets:.3f}" for tets, seconds in columns) + " |")
    print(flush=True)


def phases(bench, command):
    runs = []
    for _ in range(bench.runs):
        measure([command], 1, bench.cores)
        with open(bench.path("phases.json")) as file:
            report = json.load(file)
        runs.append(report["seconds"])
    return report["mesh"]["tets"], {name: statistics.median(run[name] for run in runs) for name in runs[0]}


FANS = [("10^3", 1000), ("10^4", 10_000), ("10^5", 100_000)]


def write_fan(path, count):
    """PATH.node and PATH.ele: tetrahedra around the edge from (0, 0, 1) to (0, 0, -1), whose other vertices are at random distances of 1 to 1.3."""
    rng = random.Random(1)
    points = [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0)]
    for i in range(count):
        angle, radius = 2 * math.pi * i / count, 1 + 0.3 * rng.random()
        points.append((radius * math.cos(angle), radius * math.sin(angle), 0.1 * (rng.random() - 0.5)))
    with open(path + ".node", "w") as file:
        file.write(f"{len(points)} 3 0 0\n")
        file.writelines(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(points))
    with open(path + ".ele", "w") as file:
        file.write(f"{count} 4 0\n")
        file.writelines(f"{i} 1 0 {2 + i} {2 + (i + 1) % count}\n" for i in range(count))


def fans(bench):
    """The judge where the boundary has vertices of very many faces: growth, and what a second thread saves."""
    rows = []
    for power, count in FANS:
        write_fan(bench.path("fan" + power.replace("^", "")), count)
        file = "fan" + power.replace("^", "") + ".ele"
        commands = [bench.command(f"fan of {power}, {threads} thread{'s' if threads > 1 else ''}", bench.ours("tetproof-verify"), file, "--threads", threads)
                    for threads in sorted({1, len(bench.cores)}, reverse=True)]
        bench.measure("fans", commands)
        rows += [(count, threads, command) for threads, command in zip(sorted({1, len(bench.cores)}, reverse=True), commands)]
    print("### Fans: all tetrahedra around one edge\n\n"
          "| tetrahedra | threads | wall s | CPU s | microseconds of CPU a tetrahedron | peak MiB |\n|---|---|---|---|---|---|")
    for count, threads, c in rows:
        print(f"| {count:,} | {threads} | {c.wall:.2f} ± {100 * c.spread():.0f} % | {c.cpu:.2f} | {1e6 * c.cpu / count:.1f} | {c.memory:,.0f} |")
    print(flush=True)
