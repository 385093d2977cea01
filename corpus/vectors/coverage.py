#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes COVERAGE.md: which row, equation, option, stopping rule and reading is met by which vectors and which traces. It looks into
the vectors and the traces themselves, and into the arguments in traces/list.txt.

usage: coverage.py           writes COVERAGE.md
       coverage.py --check   writes nothing; exit code 1 if something is met by none, or if COVERAGE.md has drifted"""
import json
import pathlib
import sys

sys.dont_write_bytecode = True
import checks  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent


class Trace:
    """A trace by kinds of records, with the arguments that make it."""

    def __init__(self, line, folder):
        self.name, *self.words = line.split()
        self.surface = self.words[0]
        self.records = {}
        with open(folder / f"{self.name}.jsonl", encoding="utf-8") as file:
            for text in file:
                record = json.loads(text)
                self.records.setdefault(record["record"], []).append(record)
        self.settings, self.end = self.all("settings")[0], self.all("end")[0]
        self.rows = [row for record in self.all("rows") for row in record["rows"]]
        self.triangles = read_surface(next(p for p in (folder / f"{self.name}.off", folder / f"{self.name}.obj") if p.exists()))
        self.signs = [(a, b) for record in self.all("indicators") for a, b in zip(record["initial"], record["after"])]
        self.table3 = rows_of_table3(self)

    def all(self, kind):
        return self.records.get(kind, [])

    def option(self, name):
        """The word after an option; "" for a flag; None if it is not given."""
        if name not in self.words:
            return None
        following = self.words[self.words.index(name) + 1:][:1]
        return following[0] if following and not following[0].startswith("--") else ""


class Vectors:
    """A file of vectors. `cases(...)` counts those with a flag, or those for which a function holds."""

    def __init__(self, path):
        self.content = json.loads(path.read_text(encoding="utf-8"))
        self.kind = self.content["kind"]

    def cases(self, what):
        met = (lambda case: what in case["flags"]) if isinstance(what, str) else what
        return sum(1 for case in self.content["cases"] if met(case))


# --- Table 3, whose rows a trace does not name

def read_surface(path):
    """The triangles of an .off or .obj of ours, as triples of points."""
    points, triangles = [], []
    lines = [line.split() for line in path.read_text(encoding="utf-8").splitlines() if line and line[0] != "#"]
    if path.suffix == ".obj":
        points = [tuple(map(float, w[1:4])) for w in lines if w[0] == "v"]
        triangles = [[int(c.split("/")[0]) - 1 for c in w[1:4]] for w in lines if w[0] == "f"]
    else:
        n = int(lines[1][0])
        points = [tuple(map(float, w)) for w in lines[2:2 + n]]
        triangles = [list(map(int, w[1:4])) for w in lines[2 + n:]]
    return [[points[v] for v in t] for t in triangles]


def rows_of_table3(trace):
    """The rows of Table 3 that the run has applied, from the indicators and from the points of the edges, counted exactly; and "both" if a
    vertex was asked for both signs."""
    place = lattice_corners(trace)
    signs = {(i, r["j"], r["k"]): a for r in trace.all("indicators") for i, a in enumerate(r["initial"])}
    settled = {tuple(m["vertex"]) for m in trace.all("moved")}
    found, asked = set(), {}
    for low in signs:
        for step in range(1, 8):
            high = tuple(x + (step >> axis & 1) for axis, x in enumerate(low))
            if high not in signs or low in settled or high in settled:
                continue
            p, q = place(low), place(high)
            box = [(min(a, b), max(a, b)) for a, b in zip(p, q)]
            near = [[checks.exact(c) for c in t] for t in trace.triangles
                    if all(min(c[x] for c in t) <= box[x][1] and max(c[x] for c in t) >= box[x][0] for x in range(3))]
            ends = "".join(sorted(signs[low] + signs[high], key="-0+".index))
            if near and len(checks.points_of_edge(checks.exact(p), checks.exact(q), near)) > (ends == "-+"):
                row = {"--": "1", "-0": "2", "-+": "3b", "00": "4", "0+": "5", "++": "6"}[ends]
                found.add(row)
                for v in (low, high):
                    if signs[v] == "0":
                        asked.setdefault(v, set()).add(row == "2")
    return found | ({"both"} if any(len(wanted) == 2 for wanted in asked.values()) else set())


# --- what can be met

def row_of(name):
    return lambda case: case["expected"].get("row") == name


def inserted(name):
    return lambda trace: any(i["row"] == name for i in trace.all("insertion"))


def stops(name):
    return lambda trace: trace.end["stopped"] == name


def given(option, value=None):
    return lambda trace: trace.option(option) is not None and (value is None or trace.option(option) == value)


def lattice_corners(trace):
    box, cells = trace.all("lattice")[0]["box"], trace.all("lattice")[0]["cells"]
    return lambda v: [(1 - i / n) * low + i / n * high for i, n, low, high in zip(v, cells, *box)]


def cut_at_vertex(trace):
    place = lattice_corners(trace)
    return any(c["point"] == place(end) for c in trace.all("cut") for end in c["edge"])


def settled_in_place(trace):
    place = lattice_corners(trace)
    return any(m["point"] == place(m["vertex"]) for m in trace.all("moved"))


def repeats(trace):
    """Whether a tetrahedron was left out because it names a vertex twice: fewer tetrahedra than the rows have."""
    size = {"5": 1, "6": 1, "7": 1, "8": 1, "9": 1, "10": 3, "11": 2, "12": 3, "13": 1, "14": 1, "E8": 1, "12g": 8, "12h": 8}
    listed = sum(size.get(row, size.get(row.rstrip("abcdef"), 0)) for row in trace.rows)
    first = trace.all("first_grid")
    return bool(first) and first[0]["tets"] < listed


def beyond_d1(trace):
    return any(w["omega"] * w["d"] > g["d1"] for g in trace.all("first_grid") for w in trace.all("weight"))


def new_point_stays(trace):
    """Whether a new point that belongs on the parametric surface is the plain mean of the corners that it replaces."""
    corners = lambda i: [i["tet"][k] for k in i["replaced"]]
    mean = lambda points: [sum(column) / len(points) for column in zip(*points)]
    return trace.settings["parametric"] and any(len(i["replaced"]) < 4 and i["point"] == mean(corners(i)) for i in trace.all("insertion"))


def law(trace):
    return trace.all("first_grid")[0] if trace.all("first_grid") else {"v0": 0, "v1": 0}


def pieces(n):
    return lambda trace: any(len(i["replaced"]) == n for i in trace.all("insertion"))


def items():
    """(group, name, what it is, {kind of vectors: which cases}, which traces, why nothing can meet it)."""
    for case in [str(n) for n in range(1, 15)] + ["E8"]:
        yield ("Table 1", case, "", {"table1": lambda c, name=case: c["expected"]["case"] == name},
               lambda t, name=case: any(r.rstrip("-abcdefgh") == name or r == name for r in t.rows), None)
    for row in ("1 2 3 4 5 5- 6 7 8 9 10a 10b 10c 10d 11a 11b 12a 12b 12c 12d 12e 12f 12g 12h 13 14 E8").split():
        yield "Table 2", row, {"5-": "four surface points, not kept"}.get(row, ""), {"table2": row_of(row)}, lambda t, name=row: name in t.rows, None
    for row in ("1", "2", "3a", "3b", "4", "5", "6"):
        why = "cannot occur: a closed surface crosses an edge between -1 and +1 an odd number of times (reading E6)" if row == "3a" else None
        yield ("Table 3", row, {"1": "outside, outside", "2": "outside, surface", "3b": "outside, inside", "4": "surface, surface", "5": "surface, inside", "6": "inside, inside"}.get(row, ""),
               {"table3": lambda c, name=row: name in c["expected"]["applied"]}, lambda t, name=row: name in t.table3, why)
    yield "Table 3", "0 to -1", "an indicator that Table 3 changed", {"table3": "row-2"}, lambda t: ("0", "-") in t.signs, None
    yield "Table 3", "0 to +1", "an indicator that Table 3 changed", {"table3": lambda c: "row-4" in c["flags"] or "row-5" in c["flags"]}, lambda t: ("0", "+") in t.signs, None
    for row in "0 1 2a 2b 3a 3b 4a 4b 4c 4d 4e".split():
        why = "cannot occur in a grid that Tables 1 and 2 made" if row == "2b" else None
        yield "Table 4", row, {"0": "no surface point"}.get(row, ""), {"table4": row_of(row)}, inserted(row), why

    some = lambda c: True
    adapted = lambda t: bool(t.all("weight"))
    yield "Equations", "(2.1)", "the lattice", {"lattice": some}, lambda t: True, None
    yield "Equations", "(3.1)", "the desired volume", {"volume_law": some, "weights": some}, adapted, None
    yield "Equations", "(3.2)", "the distance", {"weights": some}, adapted, None
    yield "Equations", "(3.3)", "the error", {"weights": some}, adapted, None
    yield "Equations", "(3.4)", "the average error", {"weights": some, "choice": some}, adapted, None
    yield "Equations", "(3.5)", "the average error after a split", {"choice": some}, lambda t: bool(t.all("insertion")), None
    yield "Equations", "(3.6)", "the curvature's weight", {"curvature_weight": some, "weights": "curvature"}, lambda t: t.settings["curvature"], None

    setting = lambda key, value: lambda t: t.settings[key] == value
    yield "Options", "--region inside", "", {"indicators": lambda c: c["input"]["region"] == "inside"}, setting("region", "inside"), None
    yield "Options", "--region outside", "", {"indicators": "outside-region"}, setting("region", "outside"), None
    yield "Options", "--cells N", "", {"lattice": "one-number"}, lambda t: "," not in t.option("--cells"), None
    yield "Options", "--cells NX,NY,NZ", "", {"lattice": "three-numbers"}, lambda t: "," in t.option("--cells"), None
    yield "Options", "--box-scale", "other than 1.2", {"lattice": lambda c: c["input"]["box_scale"] != 1.2}, lambda t: t.settings["box_scale"] != 1.2, None
    yield "Options", "--on-surface, default", "", {}, setting("on_surface", 1e-6), None
    yield "Options", "--on-surface 0", "", {"indicators": some}, lambda t: t.settings["on_surface"] == 0 and not t.settings["literal"], None
    yield "Options", "--on-surface, large", "0.1 or more", {"table3": "settled"}, lambda t: t.settings["on_surface"] >= 0.1, None
    for rule in ("lowest", "shortest"):
        yield "Options", "--diagonals " + rule, "", {"table2": rule}, setting("diagonals", rule), None
    yield "Options", "--literal", "", {}, setting("literal", True), None
    yield "Options", "--parametric on", "", {}, setting("parametric", True), None
    yield "Options", "--parametric off", "of a surface that has (u,v)", {}, lambda t: t.option("--parametric") == "off", None
    for option in ("--v0", "--v1", "--d1", "--p"):
        key = option[2:]
        vector = {"volume_law": lambda c, k=key: c["input"][k] != 1} if key in ("d1", "p") else {"weights": "mean-volume"}
        yield "Options", option, "", vector, given(option), None
    yield "Options", "--v0 abs:X", "", {"weights": lambda c: c["input"]["law"]["unit"] == "absolute"}, lambda t: (t.option("--v0") or "").startswith("abs:"), None
    yield "Options", "--e-avg", "", {}, given("--e-avg"), None
    yield "Options", "--past-dilution", "", {}, setting("past_dilution", True), None
    yield "Options", "--curvature", "", {"weights": "curvature"}, setting("curvature", True), None
    for criterion in ("solid-angle", "aspect-ratio"):
        yield ("Options", "--improve " + criterion, "", {"flips": lambda c, name=criterion: c["input"]["criterion"] == name},
               lambda t, name=criterion: t.settings["improve"] == name and t.all("flip"), None)
    yield "Options", "--improve none", "", {}, lambda t: t.settings["improve"] == "none" and t.all("insertion"), None
    yield "Options", "--improve-below", "", {}, lambda t: given("--improve-below")(t) and t.all("flip"), None
    yield "Options", "--points N", "", {}, lambda t: t.settings["points"] not in ("auto", "0"), None
    yield "Options", "--points auto", "", {}, setting("points", "auto"), None
    yield "Options", "--points 0", "", {}, given("--points", "0"), None

    for rule, note in (("no-gain", ""), ("dilution", ""), ("stalled", ""), ("points", ""), ("e-avg", ""), ("not-asked", "")):
        why = ("a trace of it would have more than 1000 insertions and 400 kB; the unit test Stopping.WhereTheAverageHasSetNoNewMinimumForLong "
               "meets it") if rule == "stalled" else None
        yield "Stopping rules", rule, note, {"choice": rule} if rule in ("no-gain",) else {}, stops(rule), why
    yield "Stopping rules", "refused split", "reading D18", {}, lambda t: t.end["refused"] > 0, None

    turned = ("10a", "10b", "10c", "10d", "12a", "12e", "12f")
    yield "Readings", "E1", "row 12a", {"table2": "mended-12a"}, lambda t: "12a" in t.rows, None
    yield "Readings", "E2", "rows 12g and 12h", {"table2": "centroid"}, lambda t: "12g" in t.rows or "12h" in t.rows, None
    yield "Readings", "E3", "row 4c", {"table4": "mended-4c"}, inserted("4c"), None
    yield "Readings", "E4", "V0 above V1", {"volume_law": "decreasing"}, lambda t: law(t)["v0"] > law(t)["v1"], None
    yield ("Readings", "E5", "D/A", {"quality": "largest-face", "flips": lambda c: c["input"]["criterion"] == "aspect-ratio"},
           lambda t: t.settings["improve"] == "aspect-ratio" and t.all("flip"), None)
    yield "Readings", "E6", "an even number of points between -1 and +1", {"table3": "two-points"}, None, "row 3a cannot occur; vectors show that it must not be taken"
    yield "Readings", "E7", "rows that list negative tetrahedra", {"table2": "orientation"}, lambda t: any(r in turned for r in t.rows), None
    yield "Readings", "E8", "(1,1,0,0)", {"table1": "not-printed", "table2": "not-printed"}, lambda t: "E8" in t.rows, None
    yield "Readings", "D1", "the box and the numbers of cells", {"lattice": some}, lambda t: True, None
    yield "Readings", "D2", "the Kuhn split", {"table3": some}, lambda t: True, None
    yield "Readings", "D3", "the order of numbers: of cuts, of moved points, of ties", {"table4": "tie"}, lambda t: bool(t.all("cut")), None
    yield "Readings", "D4", "exact indicators: a vertex exactly on the surface", {"indicators": some}, lambda t: any(a == "0" for a, _ in t.signs) and t.settings["on_surface"] == 0, None
    yield "Readings", "D4", "the tolerance: a vertex that moves", {"closest_point": some, "table3": "settled"}, lambda t: any(not m["mended"] for m in t.all("moved")) and not settled_in_place(t), None
    yield "Readings", "D4", "the tolerance: a vertex exactly on the surface stays in place", {"closest_point": "on-surface"}, settled_in_place, None
    yield "Readings", "D4", "mending", {}, lambda t: any(m["mended"] for m in t.all("moved")), None
    yield "Readings", "D5", "the region outside", {"indicators": "outside-region"}, setting("region", "outside"), None
    yield "Readings", "D6", "points are counted, not crossings", {"edge_points": "touch", "table3": "two-points"}, lambda t: any(a != b for a, b in t.signs), None
    yield "Readings", "D6", "parts along the edge are united", {"edge_points": "union"}, lambda t: t.surface.startswith("terrain") and t.settings["on_surface"] == 0, None
    yield "Readings", "D6", "requests from the initial indicators, both signs", {"table3": "both-signs"}, lambda t: "both" in t.table3, None
    yield "Readings", "D7", "a cut at an end of its edge", {"table2": "cut-at-vertex", "table3": "cut-at-vertex"}, cut_at_vertex, None
    yield "Readings", "D7", "a tetrahedron that names a vertex twice", {"table2": "cut-at-vertex"}, repeats, None
    yield "Readings", "D8", "the order of the vertices", {"table1": "permuted", "table2": "sorting"}, lambda t: True, None
    yield "Readings", "D9", "diagonals", {"table2": "lowest"}, lambda t: any(r[:2] in ("10", "11", "12") for r in t.rows), None
    yield "Readings", "D9", "shortest diagonals that lowest would not take", {"table2": "shortest"}, lambda t: any(r in ("10a", "10b", "10c", "11a", "12a", "12b", "12c", "12d", "12e", "12g", "12h") for r in t.rows), None
    yield "Readings", "D10", "four surface points: kept", {"table2": "case-5"}, lambda t: "5" in t.rows, None
    yield "Readings", "D10", "four surface points: not kept", {"table2": "case-5"}, lambda t: "5-" in t.rows, None
    yield "Readings", "D11", "features thinner than the lattice", {"table3": "row-1"}, lambda t: bool(t.table3 & {"1", "6"}), None
    yield "Readings", "D12", "a surface point moves to the parametric surface", {}, lambda t: any(m["from"] != m["to"] for m in t.all("mapped")), None
    yield "Readings", "D12", "a surface point must stay", {}, lambda t: any(m["from"] == m["to"] for m in t.all("mapped")), None
    yield "Readings", "D12", "the new point of a split must stay", {}, new_point_stays, None
    yield "Readings", "D13", "d1 by default", {"weights": "default-d1"}, lambda t: adapted(t) and t.option("--d1") is None, None
    yield "Readings", "D13", "d1 given", {"volume_law": "d1-scaled"}, given("--d1"), None
    yield "Readings", "D13", "beyond d1", {"volume_law": "beyond-d1"}, beyond_d1, None
    yield "Readings", "D14", "the distance to vertices", {"weights": "vertices-not-triangles"}, adapted, None
    yield "Readings", "D15", "curvature", {"curvature": some, "weights": "nearest-tie"}, lambda t: t.settings["curvature"] and adapted(t), None
    yield "Readings", "D15", "kappa the same everywhere", {"curvature_weight": "all-equal"}, None, "a surface with equal curvature everywhere has symmetries; --curvature then changes nothing"
    for m, row in ((2, "4c"), (3, "3b"), (4, "1")):
        yield "Readings", "D16", f"{m} pieces, a mean over L+{m - 1}", {"choice": f"pieces-{m}"}, pieces(m), None
    yield "Readings", "D17", "the end", {"choice": "no-gain"}, lambda t: t.end["stopped"] in ("no-gain", "dilution", "points", "e-avg"), None
    yield "Readings", "D18", "refused splits", {}, lambda t: t.end["refused"] > 0, None
    yield "Readings", "D19", "Table 4 with four surface points", {"table4": "edge"}, lambda t: any(i["row"][0] == "4" for i in t.all("insertion")), None
    yield "Readings", "D19", "the fall-back of 4c, 4d and 4e", {"table4": "fallback"}, lambda t: any(i["row"] in ("4c", "4d", "4e") and len(i["replaced"]) == 3 for i in t.all("insertion")), None
    yield "Readings", "D19", "the outer box", {"table4": "outer-box"}, lambda t: t.settings["region"] == "outside" and t.all("insertion"), None
    yield "Readings", "D20", "the smallest solid angle", {"quality": "smallest"}, lambda t: t.settings["improve"] == "solid-angle" and t.all("flip"), None
    yield "Readings", "D21", "when improvement is made, and in which set", {"flips": "within-the-set"}, lambda t: bool(t.all("flip")), None
    yield "Readings", "D22", "a flip 2-3", {"flips": "two-three"}, lambda t: any(f["kind"] == "2-3" for f in t.all("flip")), None
    yield "Readings", "D22", "a flip 3-2", {"flips": "three-two"}, lambda t: any(f["kind"] == "3-2" for f in t.all("flip")), None
    yield "Readings", "D22", "no flip of a hexahedron that is not strictly convex", {"flips": "flat-hexahedron"}, lambda t: bool(t.all("flip")), None
    yield "Readings", "D23", "stalled", {}, stops("stalled"), "as the stopping rule stalled"
    yield "Readings", "D23", "flips change E_avg", {}, lambda t: any(f["e_avg"] != i["e_avg"] for f, i in zip(t.all("flip"), t.all("insertion"))), None


# --- the table

def counts(vectors, wanted):
    """The text of a cell: how many cases of which file."""
    parts = []
    for kind, what in wanted.items():
        n = vectors[kind].cases(what)
        if n:
            parts.append(f"{kind} {n}" + (f" ({what})" if isinstance(what, str) else ""))
    return "; ".join(parts)


def table(vectors, traces):
    """The page, and one line for each item that nothing meets."""
    missing, out = [], []
    group = None
    for name, item, note, wanted, seen, why in items():
        if name != group:
            group = name
            out += ["", f"## {name}", "", "| | | vectors: cases (flag) | traces |", "|---|---|---|---|"]
        met = counts(vectors, wanted)
        by = [t.name for t in traces if seen and seen(t)]
        text = "all" if len(by) == len(traces) else f"all but {', '.join(others)}" if len(others := [t.name for t in traces if t.name not in by]) < 4 else ", ".join(by)
        what = f"{name}, {item}" + (f", {note}" if note else "")
        if not by and not why:
            missing.append(f"{what}: met by no trace, and no reason says why")
        if wanted and not met and not why:
            missing.append(f"{what}: met by no case of {', '.join(wanted)}")
        reason = why if why and not by else ""
        out.append(f"| {item} | {note} | {met or '-'} | {text or (reason and 'none: ' + reason) or 'none'} |")
    return out, missing


def page():
    vectors = {v.kind: v for v in (Vectors(path) for path in sorted(HERE.glob("*.json")) if not path.name.endswith(".schema.json"))}
    lines = [line for line in (HERE / "traces/list.txt").read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    traces = [Trace(line, HERE / "traces") for line in lines]
    out, missing = table(vectors, traces)
    cases = sum(len(v.content["cases"]) for v in vectors.values())
    head = ["# What the vectors and traces cover", "",
            "`coverage.py` makes this page from the vectors and the traces themselves; a test fails where something is met by none, and where the page",
            "has drifted. \"None\" with a reason names what no run can meet, or what another test meets.", "",
            f"{cases} cases in {len(vectors)} files; {len(traces)} traces:", "",
            "| trace | surface | insertions, flips | stopped |", "|---|---|---|---|"]
    head += [f"| {t.name} | `{t.surface}` | {t.end['insertions']}, {t.end['flips']} | {t.end['stopped']} |" for t in traces]
    return "\n".join(head + out) + "\n", missing


def main(words):
    if words not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    text, missing = page()
    for line in missing:
        print(line)
    there = HERE / "COVERAGE.md"
    if not words:
        there.write_text(text, encoding="utf-8")
    elif not there.exists() or there.read_text(encoding="utf-8") != text:
        print("COVERAGE.md has drifted: run coverage.py")
        return 1
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
