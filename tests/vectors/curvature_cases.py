# SPDX-License-Identifier: GPL-3.0-or-later
"""Absolute curvature (reading D15) on small patches: the least squares in fractions, unit vectors to 60 digits."""
from fractions import Fraction as F

from exact import Draws, cross, dot, root, sub

FLAGS = {
    "quadric": "The neighbours lie on a quadric and come in opposite pairs: the fit is exact, |k1|+|k2| in closed form.",
    "saddle": "The curvatures have opposite signs: absolute values are added; the mean curvature would give less, or 0.",
    "mixed-term": "c11 is not 0: curvatures are eigenvalues, not c20 and c02.",
    "overdetermined": "The neighbours lie on no quadric: least squares.",
    "unweighted-normals": "Triangles of different sizes: the normal is the mean of unit normals, weighted neither by area nor by angle.",
    "no-linear-terms": "The heights have a linear part in the chosen plane: it is not fitted.",
    "second-ring": "The first ring does not determine the fit; the second ring joins it.",
    "first-ring-enough": "Three neighbours that do determine the fit: the second ring must not join.",
    "undetermined": "Not even two rings determine the fit: curvature 0.",
    "rotated": "The normal is no axis.",
    "scaled": "Curvature is a reciprocal length.",
    "inward": "The triangles run the other way round: curvatures change sign, their absolute values don't.",
    "numbering": "The vertex is not the first point, triangles begin at any corner.",
}


def scale(v, s):
    return tuple(x * s for x in v)


def short(x):
    """Without the digits beyond 2^-240."""
    return F(round(x * 2**240), 2**240)


def unit(v):
    return tuple(map(short, scale(v, 1 / root(dot(v, v), 2))))


