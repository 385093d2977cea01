# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables 1, 2 and 3: cases on the tetrahedra of one lattice cell. The rows are transcribed here a second time, from the page."""
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, product

from exact import Draws, along, dot, mean, sub, volume

SIGN = {1: "+", 0: "0", -1: "-"}
AXIS_ORDERS = ("xyz", "xzy", "yxz", "yzx", "zxy", "zyx")  # the six tetrahedra of a cell, reading D2

# Tables 1 and 2 in the page's order. E8 is the multiset the page leaves out; 12a is mended (E1); 12g and 12h are the two that the
# text below Table 2 describes (E2). c = the centroid of the six points of case 12.
TABLE1 = ["- - - -: 1", "0 - - -: 2", "0 0 - -: 3", "0 0 0 -: 4", "0 0 0 0: 5", "+ - - -: 6", "+ 0 - -: 7", "+ 0 0 -: 8",
          "+ 0 0 0: 9", "+ + - -: 10", "+ + 0 -: 11", "+ + + -: 12", "+ + + 0: 13", "+ + + +: 14", "+ + 0 0: E8"]
TABLE2 = {
    "1": "", "2": "", "3": "", "4": "",
    "5": "v1 v2 v3 v4",
    "6": "v1 p12 p13 p14",
    "7": "v1 v2 p13 p14",
    "8": "v1 v2 v3 p14",
    "9": "v1 v2 v3 v4",
    "10a": "v1 v2 p13 p14, v2 p13 p14 p24, v2 p13 p23 p24",
    "10b": "v1 v2 p13 p24, v1 p13 p14 p24, v2 p13 p23 p24",
    "10c": "v1 v2 p14 p23, v1 p13 p14 p23, v2 p14 p23 p24",
    "10d": "v1 v2 p23 p24, v1 p13 p14 p24, v1 p13 p23 p24",
    "11a": "v1 v2 v3 p14, v2 v3 p14 p24",
    "11b": "v1 v2 v3 p24, v1 v3 p14 p24",
    "12a": "v1 v2 v3 p34, v1 v2 p14 p34, v2 p14 p24 p34",
    "12b": "v1 v2 v3 p14, v2 v3 p14 p24, v3 p14 p24 p34",
    "12c": "v1 v2 v3 p14, v2 v3 p14 p34, v2 p14 p24 p34",
    "12d": "v1 v2 v3 p24, v1 v3 p14 p24, v3 p14 p24 p34",
    "12e": "v1 v2 v3 p24, v1 v3 p24 p34, v1 p14 p24 p34",
    "12f": "v1 v2 v3 p34, v1 v2 p24 p34, v1 p14 p24 p34",
    "12g": "v1 v2 v3 c, p14 p24 p34 c, v1 v2 p24 c, v1 p14 p24 c, v2 v3 p34 c, v2 p24 p34 c, v1 v3 p14 c, v3 p14 p34 c",
    "12h": "v1 v2 v3 c, p14 p24 p34 c, v1 v2 p14 c, v2 p14 p24 c, v2 v3 p24 c, v3 p24 p34 c, v1 v3 p34 c, v1 p14 p34 c",
    "13": "v1 v2 v3 v4",
    "14": "v1 v2 v3 v4",
    "E8": "v1 v2 v3 v4",
}
TIE = Fraction(1, 10**12)  # relative: lengths that differ by rounding
CASE = {tuple(line.split(":")[0].split()): line.split(": ")[1] for line in TABLE1}


def case_of(indicators):
    return CASE[tuple(SIGN[s] for s in sorted(indicators, reverse=True))]


def rows_of(case):
    return [name for name in TABLE2 if name.rstrip("abcdefgh") == case] if case in ("10", "11", "12") else [case]


def tets_of(row):
    return [tet.split() for tet in TABLE2[row].split(", ")] if TABLE2[row] else []


# --- Table 1

TABLE1_FLAGS = {
    "printed": "A row of Table 1 in the page's order of vertices.",
    "permuted": "The vertices stand in another order: rows are looked up without sorting (reading D8).",
    "not-printed": "(1,1,0,0), the multiset that Tables 1 and 2 leave out: an implementation that covers only the 14 printed cases "
                   "drops or crashes on such a tetrahedron (reading E8).",
}


