# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole programs and their phases in wall time and memory, peers beside ours, all on the same cores in the same run.

Prints Markdown tables, and writes every single run to out/bench/bench.json."""
import argparse
import json
import os
import platform
import re
import statistics
import subprocess
import sys

import adapt
import distances
import formats
import fuzz
import judge
import surfaces
from measure import Command, Failed, measure

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKULL = os.path.join(ROOT, "corpus", "surfaces", "ct_skull.off")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=3, help="runs of every command, of which the median counts; 3")
    parser.add_argument("--cores", default=None, help="cores to run on, as in 0 or 0,1; all")
    parser.add_argument("--only", default="skull,torus,growth,verify,judge,fans,distances,hot,adapt,formats,fuzz",
                        help="of skull,torus,growth,verify,judge,fans,distances,hot,adapt,formats,fuzz")
    parser.add_argument("--build", default=os.path.join(ROOT, "build"), help="where the programs are; build")
    parser.add_argument("--out", default=os.path.join(ROOT, "out", "bench"), help="where files go; out/bench")
    arguments = parser.parse_args()
    bench = Bench(arguments)
    sections = {"skull": bench.skull, "torus": bench.torus, "growth": bench.growth, "verify": bench.verify, "judge": bench.judge, "fans": bench.fans,
                "distances": lambda: distances.distances(bench), "hot": bench.hot,
                "adapt": bench.adapt, "formats": bench.formats, "fuzz": lambda: fuzz.fuzz(bench)}
    chosen = arguments.only.split(",")
    for name in chosen:
        if name not in sections:
            parser.error(f"--only: {name} is none of {', '.join(sections)}")
    try:
        bench.print_machine()
        for name in chosen:
            print(f"{name}:", file=sys.stderr)
            sections[name]()
    except Failed as failure:
        sys.exit(f"bench: {failure}")
    with open(os.path.join(arguments.out, "bench.json"), "w") as file:
        json.dump(bench.record, file, indent=1)
    print(f"Every run: {os.path.relpath(os.path.join(arguments.out, 'bench.json'))}")


class Bench:
    def __init__(self, arguments):
        self.runs, self.build, self.out = arguments.runs, arguments.build, os.path.abspath(arguments.out)
        self.cores = set(map(int, arguments.cores.split(","))) if arguments.cores else os.sched_getaffinity(0)
        self.record = {}
        os.makedirs(self.out, exist_ok=True)

    def ours(self, name):
        return os.path.join(self.build, name)

    def path(self, name):
        return os.path.join(self.out, name)

    def command(self, name, *words, accept=(0,)):
        return Command(name, words, self.out, accept)

    def measure(self, section, commands, tets=None):
        """Measures and keeps the record; `tets` tells how many tetrahedra a command made."""
        measure(commands, self.runs, self.cores)
        for command in commands:
            record = command.record()
            if tets:
                record["tetrahedra"] = command.tets = tets(command)
            self.record.setdefault(section, {})[command.name] = record

    def print_machine(self):
        with open("/proc/cpuinfo") as file:
            cpu = re.search(r"model name\s*: (.*)", file.read()).group(1)
        versions = {"g++": first_line("g++", "-dumpfullversion"), "Gmsh": first_line("gmsh", "--version"),
                    "TetGen": first_line("dpkg-query", "-W", "-f", "${Version}", "tetgen"),
                    "CGAL": first_line("dpkg-query", "-W", "-f", "${Version}", "libcgal-dev"),
                    "tetproof": first_line("git", "-C", ROOT, "describe", "--always", "--dirty")}
        self.record["machine"] = {"cpu": cpu, "cores": sorted(self.cores), "system": platform.platform(), "runs": self.runs,
                                  "versions": versions}
        print(f"{cpu}, {len(self.cores)} cores; " + ", ".join(f"{k} {v}" for k, v in versions.items()) +
              f". Wall time, median of {self.runs} runs in turns; ± half the range.\n")

    def print_meshing(self, title, commands, first):
        """A table of tetrahedra a second; ratios are those of `first` to each."""
        print(f"### {title}\n\n| | tetrahedra | wall s | CPU s | tetrahedra a second | {first.name} is faster by | peak MiB |\n|---|---|---|---|---|---|---|")
        for c in commands:
            ratio = "" if c is first else f"{first.tets / first.wall / (c.tets / c.wall):.1f}"
            print(f"| {c.name} | {c.tets:,} | {c.wall:.2f} ± {100 * c.spread():.0f} % | {c.cpu:.2f} | {c.tets / c.wall:,.0f} | {ratio} | {c.memory:,.0f} |")
        print(flush=True)

    def meshers(self, stem, cells, tetgen_volume):
        """Our program without and with the voxel account, TetGen and HXT on the same surface. All read a file and write one."""
        threads = len(self.cores)
        mesh = [self.ours("tetproof-mesh"), stem + ".off", "--cells", cells, "--points", "0", "--timings", "--threads", threads]
        return [
            self.command("tetproof-mesh", *mesh, "-o", stem + ".msh", "--voxels", "0", "--json", stem + ".json"),
            self.command("tetproof-mesh with the voxel account", *mesh, "-o", stem + ".v.msh", "--json", stem + ".v.json"),
            self.command(f"TetGen -pqa{tetgen_volume}", "tetgen", f"-pqa{tetgen_volume}", stem + ".smesh"),
            *(self.command(f"Gmsh HXT, {n} thread{'s' * (n > 1)}", "gmsh", "-3", "-nt", n, stem + ".geo", "-o", stem + ".hxt.msh")
              for n in sorted({1, threads})),
        ]

    def meshing(self, section, title, stem, cells, tetgen_volume):
        commands = self.meshers(stem, cells, tetgen_volume)
        made = [lambda: json_tets(self.path(stem + ".json")), lambda: json_tets(self.path(stem + ".v.json")),
                lambda: ele_tets(self.path(stem + ".1.ele"))] + 2 * [lambda: msh_tets(self.path(stem + ".hxt.msh"))]
        self.measure(section, commands, lambda command: made[commands.index(command)]())
        self.print_meshing(title, commands, commands[0])
        phases = read_phases(self.path(stem + ".json"))
        self.record[section]["phases of the last run"] = phases
        print("Phases of tetproof-mesh, last run: " + ", ".join(f"{name} {s:.3f} s" for name, s in phases.items()) + ".\n")

    def skull(self):
        surfaces.write_all(self.path("skull"), *surfaces.read_off(SKULL))
        self.meshing("skull", "The skull: ct_skull.off, 114,816 triangles", "skull", SKULL_CELLS, "8")

    def torus(self):
        surfaces.write_all(self.path("torus"), *surfaces.torus(1, 0.4, 130, 100))
        self.meshing("torus", "A torus of 26,000 triangles", "torus", TORUS_CELLS, "8e-6")

    def growth(self):
        """Our phases from some 1e4 to some 1e6 tetrahedra: microseconds a tetrahedron should stay what they are."""
        surfaces.write_all(self.path("torus"), *surfaces.torus(1, 0.4, 130, 100))
        columns = []
        for cells in GROWTH_CELLS:
            file = self.path(f"growth.{cells}.json")
            command = self.command(f"{cells} cells", self.ours("tetproof-mesh"), "torus.off", "-o", "growth.msh", "--cells", cells, "--points", "0",
                                   "--voxels", "0", "--timings", "--threads", len(self.cores), "--json", file)
            runs = []
            for _ in range(self.runs):
                measure([command], 1, self.cores)
                runs.append(read_phases(file))
            phases = {name: statistics.median(run.get(name, 0) for run in runs) for name in runs[-1]}
            columns.append((json_tets(file), command.wall, phases))
            self.record.setdefault("growth", {})[command.name] = {**command.record(), "tetrahedra": columns[-1][0], "phases": runs}
        print("### Growth on the torus: microseconds a tetrahedron\n\n| phase | " + " | ".join(f"{tets:,} tetrahedra" for tets, _, _ in columns) +
              " |\n|---|" + "---|" * len(columns))
        for name in columns[-1][2]:
            print(f"| {name} | " + " | ".join(f"{1e6 * phases.get(name, 0) / tets:.3f}" for tets, _, phases in columns) + " |")
        print("| whole program | " + " | ".join(f"{1e6 * wall / tets:.3f}" for tets, wall, _ in columns) + " |\n", flush=True)

    def verify(self):
        """The judge on the skull's mesh, against the consistency checks of TetGen and Gmsh; all read the mesh from a file."""
        if not os.path.exists(self.path("skull.msh")):
            surfaces.write_all(self.path("skull"), *surfaces.read_off(SKULL))
            self.meshers("skull", SKULL_CELLS, "8")[0].run(self.cores)
        self.command("convert", self.ours("tetproof-convert"), "skull.msh", "checked.node").run(self.cores)
        threads = len(self.cores)
        commands = [
            self.command("tetproof-verify", self.ours("tetproof-verify"), "skull.msh", "--threads", threads),
            self.command("tetproof-verify, 1 thread", self.ours("tetproof-verify"), "skull.msh", "--threads", 1),
            self.command("tetproof-verify --json, angles measured too", self.ours("tetproof-verify"), "skull.msh", "--threads", threads,
                         "--json", "verify.json"),
            self.command("tetproof-verify of .node/.ele", self.ours("tetproof-verify"), "checked.node", "--threads", threads),
            self.command("tetgen -rC", "tetgen", "-rC", "checked.node"),
            self.command("tetgen -rCNEF, which writes nothing", "tetgen", "-rCNEF", "checked.node"),
            self.command("gmsh -check", "gmsh", "-check", "-nt", threads, "skull.msh", accept=(0, 1)),
        ]
        self.measure("verify", commands)
        tets = read_json(self.path("verify.json"))["mesh"]["tets"]
        print(f"### Judging the skull's mesh, {tets:,} tetrahedra, reading included\n\n| | wall s | CPU s | {commands[0].name} is faster by | peak MiB |\n|---|---|---|---|---|")
        for c in commands:
            ratio = "" if c is commands[0] else f"{c.wall / commands[0].wall:.1f}"
            print(f"| {c.name} | {c.wall:.2f} ± {100 * c.spread():.0f} % | {c.cpu:.2f} | {ratio} | {c.memory:,.0f} |")
        print(flush=True)

    def judge(self):
        """The judge's growth up to 10^7 tetrahedra, beside others that check meshes."""
        judge.judge(self, ele_tets)

    def fans(self):
        """The judge's growth on fans of up to 10^5 tetrahedra around one edge."""
        judge.fans(self)

    def hot(self):
        """Single phases on one thread, as rates."""
        surfaces.write_all(self.path("torus"), *surfaces.torus(1, 0.4, 130, 100))
        command = self.command("one thread", self.ours("tetproof-mesh"), "torus.off", "-o", "hot.msh", "--cells", TORUS_CELLS, "--points", "0",
                               "--voxels", "0", "--timings", "--threads", 1, "--json", "hot.json")
        runs = []
        for _ in range(self.runs):
            measure([command], 1, {min(self.cores)})
            runs.append(read_phases(self.path("hot.json")))
        made = read_json(self.path("hot.json"))
        lattice, tets = made["generation"]["lattice"]["tets"], made["mesh"]["tets"]
        self.record["hot"] = {**command.record(), "lattice tetrahedra": lattice, "tetrahedra": tets, "phases": runs}
        print(f"### One thread: the torus, {lattice:,} lattice tetrahedra, {tets:,} tetrahedra\n\n"
              "| phase | s | lattice tetrahedra a second | tetrahedra a second |\n|---|---|---|---|")
        for name in runs[-1]:
            seconds = statistics.median(run.get(name, 0) for run in runs)
            of_lattice = f"{lattice / seconds:,.0f}" if name in ("indicators", "extraction") and seconds else ""
            of_mesh = f"{tets / seconds:,.0f}" if seconds > 1e-3 else ""
            print(f"| {name} | {seconds:.3f} | {of_lattice} | {of_mesh} |")
        print(flush=True)

    def adapt(self):
        """Insertion: its growth, and beside other meshers that refine."""
        adapt.growth(self, read_json)
        adapt.peers(self, ele_tets, msh_tets, json_tets)

    def formats(self):
        """Reading and writing files in the formats of meshes, beside Gmsh and meshio."""
        formats.formats(self)


