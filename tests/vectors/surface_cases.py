# SPDX-License-Identifier: GPL-3.0-or-later
"""Points and lines against small surfaces, in rational arithmetic: exact indicators, the points of an edge, closest points.
Inside is decided by a ray in a direction that meets no edge, not by the reading's lines along x."""
from fractions import Fraction as F
from itertools import product

from exact import Draws, along, cross, dot, root, sub

TINY = F(1, 2**46)  # far below every tolerance, far above the spacing of doubles here

# --- surfaces


def cells_surface(cells, step=2):
    """The boundary of some cells of a lattice, oriented outward, each square cut into two triangles."""
    vertices, triangles = [], []
    number = {}

    def vertex(corner):
        if corner not in number:
            number[corner] = len(vertices)
            vertices.append(tuple(F(step * c) for c in corner))
        return number[corner]

    for cell in sorted(cells):
        for axis, side in product(range(3), (0, 1)):
            beside = list(cell)
            beside[axis] += 1 if side else -1
            if tuple(beside) in cells:
                continue
            u, v = (axis + 1) % 3, (axis + 2) % 3
            square = []
            for du, dv in ((0, 0), (1, 0), (1, 1), (0, 1)):
                corner = list(cell)
                corner[axis] += side
                corner[u] += du
                corner[v] += dv
                square.append(vertex(tuple(corner)))
            if not side:
                square.reverse()
            a, b, c, d = square
            triangles += [[a, b, c], [a, c, d]] if sum(cell) % 2 == 0 else [[a, b, d], [b, c, d]]
    return vertices, triangles


def octahedron(centre, radii):
    vertices = [tuple(F(c) + s * F(r) * (axis == x) for x, c in enumerate(centre)) for axis, r in enumerate(radii) for s in (1, -1)]
    triangles = []
    for sx, sy, sz in product((0, 1), repeat=3):
        t = [sx, 2 + sy, 4 + sz]
        triangles.append(t if (sx + sy + sz) % 2 == 0 else [t[0], t[2], t[1]])
    return vertices, triangles


def tetrahedron():
    return [tuple(map(F, p)) for p in ((0, 0, 0), (5, 1, 0), (1, 6, 1), (2, 1, 7))], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]


def surfaces():
    block = set(product(range(3), repeat=3))
    return {
        "cube": cells_surface({(0, 0, 0)}),
        "corner": cells_surface({(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)}),
        "frame": cells_surface({c for c in product(range(3), range(3), (0,)) if c != (1, 1, 0)}),
        "shell": cells_surface(block - {(1, 1, 1)}),
        "pair": cells_surface({(0, 0, 0), (2, 0, 0)}),
        "octahedron": octahedron((1, 0, 2), (4, 2, 1)),
        "tetrahedron": tetrahedron(),
    }


def corners(surface):
    vertices, triangles = surface
    return [[vertices[v] for v in t] for t in triangles]


# --- exact indicators


def on_triangle(t, p):
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    if dot(sub(p, t[0]), n) != 0:
        return False
    return all(dot(cross(sub(t[(k + 1) % 3], t[k]), sub(p, t[k])), n) >= 0 for k in range(3))


def strictly_on_triangle(t, p):
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    return dot(sub(p, t[0]), n) == 0 and all(dot(cross(sub(t[(k + 1) % 3], t[k]), sub(p, t[k])), n) > 0 for k in range(3))


def inside(triangles, p):
    """Whether p, which is on no triangle, is inside: the parity of a ray that meets no edge of the surface. All coordinates are integers."""
    for k in range(1, 100):
        ray = (217, 31 * k, 7 * (k * k + 3))
        crossings, met_an_edge = 0, False
        for t in triangles:
            n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
            slope, height = dot(ray, n), dot(sub(t[0], p), n)
            if slope == 0:
                met_an_edge |= height == 0
                continue
            if (height > 0) != (slope > 0):
                continue
            at = [[slope * (x - v) + height * r for x, v, r in zip(p, corner, ray)] for corner in t]  # seen from the corners, times the slope
            sides = [dot(cross(sub(t[(i + 1) % 3], t[i]), at[i]), n) * (1 if slope > 0 else -1) for i in range(3)]
            if min(sides) >= 0:
                met_an_edge |= min(sides) == 0
                crossings += 1
        if not met_an_edge:
            return crossings % 2 == 1
    raise AssertionError("no ray misses all edges")