def table1():
    for s in product((1, 0, -1), repeat=4):
        possible = [list(e) for e in combinations(range(4), 2) if s[e[0]] * s[e[1]] < 0]
        case = case_of(s)
        flags = ["printed" if list(s) == sorted(s, reverse=True) else "permuted"] + ["not-printed"] * (case == "E8")
        yield {"id": "table1-" + "".join(SIGN[x] for x in s), "flags": flags,
               "comment": f"case {case}: " + (f"{len(possible)} edges have their ends on different sides" if possible
                                              else "no edge has its ends on different sides"),
               "input": {"indicators": list(s)}, "expected": {"case": case, "edges": possible}}


# --- Table 2

TABLE2_FLAGS = {
    "keep": "The tetrahedron is kept whole.",
    "drop": "Nothing of the tetrahedron lies inside.",
    "not-printed": "(1,1,0,0), which the page leaves out (reading E8).",
    "case-5": "Four vertices on the surface: kept only if the centroid is inside (reading D10). Keeping it always fills grooves.",
    "sorting": "The order v1..v4 comes from the indicators, then from the vertices' numbers (reading D8), not from the order in which "
               "the tetrahedron names them: a wrong order takes the wrong row, or the wrong diagonals.",
    "orientation": "The row lists a tetrahedron that is negative when v1..v4 is positive (reading E7), or v1..v4 is itself negative: "
                   "without mending, the grid holds inverted tetrahedra.",
    "lowest": "The diagonal of a shared quadrilateral starts at the lower-numbered of the two interior vertices (reading D9). Any "
              "rule that does not look at the shared face alone leaves crossed diagonals.",
    "shortest": "The diagonal of a shared quadrilateral is the shorter one (reading D9).",
    "shortest-tie": "Both diagonals have the same length, but perhaps for rounding (1e-12, relative): the one of the rule `lowest` is "
                    "taken. Without that, rounding decides, or the order in which a tetrahedron names the two.",
    "mended-12a": "Row 12a as printed names a point p3 that does not exist (reading E1).",
    "centroid": "The diagonals of the prism run in a circle: eight tetrahedra around the centroid of the six points (reading E2), "
                "not of the prism's volume, nor of the lattice tetrahedron.",
    "cut-at-vertex": "A cut at an end of its edge, a vertex that was 0 before Table 3, is that vertex; tetrahedra that then name a "
                     "vertex twice are dropped, all others kept (reading D7).",
}


def kuhn(order):
    """The corners of a cell's tetrahedron as bits (x 1, y 2, z 4); the number of a corner of a lattice of one cell as well."""
    corners = [0]
    for axis in order:
        corners.append(corners[-1] | 1 << "xyz".index(axis))
    return corners


def apply_table2(numbers, places, after, cuts, rule, centroid_inside):
    """The row, the positive tetrahedra of one lattice tetrahedron, and whether one was negative as listed; by vertex number."""
    v = sorted(numbers, key=lambda n: (-after[n], n))
    case = case_of([after[n] for n in numbers])
    if case == "5" and not centroid_inside:
        return "5-", [], False
    place = {f"v{i + 1}": places[v[i]] for i in range(4)}
    for i, e in combinations(range(4), 2):
        if after[v[i]] * after[v[e]] < 0:
            place[f"p{i + 1}{e + 1}"] = cuts[frozenset((v[i], v[e]))]
    if case == "12":
        place["c"] = mean([place[p] for p in ("v1", "v2", "v3", "p14", "p24", "p34")])
    diagonals = []
    for i, j, e in combinations(range(4), 3):
        if after[v[i]] == after[v[j]] == 1 and after[v[e]] == -1:
            pair = (f"v{i + 1}", f"p{j + 1}{e + 1}"), (f"v{j + 1}", f"p{i + 1}{e + 1}")
            lengths = [dot(sub(place[a], place[b]), sub(place[a], place[b])) for a, b in pair]
            diagonals.append(pair[1] if rule == "shortest" and lengths[1] * (1 + 2 * TIE) < lengths[0] else pair[0])
    rows = [row for row in rows_of(case)
            if all(any(a in tet and b in tet for tet in tets_of(row)) for a, b in diagonals)]
    if len(rows) != 1:  # the diagonals leave no choice
        raise AssertionError(rows)
    tets, turned = [], False
    for names in tets_of(rows[0]):
        tet = [place[p] for p in names]
        if len(set(tet)) < 4:
            continue
        if volume(*tet) < 0:
            tet[2], tet[3], turned = tet[3], tet[2], True
        if volume(*tet) <= 0:
            raise AssertionError((rows[0], names))
        tets.append(tet)
    return rows[0], tets, turned


