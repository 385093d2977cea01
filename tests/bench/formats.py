# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading and writing one and the same mesh in every format: ours, Gmsh's SDK and meshio, each without its start-up.

A cube of a million tetrahedra with ten named physical groups. Every program runs in turns, several repetitions in
each process of which the first one is left out; the median of the others counts. Also memory, growth and whole runs
of tetproof-convert. Some four minutes on a quiet machine."""
import os
import statistics
import subprocess
import sys

from measure import Command, measure

CELLS = {"10^5": 26, "10^6": 55, "10^7": 119}    # along each edge of the cube; six tetrahedra each
PEERS_AT = "10^6"

#          name            ending   --to      encoding  Gmsh's version  meshio's format, binary
FORMATS = [(".msh 2.2 ASCII", ".22.msh", "msh22", "ascii", "2.2", ("gmsh22", False)),
           (".msh 4.1 ASCII", ".41.msh", "msh41", "ascii", "4.1", ("gmsh", False)),
           (".msh 4.1 binary", ".bin.msh", "msh41", "binary", "4.1", ("gmsh", True)),
           ("TetGen", ".ele", "tetgen", "ascii", None, ("tetgen", None))]

# How often slower Gmsh and meshio should be at least.
TARGETS = {".msh 2.2 ASCII": (10, 10), ".msh 4.1 ASCII": (10, 10), ".msh 4.1 binary": (10, 4), "TetGen": (None, 10)}

MESHIO = r"""
import sys, time
import meshio
def timed(work):
    wall, cpu = time.perf_counter(), time.process_time()
    result = work()
    print("\nseconds", time.perf_counter() - wall, "cpu", time.process_time() - cpu)
    return result
what, path, times = sys.argv[1], sys.argv[2], int(sys.argv[-1])
if what == "read":
    for _ in range(times):
        timed(lambda: meshio.read(path))
else:
    out, kind, binary = sys.argv[3], sys.argv[4], sys.argv[5]
    mesh = meshio.read(path)
    if kind == "tetgen":    # it can write nothing else for TetGen
        mesh = meshio.Mesh(mesh.points, [("tetra", mesh.get_cells_type("tetra"))])
    for _ in range(times):
        timed(lambda: meshio.write(out, mesh, file_format=kind, **({} if binary == "None" else {"binary": binary == "True"})))
"""


class Program(Command):
    """A program that prints "seconds WALL cpu CPU" for each of its repetitions, and perhaps "arrays BYTES"."""

    def __init__(self, bench, name, *words):
        super().__init__(name, words, bench.out)
        self.times, self.arrays = [], None

    def run(self, cores):
        super().run(cores)
        with open(self.log) as file:
            lines = [line.split() for line in file]
        times = [(float(words[1]), float(words[3])) for words in lines if words and words[0] == "seconds"]
        self.times += times[1:] or times
        self.arrays = next((int(words[1]) for words in lines if words and words[0] == "arrays"), self.arrays)

    wall_s = property(lambda self: statistics.median(time[0] for time in self.times))
    cpu_s = property(lambda self: statistics.median(time[1] for time in self.times))

    def record(self):
        return {**super().record(), "repetitions_wall_s": [t[0] for t in self.times], "repetitions_cpu_s": [t[1] for t in self.times]}


def formats(bench):
    subprocess.run(["cmake", "--build", bench.build, "--target", "format_programs"], check=True, stdout=sys.stderr)
    for size in CELLS:
        make(bench, size)
    rows = peers(bench)
    ratios(rows)
    whole(bench)
    growth(bench)


def file_name(size, ending):
    return "formats" + size.replace("^", "") + ending


def file_set(bench, name):
    """The file, or all of TetGen's that belong to it."""
    names = [name[:-4] + ending for ending in (".node", ".ele", ".face", ".edge")] if name.endswith(".ele") else [name]
    return [n for n in names if os.path.exists(bench.path(n))]


def file_bytes(bench, name):
    return sum(os.path.getsize(bench.path(n)) for n in file_set(bench, name))


