#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""TetGen, VTK and meshio beside tetproof-convert: of each file both understand the same mesh.

usage: differential.py --build DIR --peer tetgen|vtk|meshio [--all] [--samples DIR]...

Files of others are read by us (and written as .msh 4.1, which the lines below read) and by the peer; what we write
from .msh samples in every format that the peer reads, it reads too, without a warning. Elements are compared by the
bits of their corners' coordinates in order, and by the set of their other nodes. Where the peer is known to do
something else, KNOWN says which file, and why. Exit code 77: the peer is not installed, or there are no samples.
"""
import argparse
import collections
import ctypes
import os
import pathlib
import pickle
import re
import shutil
import struct
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]

# Gmsh's numbers of element types: corners, and what meshio and VTK call them.
CORNERS = {15: 1, 1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 6: 6, 7: 5, 8: 2, 9: 3, 10: 4, 11: 4, 12: 8, 13: 6, 14: 5, 16: 4,
           17: 8, 18: 6, 19: 5, 26: 2}
MESHIO = {"vertex": 15, "line": 1, "triangle": 2, "quad": 3, "tetra": 4, "hexahedron": 5, "wedge": 6, "pyramid": 7,
          "line3": 8, "line4": 26, "triangle6": 9, "quad9": 10, "tetra10": 11, "hexahedron27": 12, "wedge18": 13,
          "pyramid14": 14, "quad8": 16, "hexahedron20": 17, "wedge15": 18, "pyramid13": 19, "polygon": 34}
VTK = {1: 15, 3: 1, 5: 2, 7: 34, 9: 3, 10: 4, 12: 5, 13: 6, 14: 7, 21: 8, 22: 9, 23: 16, 24: 11, 25: 17, 26: 18,
       27: 19, 28: 10, 29: 12, 32: 13, 35: 26, 37: 14}


def bits(x):
    return struct.pack("<d", x + 0.0)  # -0 is 0: many formats say 0 for it


def single(x):
    return ctypes.c_float(x).value  # too large: infinity


class Mesh:
    """Elements as (corners in order, other nodes as a set) of coordinates, counted; and all points, counted."""

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
        """Without points that are in no element."""
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
    """Of our .msh 4.1 text: nodes and elements."""
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
        """Our understanding of a file, or why there is none."""
        out = self.folder / "read.msh"
        code, said = self.convert(path, out, "--to", "msh41", "--ascii")
        return (read_msh41(out, rounded), "") if code == 0 else (None, said)


# --- meshio


def meshio_read(path, rounded):
    import meshio
    mesh = meshio.read(path)
    points = [list(map(float, p)) + [0.0] * (3 - len(p)) for p in mesh.points]
    elements = []
    for block in mesh.cells:
        if re.fullmatch("polygon[0-9]*", block.type):
            kind = 34
        else:
            kind = MESHIO[block.type]
        elements += [(kind, [int(i) for i in nodes]) for nodes in block.data]
    return Mesh(points, elements, rounded)


# --- VTK


def vtk_read(path, rounded):
    import vtk
    ending = path.suffix.lower()
    if ending == ".vtk":
        reader = vtk.vtkGenericDataObjectReader()
    else:
        reader = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".stl": vtk.vtkSTLReader, ".ply": vtk.vtkPLYReader,
                  ".obj": vtk.vtkOBJReader}[ending]()
    if ending == ".stl":
        reader.MergingOff()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    points = [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
    elements = []
    for c in range(data.GetNumberOfCells()):
        cell = data.GetCell(c)
        nodes = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        if data.GetCellType(c) == 13:  # its wedge winds the other way round than Gmsh's prism
            nodes = [nodes[k] for k in (0, 2, 1, 3, 5, 4)]
        elements.append((VTK[data.GetCellType(c)], nodes))
    return Mesh(points, elements, rounded)


def apart(read, path, rounded, folder):
    """What `read` makes of a file in a process of its own, since peers crash and exit: the mesh, all that it said."""
    said, result = folder / "said", folder / "result"
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        out = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(out, 1)
        os.dup2(out, 2)
        code = 1
        try:
            with open(result, "wb") as file:
                pickle.dump(read(path, rounded), file)
            code = 0
        except Exception as error:  # whatever a peer throws
            print("%s: %s" % (type(error).__name__, str(error).split("\n")[0]))
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(code)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    words = said.read_text(errors="replace").split("\n")
    words = [re.sub("\x1b\\[[0-9;]*m", "", line).strip() for line in words]
    words = " ".join(line for line in words if line)
    if code != 0:
        raise ValueError("it crashes (signal %d)" % -code if code < 0 else "it refuses: " + words[-200:])
    with open(result, "rb") as file:
        return pickle.load(file), words


# Files of others that a peer reads otherwise, or not at all: name, and what it is. Nothing else may differ.
NO_COMMENTS = "it takes no comments or blank lines there"
UNESCAPED = "VTK leaves < in the names of arrays that it writes as it is, which no reader of XML takes"
NO_TEXTS = "it takes no arrays of texts"
SEPARATE = "it wants as many texture coordinates and normals as points"
KNOWN = {
    "meshio": {
        "two.1.node": "it takes no comment behind the numbers",
        "set.1.node": "it takes no comment behind the numbers",
        "set.1.v.node": "it wants an .ele",
        "c.node": "it takes no comment behind the numbers",
        "q1.node": "it takes no commas",
        "q2.node": "it wants an .ele",
        "q3.node": "it takes no short first line",
        "example_o2.1.node": "it takes no second order from TetGen",
        "example.1.mesh": "it takes Medit's version 1 for 32-bit coordinates, where TetGen wrote 17 digits",
        "two.mesh": "it wants each corner in a line of its own",
        "cells_text.vtu": UNESCAPED,
        "cells_raw.vtu": UNESCAPED,
        "cells_base64_zlib.vtu": UNESCAPED,
        "cells_text.vtk": NO_TEXTS,
        "cells_binary.vtk": NO_TEXTS,
        "cube.obj": "it takes no continued lines",
        "vcol.obj": "it takes colours for coordinates",
        "nancolor.obj": "it takes colours for coordinates",
        "vtvn.obj": SEPARATE,
        "box.obj": SEPARATE,
        "cube_compressed.obj": SEPARATE,
        "joined_tetrahedra.obj": SEPARATE,
        "negative_indices.obj": SEPARATE,
        "cube.off": "it wants OFF in a line of its own",
        "nohead.off": "it wants OFF in a line of its own",
        "whitespace.off": "it wants OFF in a line of its own",
        "comment.off": NO_COMMENTS,
        "comments.off": NO_COMMENTS,
        "color.off": "it takes no colours",
        "tetrahedra.stl": "it takes no exponents with D",
        "asc_noend.stl": "it takes a text without an end for a binary",
        "bin_cnt0.stl": "it believes the count 0, not the size",
        "cube_big_endian.ply": "it takes no elements but vertices and faces",
        "cube_text.ply": "it takes no elements but vertices and faces",
        "points_ascii_with_lists.ply": "it takes no elements but vertices and faces",
        "fuze.ply": "it wants all faces' lists alike long",
        "metadata.ply": "it takes no list but of corners",
        "empty.ply": "it fails where there is no face",
        "ply_empty_ascii.ply": "it fails where there is no face",
    },
    "vtk": {
        "cells_text.vtu": UNESCAPED,
        "cells_raw.vtu": UNESCAPED,
        "cells_base64_zlib.vtu": UNESCAPED,
        "cube.obj": "it takes no continued lines, and no negative numbers",
        "jacked.obj": "it reads nothing of it",
        "polygonfaces.obj": "it takes no `1//` without a number of a normal",
        "fuze.ply": "it doubles points with several texture coordinates",
        "asc_noend.stl": "it takes a text without an end for a binary",
        "cube_big_endian.ply": "it crashes on lists of other elements",
        "metadata.ply": "it crashes on lists of other elements",
    },
}

READS = {"meshio": {".vtk", ".vtu", ".mesh", ".stl", ".off", ".obj", ".ply", ".node"},
         "vtk": {".vtk", ".vtu", ".stl", ".obj", ".ply"}}
# Which points a comparison is about: a format or a reader may leave out or double those that corners share.
POINTS = {".stl": "used", ".obj": "used"}


def sample_folders(arguments):
    folders = [SOURCE / "corpus/formats", SOURCE.parent / "shared/formats", *map(pathlib.Path, arguments.samples)]
    return [f for f in folders if f.is_dir()]


def samples(arguments, endings):
    return sorted(p for folder in sample_folders(arguments) for p in folder.rglob("*") if p.suffix.lower() in endings)


def compare_samples(peer, read, ours, arguments, failures):
    compared = 0
    for path in samples(arguments, READS[peer]):
        rounded = path.suffix.lower() == ".stl" or (peer == "vtk" and path.suffix.lower() in (".ply", ".obj"))
        mesh, refusal = ours.read(path, rounded)
        if mesh is None:
            print("not read by us: %s" % refusal)
            continue
        mesh.keep(ONLY.get((peer, path.suffix.lower()[1:])))
        known = KNOWN[peer].get(path.name)
        try:
            theirs, said = apart(read, path, rounded, ours.folder)
            what = difference(mesh, theirs, POINTS.get(path.suffix.lower(), "all"))
            if said and not what:
                print("it says of %s: %s" % (path.name, said[:200]))
        except ValueError as error:
            what = str(error)
        if known and what:
            print("known: %s: %s (%s)" % (path.name, what, known))
        elif what:
            failures.append("%s: %s" % (path, what))
        else:
            if known:
                print("no longer known: %s: %s" % (path.name, known))
            compared += 1
    return compared


# What we write: from these samples, in each format and encoding that the peer reads.
RICH = ["two_41_text.msh", "two41all.msh", "two41o2b.msh", "hybrid_part.msh"]
WRITTEN = {"meshio": [("vtu", "--binary"), ("vtu", "--ascii"), ("vtk", "--binary"), ("vtk", "--ascii"),
                      ("medit", "--ascii"), ("medit", "--binary"), ("stl", "--binary"), ("stl", "--ascii"),
                      ("off", "--ascii"), ("obj", "--ascii"), ("ply", "--ascii"), ("ply", "--binary"),
                      ("tetgen", "--ascii"), ("msh41", "--ascii"), ("msh41", "--binary"), ("msh22", "--ascii"),
                      ("msh22", "--binary")],  # it takes 4.0 for 4.1, of Gmsh's own files too
           "vtk": [("vtu", "--binary"), ("vtu", "--ascii"), ("vtk", "--binary"), ("vtk", "--ascii"),
                   ("stl", "--binary"), ("stl", "--ascii"), ("obj", "--ascii"), ("ply", "--ascii"),
                   ("ply", "--binary")]}
ENDING = {"medit": {"--ascii": ".mesh", "--binary": ".meshb"}, "tetgen": ".node", "msh41": ".msh", "msh22": ".msh"}


def compare_written(peer, read, ours, arguments, failures):
    compared = 0
    sources = [p for p in samples(arguments, {".msh"}) if arguments.all or p.name in RICH]
    for source in sources:
        if "crashers" in str(source):
            continue
        for format_, encoding in WRITTEN[peer]:
            ending = ENDING.get(format_, "." + format_)
            if isinstance(ending, dict):
                ending = ending[encoding]
            what = "%s as %s %s" % (source.name, format_, encoding)
            target = ours.folder / ("out" + ending)
            for old in ours.folder.glob("out*"):
                old.unlink()
            code, said = ours.convert(source, target, "--to", format_, encoding)
            if code != 0:
                print("not written: %s: %s" % (what, said))
                continue
            if format_ == "tetgen":  # what only we see
                for file in ours.folder.glob("out*"):
                    file.write_bytes(b"".join(line for line in file.read_bytes().splitlines(True)
                                              if not line.startswith(b"#:")))
            rounded = format_ == "stl" or (peer == "vtk" and format_ in ("ply", "obj"))
            mesh, refusal = ours.read(target, rounded)
            if mesh is None:
                print("not read again by us: %s: %s" % (what, refusal))
                mesh, _ = ours.read(source, rounded)
            kinds = {kind for kind, _, _ in mesh.elements}
            mesh.keep(ONLY.get((peer, format_)))
            # An element in several groups stands there once for each, which we know for one, and meshio for several.
            merge = format_ == "msh22"
            try:
                theirs, said = apart(read, target, rounded, ours.folder)
                if merge:
                    theirs.elements = collections.Counter(set(theirs.elements))
                wrong = difference(mesh, theirs, POINTS.get(ending, "all"))
                if said:
                    wrong += " it says: " + said[:200]
            except ValueError as error:
                wrong = str(error)
            known = wrong and known_of_written(peer, format_, kinds, wrong, target.read_bytes())
            if known:
                print("known: %s: %s (%s)" % (what, wrong, known))
            elif wrong:
                failures.append("%s: %s" % (what, wrong))
            else:
                compared += 1
    return compared


# What a peer reads of a format, by the types of elements.
SURFACE, SOLID, FIRST_ORDER = {2, 3, 9, 16, 34}, {4, 5, 6, 7, 11}, {1, 2, 3, 4, 5, 6, 7, 15}
ONLY = {("meshio", "obj"): SURFACE, ("meshio", "tetgen"): SOLID, ("meshio", "medit"): FIRST_ORDER,
        ("meshio", "node"): SOLID, ("vtk", "obj"): SURFACE | {1, 15},
        ("vtk", "ply"): SURFACE}

# Of what we write, in the peers' own words, with what must be so of the file that they say them of.
SECOND_ORDER = {8, 9, 10, 11, 12, 13, 14, 16, 17, 18, 19}
FEW_TAGS = "it wants a group and an entity of each element, and nothing else"


def counts_from_1(text, section):
    """Whether the numbers in a section of a binary file are 1, 2, ...: nodes of .msh 2.2, or values."""
    at = text.find(b"$" + section + b"\n")
    if at < 0 or text.split(b"\n")[1].split()[1] != b"1":
        return True
    lines = text[at:at + 4000].split(b"\n")
    skip, size, rows = 2, 4 + 3 * 8, int(lines[1])
    if section.endswith(b"Data"):
        skip = 1
        for _ in range(3):  # texts, numbers, integers: each count, and so many lines
            skip += 1 + int(lines[skip])
        size, rows = 4 + int(lines[skip - 2]) * 8, int(lines[skip - 1])
    place = at + sum(len(line) + 1 for line in lines[:skip])
    return all(struct.unpack_from("<i", text, place + k * size)[0] == k + 1 for k in range(rows))


KNOWN_WRITTEN = {
    "meshio": [
        ("msh41", "parametric nodes not implemented", "it takes no parametric nodes", None),
        ("msh41", "KeyError: [0-9]+", "it takes no partitioned entities",
         lambda kinds, text: b"$PartitionedEntities" in text),
        ("msh41|msh22", "KeyError", "it knows no such elements", lambda kinds, text: kinds - set(MESHIO.values())),
        ("msh41|msh22", "Incompatible cell data", "it wants groups and values of all elements or of none", None),
        ("msh41|msh22", "MemoryError", "it makes an array as long as the largest number", None),
        ("msh22", "invalid value encountered in cast", "it takes no numbers beyond 32 bits",
         lambda kinds, text: re.search(rb"\b[1-9][0-9]{9,}\b", text)),
        ("msh22", "NoneType|concatenation axis|^ it says: Warning: The file contains tag data", FEW_TAGS, None),
        ("msh22", "only it: ", "it takes node 0 for the last one", lambda kinds, text: re.search(rb"\$Nodes\n\d+\n0 ", text)),
        ("msh22", "Couldn't read file", "it wants numbers 1, 2, ... in binary",
         lambda kinds, text: not (counts_from_1(text, b"Nodes") and counts_from_1(text, b"NodeData") and
                                  counts_from_1(text, b"ElementData"))),
        ("msh41", "Couldn't read file", "it wants numbers 1, 2, ... in binary",
         lambda kinds, text: not (counts_from_1(text, b"NodeData") and counts_from_1(text, b"ElementData"))),
        ("vtk|vtu|msh41|msh22", "KeyError: 'pyramid13'", "it knows no such pyramids", lambda kinds, text: 19 in kinds),
        ("medit", "^ it says: Warning: meshio doesn't know Gmf[A-Za-z]*[PQ]2|Couldn't read file", "it knows no second order of Medit's",
         lambda kinds, text: kinds & SECOND_ORDER),
        ("tetgen", "Couldn't read file", "it takes no second order from TetGen", lambda kinds, text: 11 in kinds),
        ("stl", r"^ it says: \S*/_stl\.py:\d+: RuntimeWarning: overflow encountered in scalar multiply "
         r"if 84 \+ num_triangles \* 50 == filesize_bytes:$",
         "meshio 5.3.5 with NumPy 2 warns while it tries a text as binary", lambda kinds, text: text.startswith(b"solid")),
        ("off", "Can only read triangular faces", "it takes no faces but triangles",
         lambda kinds, text: any(line[:2] != b"3 " for line in text.split(b"\n")
                                 if line.count(b" ") != 2 and line[:1].isdigit())),
        ("ply", "Expected `element vertex`", "it takes no elements but vertices and faces", lambda kinds, text: b"element edge" in text),
        ("ply", "no field of name", "its reader of text drops characters of names", None),
    ],
    "vtk": [
        ("vtk", "Error reading ascii data", "its reader of text takes no nan, which stands where there is no value "
         "(tetproof-convert warns of it)", lambda kinds, text: b"nan" in text),
    ],
}


def known_of_written(peer, format_, kinds, wrong, text):
    for formats, words, reason, is_so in KNOWN_WRITTEN.get(peer, []):
        if re.fullmatch(formats, format_) and re.search(words, wrong) and (is_so is None or is_so(kinds, text)):
            return reason
    return None


# --- TetGen


def without_comments(path):
    if not path.exists():
        return None
    return [line.split() for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]


def tetgen_rebuilds(folder, stem):
    """What TetGen makes of a mesh: all files that it writes, without their comments."""
    run = subprocess.run(["tetgen", "-rCC", stem], cwd=folder, capture_output=True, text=True, errors="replace")
    said = run.stdout + run.stderr
    wrong = "" if run.returncode == 0 and "appears to be consistent" in said else "code %d: %s" % (run.returncode, said[-200:])
    if re.search("warning|error", said, re.I):
        wrong += " " + re.search("[^\n]*(warning|error)[^\n]*", said, re.I).group(0)
    base, _, step = stem.rpartition(".")
    new = "%s.%d" % (base, int(step) + 1)
    return {e: without_comments(folder / (new + e)) for e in (".node", ".ele", ".face", ".edge")}, wrong


def compare_tetgen(ours, arguments, failures):
    compared = 0
    for path in samples(arguments, {".ele"}):
        stem = path.name[:-len(".ele")]
        if not stem.endswith(".1") or not path.with_suffix(".node").exists():
            continue
        folders = {}
        for who in ("theirs", "ours"):
            folders[who] = ours.folder / ("%s-%s" % (who, stem))
            folders[who].mkdir()
        for part in path.parent.glob(stem + ".*"):
            if part.suffix in (".node", ".ele", ".face", ".edge", ".neigh"):
                shutil.copy(part, folders["theirs"])
        code, said = ours.convert(path, folders["ours"] / (stem + ".ele"))
        if code != 0:
            failures.append("%s: %s" % (path, said))
            continue
        theirs, complaint = tetgen_rebuilds(folders["theirs"], stem)
        if complaint:
            print("TetGen itself of %s: %s" % (path.name, complaint))
        again, wrong = tetgen_rebuilds(folders["ours"], stem)
        if wrong and not complaint:
            failures.append("%s, rewritten by us: %s" % (path, wrong))
        for ending, lines in theirs.items():
            there = (folders["theirs"] / (stem + ending)).exists()
            if there and not (folders["ours"] / (stem + ending)).exists():
                print("not written: %s of %s" % (ending, path.name))
                continue
            if lines != again[ending]:
                first = next((a for a in zip(lines or [], again[ending] or []) if a[0] != a[1]), "length")
                failures.append("%s: TetGen makes another %s of it when it comes from us: %s" % (path, ending, first))
        compared += 1
    return compared


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("--peer", required=True, choices=["tetgen", "vtk", "meshio"])
    parser.add_argument("--all", action="store_true", help="write all .msh samples, not only the rich ones")
    parser.add_argument("--samples", action="append", default=[], help="a further folder of samples")
    arguments = parser.parse_args()
    if not sample_folders(arguments):
        print("no samples")
        return 77
    try:
        if arguments.peer == "tetgen":
            if not shutil.which("tetgen"):
                raise ImportError("tetgen")
        else:
            __import__(arguments.peer)
    except ImportError as missing:
        print("not installed: %s" % missing)
        return 77
    failures = []
    with tempfile.TemporaryDirectory(prefix="tetproof-differential-") as folder:
        ours = Ours(arguments.build, folder)
        if arguments.peer == "tetgen":
            compared = compare_tetgen(ours, arguments, failures)
        else:
            read = {"meshio": meshio_read, "vtk": vtk_read}[arguments.peer]
            compared = compare_samples(arguments.peer, read, ours, arguments, failures)
            compared += compare_written(arguments.peer, read, ours, arguments, failures)
    print("%d files understood alike, %d not" % (compared, len(failures)))
    for failure in failures:
        print("FAILED " + failure)
    return 1 if failures or compared == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