class Cell:
    """One tetrahedron of a lattice cell with its indicators and cuts."""

    def __init__(self, draws, order, kinds, cell, steps):
        """`kinds`: + 0 - of the four corners, or P, M: + and - that were 0 before Table 3."""
        self.order, self.kinds, self.draws = order, kinds, draws
        self.numbers = kuhn(order)
        self.places = {n: tuple(cell[a] if n >> a & 1 else Fraction(0) for a in range(3)) for n in self.numbers}
        self.after = {n: {"+": 1, "P": 1, "0": 0, "-": -1, "M": -1}[k] for n, k in zip(self.numbers, kinds)}
        self.before = {n: 0 if k in "P0M" else self.after[n] for n, k in zip(self.numbers, kinds)}
        self.cuts = {}
        for a, b in combinations(self.numbers, 2):
            inner, outer = (a, b) if self.after[a] > self.after[b] else (b, a)
            if self.after[a] * self.after[b] < 0:
                t = Fraction(steps()) / 16
                self.cuts[frozenset((a, b))] = (self.places[outer] if self.before[outer] == 0 else
                                                self.places[inner] if self.before[inner] == 0 else
                                                along(self.places[inner], self.places[outer], t))

    def case(self, prefix, rule, flags, comment, centroid_inside=None):
        row, tets, turned = apply_table2(self.numbers, self.places, self.after, self.cuts, rule, centroid_inside)
        flags = list(flags)
        flags += ["drop"] * (not tets) + ["keep"] * (len(tets) == 1 and set(tets[0]) == set(self.places.values()))
        flags += ["not-printed"] * (row == "E8") + ["case-5"] * (row in ("5", "5-")) + ["mended-12a"] * (row == "12a")
        flags += ["centroid"] * (row in ("12g", "12h"))
        if row[:2] in ("10", "11", "12"):
            flags.append(rule)
        ordered = sorted(self.numbers, key=lambda n: (-self.after[n], n))
        if ordered != self.numbers and tets:
            flags.append("sorting")
        if turned:
            flags.append("orientation")
        vertices = [{"number": n, "point": self.places[n], "before": self.before[n], "after": self.after[n]}
                    for n in self.draws.shuffled(self.numbers)]
        given = {"vertices": vertices, "diagonals": rule,
                 "cuts": [{"edge": sorted(e), "point": p} for e, p in sorted(self.cuts.items(), key=lambda each: sorted(each[0]))]}
        if row in ("5", "5-"):
            given["centroid_inside"] = centroid_inside
        return {"id": f"table2-{prefix}-{self.order}/{''.join(self.kinds)}", "flags": flags, "comment": comment or f"row {row}",
                "input": given, "expected": {"row": row, "tetrahedra": tets},
                "tolerance": {"absolute": 1e-12 if "centroid" in flags else 0}}


CELL = (Fraction(3), Fraction(4), Fraction(5))