def make(bench, size):
    source = file_name(size, ".bin.msh")
    if not os.path.exists(bench.path(source)):
        bench.command(f"make {size}", bench.ours("formats_ours"), "make", CELLS[size], source).run(bench.cores)
    for _, ending, target, encoding, _, _ in FORMATS:
        if not os.path.exists(bench.path(file_name(size, ending))):
            bench.command(f"convert {size} {target}", bench.ours("tetproof-convert"), "--quiet", source, file_name(size, ending), "--to", target,
                          f"--{encoding}").run(bench.cores)


def peers(bench):
    """Reading and writing in every format by everybody: rows of (what, format, bytes, programs)."""
    ours, gmsh, threads = bench.ours("formats_ours"), bench.ours("formats_gmsh"), len(bench.cores)
    python = ["/usr/bin/python3", "-c", MESHIO]
    source, rows = file_name(PEERS_AT, ".bin.msh"), []
    for name, ending, target, encoding, version, (kind, binary) in FORMATS:
        file = file_name(PEERS_AT, ending)
        out = "formats.written" + ending
        reading = {"tetproof": Program(bench, f"tetproof reads {name}", ours, "read", file, 6, threads),
                   "one thread": Program(bench, f"tetproof reads {name}, one thread", ours, "read", file, 4, 1)}
        writing = {"tetproof": Program(bench, f"tetproof writes {name}", ours, "write", source, out, target, encoding, 6, threads),
                   "one thread": Program(bench, f"tetproof writes {name}, one thread", ours, "write", source, out, target, encoding, 4, 1)}
        if version:
            reading["Gmsh"] = Program(bench, f"Gmsh reads {name}", gmsh, "read", file, 3)
            writing["Gmsh"] = Program(bench, f"Gmsh writes {name}", gmsh, "write", source, out, version, encoding, 3)
        slow = 1 if kind == "gmsh22" or target == "tetgen" else 3   # ten seconds each
        reading["meshio"] = Program(bench, f"meshio reads {name}", *python, "read", file, slow)
        writing["meshio"] = Program(bench, f"meshio writes {name}", *python, "write", source, out, kind, binary, slow)
        size = file_bytes(bench, file)
        rows += [("read", name, size, reading), ("write", name, size, writing)]
    commands = [program for row in rows for program in row[3].values()]
    measure(commands, bench.runs, bench.cores)
    for command in commands:
        bench.record.setdefault("formats", {})[command.name] = command.record()
    cats = {name: cat(bench, file_name(PEERS_AT, ending)) for name, ending, *_ in FORMATS}
    print(f"### Formats: {6 * CELLS[PEERS_AT] ** 3:,} tetrahedra with ten named groups, seconds without start-up (CPU seconds of all threads)\n\n"
          "| | MB | tetproof | MB/s | one thread | Gmsh | meshio | Gmsh / ours | meshio / ours | CPU s: ours | Gmsh / ours | meshio / ours | `cat`, MB/s |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|---|---|")
    for what, name, size, programs in rows:
        mine = programs["tetproof"]
        peers = [programs.get(peer) for peer in ("Gmsh", "meshio")]
        cells = [f"{what} {name}", f"{size / 1e6:.1f}", f"{mine.wall_s:.3f}", f"{size / 1e6 / mine.wall_s:,.0f}", f"{programs['one thread'].wall_s:.3f}",
                 *(f"{peer.wall_s:.2f}" if peer else "" for peer in peers), *(f"{peer.wall_s / mine.wall_s:.1f}" if peer else "" for peer in peers),
                 f"{mine.cpu_s:.3f}", *(f"{peer.cpu_s / mine.cpu_s:.1f}" if peer else "" for peer in peers), f"{cats[name]:,.0f}"]
        print(f"| {' | '.join(cells)} |")
    print()
    return rows


def ratios(rows):
    """Says which targets are missed."""
    missed = []
    for what, name, _, programs in rows:
        for peer, least in zip(("Gmsh", "meshio"), TARGETS[name]):
            if least and programs[peer].wall_s < least * programs["tetproof"].wall_s:
                missed.append(f"{what} {name}: {programs[peer].wall_s / programs['tetproof'].wall_s:.1f} times {peer}, not {least}")
    print(("Missed: " + "; ".join(missed) if missed else "All targets (10 times Gmsh; 10 times meshio, 4 for binary) are met") + ".\n", flush=True)


