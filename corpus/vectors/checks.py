# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the vectors themselves, in rational arithmetic: rows tile the inside part, pieces fill their tetrahedron, clusters do not
overlap, equations hold. The checks do not use the way in which the vectors were made."""
import math
from fractions import Fraction
from itertools import combinations

LEAST_CELLS = 4  # the cells that every side gets at least (reading D1)
FACES = ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))


def exact(point):
    return tuple(Fraction(x) for x in point)


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def volume(a, b, c, d):
    return Fraction(dot(cross(sub(b, a), sub(c, a)), sub(d, a))) / 6


def is_tet(value):
    number = lambda x: isinstance(x, (int, float)) and not isinstance(x, bool) and abs(x) < float("inf")
    return (isinstance(value, list) and len(value) == 4
            and all(isinstance(p, list) and len(p) == 3 and all(map(number, p)) for p in value))


def boundary(tets):
    """The faces that only one tetrahedron has, as triples of points, anticlockwise from outside. None if a face occurs twice with the same
    orientation."""
    faces = {}
    for tet in tets:
        for f in FACES:
            corners = [tet[c] for c in f]
            first = corners.index(min(corners))
            face = tuple(corners[first:] + corners[:first])
            if face in faces:
                return None
            faces[face] = True
    return [f for f in faces if (f[0], f[2], f[1]) not in faces]


def table1(case):
    s, e = case["input"]["indicators"], case["expected"]
    if sorted(map(tuple, e["edges"])) != [p for p in combinations(range(4), 2) if s[p[0]] * s[p[1]] == -1]:
        yield "an edge has a cut exactly where its ends lie on different sides"


def table2(case):
    """The tetrahedra must be positive, match face to face, and be bounded by the surface and by the inside part of each face of the
    lattice tetrahedron. Then they tile the inside part."""
    vertices = case["input"]["vertices"]
    place = {v["number"]: exact(v["point"]) for v in vertices}
    after = {v["number"]: v["after"] for v in vertices}
    cut = {frozenset(c["edge"]): exact(c["point"]) for c in case["input"]["cuts"]}
    if set(cut) != {frozenset(e) for e in combinations(place, 2) if after[e[0]] * after[e[1]] < 0}:
        yield "cuts: one for each edge between -1 and +1"
        return
    surface = set(cut.values()) | {place[v] for v in place if after[v] == 0}
    # A centroid is rounded. Only for such cases are the sums compared with a tolerance.
    slack = Fraction(case["tolerance"]["absolute"]) * 1000
    tets = [[exact(p) for p in t] for t in case["expected"]["tetrahedra"]]
    if any(volume(*t) <= 0 for t in tets):
        yield "a tetrahedron is not positive"
    outer = boundary(tets)
    if outer is None:
        yield "a face is induced twice with the same orientation"
        return
    if not tets and any(after[v] > 0 and place[v] not in surface for v in place):
        yield "nothing is kept though a vertex is inside"
    left = [f for f in outer if not all(p in surface for p in f)]
    for corners in combinations(place, 3):
        a, b, c = (place[v] for v in corners)
        normal = cross(sub(b, a), sub(c, a))
        twice = lambda f: dot(cross(sub(f[1], f[0]), sub(f[2], f[0])), normal)
        here = [f for f in outer if all(dot(sub(p, a), normal) == 0 for p in f)]
        left = [f for f in left if f not in here]
        polygon = []
        for v, w in zip(corners, corners[1:] + corners[:1]):
            if after[v] >= 0:
                polygon.append(place[v])
            if after[v] * after[w] < 0:
                polygon.append(cut[frozenset((v, w))])
        inside = sum((twice((polygon[0], p, q)) for p, q in zip(polygon[1:], polygon[2:])), Fraction(0))
        # If all corners of the inside part of a face are on the surface, the part may belong to the surface, and may be covered or not.
        covered = abs(sum(map(twice, here)))
        if abs(covered - abs(inside)) > slack and (covered or not set(polygon) <= surface):
            if not (all(after[v] <= 0 for v in corners) and all(set(f) <= surface for f in here)):
                yield f"on the lattice face {corners} the tetrahedra do not cover the inside part"
    if left:
        yield f"{len(left)} boundary faces lie neither on a lattice face nor on the surface"


def table3(case):
    given, e = case["input"], case["expected"]
    before = [v["indicator"] for v in given["vertices"]]
    points = {tuple(c["edge"]): [exact(p) for p in c["points"]] for c in given["edges"]}
    place = [exact(v["point"]) for v in given["vertices"]]
    for v, (old, new) in enumerate(zip(before, e["indicators"])):
        if old and new != old:
            yield f"vertex {v}: only a 0 can change"
        if v in given["settled"] and new != old:
            yield f"vertex {v} is settled"
    for edge, where in points.items():
        parameters = [dot(sub(p, place[edge[0]]), sub(place[edge[1]], place[edge[0]])) for p in where]
        if parameters != sorted(set(parameters)):
            yield f"edge {edge}: points are distinct and run from the lower-numbered end"
    cuts = {tuple(c["edge"]): exact(c["point"]) for c in e["cuts"]}
    for edge in [(a, b) for a in range(8) for b in range(a + 1, 8) if a & b == a]:
        different = e["indicators"][edge[0]] * e["indicators"][edge[1]] < 0
        if different != (edge in cuts):
            yield f"edge {edge}: a cut exactly where the ends lie on different sides"
        elif different:
            outer, inner = edge if e["indicators"][edge[0]] < 0 else edge[::-1]
            choice = [place[outer]] if before[outer] == 0 else []
            choice += points.get(edge, [])[::1 if outer == edge[0] else -1]
            choice += [place[inner]] if before[inner] == 0 else []
            if not choice or cuts[edge] != choice[0]:
                yield f"edge {edge}: the cut is the point closest to the exterior end"


def disjoint(s, t):
    normals = [cross(sub(one[b], one[a]), sub(one[c], one[a])) for one in (s, t) for a, b, c in FACES]
    edges = [[sub(b, a) for a, b in combinations(one, 2)] for one in (s, t)]
    for n in normals + [cross(e, f) for e in edges[0] for f in edges[1]]:
        first, second = [dot(n, p) for p in s], [dot(n, p) for p in t]
        if any(n) and (max(first) <= min(second) or max(second) <= min(first)):
            return True
    return False


def table4(case):
    given, e = case["input"], case["expected"]
    points = [exact(p) for p in given["points"]]
    tets, at = given["tetrahedra"], given["tetrahedra"][given["split"]]
    place = lambda t: [points[v] for v in t]
    if any(volume(*place(t)) <= 0 for t in tets) or boundary(tets) is None:
        yield "the cluster is not positive and conforming"
    if not all(disjoint(place(s), place(t)) for s, t in combinations(tets, 2)):
        yield "tetrahedra of the cluster overlap"
    others = [set(t) for k, t in enumerate(tets) if k != given["split"]]
    if len(e["replaced"]) < 4 and any(set(e["replaced"]) <= other for other in others):
        yield "the new point lies on an edge or face that another tetrahedron has"
    points.append(exact(e["point"]))
    mean = tuple(sum(points[v][x] for v in e["replaced"]) / len(e["replaced"]) for x in range(3))
    if max(map(abs, sub(mean, points[-1]))) > Fraction(case["tolerance"]["absolute"]):
        yield "the new point is the mean of the corners it replaces"
    if len(e["pieces"]) != len(e["replaced"]) or any(volume(*place(t)) <= 0 for t in e["pieces"]):
        yield "one positive piece for each corner replaced"
    if abs(sum(volume(*place(t)) for t in e["pieces"]) - volume(*place(at))) > Fraction(1, 10**9):
        yield "the pieces fill the tetrahedron"


def near(a, b, tolerance=Fraction(1, 10**12)):
    return abs(a - b) <= tolerance * max(1, abs(a), abs(b))


def volume_law(case):
    """Eq. (3.1) is solved for t = (d/d1)^p. With p = a/b, t^b is compared with (d/d1)^a, so that all numbers are rational."""
    g = {key: Fraction(x) for key, x in case["input"].items()}
    found, p = Fraction(case["expected"]["volume"]), Fraction(case["input"]["p"]).limit_denominator(4)
    if g["v0"] == g["v1"] or found == min(g["v0"], g["v1"]) != g["v0"]:
        right = found == g["v0"] or ((g["d"] / g["d1"]) ** p.numerator >= 1 and g["v1"] < g["v0"])
    else:
        t = (found - g["v0"]) / (g["v1"] - g["v0"])
        right = t >= 0 and near(t**p.denominator, (g["d"] / g["d1"]) ** p.numerator)
    if not right:
        yield "eq. (3.1) does not hold"


def curvature_weight(case):
    g = {key: Fraction(x) for key, x in case["input"].items()}
    span = g["kappa_max"] - g["kappa_min"]
    if not near(Fraction(case["expected"]["weight"]), 1 - Fraction(9, 10) * (g["kappa"] - g["kappa_min"]) / span if span else Fraction(1)):
        yield "eq. (3.6) does not hold"


def weights(case):
    given, e = case["input"], case["expected"]
    points, surface = [exact(p) for p in given["points"]], [exact(p) for p in given["surface"]]
    for number, (t, w) in enumerate(zip(given["tetrahedra"], e["tetrahedra"])):
        corners = [points[v] for v in t]
        middle = tuple(sum(column) / 4 for column in zip(*corners))
        squares = [dot(sub(middle, x), sub(middle, x)) for x in surface]
        d2 = Fraction(w["d"]) ** 2
        if not near(d2, min(squares)) or not near(squares[w["nearest"]], min(squares), Fraction(1, 10**11)):
            yield f"tetrahedron {number}: eq. (3.2) does not hold"
        if not near(Fraction(w["volume"]), volume(*corners)) or volume(*corners) <= 0:
            yield f"tetrahedron {number}: the volume is wrong"
        if not near(Fraction(w["error"]), abs(Fraction(w["volume"]) - Fraction(w["desired"]))):
            yield f"tetrahedron {number}: eq. (3.3) does not hold"
        if not given["kappa"] and w["omega"] != 1 or not Fraction(1, 10) <= Fraction(w["omega"]).limit_denominator(10**9) <= 1:
            yield f"tetrahedron {number}: the weight is not in [1/10, 1]"
    if not near(Fraction(e["e_avg"]), sum(Fraction(w["error"]) for w in e["tetrahedra"]) / len(e["tetrahedra"])):
        yield "eq. (3.4) does not hold"


def choice(case):
    errors, e = list(map(Fraction, case["input"]["errors"])), case["expected"]
    after = []
    for c in case["input"]["candidates"]:
        grid = errors[:c["tet"]] + list(map(Fraction, c["pieces"])) + errors[c["tet"] + 1:]
        after.append((sum(grid) / len(grid), c["tet"]))
    if not all(near(Fraction(x), y) for x, (y, _) in zip(e["after_each"], after)) or len(after) != len(e["after_each"]):
        yield "eq. (3.5) does not hold"
    best = min(after)
    if e["tet"] != (best[1] if best[0] < sum(errors) / len(errors) else None):
        yield "the choice is not the smallest average"


def curvature(case):
    g = case["input"]
    if not any(g["vertex"] in t for t in g["triangles"]) or case["expected"]["curvature"] < 0:
        yield "no triangle at the vertex, or a negative curvature"
    edges = [(t[k], t[(k + 1) % 3]) for t in g["triangles"] for k in range(3)]
    if len(edges) != len(set(edges)):
        yield "the triangles are not consistently oriented"


def lattice(case):
    """The vertices are solved for their position in the box, which must be that of their numbers."""
    given, e = case["input"], case["expected"]
    used = [exact(given["vertices"][v]) for t in given["triangles"] for v in t]
    low, high = exact(e["box"][0]), exact(e["box"][1])
    sides = [max(p[x] for p in used) - min(p[x] for p in used) for x in range(3)]
    slack = Fraction(case["tolerance"]["absolute"])
    for x in range(3):
        if abs(min(p[x] for p in used) + max(p[x] for p in used) - low[x] - high[x]) > slack or abs(high[x] - low[x] - sides[x] * Fraction(given["box_scale"])) > slack:
            yield "the box of eq. (2.1) is the surface's, scaled about its centre"
        cells = e["cells"][x]
        if len(given["cells"]) == 3 and cells != given["cells"][x]:
            yield "the numbers of cells were given"
        wanted = given["cells"][0] * sides[x] / max(sides)
        least = min(LEAST_CELLS, given["cells"][0])
        if len(given["cells"]) == 1 and not (cells - Fraction(1, 2) <= wanted < cells + Fraction(1, 2) or (cells == least and wanted < least)):
            yield "one number of cells: the cells come closest to cubes"
        for at, p in zip(given["at"], e["points"]):
            if abs((Fraction(p[x]) - low[x]) * cells - (high[x] - low[x]) * at[x]) > slack * cells:
                yield f"eq. (2.1) does not hold at {at}"


def winding_number(triangles, p):
    """How often the surface surrounds p: the sum of the triangles' solid angles, in doubles. Only the determinants, which decide the
    signs, are exact."""
    total = 0.0
    for t in triangles:
        a, b, c = (sub(v, p) for v in t)
        la, lb, lc = (math.sqrt(dot(v, v)) for v in (a, b, c))
        denominator = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la
        total += 2 * math.atan2(dot(a, cross(b, c)), denominator)
    return round(total / (4 * math.pi))


def on_triangle(t, p):
    """By barycentric coordinates."""
    u, v, w = sub(t[1], t[0]), sub(t[2], t[0]), sub(p, t[0])
    n = cross(u, v)
    if dot(w, n) != 0:
        return False
    b, c, whole = dot(cross(w, v), n), dot(cross(u, w), n), dot(n, n)
    return b >= 0 and c >= 0 and b + c <= whole


def surface_of(given):
    place = [exact(p) for p in given["vertices"]]
    return [[place[v] for v in t] for t in given["triangles"]]


def indicators(case):
    given, scale = case["input"], 2**48
    whole = lambda p: tuple(int(x * scale) for x in exact(p))  # integers are faster than fractions
    triangles = [[whole(given["vertices"][v]) for v in t] for t in given["triangles"]]
    edges = [(t[k], t[(k + 1) % 3]) for t in given["triangles"] for k in range(3)]
    if len(set(edges)) != len(edges) or {(b, a) for a, b in edges} != set(edges):
        yield "the surface is not closed"
    for p, found in zip(given["points"], case["expected"]["indicators"]):
        on = any(on_triangle(t, whole(p)) for t in triangles)
        if exact(p) != tuple(Fraction(x, scale) for x in whole(p)):
            yield f"{p}: more digits than this check allows"
        elif on != (found == 0):
            yield f"{p}: 0 exactly on the surface"
        elif not on and (winding_number(triangles, whole(p)) != 0) != ((found > 0) == (given["region"] == "inside")):
            yield f"{p}: the surface surrounds the points inside, and no others"


def points_of_edge(p, q, triangles):
    """The parameters, within the open edge from p to q, where the edge begins or ends to lie on the surface. All points are exact."""
    d, found = sub(q, p), set()
    for t in triangles:  # where the edge enters or leaves this triangle, by the signs of the three areas
        u, v = sub(t[1], t[0]), sub(t[2], t[0])
        n = cross(u, v)

        def coordinates(x):
            w = sub(x, t[0])
            b, c = dot(cross(w, v), n), dot(cross(u, w), n)
            return dot(n, n) - b - c, b, c, dot(w, n)

        for a, b in zip(coordinates(p), coordinates(q)):
            if a != b and 0 <= Fraction(a) / (a - b) <= 1:
                s = Fraction(a) / (a - b)
                if on_triangle(t, tuple(x + s * y for x, y in zip(p, d))):
                    found.add(s)
    spots = sorted(found | {Fraction(0), Fraction(1)})
    middle = [any(on_triangle(t, tuple(x + (a + b) / 2 * y for x, y in zip(p, d))) for t in triangles) for a, b in zip(spots, spots[1:])]
    return [s for k, s in enumerate(spots[1:-1]) if not (middle[k] and middle[k + 1])]


def edge_points(case):
    """Between two points, the edge is on the surface altogether or nowhere."""
    given, e, triangles = case["input"], case["expected"], surface_of(case["input"])
    p, q = map(exact, given["edge"])
    d = sub(q, p)
    at = [Fraction(dot(sub(exact(x), p), d)) / dot(d, d) for x in e["points"]]
    if e["count"] != len(at) or at != sorted(set(at)) or any(not 0 < s < 1 for s in at):
        yield "distinct points of the open edge, in its order"
    right = points_of_edge(p, q, triangles)
    if len(right) != len(at) or any(abs(a - b) > Fraction(1, 10**12) for a, b in zip(at, right)):
        yield "the points are the ends of what the edge has in common with the surface"


def closest_point(case):
    """The closest of the points where the distance is stationary: by least squares in each triangle, along each side, and the corners."""
    given, e, triangles = case["input"], case["expected"], surface_of(case["input"])
    p, found, slack = exact(given["point"]), exact(e["point"]), Fraction(1, 10**9)
    square = dot(sub(found, p), sub(found, p))
    if abs(square - Fraction(e["distance"]) ** 2) > slack:
        yield "the distance is that of the point"
    least = None
    for t in triangles:
        u, v, w = sub(t[1], t[0]), sub(t[2], t[0]), sub(p, t[0])
        a, b, c, d, f = dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w)
        spots = [(Fraction(c * d - b * f) / (a * c - b * b), Fraction(a * f - b * d) / (a * c - b * b))]  # least squares
        for x in (Fraction(d) / a, Fraction(0), Fraction(1)):
            spots.append((x, Fraction(0)))
        spots += [(Fraction(0), Fraction(f) / c), (Fraction(0), Fraction(1))]
        s = Fraction(a - b + f - d) / (a - 2 * b + c)  # along the third side
        spots.append((1 - s, s))
        for x, y in spots:
            if x >= 0 and y >= 0 and x + y <= 1:
                at = tuple(o + x * i + y * j for o, i, j in zip(t[0], u, v))
                here = (dot(sub(at, p), sub(at, p)), at)
                least = here if least is None or here < least else least
    if abs(least[0] - square) > slack or any(abs(x - y) > slack for x, y in zip(least[1], found)):
        yield "another point of the surface is closer, or as close and lexicographically smaller"


def tangent_and_ratio(corners):
    """tan(Omega/2) of the smallest solid angle after van Oosterom and Strackee, and D/A, in doubles."""
    angles, areas = [], []
    six = float(abs(volume(*corners) * 6))
    for k in range(4):
        a, b, c = (sub(corners[x], corners[k]) for x in range(4) if x != k)
        la, lb, lc = (math.sqrt(dot(v, v)) for v in (a, b, c))
        angles.append(math.atan2(six, la * lb * lc + float(dot(a, b)) * lc + float(dot(a, c)) * lb + float(dot(b, c)) * la))  # halved
        n = cross(sub(b, a), sub(c, a))
        areas.append(math.sqrt(dot(n, n)) / 2)
    return math.tan(min(angles)), six / 2 / max(areas) ** 2, six / 2 / max(areas) ** 1.5


def quality(case):
    e = case["expected"]
    corners = [exact(p) for p in case["input"]["points"]]
    tangent, ratio, plain = tangent_and_ratio(corners)
    right = {"tangent": tangent, "solid_angle": math.atan(tangent) / (2 * math.pi), "d_over_a": ratio, "d_over_sqrt_a": plain}
    if volume(*corners) <= 0:
        yield "the tetrahedron is not positive"
    for key, value in right.items():
        if abs(e[key] - value) > 1e-11 * abs(value):
            yield f"{key} is not {value}"


def flips(case):
    """The new tetrahedra fill the place of the old ones: the same boundary, the same volume. No other exchange that does gains more."""
    given, e = case["input"], case["expected"]
    points, tets = [exact(p) for p in given["points"]], given["tetrahedra"]
    place = lambda t: [points[v] for v in t]
    of = lambda t: tangent_and_ratio(place(t))[0 if given["criterion"] == "solid-angle" else 1]
    if any(volume(*place(t)) <= 0 for t in tets):
        yield "a tetrahedron is not positive"
    gains = []
    for size in (2, 3):
        for old in combinations(given["set"], size):
            hull = sorted(set().union(*(tets[t] for t in old)))
            outer = boundary([tets[t] for t in old])
            if len(hull) != 5 or outer is None or len(outer) != 6:
                continue
            common = [v for v in hull if all(v in tets[t] for t in old)]
            new = [[v for v in hull if v != c] for c in common]
            new = [t if volume(*place(t)) > 0 else [t[0], t[1], t[3], t[2]] for t in new]
            if any(volume(*place(t)) <= 0 for t in new) or sorted(boundary(new) or []) != sorted(outer):
                continue
            if sum(volume(*place(t)) for t in new) == sum(volume(*place(tets[t])) for t in old):
                before, after = min(of(tets[t]) for t in old), min(map(of, new))
                gains.append((after - before, old, sorted(map(sorted, new)), before, after))
    best = max((g[0] for g in gains), default=0.0)
    if e["flip"] is None:
        if best > 1e-12 or e["tetrahedra"]:
            yield "a flip gains, and none is made"
        return
    mine = [g for g in gains if g[2] == sorted(map(sorted, e["tetrahedra"]))]
    if not mine or mine[0][0] <= 0 or mine[0][0] < best - 1e-12:
        yield "the flip is not possible, or another one gains more"
        return
    if any(volume(*place(t)) <= 0 for t in e["tetrahedra"]):
        yield "a new tetrahedron is not positive"
    shown = lambda q: math.atan(q) / (2 * math.pi) if given["criterion"] == "solid-angle" else q
    if any(abs(a - shown(b)) > 1e-11 for a, b in zip(e["flip"]["quality"], mine[0][3:])):
        yield "the qualities are wrong"


def faults(kind, content):
    """Everything that is wrong with a file, one line for each fault."""
    checks = {"table1": table1, "table2": table2, "table3": table3, "table4": table4, "volume_law": volume_law, "weights": weights,
              "choice": choice, "curvature_weight": curvature_weight, "curvature": curvature, "lattice": lattice, "indicators": indicators,
              "edge_points": edge_points, "closest_point": closest_point, "quality": quality, "flips": flips}
    if kind not in checks:
        yield f"{kind}: unknown kind"
        return
    seen, used = set(), set()
    for case in content["cases"]:
        if case["id"] in seen:
            yield f"{case['id']}: the id is there twice"
        seen.add(case["id"])
        used |= set(case["flags"])
        for flag in set(case["flags"]) - set(content["flags"]):
            yield f"{case['id']}: no note on the flag {flag}"
        if not case["comment"] or len(set(case["flags"])) != len(case["flags"]):
            yield f"{case['id']}: no comment, or a flag twice"
        for fault in checks[kind](case):
            yield f"{case['id']}: {fault}"
    for flag in set(content["flags"]) - used:
        yield f"{kind}: no case has the flag {flag}"