def table2():
    draws = Draws(2)
    any_step = lambda: draws.between(1, 15)
    for n, kinds in enumerate(product("+0-", repeat=4)):
        for inside in (True, False) if kinds == ("0",) * 4 else (None,):
            prefix = "lowest" + {None: "", True: "-inside", False: "-outside"}[inside]
            yield Cell(draws, AXIS_ORDERS[n % 6], kinds, CELL, any_step).case(prefix, "lowest", [], None, inside)
    # Each row that `shortest` can take, for several orders of the vertices.
    for row in [r for case in ("10", "11", "12") for r in rows_of(case)]:
        signs = [k for k in sorted(CASE) if CASE[k] == row.rstrip("abcdefgh")][0]
        for order in AXIS_ORDERS[::2] + AXIS_ORDERS[1::2]:
            while True:
                cell = Cell(draws, order, draws.shuffled(signs), [Fraction(draws.between(2, 7)) for _ in range(3)], any_step)
                if apply_table2(cell.numbers, cell.places, cell.after, cell.cuts, "shortest", None)[0] == row:
                    break
            yield cell.case(f"shortest-{row}", "shortest", [], f"the shorter diagonals ask for row {row}")
    # Equal lengths: a cell whose sides are equal, cuts at midpoints.
    for order in AXIS_ORDERS:
        for signs in ("++--", "++0-", "+++-"):
            cell = Cell(draws, order, draws.shuffled(signs), (Fraction(4),) * 3, lambda: 8)
            yield cell.case("tie", "shortest", ["shortest-tie"], "cuts at the midpoints of a cube's tetrahedron: some diagonals tie")
            cell = Cell(draws, order, draws.shuffled(signs), (Fraction(4),) * 3, lambda: 8 + Fraction(draws.between(-1, 1), 2**42))
            yield cell.case("near-tie", "shortest", ["shortest-tie"], "cuts at the midpoints but for a rounding: the same diagonals")
    # Cuts at vertices that were 0 before Table 3.
    for n, kinds in enumerate(combinations_with_replacement("+P0M-", 4)):
        if not set("PM") & set(kinds) or not set("+P") & set(kinds) or not set("M-") & set(kinds):
            continue
        cell = Cell(draws, AXIS_ORDERS[n % 6], draws.shuffled(kinds), CELL, any_step)
        rule = ("lowest", "shortest")[n % 2]
        yield cell.case(f"at-vertex-{rule}", rule, ["cut-at-vertex"],
                        "P and M: +1 and -1 that were 0 before Table 3, so that cuts lie at their ends")


# --- Table 3

TABLE3_FLAGS = {
    "row-1": "Outside and outside with points between: nothing changes, the points are given up.",
    "row-2": "Outside and surface with a point between: the surface vertex becomes exterior.",
    "row-3b": "Outside and inside: of several points the one closest to the exterior end.",
    "row-4": "Surface and surface with a point between: both become interior.",
    "row-5": "Surface and inside with a point between: the surface vertex becomes interior.",
    "row-6": "Inside and inside with points between: nothing changes.",
    "not-applied": "The edge meets the surface in no more points than its indicators need: Table 3 must not touch it (reading D6).",
    "two-points": "Points are counted, not crossings: the edge touches the surface and crosses it, two points in all; row 3a "
                  "(an even number) must not be taken (readings D6, E6).",
    "high-end": "The exterior end has the higher number: `closest to v_i` means the exterior end, not the lower-numbered one.",
    "at-once": "Requests come from the initial indicators and are applied at once (reading D6): applied one after the other, or "
               "repeated until nothing changes, the outcome depends on the order of edges.",
    "both-signs": "A vertex asked for both signs becomes exterior (reading D6).",
    "cut-at-vertex": "After Table 3 an edge between -1 and +1 has its cut at an end that was 0 (readings D6, D7).",
    "settled": "A vertex taken to the surface for good by the tolerance of reading D4 makes and takes no request; edges to it have no "
               "cuts. Skip this flag if you have no such tolerance.",
}


def apply_table3(initial, points, settled):
    """`points`: for edges (low, high) the parameters of their points from the low end, ascending, within the open edge."""
    requests, applied = {}, {}
    for (a, b), where in points.items():
        low, high = sorted((a, b), key=lambda v: initial[v])
        if any(v in settled and initial[v] == 0 for v in (a, b)):
            continue
        if len(where) <= (1 if initial[low] * initial[high] < 0 else 0):
            continue
        row = {(-1, -1): "1", (-1, 0): "2", (-1, 1): "3b", (0, 0): "4", (0, 1): "5", (1, 1): "6"}[initial[low], initial[high]]
        applied[row] = applied.get(row, 0) + 1
        for v in (low, high):
            if initial[v] == 0:
                requests.setdefault(v, set()).add({"2": -1, "4": 1, "5": 1}[row])
    after = [min(requests[v]) if v in requests else initial[v] for v in range(8)]
    cuts = {}
    for a, b in CELL_EDGES:
        if after[a] * after[b] < 0:
            outer, inner = (a, b) if after[a] < 0 else (b, a)
            where = points.get((a, b), [])
            if initial[outer] == 0:
                t = Fraction(0 if outer == a else 1)
            elif initial[inner] == 0:
                if where:
                    raise AssertionError("row 2 had asked for -1")
                t = Fraction(0 if inner == a else 1)
            else:
                t = where[0] if outer == a else where[-1]
            cuts[a, b] = t
    return after, cuts, applied