def first_line(*words):
    try:
        run = subprocess.run(words, capture_output=True, text=True)
    except OSError:
        return "absent"
    return ((run.stdout or run.stderr).strip().splitlines() or ["?"])[0]


def read_json(path):
    with open(path) as file:
        return json.load(file)


def read_phases(path):
    """Seconds of the phases in their order, and those of the verification's own phases, which come first in the JSON."""
    seconds = read_json(path)["seconds"]
    names = list(seconds)
    inner = names[:names.index("reading")]
    return {("verification: " if name in inner else "") + name: seconds[name] for name in names[len(inner):] + inner}


def json_tets(path):
    return read_json(path)["mesh"]["tets"]


def ele_tets(path):
    with open(path) as file:
        return int(file.readline().split()[0])


def msh_tets(path):
    """Tetrahedra in an ASCII .msh 4.1: the sizes of the blocks of element type 4."""
    with open(path) as file:
        for line in file:
            if line.startswith("$Elements"):
                break
        total = 0
        for _ in range(int(file.readline().split()[0])):
            _, _, kind, count = map(int, file.readline().split())
            total += count if kind == 4 else 0
            for _ in range(count):
                file.readline()
        return total


SKULL_CELLS = 110                # about a million tetrahedra inside the skull
TORUS_CELLS = 114                # and inside the torus
GROWTH_CELLS = [20, 50, 114]     # some 1e4, 1e5, 1e6

if __name__ == "__main__":
    main()
