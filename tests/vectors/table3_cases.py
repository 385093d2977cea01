# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 3: cases on the edges of one lattice cell. The rows are transcribed here a second time, from the page."""
from fractions import Fraction
from itertools import combinations

from exact import Draws, along

CELL = (Fraction(3), Fraction(4), Fraction(5))  # the cell's sides
# The edges of the six tetrahedra of a cell: pairs of corners of which one has all the bits of the other.
CELL_EDGES = [(a, b) for a, b in combinations(range(8), 2) if a & b == a]
FLAGS = {
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