def indicator(triangles, p):
    return 0 if any(on_triangle(t, p) for t in triangles) else 1 if inside(triangles, p) else -1


def line_hits(triangles, p):
    """How many closed triangles the line in the direction of x meets before p: what a test without a rule for edges counts."""
    hits = 0
    for t in triangles:
        turn = lambda a, b, c: (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
        facing = turn(*t)
        if facing and all(turn(t[k], t[(k + 1) % 3], p) * facing >= 0 for k in range(3)):
            n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
            hits += dot(sub(p, t[0]), n) * n[0] > 0
    return hits


INDICATORS_FLAGS = {
    "outside-region": "The region outside: the signs are exchanged (reading D5).",
    "on-edge-or-vertex": "A point on an edge or a vertex of the surface is on the surface, as one within a triangle is.",
    "line-meets-edge": "The line along x from the point goes through an edge or a vertex of the surface: a test that counts the triangles "
                       "that it meets counts some twice (reading D4).",
    "near": "A point so close to the surface that a tolerance would take it for 0: indicators are exact for the doubles (reading D4). Skip "
            "this flag if you have such a tolerance on purpose.",
    "cavity": "A point within a cavity, a hole or a notch is outside.",
}


def indicators_case(name, comment, surface, points, region="inside", cavity=False, near=False):
    whole = lambda x: tuple(int(c * 2**48) for c in x)  # integers are faster than fractions
    given, points = points, [whole(p) for p in points]
    triangles = [[whole(v) for v in t] for t in corners(surface)]
    found = [indicator(triangles, p) * (1 if region == "inside" else -1) for p in points]
    flags = ["outside-region"] * (region == "outside" and any(found)) + ["cavity"] * cavity
    edge = [f == 0 and not any(strictly_on_triangle(t, p) for t in triangles) for p, f in zip(points, found)]
    naive = [(1 if line_hits(triangles, p) % 2 else -1) * (1 if region == "inside" else -1) for p in points]
    flags += ["on-edge-or-vertex"] * any(edge) + ["line-meets-edge"] * any(f and f != n for f, n in zip(found, naive))
    flags += ["near"] * near
    return {"id": "indicators-" + name, "flags": flags, "comment": comment,
            "input": {"vertices": surface[0], "triangles": surface[1], "region": region, "points": given}, "expected": {"indicators": found}}


def indicators():
    draws = Draws(42)
    for name, surface in surfaces().items():
        vertices, triangles = surface
        shapes = corners(surface)
        low, high = [min(v[x] for v in vertices) for x in range(3)], [max(v[x] for v in vertices) for x in range(3)]
        lattice = [tuple(F(x) for x in p) for p in product(*[range(int(l) - 1, int(h) + 2) for l, h in zip(low, high)])]
        for region in ("inside", "outside"):
            end = "" if region == "inside" else "-outside"
            yield indicators_case(f"{name}-lattice{end}", "the points with integer coordinates in and around the box", surface,
                                  draws.shuffled(lattice)[:60], region, name in ("shell", "frame", "corner"))
        yield indicators_case(f"{name}-vertices", "every vertex", surface, list(dict.fromkeys(vertices)))
        inner = [tuple((2 * a[x] + b[x] + c[x]) / 4 for x in range(3)) for a, b, c in shapes]
        middle = [tuple((a[x] + b[x]) / 2 for x in range(3)) for t in shapes for a, b in (t[:2], t[1:])]
        yield indicators_case(f"{name}-within", "a point within each triangle", surface, inner)
        yield indicators_case(f"{name}-edges", "midpoints of edges", surface, list(dict.fromkeys(middle)))
        beside = []
        for p in inner[:12] + middle[:6] + list(vertices[:4]):
            for axis, sign in ((0, 1), (0, -1), (1, 1), (2, -1)):
                q = list(p)
                q[axis] += sign * TINY
                beside.append(tuple(q))
        yield indicators_case(f"{name}-near", "beside faces, edges and vertices, by 2^-46", surface, beside, near=True)
        level = [(F(x), p[1], p[2]) for p in list(vertices)[:8] for x in (low[0] - 1, (low[0] + high[0]) / 2 + F(1, 8), high[0] + 1)]
        yield indicators_case(f"{name}-lines", "lines along x through vertices of the surface", surface, list(dict.fromkeys(level)))
        level = [(x, p[1], p[2]) for p in middle[:10] for x in (low[0] - 1, (low[0] + high[0]) / 2 + F(1, 8), high[0] + 1)]
        yield indicators_case(f"{name}-lines-edges", "lines along x through midpoints of edges", surface, list(dict.fromkeys(level)))
    shell = surfaces()["shell"]
    yield indicators_case("shell-cavity", "points within the cavity", shell, [(F(3), F(3), F(3)), (F(5, 2), F(3), F(7, 2)), (F(9, 4), F(9, 4), F(9, 4))], cavity=True)
    frame = surfaces()["frame"]
    yield indicators_case("frame-hole", "points within the hole", frame, [(F(3), F(3), F(1)), (F(3), F(3), F(2)), (F(5, 2), F(7, 2), F(0))], cavity=True)


# --- the points of an edge


def common_part(p, q, t):
    """The parameters (first, last) of what the closed triangle has in common with the edge from p to q; None if nothing."""
    d = sub(q, p)
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    slope, height = dot(d, n), dot(sub(t[0], p), n)
    if slope:
        s = height / slope
        at = along(p, q, s)
        within = all(dot(cross(sub(t[(k + 1) % 3], t[k]), sub(at, t[k])), n) >= 0 for k in range(3))
        return (s, s) if 0 <= s <= 1 and within else None
    if height:
        return None
    first, last = F(0), F(1)
    for k in range(3):  # inside of each side: side + s * change >= 0
        inward = cross(n, sub(t[(k + 1) % 3], t[k]))
        side, change = dot(sub(p, t[k]), inward), dot(d, inward)
        if change == 0:
            if side < 0:
                return None
        elif change > 0:
            first = max(first, -side / change)
        else:
            last = min(last, -side / change)
    return (first, last) if first <= last else None


def parts_of(p, q, triangles):
    return [part for part in (common_part(p, q, t) for t in triangles) if part]


def counted(parts):
    """The ends of the union of the parts, within the open edge."""
    points, reach = [], None
    for first, last in sorted(parts):
        if reach is None or first > reach:
            if reach is not None:
                points.append(reach)
            points.append(first)
            reach = last
        else:
            reach = max(reach, last)
    if reach is not None:
        points.append(reach)
    return [s for s in sorted(set(points)) if 0 < s < 1]


EDGE_FLAGS = {
    "several-triangles": "Several triangles go through one point, at an edge or a vertex of the surface: points are counted, not triangles "
                         "(reading D6).",
    "union": "The edge runs along the surface across several coplanar triangles: only the ends of the union count, not those of each "
             "triangle (reading D6).",
    "along": "The edge has a part that lies on the surface.",
    "touch": "The edge touches the surface without crossing it: a point all the same (reading D6).",
    "ends": "An end of the edge lies on the surface: it is no point of the open edge.",
    "none": "The edge does not meet the surface in its open interior.",
}


def edge_case(name, comment, surface, p, q, flags=()):
    triangles = corners(surface)
    parts = parts_of(p, q, triangles)
    where = counted(parts)
    ends = sorted({s for part in parts for s in part if 0 < s < 1})
    flags = list(flags) + ["along"] * any(a < b for a, b in parts) + ["union"] * (ends != where) + ["none"] * (not where)
    flags += ["several-triangles"] * (sum(len({s for s in part if 0 < s < 1}) for part in parts) != len(where))
    flags += ["ends"] * any(0 in part or 1 in part for part in parts)
    return {"id": "edge-" + name, "flags": flags, "comment": comment,
            "input": {"vertices": surface[0], "triangles": surface[1], "edge": [p, q]},
            "expected": {"count": len(where), "points": [along(p, q, s) for s in where]},
            "tolerance": {"absolute": float(max(abs(x) for x in sub(q, p))) * 1e-12}}


def edge_points():
    shapes = surfaces()
    f = lambda *x: tuple(map(F, x))
    cube, corner, shell, frame, octa, tetra = (shapes[n] for n in ("cube", "corner", "shell", "frame", "octahedron", "tetrahedron"))
    yield edge_case("cube-face", "through the inside of one triangle", cube, f(1, F(1, 2), 1), f(1, F(1, 2), 5))
    yield edge_case("cube-two", "through two faces", cube, f(-1, F(1, 2), F(3, 4)), f(5, F(3, 4), F(3, 4)))
    yield edge_case("cube-inside", "altogether inside", cube, f(F(1, 2), F(1, 2), F(1, 2)), f(1, 1, F(3, 2)))
    yield edge_case("cube-beside", "altogether outside", cube, f(3, 0, 0), f(3, 2, 2))
    yield edge_case("cube-diagonal-of-face", "through the diagonal of a face: two triangles, one point", cube, f(1, 1, 1), f(1, 1, 5))
    yield edge_case("cube-edge", "through an edge of the cube", cube, f(1, 1, 1), f(3, 3, 1))
    yield edge_case("cube-vertex", "through a vertex of the cube", cube, f(1, 1, 1), f(3, 3, 3))
    yield edge_case("cube-two-vertices", "along the main diagonal, through two vertices", cube, f(-1, -1, -1), f(3, 3, 3))
    yield edge_case("cube-touch-edge", "touches an edge of the cube from outside", cube, f(1, 3, 1), f(3, 1, 1), ["touch"])
    yield edge_case("cube-touch-vertex", "touches a vertex of the cube from outside", cube, f(1, 2, 3), f(3, 2, 1), ["touch"])
    yield edge_case("cube-along-edge", "runs along an edge of the cube and beyond it at both ends", cube, f(-1, 0, 0), f(3, 0, 0))
    yield edge_case("cube-on-edge", "lies within an edge of the cube", cube, f(F(1, 2), 0, 0), f(1, 0, 0))
    yield edge_case("cube-along-face", "runs across a face in its plane, over the diagonal", cube, f(-1, F(1, 2), 2), f(3, F(3, 4), 2))
    yield edge_case("cube-in-face", "lies within a face, over the diagonal", cube, f(F(1, 4), F(1, 2), 2), f(F(7, 4), F(3, 4), 2))
    yield edge_case("cube-into-face", "begins within a face and leaves it in its plane", cube, f(F(1, 4), F(1, 2), 2), f(3, F(3, 4), 2))
    yield edge_case("cube-along-diagonal", "runs along the diagonal of a face", cube, f(-1, -1, 2), f(3, 3, 2))
    yield edge_case("cube-end-on-face", "ends on a face", cube, f(1, F(1, 2), 2), f(1, F(1, 2), 5))
    yield edge_case("cube-ends-on-two-faces", "from face to face", cube, f(1, F(1, 2), 0), f(1, F(1, 2), 2))
    yield edge_case("corner-step", "along a step: in the plane of one face and through others", corner, f(-1, 1, 2), f(5, 1, 2))
    yield edge_case("corner-notch", "through the edge in the notch", corner, f(1, 1, 1), f(3, 3, 3))
    yield edge_case("corner-notch-touch", "touches the notch's edge from inside", corner, f(1, 3, 1), f(3, 1, 1), ["touch"])
    yield edge_case("shell-four", "in and out twice", shell, f(-1, F(5, 2), F(11, 4)), f(7, F(11, 4), F(11, 4)))
    yield edge_case("shell-diagonal", "the main diagonal, through four vertices", shell, f(-1, -1, -1), f(7, 7, 7))
    yield edge_case("shell-cavity", "from the cavity to outside", shell, f(3, 3, F(5, 2)), f(3, 3, 8))
    yield edge_case("frame-hole", "through the hole's rim, in the plane of the top", frame, f(-1, 3, 2), f(7, F(7, 2), 2))
    yield edge_case("frame-through", "along the axis of the hole", frame, f(3, 3, -1), f(3, 3, 3))
    yield edge_case("octahedron-vertices", "from beyond one vertex to beyond the opposite one", octa, f(-4, 0, 2), f(6, 0, 2))
    yield edge_case("octahedron-touch", "touches a vertex", octa, f(5, -1, 2), f(5, 1, 2), ["touch"])
    yield edge_case("tetrahedron-skew", "through two skew faces", tetra, f(-1, 2, 1), f(5, 3, 2))
    draws = Draws(43)
    for n in range(40):
        name = draws.choice(sorted(shapes))
        vertices = shapes[name][0]
        spot = lambda: draws.choice(vertices) if draws.below(3) == 0 else tuple(F(draws.between(-4, 28), 4) for _ in range(3))
        a, b = spot(), spot()
        if a == b:
            b = along(a, (F(9), F(8), F(7)), F(1))
        if n % 3 == 0:  # beyond both
            a, b = along(a, b, F(-1, 2)), along(a, b, F(3, 2))
        yield edge_case(f"random-{n:02}-{name}", "drawn at random", shapes[name], a, b)


# --- closest points


def closest(t, p):
    """The point of the triangle that is closest to p: the foot in the plane if it is within, else the best on an edge."""
    n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
    foot = sub(p, tuple(dot(sub(p, t[0]), n) / dot(n, n) * x for x in n))
    if all(dot(cross(sub(t[(k + 1) % 3], t[k]), sub(foot, t[k])), n) >= 0 for k in range(3)):
        return foot
    spots = []
    for k in range(3):
        a, d = t[k], sub(t[(k + 1) % 3], t[k])
        s = min(max(dot(sub(p, a), d) / dot(d, d), F(0)), F(1))
        spots.append(along(a, t[(k + 1) % 3], s))
    return min(spots, key=lambda x: dot(sub(x, p), sub(x, p)))


CLOSEST_FLAGS = {
    "region-face": "The closest point lies within a triangle.",
    "region-edge": "The closest point lies within an edge.",
    "region-vertex": "The closest point is a vertex.",
    "beyond-the-plane": "The closest foot of a perpendicular to a triangle's plane is another point: it lies outside the triangle.",
    "no-vertex": "The closest point is no vertex of the surface.",
    "tie": "Several points are equally close: the lexicographically smallest (reading D4).",
    "on-surface": "The point lies on the surface: it is its own closest point.",
}


def closest_case(name, comment, surface, p):
    triangles, square = corners(surface), lambda x: dot(sub(x, p), sub(x, p))
    spots = sorted({closest(t, p) for t in triangles})
    least = min(map(square, spots))
    tied = [x for x in spots if square(x) == least]
    others = sorted(map(square, set(spots) - set(tied)))
    if others and others[0] - least < F(1, 10**6):
        raise AssertionError(f"{name}: almost a tie")
    best = tied[0]
    feet = []
    for t in triangles:
        n = cross(sub(t[1], t[0]), sub(t[2], t[0]))
        feet.append(sub(p, tuple(dot(sub(p, t[0]), n) / dot(n, n) * x for x in n)))
    foot = min(feet, key=lambda x: (square(x), x))
    at_vertex = best in surface[0]
    flags = ["on-surface"] * (least == 0) + ["tie"] * (len(tied) > 1) + ["beyond-the-plane"] * (foot != best) + ["no-vertex"] * (not at_vertex)
    flags.append("region-face" if any(strictly_on_triangle(t, best) for t in triangles) else "region-vertex" if at_vertex else "region-edge")
    size = max(abs(x) for v in list(surface[0]) + [p] for x in v)
    return {"id": "closest-" + name, "flags": flags, "comment": comment,
            "input": {"vertices": surface[0], "triangles": surface[1], "point": p},
            "expected": {"point": best, "distance": root(least, 2)}, "tolerance": {"absolute": float(size) * 1e-14}}


def closest_point():
    f = lambda *x: tuple(map(F, x))
    skew = ([f(0, 0, 0), f(8, 0, 4), f(2, 6, -1)], [[0, 1, 2]])
    a, b, c = skew[0]
    n = cross(sub(b, a), sub(c, a))
    lift = lambda x, h: tuple(u + h * w for u, w in zip(x, n))
    mix = lambda u, v, w: tuple(u * x + v * y + w * z for x, y, z in zip(a, b, c))
    regions = {"face": (F(1, 4), F(1, 4), F(1, 2)), "ab": (F(3, 4), F(3, 4), F(-1, 2)), "bc": (F(-1, 2), F(3, 4), F(3, 4)), "ca": (F(3, 4), F(-1, 2), F(3, 4)),
               "a": (F(3), F(-1), F(-1)), "b": (F(-1), F(3), F(-1)), "c": (F(-1), F(-1), F(3))}
    for region, weights in regions.items():
        for height, where in ((F(1, 32), "above"), (F(0), "level"), (F(-1, 16), "below")):
            yield closest_case(f"triangle-{region}-{where}", f"a lone triangle, the region of {region}, {where} its plane", skew, lift(mix(*weights), height))
    needle = ([f(0, 0, 0), f(16, 0, F(1, 8)), f(8, F(1, 64), 0)], [[0, 1, 2]])
    for k, p in enumerate((f(8, 1, 0), f(4, F(1, 256), 1), f(-1, 0, 0), f(8, -1, 0))):
        yield closest_case(f"needle-{k}", "a lone triangle shaped like a needle", needle, p)
    shapes = surfaces()
    for name, points in {
        "cube": (f(1, 1, 1), f(1, 1, F(1, 2)), f(3, 3, 3), f(3, 3, 1), f(3, 1, 1), f(1, F(1, 2), F(1, 2)), f(2, 1, 1), f(2, 2, 2)),
        "pair": (f(3, 1, 1), f(3, 3, 3), f(3, 1, 4), f(3, -1, 1)),
        "shell": (f(3, 3, 3), f(3, 3, F(9, 4)), f(1, 1, 1), f(3, 1, 3), f(7, 7, 3)),
        "corner": (f(3, 3, 1), f(3, 3, 3), f(F(5, 2), F(5, 2), F(1, 2)), f(1, 1, 1), f(5, 5, 5)),
        "frame": (f(3, 3, 1), f(3, 3, F(7, 2)), f(1, 3, 1), f(3, 3, -1)),
        "tetrahedron": (f(2, 2, 2), f(6, 6, 6), f(-1, -1, -1), f(3, 0, 0)),
    }.items():
        for k, p in enumerate(points):
            yield closest_case(f"{name}-{k}", "inside, outside and on a surface", shapes[name], p)
    draws = Draws(44)
    for k in range(24):
        name = draws.choice(("cube", "corner", "frame", "tetrahedron"))
        yield closest_case(f"random-{k:02}-{name}", "drawn at random", shapes[name], tuple(F(draws.between(-30, 90), 16) for _ in range(3)))
