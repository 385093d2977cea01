# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes as tetproof-convert and its peers understand them, and where two of them differ."""
import collections
import ctypes
import pathlib
import struct
import subprocess

# How many corners Gmsh's types of elements have.
CORNERS = {15: 1, 1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 6: 6, 7: 5, 8: 2, 9: 3, 10: 4, 11: 4, 12: 8, 13: 6, 14: 5, 16: 4,
           17: 8, 18: 6, 19: 5, 26: 2}


def bits(x):
    return struct.pack("<d", x + 0.0)  # -0 becomes 0, as in many formats


def single(x):
    return ctypes.c_float(x).value  # infinity if it is too large


class Mesh:
    """Counts elements, as coordinates of (corners in order, set of other nodes), and points."""

    def __init__(self, points, elements, rounded=False):
        place = [tuple(bits(single(x) if rounded else x) for x in p) for p in points]
        self.points = collections.Counter(place)
        self.elements = collections.Counter()
        for kind, nodes in elements:
            n = CORNERS.get(kind, len(nodes))
            where = [place[i] for i in nodes]
            if n in (3, 4) and kind == 34:
                kind = n - 1
            self.elements[kind, tuple(where[:n]), frozenset(where[n:])] += 1

    def keep(self, kinds):
        if kinds:
            self.elements = collections.Counter({e: n for e, n in self.elements.items() if e[0] in kinds})

    def used(self):
        """The points of elements."""
        return {p for _, corners, others in self.elements for p in (*corners, *others)}


def difference(ours, theirs, points="all"):
    text = []
    if ours.elements != theirs.elements:
        for who, rest in (("we", ours.elements - theirs.elements), ("it", theirs.elements - ours.elements)):
            if rest:
                kind, corners, others = next(iter(rest))
                shown = [[struct.unpack("<d", x)[0] for x in p] for p in corners]
                text.append("only %s: %d elements, such as type %d %s" % (who, sum(rest.values()), kind, shown))
    if points == "all" and ours.points != theirs.points:
        text.append("points: only we %d, only it %d" % (sum((ours.points - theirs.points).values()),
                                                       sum((theirs.points - ours.points).values())))
    if points == "used" and ours.used() != theirs.used():
        text.append("points of elements differ")
    return "; ".join(text)


def read_msh41(path, rounded=False):
    """The nodes and elements of .msh 4.1 text that we wrote."""
    lines = path.read_text(errors="surrogateescape").split("\n")
    at = lines.index("$Nodes") + 1
    blocks = int(lines[at].split()[0])
    at += 1
    number, points = {}, []
    for _ in range(blocks):
        count = int(lines[at].split()[3])
        for k in range(count):
            number[int(lines[at + 1 + k])] = len(points)
            points.append([float(x) for x in lines[at + 1 + count + k].split()[:3]])
        at += 1 + 2 * count
    at = lines.index("$Elements") + 1
    blocks = int(lines[at].split()[0])
    at += 1
    elements = []
    for _ in range(blocks):
        _, _, kind, count = map(int, lines[at].split())
        for k in range(count):
            elements.append((kind, [number[int(n)] for n in lines[at + 1 + k].split()[1:]]))
        at += 1 + count
    return Mesh(points, elements, rounded)


class Ours:
    def __init__(self, build, folder):
        self.program = str(pathlib.Path(build).resolve() / "tetproof-convert")
        self.folder = pathlib.Path(folder)

    def convert(self, source, target, *options):
        run = subprocess.run([self.program, str(source), str(target), "--quiet", *options], capture_output=True,
                             text=True, errors="replace")
        return run.returncode, run.stderr.strip()

    def read(self, path, rounded=False):
        """How we understand a file, or why we do not."""
        out = self.folder / "read.msh"
        code, said = self.convert(path, out, "--to", "msh41", "--ascii")
        return (read_msh41(out, rounded), "") if code == 0 else (None, said)
