# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables 1 and 2: cases on the tetrahedra of one lattice cell. The rows are transcribed here a second time, from the page."""
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