def solve(matrix, right):
    """Gauss-Jordan; nothing if the matrix is singular."""
    rows = [list(r) + [b] for r, b in zip(matrix, right)]
    n = len(rows)
    for c in range(n):
        pivot = next((r for r in range(c, n) if rows[r][c] != 0), None)
        if pivot is None:
            return None
        rows[c], rows[pivot] = rows[pivot], rows[c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for r in range(n):
            if r != c:
                rows[r] = [x - rows[r][c] * y for x, y in zip(rows[r], rows[c])]
    return [r[n] for r in rows]


def absolute_curvature(points, triangles, v):
    """(curvature, rings used). A determinant below 2^-60 of what it could be vanishes but for the rounding of the coordinates."""
    around = [t for t in triangles if v in t]
    normal = unit(tuple(map(sum, zip(*(unit(cross(sub(points[b], points[a]), sub(points[c], points[a]))) for a, b, c in around)))))
    axis = min(range(3), key=lambda k: abs(normal[k]))
    u = unit(cross(normal, tuple(F(k == axis) for k in range(3))))
    w = cross(normal, u)
    ring = {n for t in around for n in t} - {v}
    for rings in (1, 2):
        rows, heights = [], []
        for n in sorted(ring):
            o = sub(points[n], points[v])
            a, b = short(dot(o, u)), short(dot(o, w))
            rows.append((a * a / 2, a * b, b * b / 2))
            heights.append(short(dot(o, normal)))
        gram = [[short(sum(r[i] * r[j] for r in rows)) for j in range(3)] for i in range(3)]
        determinant = dot(gram[0], cross(gram[1], gram[2]))
        if determinant > F(1, 2**60) * max(max(map(abs, g)) for g in gram) ** 3:
            c20, c11, c02 = solve(gram, [sum(r[i] * h for r, h in zip(rows, heights)) for i in range(3)])
            if c20 * c02 >= c11 * c11:
                return abs(c20 + c02), rings
            return root((c20 - c02) ** 2 + 4 * c11**2, 2), rings
        ring |= {n for t in triangles if set(t) & ring for n in t} - {v}
    return F(0), 0


def fan(ring, rim=None):
    """Triangles around point 0 with the ring 1..n; with `rim`, a strip to as many points more."""
    n = len(ring)
    triangles = [(0, 1 + k, 1 + (k + 1) % n) for k in range(n)]
    if rim:
        for k in range(n):
            a, b, c, d = 1 + k, 1 + (k + 1) % n, 1 + n + k, 1 + n + (k + 1) % n
            triangles += [(a, c, b), (b, c, d)]
    return triangles


# Rational rotations: unit quaternions with rational parts.
def rotation(q):
    a, b, c, d = map(F, q)
    n = a * a + b * b + c * c + d * d
    return [[(a * a + b * b - c * c - d * d) / n, 2 * (b * c - a * d) / n, 2 * (b * d + a * c) / n],
            [2 * (b * c + a * d) / n, (a * a - b * b + c * c - d * d) / n, 2 * (c * d - a * b) / n],
            [2 * (b * d - a * c) / n, 2 * (c * d + a * b) / n, (a * a - b * b - c * c + d * d) / n]]


def placed(points, q, size, centre):
    """Rotated, scaled and moved, rounded to doubles: what the file holds is the input, and the answer is computed from that."""
    m = rotation(q)
    return [tuple(F(float(sum(m[r][k] * p[k] for k in range(3)) * size + centre[r])) for r in range(3)) for p in points]


def case(name, flags, comment, points, triangles, vertex=0, closed_form=None, tolerance=1e-9):
    value, rings = absolute_curvature(points, triangles, vertex)
    if closed_form is not None and abs(value - closed_form) > F(1, 10**40) * max(1, abs(closed_form)):
        raise AssertionError(f"{name}: {float(value)} but {float(closed_form)}")
    flags = list(flags) + ["second-ring"] * (rings == 2) + ["undetermined"] * (rings == 0)
    return {"id": "curvature-" + name, "flags": flags, "comment": comment,
            "input": {"points": points, "triangles": [list(t) for t in triangles], "vertex": vertex},
            "expected": {"curvature": value}, "tolerance": {"relative": tolerance, "absolute": 1e-12}}


RING6 = [(F(2), F(0)), (F(1), F(2)), (F(-1), F(2)), (F(-2), F(0)), (F(-1), F(-2)), (F(1), F(-2))]
RING8 = [(F(3), F(0)), (F(2), F(2)), (F(0), F(3)), (F(-1), F(2)), (F(-3), F(0)), (F(-2), F(-2)), (F(0), F(-3)), (F(1), F(-2))]
CROSS = [(F(2), F(0)), (F(0), F(3)), (F(-2), F(0)), (F(0), F(-3))]


def curvature():
    def quadric(c20, c11, c02):
        return lambda x, y: (c20 * x * x + 2 * c11 * x * y + c02 * y * y) / 2

    def patch(f, *rings):
        return [(F(0),) * 3] + [(x, y, f(x, y)) for ring in rings for x, y in ring]

    def closed_form(c20, c11, c02):
        return abs(c20 + c02) if c20 * c02 >= c11 * c11 else root((c20 - c02) ** 2 + 4 * c11**2, 2)

    # Opposite pairs on quadrics: the mean normal is the axis, the fit exact.
    quadrics = {"sphere": (F(-1, 4), F(0), F(-1, 4)), "cylinder": (F(1, 2), F(0), F(0)), "torus-outer": (F(-1, 2), F(0), F(-1, 8)),
                "torus-inner": (F(-1, 2), F(0), F(1, 4)), "saddle": (F(1, 2), F(0), F(-1, 2)), "plane": (F(0), F(0), F(0)),
                "twisted": (F(1, 8), F(1, 4), F(1, 2)), "twisted-saddle": (F(1, 4), F(3, 8), F(-1, 8)), "hyperbolic": (F(0), F(1, 4), F(0)),
                "parabolic": (F(1, 2), F(1, 2), F(1, 2))}
    for name, c in quadrics.items():
        flags = ["quadric"] + ["saddle"] * (c[0] * c[2] < c[1] ** 2) + ["mixed-term"] * (c[1] != 0)
        kappa = closed_form(*c)
        for n, ring in (("6", RING6), ("8", RING8)):
            points, triangles = patch(quadric(*c), ring), fan(ring)
            yield case(f"{name}-{n}", flags, f"{n} neighbours, c20 = {c[0]}, c11 = {c[1]}, c02 = {c[2]}", points, triangles, 0, kappa)
        yield case(f"{name}-inward", flags + ["inward"], "triangles reversed", points, [(a, c_, b) for a, b, c_ in triangles], 0, kappa)
        yield case(f"{name}-large", flags + ["scaled"], "1024 times as large", [scale(p, 1024) for p in points], triangles, 0, kappa / 1024)
        yield case(f"{name}-rotated", flags + ["rotated"], "rotated; coordinates rounded to doubles", placed(points, (3, 1, -2, 2), F(1), (F(1), F(2), F(-1))), triangles)
        outer = [(F(4), F(3)), (F(-2), F(5)), (F(-4), F(-3)), (F(2), F(-5))]
        points, triangles = patch(quadric(*c), CROSS, outer), fan(CROSS, outer)
        yield case(f"{name}-cross", flags, "four neighbours on a cross do not determine c11", points, triangles, 0, kappa)
        yield case(f"{name}-cross-rotated", flags + ["rotated"], "the same rotated: rank 2 but for rounding", placed(points, (2, -1, 4, 2), F(1, 2), (F(0), F(0), F(3))), triangles)

    # Opposite pairs on no quadric: heights drawn at random, the fit a true least squares.
    draws = Draws(15)
    for n in range(8):
        half = [F(draws.between(-16, 16), 16) for _ in range(4)]
        points = [(F(0),) * 3] + [(x, y, h) for (x, y), h in zip(RING8, half + half)]
        yield case(f"pairs-{n}", ["overdetermined", "saddle", "mixed-term"], "eight neighbours in opposite pairs, heights at random", points, fan(RING8))
    # Any star: the normal leans, the heights have a linear part.
    for n in range(16):
        size = draws.choice((3, 4, 5, 6, 7, 9))
        ring = star(draws, size)
        points = [(F(0),) * 3] + [(x, y, F(draws.between(-12, 12), 16)) for x, y in ring]
        flags = ["unweighted-normals", "no-linear-terms", "overdetermined" if size > 3 else "first-ring-enough"]
        triangles, vertex = fan(ring), 0
        if n % 2:
            new = draws.shuffled(range(len(points)))
            points = [p for _, p in sorted(zip(new, points))]
            triangles = draws.shuffled([tuple(new[v] for v in (t[k:] + t[:k])) for t in triangles for k in [draws.below(3)]])
            vertex, flags = new[0], flags + ["numbering"]
        yield case(f"star-{n:02}", flags, f"{size} neighbours at random", points, triangles, vertex)
    # Three neighbours, with a second ring that would change the answer.
    ring = [(F(4), F(0)), (F(-2), F(3)), (F(-2), F(-3))]
    rim = [(F(6), F(8)), (F(-9), F(1)), (F(5), F(-7))]
    points = [(F(0),) * 3] + [(x, y, F(-1)) for x, y in ring] + [(x, y, h) for (x, y), h in zip(rim, (F(-2), F(-7), F(-3)))]
    yield case("valence-3", ["first-ring-enough"], "three neighbours determine three coefficients", points, fan(ring, rim))
    tetrahedron = [tuple(map(F, p)) for p in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))]
    faces = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
    # The neighbours of a corner lie at distance sqrt(8/3) from the axis and 4/sqrt(3) below: c20 = c02 = -sqrt(3).
    yield case("tetrahedron", ["first-ring-enough", "rotated"], "a regular tetrahedron: |k1|+|k2| = 2 sqrt(3)", tetrahedron, faces, 0, root(F(12), 2))
    octahedron = [tuple(map(F, p)) for p in ((0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, -1))]
    faces = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1), (5, 2, 1), (5, 3, 2), (5, 4, 3), (5, 1, 4)]
    yield case("octahedron", [], "a cross, and the opposite corner on the axis", octahedron, faces, 0, F(0))
    yield case("octahedron-rotated", ["rotated"], "the same rotated: rank 2 but for rounding", placed(octahedron, (1, 2, 3, -1), F(3), (F(0),) * 3), faces)
    cube = [(F(i), F(j), F(k)) for k in (0, 1) for j in (0, 1) for i in (0, 1)]
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    for v in range(8):
        yield case(f"cube-{v}", ["unweighted-normals", "no-linear-terms", "numbering"], "a corner of a cube, its faces halved", cube, faces, v)


def star(draws, size):
    """A ring around the origin, anticlockwise, its angles below 180 degrees."""
    while True:
        ring = sorted({(F(draws.between(-48, 48), 16), F(draws.between(-48, 48), 16)) for _ in range(size)}, key=angle)
        if len(ring) < size or any(dot(p, p) < F(1, 2) for p in ring):
            continue
        turns = [ring[k][0] * ring[(k + 1) % size][1] - ring[k][1] * ring[(k + 1) % size][0] for k in range(size)]
        if min(turns) > F(1, 2):
            return ring


def angle(p):
    """Ascends with the angle, in fractions."""
    x, y = p
    size = abs(x) + abs(y)
    return (x / size if y < 0 else 2 - x / size) if size else F(0)
