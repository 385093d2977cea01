# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 4: small clusters of tetrahedra made by hand around the one that is split."""
from fractions import Fraction
from itertools import combinations

from exact import FACES, Draws, dot, mean, sub, volume, disjoint

FLAGS = {
    "whole": "The new point is the centroid of the tetrahedron: four pieces.",
    "face": "The new point is the centroid of a face that no other tetrahedron has: three pieces.",
    "edge": "The new point is the midpoint of an edge that no other tetrahedron has: two pieces.",
    "row-2b": "Cannot occur in a grid that Tables 1 and 2 made; implementers forget it.",
    "mended-4c": "Two faces shared, two not: the page prints this row as a first `4d` (reading E3).",
    "outer-box": "An unshared face or edge that the surface points do not span, as on the outer box of an outside grid: it must not "
                 "count (only the edge of two, or the face of three surface points decides).",
    "edge-not-face": "Another tetrahedron has the edge without sharing a face: `shares the edge` is edge incidence. Looking at "
                     "face neighbours alone splits an edge under a neighbour, which leaves a hanging node (reading D19).",
    "nonmanifold-edge": "The edge between two unshared faces belongs to another tetrahedron as well, a non-manifold boundary edge.",
    "fallback": "Row 4c, 4d or 4e without an edge of its own: the centroid of the largest unshared face (reading D19).",
    "longest": "Several edges could be split: the longest one is.",
    "tie": "Edges of equal length, or faces of equal area: the one with the smallest vertex numbers, compared in ascending order.",
    "neighbours-elsewhere": "Other tetrahedra touch this one in a vertex or an edge only: its faces stay unshared.",
    "permuted": "The tetrahedron names its vertices in another order: nothing may depend on it.",
    "renumbered": "The points have other numbers: only ties may depend on them.",
}


def area2(a, b, c):
    """Four times the squared area."""
    u, v = sub(b, a), sub(c, a)
    return dot(u, u) * dot(v, v) - dot(u, v) ** 2


def split(points, surface, tets, j):
    """Row of Table 4, the simplex that holds the new point, the point, the pieces, and the flags that follow from the choice."""
    tet = tets[j]
    others = [set(t) for i, t in enumerate(tets) if i != j]
    shared = lambda simplex: any(set(simplex) <= other for other in others)
    on = [v for v in tet if surface[v]]
    faces = [sorted(tet[c] for c in f) for f in FACES]
    unshared = sorted(f for f in faces if not shared(f))
    flags = []
    if len(on) < 2:
        row, simplex = str(len(on)), tet
    elif len(on) == 2:
        row, simplex = ("2a", tet) if shared(on) else ("2b", on)
    elif len(on) == 3:
        row, simplex = ("3a", tet) if shared(on) else ("3b", on)
    else:
        row = "4" + "abcde"[len(unshared)]
        edges = [sorted(e) for e in combinations(sorted(tet), 2) if not shared(e)]
        if row == "4a":
            simplex = tet
        elif row == "4b":
            simplex = unshared[0]
        else:
            if row == "4c":
                edges = [e for e in edges if set(e) == set(unshared[0]) & set(unshared[1])]
            length2 = lambda e: dot(sub(points[e[0]], points[e[1]]), sub(points[e[0]], points[e[1]]))
            size, among = (length2, edges) if edges else (lambda f: area2(*(points[v] for v in f)), unshared)
            largest = [s for s in among if size(s) == max(map(size, among))]
            simplex = min(largest)
            flags = ["longest"] * (len(edges) > 1) + ["tie"] * (len(largest) > 1) + ["fallback"] * (not edges)
    new = len(points)
    pieces = [[new if v == gone else v for v in tet] for gone in tet if gone in simplex]
    flags += [{4: "whole", 3: "face", 2: "edge"}[len(simplex)]] + ["row-2b"] * (row == "2b") + ["mended-4c"] * (row == "4c")
    return row, sorted(simplex), mean([points[v] for v in simplex]), pieces, flags


# The tetrahedron in the middle, and what can stand around it without overlap. Letters: a the right angle, b, c, d along x, y, z.
CORNERS = {"a": (0, 0, 0), "b": (24, 0, 0), "c": (0, 24, 0), "d": (0, 0, 24)}
APEX = {"bcd": (24, 24, 24), "acd": (-24, 6, 6), "abd": (6, -24, 6), "abc": (6, 6, -24)}  # of a neighbour across the face
# Two points that make a tetrahedron which has the edge but no face in common with the one in the middle, nor with its neighbours.
WEDGE = {"ab": ((12, -24, -12), (12, -12, -24)), "ac": ((-24, 12, -12), (-12, 12, -24)), "ad": ((-24, -12, 12), (-12, -24, 12)),
         "bc": ((48, 48, -6), (54, 54, 6)), "bd": ((48, -6, 48), (54, 6, 54)), "cd": ((-6, 48, 48), (6, 54, 54))}
