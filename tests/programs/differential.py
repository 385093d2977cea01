#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares TetGen, VTK and meshio with tetproof-convert: both must understand the same mesh of each file.

usage: differential.py --build DIR --peer tetgen|vtk|meshio [--all] [--samples DIR]...

Samples of other programs are read by us (and written as .msh 4.1, which differential_meshes.py reads) and by the peer.
What we write from .msh samples, in every format that the peer reads, the peer must read without a warning. Elements are
compared by the bits of their corners' coordinates, in order, and by the set of their other nodes. Known differences of
a peer are in differential_known.py, with the reasons. Exit code 77: the peer is not installed, or there are no samples.
"""
import argparse
import collections
import pathlib
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
from differential_known import KNOWN, ONLY, known_of_written  # noqa: E402
from differential_meshes import Ours, difference  # noqa: E402
from differential_peers import apart, meshio_read, vtk_read  # noqa: E402
from differential_tetgen import compare_tetgen  # noqa: E402

SOURCE = pathlib.Path(__file__).resolve().parents[2]

READS = {"meshio": {".vtk", ".vtu", ".mesh", ".stl", ".off", ".obj", ".ply", ".node"},
         "vtk": {".vtk", ".vtu", ".stl", ".obj", ".ply"}}
# Which points are compared: a format or a reader may leave out points, or repeat those that corners share.
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


# The samples that we write, and the formats and encodings that the peer reads.
RICH = ["two_41_text.msh", "two41all.msh", "two41o2b.msh", "hybrid_part.msh"]
WRITTEN = {"meshio": [("vtu", "--binary"), ("vtu", "--ascii"), ("vtk", "--binary"), ("vtk", "--ascii"),
                      ("medit", "--ascii"), ("medit", "--binary"), ("stl", "--binary"), ("stl", "--ascii"),
                      ("off", "--ascii"), ("obj", "--ascii"), ("ply", "--ascii"), ("ply", "--binary"),
                      ("tetgen", "--ascii"), ("msh41", "--ascii"), ("msh41", "--binary"), ("msh22", "--ascii"),
                      ("msh22", "--binary")],  # no 4.0, which it takes for 4.1, even in Gmsh's own files
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
            if format_ == "tetgen":  # without the comments that only we read
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
            # An element in several groups is listed once for each. We make it one element again, meshio does not.
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
            compared = compare_tetgen(ours, samples(arguments, {".ele"}), failures)
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
