# SPDX-License-Identifier: GPL-3.0-or-later
"""What TetGen makes of its own meshes, and of the same meshes after we have rewritten them."""
import re
import shutil
import subprocess


def without_comments(path):
    if not path.exists():
        return None
    return [line.split() for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]


def tetgen_rebuilds(folder, stem):
    """Lets TetGen rebuild a mesh. Returns the files that it writes, without comments, and what is wrong."""
    run = subprocess.run(["tetgen", "-rCC", stem], cwd=folder, capture_output=True, text=True, errors="replace")
    said = run.stdout + run.stderr
    wrong = "" if run.returncode == 0 and "appears to be consistent" in said else "code %d: %s" % (run.returncode, said[-200:])
    if re.search("warning|error", said, re.I):
        wrong += " " + re.search("[^\n]*(warning|error)[^\n]*", said, re.I).group(0)
    base, _, step = stem.rpartition(".")
    new = "%s.%d" % (base, int(step) + 1)
    return {e: without_comments(folder / (new + e)) for e in (".node", ".ele", ".face", ".edge")}, wrong


def compare_tetgen(ours, paths, failures):
    compared = 0
    for path in paths:
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