AT_VERTEX = {"a": ((-24, -24, -24), (-30, -24, -24), (-24, -30, -24))}


class Cluster:
    def __init__(self, faces=(), edges=(), vertices=(), corners=None):
        corners = corners or CORNERS
        self.names, self.points, self.tets = "abcd", [], []
        index = {}
        for name in "abcd":
            index[name] = self.add(corners[name])
        self.tets.append([index[v] for v in "abcd"])
        for face in faces:
            self.tets.append([index[v] for v in face] + [self.add(APEX[face])])
        for edge in edges:
            self.tets.append([index[v] for v in edge] + [self.add(p) for p in WEDGE[edge]])
        for vertex in vertices:
            self.tets.append([index[vertex]] + [self.add(p) for p in AT_VERTEX[vertex]])
        for t in self.tets:
            if volume(*(self.points[v] for v in t)) < 0:
                t[2], t[3] = t[3], t[2]
        for s, t in combinations(self.tets, 2):
            if not disjoint(*([self.points[v] for v in each] for each in (s, t))):
                raise AssertionError(f"{faces} {edges}: tetrahedra overlap")

    def add(self, point):
        self.points.append(tuple(map(Fraction, point)))
        return len(self.points) - 1


def case(name, flags, comment, surface, cluster, draws=None):
    """`surface`: the corners that are surface points, as letters. With `draws` the numbers and orders are mixed."""
    points, tets, on = cluster.points, cluster.tets, [False] * len(cluster.points)
    for v in surface:
        on["abcd".index(v)] = True
    at = 0
    if draws:
        new = draws.shuffled(range(len(points)))
        moved, moved_on = [None] * len(points), [None] * len(points)
        for old, n in enumerate(new):
            moved[n], moved_on[n] = points[old], on[old]
        even = [(0, 1, 2, 3), (1, 2, 0, 3), (2, 0, 1, 3), (0, 2, 3, 1), (1, 0, 3, 2), (3, 2, 1, 0), (2, 3, 0, 1), (3, 1, 0, 2)]
        tets = [[new[t[k]] for k in draws.choice(even)] for t in tets]
        order = draws.shuffled(range(len(tets)))
        tets, at, points, on = [tets[k] for k in order], order.index(0), moved, moved_on
        flags = flags + ["permuted", "renumbered"]
    row, simplex, point, pieces, more = split(points, on, tets, at)
    return {"id": f"table4-{name}", "flags": flags + more, "comment": f"row {row}: {comment}",
            "input": {"points": points, "surface_point": on, "tetrahedra": tets, "split": at},
            "expected": {"row": row, "replaced": simplex, "point": point, "pieces": pieces},
            "tolerance": {"absolute": 1e-12}}


ALL_FACES, ALL_EDGES = tuple(APEX), tuple(WEDGE)