# The edges of the six tetrahedra of a cell: pairs of corners of which one has all the bits of the other.
CELL_EDGES = [(a, b) for a, b in combinations(range(8), 2) if a & b == a]


def table3_case(name, flags, comment, initial, points, settled=()):
    place = [tuple(CELL[x] if v >> x & 1 else Fraction(0) for x in range(3)) for v in range(8)]
    points = {e: sorted(Fraction(t) for t in where) for e, where in points.items()}
    for a, b in CELL_EDGES:  # an edge between -1 and +1 meets the surface
        if initial[a] * initial[b] < 0:
            points.setdefault((a, b), [Fraction(3, 8)])
    after, cuts, applied = apply_table3(initial, points, settled)
    on = lambda e, t: along(place[e[0]], place[e[1]], t)
    given = {"vertices": [{"number": v, "point": place[v], "indicator": initial[v]} for v in range(8)],
             "edges": [{"edge": list(e), "points": [on(e, t) for t in where]} for e, where in sorted(points.items()) if where],
             "settled": sorted(settled)}
    flags = flags + ["row-" + row for row in sorted(applied) if "row-" + row not in flags]
    if any(t in (0, 1) for t in cuts.values()):
        flags.append("cut-at-vertex")
    return {"id": "table3-" + name, "flags": sorted(set(flags)), "comment": comment, "input": given,
            "expected": {"indicators": after, "cuts": [{"edge": list(e), "point": on(e, t)} for e, t in sorted(cuts.items())],
                         "applied": applied},
            "tolerance": {"absolute": 1e-12}}