def cat(bench, name):
    """MB/s of `cat FILE >/dev/null`, the file being in memory."""
    script = "cat " + " ".join(file_set(bench, name)) + " >/dev/null"
    empty = bench.command("sh", "sh", "-c", "cat /dev/null >/dev/null")
    command = bench.command("cat", "sh", "-c", script)
    measure([empty, command], 3 * bench.runs, bench.cores)
    return file_bytes(bench, name) / 1e6 / max(command.wall - empty.wall, 1e-4)


def whole(bench):
    """tetproof-convert as users run it, all of it: time, and memory beside that of the arrays (of the smallest
    size the program itself is most)."""
    rows = []
    for size in CELLS:
        read = Program(bench, f"arrays {size}", bench.ours("formats_ours"), "read", file_name(size, ".bin.msh"), 1, len(bench.cores))
        read.run(bench.cores)
        pairs = [(".22.msh", ".w.41.msh", "msh41", "ascii"), (".41.msh", ".w.22.msh", "msh22", "ascii"), (".41.msh", ".w.bin.msh", "msh41", "binary"),
                 (".bin.msh", ".w.41.msh", "msh41", "ascii"), (".ele", ".w.41.msh", "msh41", "ascii"), (".41.msh", ".w.ele", "tetgen", "ascii")]
        commands = [bench.command(f"tetproof-convert {file_name(size, a)} {file_name(size, b)}", bench.ours("tetproof-convert"), "--quiet", file_name(size, a),
                                  file_name(size, b), "--to", target, f"--{encoding}", "--threads", len(bench.cores)) for a, b, target, encoding in pairs]
        measure(commands, bench.runs, bench.cores)
        for command, (a, b, _, _) in zip(commands, pairs):
            bench.record.setdefault("formats", {})[command.name] = command.record()
            rows.append((command, file_bytes(bench, file_name(size, a)) + file_bytes(bench, file_name(size, b)), read.arrays))
        for name in {file_name(size, b) for _, b, _, _ in pairs}:
            for written in file_set(bench, name):
                os.remove(bench.path(written))
    print("### The whole of tetproof-convert\n\n| | MB in and out | wall s | CPU s | MB/s | peak MiB | points and elements MiB | peak in these |\n"
          "|---|---|---|---|---|---|---|---|")
    for c, size, arrays in rows:
        print(f"| {c.name[len('tetproof-convert '):]} | {size / 1e6:,.1f} | {c.wall:.2f} ± {100 * c.spread():.0f} % | {c.cpu:.2f} | {size / 1e6 / c.wall:,.0f} | {c.memory:,.0f} | "
              f"{arrays / 2**20:,.0f} | {c.memory / (arrays / 2**20):.2f} |")
    print(flush=True)


def growth(bench):
    """Ours at three sizes a factor of ten apart: nanoseconds a tetrahedron should stay what they are."""
    threads, columns = len(bench.cores), {}
    for size in CELLS:
        programs = []
        for name, ending, target, encoding, _, _ in FORMATS:
            source, out = file_name(size, ".bin.msh"), "formats.written" + ending
            programs += [Program(bench, f"read {name}", bench.ours("formats_ours"), "read", file_name(size, ending), 3, threads),
                         Program(bench, f"write {name}", bench.ours("formats_ours"), "write", source, out, target, encoding, 3, threads)]
        measure(programs, bench.runs, bench.cores)
        columns[size] = programs
        for program in programs:
            bench.record.setdefault("formats", {})[f"{program.name}, {size}"] = program.record()
    tets = {size: 6 * CELLS[size] ** 3 for size in CELLS}
    print("### Growth: nanoseconds a tetrahedron\n\n| | " + " | ".join(f"{tets[size]:,}" for size in CELLS) + " |\n|---|" + "---|" * len(CELLS))
    for row in zip(*columns.values()):
        print(f"| {row[0].name} | " + " | ".join(f"{1e9 * program.wall_s / tets[size]:,.0f}" for program, size in zip(row, CELLS)) + " |")
    print(flush=True)