def plain_cases():
    """(name, flags, comment, surface points, cluster) in the order of Table 4."""
    yield "0-alone", ["outer-box"], "no surface point and no neighbour", "", Cluster()
    yield "0-shared", [], "no surface point, all faces shared", "", Cluster(ALL_FACES)
    yield "1-alone", ["outer-box"], "one surface point and no neighbour", "c", Cluster()
    yield "1-shared", [], "one surface point, all faces shared", "a", Cluster(ALL_FACES)
    for e in ALL_EDGES:
        rest = "".join(v for v in "abcd" if v not in e)
        with_edge = [f for f in ALL_FACES if set(e) <= set(f)]
        without = [f for f in ALL_FACES if not set(e) <= set(f)]
        yield f"2b-{e}", [], "nobody else has the edge of the two surface points", e, Cluster()
        yield f"2b-{e}-others", ["neighbours-elsewhere"], "the faces beside the edge are unshared, the other two are not", e, Cluster(without)
        yield f"2a-{e}-one", [], "one of the two faces at the edge is shared", e, Cluster(with_edge[:1])
        yield f"2a-{e}-edge", ["edge-not-face"], "another tetrahedron has the edge, but no face", e, Cluster((), [e])
        yield f"2b-{e}-opposite", ["neighbours-elsewhere"], "another tetrahedron has the opposite edge", e, Cluster((), [rest])
    for f in ALL_FACES:
        other = [g for g in ALL_FACES if g != f]
        yield f"3b-{f}", [], "the face of the three surface points is unshared, all others are shared", f, Cluster(other)
        yield f"3b-{f}-alone", ["outer-box"], "no neighbour at all", f, Cluster()
        yield f"3b-{f}-edge", ["edge-not-face", "neighbours-elsewhere"], "another tetrahedron has an edge of the face, not the face", f, Cluster((), [f[:2]])
        yield f"3a-{f}", ["outer-box"], "the face of the three surface points is the only shared one", f, Cluster([f])
        yield f"3a-{f}-all", [], "all faces are shared", f, Cluster(ALL_FACES)
    yield "4a", [], "all faces are shared", "abcd", Cluster(ALL_FACES)
    for f in ALL_FACES:
        yield f"4b-{f}", [], f"only {f} is unshared", "abcd", Cluster([g for g in ALL_FACES if g != f])
    yield "4b-edge", ["edge-not-face"], "only abc is unshared, and another tetrahedron has its edge ab", "abcd", Cluster(("bcd", "acd", "abd"), ["ab"])
    for f, g in combinations(ALL_FACES, 2):
        e = "".join(sorted(set(f) & set(g)))
        rest = [h for h in ALL_FACES if h not in (f, g)]
        yield f"4c-{f}-{g}", [], f"the unshared faces {f} and {g} meet in {e}", "abcd", Cluster(rest)
        yield f"4c-{f}-{g}-touched", ["edge-not-face", "nonmanifold-edge"], f"another tetrahedron has {e}, where the unshared faces meet", "abcd", Cluster(rest, [e])
    for f in ALL_FACES:
        apex = next(v for v in "abcd" if v not in f)
        edges = ["".join(sorted(apex + v)) for v in f]
        yield f"4d-{f}", [], f"only {f} is shared; the edges at {apex} are nobody else's", "abcd", Cluster([f])
        for e in edges:
            yield f"4d-{f}-{e}", ["edge-not-face", "nonmanifold-edge"], f"{e} belongs to another tetrahedron", "abcd", Cluster([f], [e])
        yield f"4d-{f}-fallback", ["edge-not-face", "nonmanifold-edge"], f"all edges at {apex} belong to other tetrahedra", "abcd", Cluster([f], edges)
    yield "4e", [], "no neighbour at all", "abcd", Cluster()
    yield "4e-vertex", ["neighbours-elsewhere"], "another tetrahedron has the corner a", "abcd", Cluster((), (), ["a"])
    for k in range(1, 6):
        yield f"4e-{k}-edges", ["edge-not-face", "nonmanifold-edge"], f"other tetrahedra have {', '.join(ALL_EDGES[::-1][:k])}", "abcd", Cluster((), ALL_EDGES[::-1][:k])
    yield "4e-fallback", ["edge-not-face", "nonmanifold-edge"], "other tetrahedra have all six edges", "abcd", Cluster((), ALL_EDGES)


# Other shapes of the one in the middle, without ties.
LONG = {"a": (0, 0, 0), "b": (24, 0, 0), "c": (0, 30, 0), "d": (0, 0, 36)}


def shape_cases():
    yield "4e-longest", [], "three different lengths: cd", "abcd", Cluster(corners=LONG)
    yield "4e-longest-touched", ["edge-not-face", "nonmanifold-edge"], "cd belongs to another tetrahedron: bd is next", "abcd", touched(LONG, ["cd"])
    yield "4d-longest", [], "abc is shared; of ad, bd, cd the last is the longest", "abcd", across(LONG, ["abc"])
    yield "4d-longest-bcd", [], "bcd is shared; of ab, ac, ad the last is the longest", "abcd", across(LONG, ["bcd"])


def touched(corners, edges):
    cluster = Cluster(corners=corners)
    for e in edges:
        outwards = [8 * (p + q) for p, q in zip(corners[e[0]], corners[e[1]])]
        other = [k for k in range(3) if not outwards[k]]
        points = []
        for step in (-1, 1):
            point = list(outwards)
            point[other[0]] += step
            point = [x + (step if k not in other else 0) for k, x in enumerate(point)]
            points.append(cluster.add(point))
        t = ["abcd".index(v) for v in e] + points
        if volume(*(cluster.points[v] for v in t)) < 0:
            t[2], t[3] = t[3], t[2]
        cluster.tets.append(t)
    for s, t in combinations(cluster.tets, 2):
        if not disjoint(*([cluster.points[v] for v in each] for each in (s, t))):
            raise AssertionError("tetrahedra overlap")
    return cluster


def across(corners, faces):
    cluster = Cluster(corners=corners)
    for f in faces:
        inner = next(v for v in "abcd" if v not in f)
        point = sub(mean([corners[v] for v in f]), sub(corners[inner], mean([corners[v] for v in f])))
        t = ["abcd".index(v) for v in f] + [cluster.add(point)]
        if volume(*(cluster.points[v] for v in t)) < 0:
            t[2], t[3] = t[3], t[2]
        cluster.tets.append(t)
    return cluster


def table4():
    draws = Draws(4)
    for name, flags, comment, surface, cluster in [*plain_cases(), *shape_cases()]:
        yield case(name, flags, comment, surface, cluster)
        yield case(name + "-mixed", flags, comment, surface, cluster, draws)