def table3():
    def cell(rest, **named):  # indicators of vertices 0..7: `rest`, but for v0=.., v5=..
        return [named.get(f"v{v}", rest) for v in range(8)]

    half, quarter = Fraction(1, 2), Fraction(1, 4)
    for count in (1, 2, 3):
        where = [Fraction(k, 8) for k in (1, 4, 6)[:count]]
        yield table3_case(f"row1-{count}", [], "outside, outside", cell(-1), {(0, 1): where})
        yield table3_case(f"row6-{count}", [], "inside, inside", cell(1), {(2, 6): where})
        yield table3_case(f"row2-{count}", [], "outside, surface", cell(-1, v1=0), {(0, 1): where})
        yield table3_case(f"row2-high-{count}", ["high-end"], "surface, outside", cell(-1, v0=0), {(0, 1): where})
        yield table3_case(f"row4-{count}", [], "surface, surface", cell(1, v0=0, v4=0), {(0, 4): where})
        yield table3_case(f"row5-{count}", [], "surface, inside", cell(1, v0=0), {(0, 7): where})
        yield table3_case(f"row5-high-{count}", ["high-end"], "inside, surface", cell(1, v7=0), {(0, 7): where})
        flags = ["not-applied"] if count == 1 else ["two-points"] if count == 2 else []
        yield table3_case(f"row3b-{count}", flags, "outside, inside: the first point from the outer end", cell(1, v0=-1),
                          {(0, 3): where})
        yield table3_case(f"row3b-high-{count}", flags + ["high-end"], "inside, outside: the last point", cell(-1, v0=1),
                          {(0, 3): where})
    for name, initial in (("outside-surface", cell(-1, v1=0)), ("surface-surface", cell(1, v0=0, v1=0)),
                          ("surface-inside", cell(1, v0=0))):
        yield table3_case(f"none-{name}", ["not-applied"], "no point in the open edge: the 0 stays", initial, {})
    yield table3_case("none-lone-zero", ["not-applied"], "a surface vertex between both sides: the 0 stays",
                      cell(1, v0=-1, v1=0), {})

    yield table3_case("both-2-5", ["both-signs"], "rows 2 and 5 at one vertex: exterior", [0, -1, 1, 1, 1, 1, 1, 1],
                      {(0, 1): [half], (0, 2): [half]})
    yield table3_case("both-2-4", ["both-signs"], "rows 2 and 4 at one vertex: it becomes exterior, the other end of row 4 interior",
                      [0, -1, 0, 1, 1, 1, 1, 1], {(0, 1): [half], (0, 2): [half]})
    yield table3_case("both-2-4-5", ["both-signs"], "rows 2, 4 and 5 at one vertex", [0, -1, 0, 1, 1, 1, 1, 1],
                      {(0, 1): [half], (0, 2): [half], (0, 4): [quarter, half]})
    yield table3_case("both-many-5", ["both-signs"], "one request for exterior against six for interior",
                      [0, 1, 1, 1, 1, 1, 1, -1], {(0, k): [half] for k in range(1, 8)})
    yield table3_case("same-2-2", [], "row 2 on all edges of a vertex", cell(-1, v7=0), {(k, 7): [half] for k in range(7)})
    yield table3_case("same-4-5", [], "rows 4 and 5 ask for the same", [0, 1, 0, 1, 1, 1, 1, 1], {(0, 1): [half], (0, 2): [half]})
    yield table3_case("chain-2-4", ["at-once"], "a row 2 at one end of a row 4: the other end is asked by row 4 alone",
                      [-1, 0, -1, 0, -1, -1, -1, -1], {(0, 1): [half], (1, 3): [half]})
    yield table3_case("chain-4-4", ["at-once"], "two row 4 in a row, and a row 2 at the end", [-1, 0, -1, 0, -1, -1, -1, 0],
                      {(0, 1): [half], (1, 3): [half], (3, 7): [half]})
    yield table3_case("chain-5-2", ["at-once"], "row 5 makes a vertex interior; its edge to a 0 has no point: that 0 stays",
                      [1, 0, 1, 0, 1, 1, 1, 1], {(0, 1): [half]})
    yield table3_case("chain-2-none", ["at-once"], "a 0 that becomes exterior beside a 0 without a request",
                      [-1, 0, -1, 0, -1, -1, -1, -1], {(0, 1): [half]})
    yield table3_case("cut-at-exterior", ["cut-at-vertex"], "row 2 makes an edge to +1 without a point: cut at the end that was 0",
                      [0, -1, 1, 1, 1, 1, 1, 1], {(0, 1): [half]})
    yield table3_case("cut-at-interior", ["cut-at-vertex"], "row 5 makes an edge to -1 without a point: cut at the end that was 0",
                      [0, -1, 1, 1, 1, 1, 1, 1], {(0, 2): [half]})
    yield table3_case("cut-between-two", ["cut-at-vertex"], "both ends were 0, with points between: cut at the exterior end",
                      [0, -1, 0, 1, 1, 1, 1, 1], {(0, 1): [half], (0, 2): [quarter, half]})
    for zero, name in ((0, "low"), (7, "high")):
        initial = cell(1)
        initial[zero] = 0
        yield table3_case(f"settled-{name}-5", ["settled", "not-applied"], "a settled vertex takes no request", initial,
                          {(0, 7): [half]}, {zero})
    yield table3_case("settled-4", ["settled", "not-applied"], "a settled vertex makes no request of its neighbour",
                      cell(1, v0=0, v1=0), {(0, 1): [half]}, {0})
    yield table3_case("settled-2-and-4", ["settled"], "the other end is asked by another edge",
                      cell(-1, v0=0, v1=0), {(0, 1): [half], (1, 3): [half]}, {0})

    draws = Draws(3)
    for n in range(40):
        initial = [draws.choice((-1, 0, 0, 1)) for _ in range(8)]
        settled = {v for v in range(8) if initial[v] == 0 and n % 4 == 3 and draws.below(2)}
        points = {}
        for a, b in CELL_EDGES:
            places = sorted({Fraction(draws.between(1, 15), 16) for _ in range(draws.choice((0, 0, 1, 2, 3)))})
            if initial[a] * initial[b] < 0 and not places:
                places = [Fraction(draws.between(1, 15), 16)]
            points[a, b] = places
        yield table3_case(f"random-{n:02}", ["settled"] if settled else [], "a cell drawn at random", initial, points, settled)
